#include "tests/golden/golden.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>
#include <variant>

#include "transpiler/compile/child_process.h"
#include "transpiler/project/project.h"
#include "transpiler/scenarios/scenario.h"

namespace plcxx::golden {
namespace {

constexpr std::string_view kDebug = "debug";

constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kPhases = {{{".tokens", "tokens"},
                                                                                   {".syntax", "syntax"},
                                                                                   {".ir", "ir"},
                                                                                   {".ir-structured", "ir-structured"},
                                                                                   {".ir-optimized", "ir-optimized"},
                                                                                   {".ir-emittable", "ir-emittable"},
                                                                                   {".cc", "cpp"},
                                                                                   {".debug", kDebug}}};

constexpr int kToolSeconds = 600;

std::string Quoted(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

void WriteFile(const fs::path& path, std::string_view text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary).write(text.data(), static_cast<std::streamsize>(text.size()));
}

/// The line that begins at `at`, or a word for the end of the text.
std::string LineAt(std::string_view text, size_t at) {
  if (at >= text.size()) return "(end of file)";
  return std::string(text.substr(at, text.find('\n', at) - at));
}

std::string FirstDifference(std::string_view kept, std::string_view actual) {
  const size_t shorter = std::min(kept.size(), actual.size());
  size_t at = 0, line_start = 0, line = 1;
  for (; at < shorter && kept[at] == actual[at]; ++at) {
    if (kept[at] != '\n') continue;
    line_start = at + 1;
    ++line;
  }
  return "line " + std::to_string(line) + " is '" + LineAt(kept, line_start) + "', but plcxx gives '" +
         LineAt(actual, line_start) + "'";
}

/// The words of the command line that describe a program: options, then sources.
struct Program {
  std::vector<std::string> words;
};

/// What a scenario names; none, when it cannot be read.
std::optional<Program> ProgramOf(const fs::path& path) {
  const scenarios::ScenarioOrErrors read = scenarios::ReadScenario(path.string());
  const auto* scenario = std::get_if<scenarios::Scenario>(&read);
  if (scenario == nullptr || scenario->sources.empty()) return std::nullopt;
  Program program;
  if (!scenario->dialect.empty()) program.words = {"--dialect", scenario->dialect};
  for (const auto& [key, value] : scenario->options) {
    program.words.push_back("--set");
    program.words.push_back(key + "=" + value);
  }
  program.words.insert(program.words.end(), scenario->sources.begin(), scenario->sources.end());
  return program;
}

std::vector<std::string> Command(std::vector<std::string> words, const Program& program) {
  words.insert(words.end(), program.words.begin(), program.words.end());
  return words;
}

std::string Failure(const fs::path& what, const ToolResult& result) {
  return what.string() + ": plcxx ends with " + std::to_string(result.exit_code) + ":\n" + result.errors;
}

/// The C++ with force masks, line enables and #line directives; no phase prints it.
std::optional<std::string> CheckDebug(const PhaseGolden& golden, const Program& program, Mode mode) {
  const compile::TemporaryDirectory temporary;
  const ToolResult result = RunTool(
      golden.file.parent_path(),
      Command({"emit", "--debug", "--line-directives", "--quiet", "--name", "debug", "-o", temporary.path()}, program));
  if (result.exit_code != 0) return Failure(golden.file, result);
  std::string text;
  for (const std::string_view ending : {".hpp", ".cpp"}) {
    for (const fs::path& file : FilesBelow(temporary.path(), ending)) {
      if (file.parent_path() == temporary.path()) text += ReadFile(file);  // without the runtime
    }
  }
  return CheckFile(golden.file, text, mode);
}

}  // namespace

Mode ChosenMode() {
  const char* value = std::getenv("PLCXX_UPDATE_GOLDEN");
  return value != nullptr && *value != '\0' && std::string_view(value) != "0" ? Mode::kUpdate : Mode::kCompare;
}

std::string ReadFile(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

ToolResult RunTool(const fs::path& directory, const std::vector<std::string>& arguments) {
  const compile::TemporaryDirectory temporary;
  std::string command = "cd " + Quoted(directory.string()) + " && " + Quoted(PLCXX_BINARY);
  for (const std::string& argument : arguments) command += " " + Quoted(argument);
  command += " >" + Quoted(temporary.path() + "/output") + " 2>" + Quoted(temporary.path() + "/errors");
  const compile::ProcessResult result = compile::RunProcess({"sh", "-c", command}, kToolSeconds);
  return {result.exit_code, ReadFile(temporary.path() + "/output"), ReadFile(temporary.path() + "/errors")};
}

std::optional<std::string> CheckFile(const fs::path& file, std::string_view actual, Mode mode) {
  const bool there = fs::exists(file);
  const std::string kept = there ? ReadFile(file) : std::string();
  if (there && kept == actual) return std::nullopt;
  if (mode == Mode::kUpdate) {
    WriteFile(file, actual);
    return std::nullopt;
  }
  return file.string() + ": " + (there ? FirstDifference(kept, actual) : "is missing") +
         "; PLCXX_UPDATE_GOLDEN=1 rewrites it";
}

std::vector<fs::path> FilesBelow(const fs::path& directory, std::string_view ending) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(directory, error)) {
    if (entry.is_regular_file() && entry.path().string().ends_with(ending)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<PhaseGolden> PhaseGoldens(const fs::path& directory) {
  std::vector<PhaseGolden> goldens;
  for (const auto& [suffix, phase] : kPhases) {
    for (const fs::path& file : FilesBelow(directory, suffix)) {
      const fs::path program = fs::path(file).replace_extension();
      if (file.parent_path() == directory && !fs::exists(program)) continue;  // a file of this folder's own C++
      const fs::path scenario = fs::path(program).replace_extension(".yaml");
      goldens.push_back(
          {file, std::string(phase), fs::exists(scenario) ? scenario : fs::path(), program.filename().string()});
    }
  }
  return goldens;
}

std::vector<std::string> MissingPhases(const fs::path& directory, size_t least) {
  std::vector<std::string> problems;
  for (const auto& language : fs::directory_iterator(directory)) {
    if (!language.is_directory()) continue;
    for (const std::string_view suffix : {".syntax", ".ir", ".cc"}) {
      const size_t count = FilesBelow(language.path(), suffix).size();
      if (count >= least || FilesBelow(language.path(), ".yaml").size() < least) continue;
      problems.push_back(language.path().string() + ": " + std::to_string(count) + " files *" + std::string(suffix) +
                         " beside programs, and " + std::to_string(least) + " are asked for");
    }
  }
  return problems;
}

std::optional<std::string> CheckPhase(const PhaseGolden& golden, Mode mode) {
  Program program{{golden.source}};
  if (!golden.scenario.empty()) {
    const std::optional<Program> named = ProgramOf(golden.scenario);
    if (!named) return golden.scenario.string() + ": names no program";
    program = *named;
  }
  if (golden.phase == kDebug) return CheckDebug(golden, program, mode);
  const ToolResult result = RunTool(golden.file.parent_path(), Command({"print", golden.phase}, program));
  if (result.exit_code != 0) return Failure(golden.file, result);
  return CheckFile(golden.file, result.output, mode);
}

std::vector<std::string> CheckSample(const fs::path& machine, Mode mode) {
  std::vector<fs::path> scenarios = FilesBelow(machine, ".yaml");
  std::erase_if(scenarios, [](const fs::path& file) { return project::IsNoScenario(file.string()); });
  if (scenarios.empty()) return {machine.string() + ": a sample has scenarios"};
  if (!fs::exists(machine / "plcxx.yaml")) return {machine.string() + ": a sample has a plcxx.yaml"};
  const compile::TemporaryDirectory temporary;
  const ToolResult result = RunTool(machine, {"emit", "--quiet", "-o", temporary.path()});  // as plcxx.yaml says
  if (result.exit_code != 0) return {Failure(machine, result)};

  const fs::path generated = machine / "generated";
  std::vector<std::string> problems;
  std::set<std::string> names;
  for (const fs::path& file : FilesBelow(temporary.path(), "")) {
    names.insert(file.filename().string());
    if (const auto problem = CheckFile(generated / file.filename(), ReadFile(file), mode)) problems.push_back(*problem);
  }
  for (const fs::path& file : FilesBelow(generated, "")) {
    if (names.contains(file.filename().string())) continue;
    if (mode == Mode::kUpdate)
      fs::remove(file);
    else
      problems.push_back(file.string() + ": plcxx writes no such file any more");
  }
  return problems;
}

}  // namespace plcxx::golden
