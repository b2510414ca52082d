#include "transpiler/compile/toolchain.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <system_error>

#include "transpiler/compile/child_process.h"

namespace plcxx::compile {
namespace {

constexpr int kVersionSeconds = 20;
constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz";

/// What all code is compiled with. No jump tables: an indirect jump would hide where the longest path goes, and a
/// switch of a machine program is a few comparisons.
constexpr std::string_view kFlags[] = {
    "-std=c++17",
    "-ffreestanding",
    "-fno-exceptions",
    "-fno-rtti",
    "-fno-unwind-tables",
    "-fno-asynchronous-unwind-tables",
    "-fno-threadsafe-statics",
    "-fno-stack-protector",
    "-fno-jump-tables",
    "-fomit-frame-pointer",
    "-ffunction-sections",
    "-fdata-sections",
    "-ffp-contract=off",  // a product is rounded before it is added, as in the simulator
    "-Wall",
    "-Wextra",
    "-Wconversion",
    "-Wshadow",
    "-Werror",
    "-g1"};

struct PackageRow {
  std::string_view prefix;
  std::string_view package;
};
constexpr PackageRow kPackages[] = {{"", "g++ (Debian package g++)"},
                                    {"arm-none-eabi-", "Debian package gcc-arm-none-eabi"},
                                    {"riscv64-unknown-elf-", "Debian package gcc-riscv64-unknown-elf"}};

std::string PackageOf(const Target& target, const std::string& command) {
  if (command.find("clang") != std::string::npos) return "Debian package clang-19";
  for (const PackageRow& row : kPackages) {
    if (row.prefix == target.prefix) return std::string(row.package);
  }
  return "the package that has it";
}

/// Empty when it cannot be run.
std::string VersionOf(std::vector<std::string> command) {
  command.emplace_back("--version");
  const ProcessResult result = RunProcess(command, kVersionSeconds);
  return result.exit_code == 0 ? result.output.substr(0, result.output.find('\n')) : "";
}

std::vector<std::string> Candidates(const Target& target, const std::string& compiler) {
  if (!compiler.empty()) return {compiler};
  if (!target.prefix.empty()) return {std::string(target.prefix) + "g++"};
  const char* chosen = std::getenv("CXX");
  if (chosen != nullptr && *chosen != '\0') return {chosen};
  return {"g++", "c++", "clang++"};
}

/// Both write the same format; a deterministic archive is asked for.
std::string FindArchiver(const Target& target) {
  for (const std::string& candidate :
       {std::string(target.prefix) + "ar", std::string("llvm-ar-19"), std::string("llvm-ar"), std::string("ar")}) {
    if (!VersionOf({candidate}).empty()) return candidate;
  }
  return "";
}

}  // namespace

std::vector<std::string> CommandWords(const std::string& command) {
  std::error_code error;
  if (command.find('/') != std::string::npos && std::filesystem::is_regular_file(command, error)) return {command};
  std::istringstream stream(command);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::variant<Toolchain, MissingTool> FindToolchain(const Target& target, const std::string& compiler) {
  const std::vector<std::string> candidates = Candidates(target, compiler);
  for (const std::string& candidate : candidates) {
    Toolchain toolchain;
    toolchain.command = CommandWords(candidate);
    if (toolchain.command.empty()) continue;
    toolchain.version = VersionOf(toolchain.command);
    if (toolchain.version.empty()) continue;
    toolchain.is_clang = toolchain.version.find("clang") != std::string::npos;
    toolchain.archiver = FindArchiver(target);
    if (toolchain.archiver.empty()) return MissingTool{std::string(target.prefix) + "ar", "Debian package binutils"};
    return toolchain;
  }
  return MissingTool{candidates.front(), PackageOf(target, candidates.front())};
}

std::string OtherMachineOf(const Toolchain& toolchain, const Target& target) {
  const std::string_view family = target.prefix.substr(0, target.prefix.find_first_not_of(kLetters));
  if (toolchain.is_clang || family.empty()) return {};
  std::vector<std::string> command = toolchain.command;
  command.emplace_back("-dumpmachine");
  const ProcessResult result = RunProcess(command, kVersionSeconds);
  if (result.exit_code != 0 || result.output.starts_with(family)) return {};
  return result.output.substr(0, result.output.find('\n'));
}

std::vector<std::string> CompileCommand(const Toolchain& toolchain, const Target& target, const std::string& level,
                                        const std::string& directory, const std::string& source,
                                        const std::string& object) {
  std::vector<std::string> command = toolchain.command;
  if (toolchain.is_clang && !target.triple.empty()) command.push_back("--target=" + std::string(target.triple));
  for (const std::string& flag : FlagsOf(target)) command.push_back(flag);
  command.push_back("-O" + level);
  for (const std::string_view flag : kFlags) command.emplace_back(flag);
  // GCC would split a function in two, and call one function for another one of the same code: the measurement takes
  // functions as wholes, and tells slices apart by what they call.
  if (!toolchain.is_clang) {
    command.emplace_back("-fno-reorder-blocks-and-partition");
    command.emplace_back("-fno-ipa-icf");
  }
  command.push_back("-ffile-prefix-map=" + directory + "=.");
  command.insert(command.end(), {"-I", ".", "-c", source, "-o", object});
  return command;
}

}  // namespace plcxx::compile
