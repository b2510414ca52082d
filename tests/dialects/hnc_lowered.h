// Lowers hnc programs given as text and shows the IR, for the tests of the lowering.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/hnc/hnc.h"
#include "transpiler/ir/printer.h"
#include "transpiler/ir/verifier.h"

namespace plcxx::hnc {

/// One compilation.
struct LoweredProgram {
  source::SourceManager sources;
  diag::Engine diagnostics;
  dialects::Lowered lowered;

  const ir::Program& program() const { return lowered.program; }
  /// "3 W18" of every diagnostic, in source order.
  std::vector<std::string> Reported() const {
    std::vector<std::string> result;
    for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
      const std::string_view code = diagnostic.row->code;
      result.push_back(std::to_string(sources.Locate(diagnostic.range.begin).line) + " " +
                       std::string(code.substr(code.find('-') + 1)));
    }
    return result;
  }
  /// One routine as the printer shows it, without indentation and numbers of statements.
  std::vector<std::string> Routine(std::string_view name) const {
    std::vector<std::string> result;
    const std::string text = ir::Print(program());
    bool inside = false;
    for (size_t begin = 0; begin < text.size();) {
      const size_t end = std::min(text.find('\n', begin), text.size());
      std::string_view line(text.data() + begin, end - begin);
      begin = end + 1;
      if (line == "}") inside = false;
      line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
      if (line.starts_with("routine ")) inside = line.starts_with("routine " + std::string(name) + " ");
      if (!inside) continue;
      result.push_back(line.starts_with("stmt ") ? "stmt" : std::string(line));
    }
    return result;
  }
};

inline void LowerInto(LoweredProgram& lowered, const std::string& text,
                      const std::map<std::string, std::string>& options = {}, ir::Facts facts = ir::Facts::kTrusted) {
  dialects::Request request;
  request.sources = &lowered.sources;
  request.diagnostics = &lowered.diagnostics;
  request.options = options;
  request.facts = facts;
  request.files.push_back(lowered.sources.AddText("test.cld", text));
  lowered.lowered = kHnc.lower(request);
  lowered.diagnostics.SortBySource();
  if (!lowered.diagnostics.HasErrors()) {
    EXPECT_THAT(ir::Verify(lowered.program(), ir::Stage::kLowered), testing::IsEmpty()) << ir::Print(lowered.program());
  }
}

/// A program whose plc1() has these statements, with a few variables around: line 3 is theirs.
inline std::string WithStatements(const std::string& statements) {
  return "#include \"plc.h\"\nint a, b; unsigned u; long l; unsigned char c; int table[8]; int i, n;\nvoid plc1() {" +
         statements + "}\nvoid init() { plc1_time = 16; plc2_time = 32; }\nvoid plc2() { }\n";
}

/// "3 E032" of each error of plc1() with these statements.
inline std::vector<std::string> Errors(const std::string& statements) {
  LoweredProgram lowered;
  LowerInto(lowered, WithStatements(statements));
  std::vector<std::string> reported = lowered.Reported();
  std::erase_if(reported, [](const std::string& line) { return line.find(" W") != std::string::npos; });
  return reported;
}

}  // namespace plcxx::hnc
