#include "transpiler/compile/known_objects.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "transpiler/compile/child_process.h"
#include "transpiler/compile/runtime_files.h"
#include "transpiler/support/sha256.h"
#include "transpiler/support/sized_text.h"

namespace plcxx::compile {
namespace {

namespace fs = std::filesystem;

constexpr int kToolSeconds = 60;
constexpr std::string_view kRecordHead = "# what the objects were made of, and what they are (SHA-256)\n";
constexpr size_t kDigits = 64;

/// Compilers read them beside their arguments.
constexpr const char* kVariables[] = {"CPATH", "CPLUS_INCLUDE_PATH", "COMPILER_PATH", "GCC_EXEC_PREFIX"};

/// The file that a command's word is, as the shell finds it; empty: none.
fs::path ProgramOf(const std::string& word) {
  std::error_code failed;
  if (word.find('/') != std::string::npos) return fs::is_regular_file(word, failed) ? fs::path(word) : fs::path();
  const char* path = std::getenv("PATH");
  std::istringstream directories(path != nullptr ? path : "");
  for (std::string directory; std::getline(directories, directory, ':');) {
    const fs::path candidate = fs::path(directory) / word;
    if (fs::is_regular_file(candidate, failed)) return candidate;
  }
  return {};
}

/// Size and time of a program: an upgrade changes one of them also where its version stays.
std::string StampOf(const std::string& word) {
  const fs::path program = ProgramOf(word);
  std::error_code failed;
  const uintmax_t size = program.empty() ? 0 : fs::file_size(program, failed);
  if (program.empty() || failed) return "";
  const fs::file_time_type time = fs::last_write_time(program, failed);
  return std::to_string(size) + " " + std::to_string(time.time_since_epoch().count());
}

std::string OutputOf(std::vector<std::string> command, const std::string& argument) {
  command.push_back(argument);
  const ProcessResult result = RunProcess(command, kToolSeconds);
  return result.exit_code == 0 ? result.output : "";
}

bool IsDigest(std::string_view text) {
  return text.size() == kDigits && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace

bool IsHeader(const emit::OutputFile& file) { return file.name.ends_with(".hpp") || file.name.ends_with(".h"); }

std::string CommonInputs(const Toolchain& toolchain, const std::vector<emit::OutputFile>& files) {
  std::string inputs;
  for (const emit::OutputFile& file : files) {
    if (!IsHeader(file)) continue;
    support::AddSized(inputs, file.name);
    support::AddSized(inputs, file.text);
  }
  for (const RuntimeFile& header : RuntimeFiles()) {
    support::AddSized(inputs, header.name);
    support::AddSized(inputs, header.text);
  }
  support::AddSized(inputs, OutputOf(toolchain.command, "--version"));
  for (const std::string& word : toolchain.command) support::AddSized(inputs, StampOf(word));
  if (!toolchain.is_clang) {  // g++ only calls the compiler
    std::string compiler = OutputOf(toolchain.command, "-print-prog-name=cc1plus");
    compiler.resize(std::min(compiler.find('\n'), compiler.size()));
    support::AddSized(inputs, compiler);
    support::AddSized(inputs, StampOf(compiler));
  }
  for (const char* variable : kVariables) {
    const char* value = std::getenv(variable);
    support::AddSized(inputs, value != nullptr ? value : "");
  }
  return inputs;
}

std::string InputsOf(const Toolchain& toolchain, const Target& target, const std::string& level,
                     const emit::OutputFile& source, const std::string& object, const std::string& common_inputs) {
  std::string inputs;
  // The directory is not in the object.
  for (const std::string& word : CompileCommand(toolchain, target, level, "", source.name, object))
    support::AddSized(inputs, word);
  support::AddSized(inputs, source.text);
  return support::Sha256(inputs + common_inputs);
}

KnownObjects ReadRecord(std::string_view text) {
  KnownObjects objects;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string inputs, bytes, name;
    if (words >> inputs >> bytes >> name && IsDigest(inputs) && IsDigest(bytes)) objects[name] = {inputs, bytes};
  }
  return objects;
}

std::string RecordText(const KnownObjects& objects) {
  std::string text(kRecordHead);
  for (const auto& [name, known] : objects) text += known.inputs + " " + known.bytes + " " + name + "\n";
  return text;
}

bool TakeObjects(const std::string& archiver, const std::string& library, const std::vector<std::string>& objects,
                 const std::string& directory) {
  std::error_code failed;
  const fs::path archive = fs::absolute(library, failed);
  if (failed || objects.empty()) return false;
  std::vector<std::string> command = {archiver, "x", archive.string()};
  command.insert(command.end(), objects.begin(), objects.end());
  return RunProcess(command, kToolSeconds, directory).exit_code == 0;
}

}  // namespace plcxx::compile
