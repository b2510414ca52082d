#include "transpiler/mcp/tools.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <variant>

#include "transpiler/compile/child_process.h"
#include "transpiler/diagnostics/explain.h"
#include "transpiler/dialects/dialect.h"
#include "transpiler/mcp/command.h"
#include "transpiler/mcp/why_tool.h"
#include "transpiler/project/project.h"

namespace plcxx::mcp {
namespace {

namespace fs = std::filesystem;

/// What is shown and not kept is written there.
void RequireRoom(const compile::TemporaryDirectory& temporary) {
  if (!temporary.valid()) throw std::runtime_error("there is no room for a temporary folder");
}

// --- what a folder holds -------------------------------------------------------------------------------------------

constexpr size_t kMaxFilesListed = 2000;
/// Of a language, or of what its sources include.
bool IsSource(std::string_view extension) {
  if (extension == ".inc" || extension == ".h") return true;
  return std::ranges::any_of(dialects::AllDialects(), [&](const dialects::Dialect* dialect) {
    return std::ranges::find(dialect->extensions, extension) != dialect->extensions.end();
  });
}

Json ProjectSchema() {
  return ObjectSchema({{"folder", TextSchema("below the server's folder; else all of it")}}, Json::array());
}

Json ProjectOf(const Workplace& workplace, const std::string& name) {
  Json said = {{"file", name}};
  const project::ProjectOrErrors read = project::ReadProject((fs::path(workplace.folder) / name).string());
  if (const auto* errors = std::get_if<std::vector<yaml::Error>>(&read)) {
    for (const yaml::Error& error : *errors) {
      said["errors"].push_back({{"line", error.mark.line}, {"column", error.mark.column}, {"message", error.message}});
    }
    return said;
  }
  said["programs"] = Json::array();
  for (const project::Program& program : std::get<project::Project>(read).programs) {
    said["programs"].push_back(
        {{"name", project::NameOf(program)}, {"dialect", program.dialect}, {"sources", program.sources}});
  }
  return said;
}

/// Files by what their names say; which of them are one program, a project file or a scenario says.
Json RunProject(const Workplace& workplace, const Json& arguments) {
  const Command command(workplace, arguments, "check");
  const fs::path below =
      fs::path(workplace.folder) / command.Checked(rpc::OptionalText(arguments, "folder").value_or("."));
  Json sources = Json::array(), scenarios = Json::array(), projects = Json::array();
  std::error_code error;
  std::vector<std::string> names;
  for (fs::recursive_directory_iterator entry(below, fs::directory_options::skip_permission_denied, error), end;
       !error && entry != end && names.size() < kMaxFilesListed; entry.increment(error)) {
    const bool hidden = entry->path().filename().string().starts_with('.');
    if (hidden && entry->is_directory(error)) entry.disable_recursion_pending();
    if (!hidden && entry->is_regular_file(error)) {
      names.push_back(fs::relative(entry->path(), workplace.folder, error).string());
    }
  }
  std::ranges::sort(names);
  for (const std::string& name : names) {
    std::string extension = fs::path(name).extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    if (fs::path(name).filename() == "plcxx.yaml") {
      projects.push_back(ProjectOf(workplace, name));
    } else if (extension == ".yaml" && !project::IsNoScenario(name)) {
      scenarios.push_back(name);
    } else if (IsSource(extension)) {
      sources.push_back(name);
    }
  }
  return {{"folder", workplace.folder},
          {"projects", projects},
          {"sources", sources},
          {"scenarios", scenarios},
          {"cutOff", names.size() >= kMaxFilesListed}};
}

// --- a program -----------------------------------------------------------------------------------------------------

Json SourcesSchema() { return ProgramSchema(Json::object(), Json::array()); }

Json RunCheck(const Workplace& workplace, const Json& arguments) {
  Command command(workplace, arguments, "check");
  command.Add("--diagnostics=json");
  command.AddProgram();
  command.AddSources();
  Json result = JsonResultOf(command.Run(), "diagnostics");
  result["ok"] = result["exitCode"] == 0;
  return result;
}

Json ExplainSchema() {
  return ObjectSchema({{"code", TextSchema("of a message: nc110-41; without it all codes are listed")}}, Json::array());
}

Json RunExplain(const Workplace&, const Json& arguments) {
  const auto code = rpc::OptionalText(arguments, "code");
  if (!code) {
    Json codes = Json::array();
    for (const std::string_view known : diag::ExplainedCodes()) codes.push_back(known);
    return {{"codes", codes}};
  }
  const auto page = diag::Explain(*code);
  if (!page) throw rpc::Error(rpc::kInvalidParams, "there is no message '" + *code + "'");
  return {{"code", *code}, {"page", *page}};
}

Json EmitSchema() {
  return ProgramSchema({{"output", TextSchema("folder for the files, below the server's; else they are only shown")},
                        {"name", TextSchema("of the program and its files")}},
                       Json::array());
}

std::string ReadFile(const fs::path& path, size_t most) {
  std::ifstream in(path, std::ios::binary);
  std::string text(most, '\0');
  in.read(text.data(), static_cast<std::streamsize>(most));
  text.resize(static_cast<size_t>(in.gcount()));
  return text;
}

Json RunEmit(const Workplace& workplace, const Json& arguments) {
  Command command(workplace, arguments, "emit");
  command.Add("--diagnostics=json");
  command.AddProgram();
  if (const auto name = rpc::OptionalText(arguments, "name")) {
    command.Add("--name");
    command.AddWord(*name);
  }
  const auto output = rpc::OptionalText(arguments, "output");
  const compile::TemporaryDirectory temporary;
  RequireRoom(temporary);
  command.Add("-o");
  if (output) {
    command.AddPath(*output);
  } else {
    command.Add(temporary.path());
  }
  command.AddSources();
  Json result = JsonResultOf(command.Run(), "diagnostics");
  const fs::path folder = output ? fs::path(workplace.folder) / *output : fs::path(temporary.path());
  Json files = Json::array();
  size_t left = workplace.most_bytes;
  std::vector<fs::path> paths;
  std::error_code error;
  if (result["exitCode"] == 0 && !output) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) paths.push_back(entry.path());
  }
  std::ranges::sort(paths);
  for (const fs::path& path : paths) {
    std::string text = ReadFile(path, left);
    left -= text.size();
    if (left == 0) result["cutOff"] = true;
    files.push_back({{"name", path.filename().string()}, {"text", std::move(text)}});
  }
  if (output) result["output"] = *output;
  if (!output) result["files"] = std::move(files);
  return result;
}

// --- a running program ---------------------------------------------------------------------------------------------

Json SimulateSchema() {
  return ProgramSchema(
      {{"for", TextSchema("simulated time: 100ms, 3s, 2min; 1s if nothing is said")},
       {"watch", TextsSchema("locations to show, up to 16")},
       {"at", TextsSchema("what is written meanwhile: 100ms:I0A3=1")},
       {"force", TextsSchema("what is held against every writer: U4A8=1")},
       {"changes",
        {{"type", "boolean"}, {"description", "only rows in which something changed; true if nothing is said"}}}},
      {"watch"});
}

std::vector<std::string> WordsOf(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

/// The columns of the table that plcxx sim prints; names may have blanks in them.
std::vector<std::string> ColumnsOf(const std::vector<std::string>& watched) {
  std::vector<std::string> columns = {"ms"};
  for (const std::string& words : watched) {
    std::istringstream names(words);
    for (std::string name; std::getline(names, name, ',');) columns.push_back(name);
  }
  return columns;
}

/// A byte is shown as its bits and as a number.
bool AreBitsOf(const std::string& bits, const std::string& number) {
  constexpr size_t kByteBits = 8;
  if (bits.size() != kByteBits || bits.find_first_not_of("01") != std::string::npos) return false;
  return std::to_string(std::strtoul(bits.c_str(), nullptr, 2)) == number;
}

/// Empty: the line is no row of the table.
Json RowOf(const std::string& line, const std::vector<std::string>& columns) {
  const std::vector<std::string> words = WordsOf(line);
  Json row = Json::object();
  size_t at = 0;
  for (const std::string& column : columns) {
    if (at + 1 < words.size() && AreBitsOf(words[at], words[at + 1])) ++at;
    if (at == words.size() || words[at].find_first_not_of("+-.0123456789abefinE") != std::string::npos) return nullptr;
    row[column] = words[at++];
  }
  return at == words.size() ? row : Json(nullptr);
}

Json RunSimulate(const Workplace& workplace, const Json& arguments) {
  Command command(workplace, arguments, "sim");
  command.AddProgram();
  command.Add("--for");
  command.AddWord(rpc::OptionalText(arguments, "for").value_or("1s"));
  if (rpc::OptionalFlag(arguments, "changes").value_or(true)) command.Add("--changes");
  const auto add = [&](const char* key, const char* option) {
    for (const std::string& word : TextsOf(arguments, key)) {
      command.Add(option);
      command.AddWord(word);
    }
  };
  add("watch", "--watch");
  add("at", "--at");
  add("force", "--force");
  command.AddSources();
  const ChildResult run = command.Run();
  Json result = ResultOf(run);
  std::istringstream lines(run.output);
  std::string line;
  const std::vector<std::string> columns = ColumnsOf(TextsOf(arguments, "watch"));
  Json rows = Json::array();
  while (std::getline(lines, line)) {
    if (Json row = RowOf(line, columns); !row.is_null()) rows.push_back(std::move(row));
  }
  result["columns"] = columns;
  result["rows"] = std::move(rows);
  return result;
}

Json TestSchema() {
  return ObjectSchema(
      {{"scenarios", TextsSchema("scenario files, or folders: all *.yaml in them; else those of the project")},
       {"project", TextSchema("a plcxx.yaml, else the one of the folder")},
       {"program", TextSchema("one of the programs of the project")},
       {"engine", TextSchema("sim (the default here), host, all")},
       {"seconds", NumberSchema("of real time, at most; 60 if nothing is said")}},
      Json::array());
}

Json RunTest(const Workplace& workplace, const Json& arguments) {
  Command command(workplace, arguments, "test");
  command.Add("--engine");
  command.AddWord(rpc::OptionalText(arguments, "engine").value_or("sim"));
  command.Add("--jobs");
  command.Add("1");
  const std::vector<std::string> scenarios = TextsOf(arguments, "scenarios");
  if (scenarios.empty()) command.AddProject();
  for (const std::string& scenario : scenarios) command.AddPath(scenario);
  Json result = TextResultOf(command.Run(), "report");
  result["passed"] = result["exitCode"] == 0;
  return result;
}

// --- what a reviewer asks ------------------------------------------------------------------------------------------

Json DiffSchema() {
  return ProgramSchema(
      {{"old", TextSchema("file or folder of the old version")},
       {"new", TextSchema("file or folder of the new version")},
       {"revisions",
        TextSchema(
            "of git instead of old and new: v1.2..HEAD, or v1.2.. for the work tree; HEAD.. if nothing is said")}},
      Json::array());
}

Json RunDiff(const Workplace& workplace, const Json& arguments) {
  Command command(workplace, arguments, "diff");
  command.Add("--format=json");
  command.AddTime(1);
  command.AddProgram();
  const auto revisions = rpc::OptionalText(arguments, "revisions");
  if (revisions || !(arguments.contains("old") || arguments.contains("new"))) {
    command.Add("--git");
    command.AddWord(revisions.value_or("HEAD.."));
    command.AddSources();
    return JsonResultOf(command.Run(), "diff");
  }
  command.AddPath(rpc::TextOf(arguments, "old"));
  command.AddPath(rpc::TextOf(arguments, "new"));
  if (!TextsOf(arguments, "sources").empty()) {
    command.Add("--sources");
    command.AddSources();
  }
  return JsonResultOf(command.Run(), "diff");
}

void Replace(std::string& text, std::string_view what, std::string_view by) {
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
}

Json ProveSchema() {
  return ProgramSchema(
      {{"properties",
        TextsSchema("such as 'never U4A8 and U4A9', or 'I0K1 implies U21K8 within 1 slow'; else those that "
                    "the project names")}},
      Json::array());
}

Json RunProve(const Workplace& workplace, const Json& arguments) {
  Command command(workplace, arguments, "prove");
  command.Add("--format=json");
  command.AddProgram();
  const compile::TemporaryDirectory temporary;
  RequireRoom(temporary);
  const std::string file = temporary.path() + "/properties";
  const std::vector<std::string> properties = TextsOf(arguments, "properties");
  command.AddTime(std::max<size_t>(properties.size(), 1));
  if (!properties.empty()) {
    std::ofstream out(file);
    for (const std::string& property : properties) out << property << '\n';
    command.Add("--property");
    command.Add(file);
  }
  command.AddSources();
  // Lines and columns are those of the argument: the file is nobody's.
  ChildResult run = command.Run();
  Replace(run.output, file, "properties");
  Replace(run.errors, file, "properties");
  return JsonResultOf(run, "proof");
}

Json CrossReferenceSchema() {
  return ProgramSchema({{"signal", TextSchema("only what has this in its address, name or meaning")}}, Json::array());
}

Json PlacesOf(const std::string& line) {
  Json places = Json::array();
  const std::vector<std::string> words = WordsOf(line.substr(line.find(':') + 1));
  std::string file;  // a name may have blanks in it: a place ends with a line
  for (const std::string& word : words) {
    file += (file.empty() ? "" : " ") + word;
    const size_t colon = word.rfind(':');
    if (colon == std::string::npos || colon + 1 == word.size() ||
        word.find_first_not_of("0123456789", colon + 1) != std::string::npos) {
      continue;  // "-": nobody
    }
    const int number = std::atoi(word.c_str() + colon + 1);
    file.resize(file.size() - (word.size() - colon));
    places.push_back({{"file", file}, {"line", number}});
    file.clear();
  }
  return places;
}

Json RunCrossReference(const Workplace& workplace, const Json& arguments) {
  Command command(workplace, arguments, "report");
  command.Add("--cross-reference");
  command.AddProgram();
  command.AddSources();
  const std::string wanted = rpc::OptionalText(arguments, "signal").value_or("");
  const ChildResult run = command.Run();
  Json result = ResultOf(run);
  result["signals"] = Json::array();
  std::istringstream lines(run.output);
  std::string head, written, read;
  while (std::getline(lines, head) && std::getline(lines, written) && std::getline(lines, read)) {
    if (head.find(wanted) == std::string::npos) continue;
    result["signals"].push_back({{"signal", head}, {"written", PlacesOf(written)}, {"read", PlacesOf(read)}});
  }
  return result;
}

Json LadderSchema() {
  return ProgramSchema({{"signal", TextSchema("only the rungs that name this address or symbol")}}, Json::array());
}

Json RunLadder(const Workplace& workplace, const Json& arguments) {
  Command command(workplace, arguments, "report");
  command.Add("--ladder-text");
  if (const auto signal = rpc::OptionalText(arguments, "signal")) {
    command.Add("--signal");
    command.AddWord(*signal);
  }
  command.AddProgram();
  command.AddSources();
  return TextResultOf(command.Run(), "ladder");
}

}  // namespace

std::span<const Tool> Tools() {
  static const Tool kTools[] = {
      {"project", "What the folder holds", "Project files, sources and scenarios of the server's folder", ProjectSchema,
       RunProject},
      {"check", "Check a program", "What is wrong or doubtful in a PLC program, each with file, line and column",
       SourcesSchema, RunCheck},
      {"explain", "Explain a message", "The page of a message: what it means, wrong and right programs", ExplainSchema,
       RunExplain},
      {"emit", "Emit C++", "The C++ that a program becomes; written only where 'output' names a folder", EmitSchema,
       RunEmit, true},
      {"simulate", "Simulate a program", "Runs a program in virtual time and shows locations as rows", SimulateSchema,
       RunSimulate},
      {"test", "Run scenarios", "Runs scenario files; a failure names its step, what was expected and who wrote last",
       TestSchema, RunTest},
      {"why", "Why is a signal so", "Which conditions keep a signal off or on in a state of a scenario, down to inputs",
       WhySchema, RunWhy},
      {"diff", "Compare behaviour", "Which outputs of two versions behave differently: proved equal, or shown by a run",
       DiffSchema, RunDiff},
      {"prove", "Prove properties", "Proves properties for all inputs and all scans, or shows a run that violates them",
       ProveSchema, RunProve},
      {"cross_reference", "Cross reference", "Who writes and who reads each signal, with file and line",
       CrossReferenceSchema, RunCrossReference},
      {"ladder", "Ladder as text", "The rungs of a program as text", LadderSchema, RunLadder},
  };
  return kTools;
}

}  // namespace plcxx::mcp
