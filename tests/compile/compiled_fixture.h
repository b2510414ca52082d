// A C++ text compiled for a target as plcxx build does, and read by the module.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "tests/temporary_directory.h"
#include "transpiler/compile/audit_module.h"
#include "transpiler/compile/child_process.h"
#include "transpiler/compile/program_code.h"
#include "transpiler/compile/toolchain.h"

namespace plcxx::compile {

inline std::string FileText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline std::string FixtureText(const std::string& name) {
  return FileText(std::string(PLCXX_ROOT) + "/tests/compile/fixtures/" + name);
}

/// None, with a failure, when it does not compile.
inline std::optional<ProgramCode> CompileText(const std::string& text, const Target& target, const Toolchain& toolchain,
                                              const std::string& level = "2") {
  const testing_support::TemporaryDirectory directory;
  directory.Write("text.cpp", text);
  const std::string folder = directory.path().string();
  const ProcessResult result =
      RunProcess(CompileCommand(toolchain, target, level, folder, "text.cpp", "text.o"), 60, folder);
  EXPECT_EQ(result.exit_code, 0) << target.name << ": " << result.output;
  if (result.exit_code != 0) return std::nullopt;
  std::string reason;
  const ReadObjectFunction read = LoadObjectReader(reason);
  EXPECT_NE(read, nullptr) << reason;
  if (read == nullptr) return std::nullopt;
  std::vector<ObjectFacts> facts(1);
  const std::string object = FileText(directory.File("text.o"));
  read({.bytes = object, .processor = target.processor}, facts[0]);
  EXPECT_EQ(facts[0].failure, "");
  return ProgramCode(std::move(facts));
}

struct Tools {
  const Target* target;
  Toolchain toolchain;
};

/// GCC of each target, and Clang for all of them; what is not installed is left out with a message.
inline std::vector<Tools> InstalledTools() {
  std::vector<Tools> all;
  for (const Target& target : Targets()) {
    for (const std::string compiler : {"", "clang++-19"}) {
      auto found = FindToolchain(target, compiler);
      if (const auto* missing = std::get_if<MissingTool>(&found)) {
        std::cerr << "skipped: " << missing->command << " is not there\n";
      } else {
        all.push_back({&target, std::get<Toolchain>(found)});
      }
    }
  }
  return all;
}

}  // namespace plcxx::compile
