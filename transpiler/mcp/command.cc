#include "transpiler/mcp/command.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <variant>

#include "transpiler/project/project.h"
#include "transpiler/source/find_file.h"

namespace plcxx::mcp {
namespace {

[[noreturn]] void Refuse(const std::string& why) { throw rpc::Error(rpc::kInvalidParams, why); }

std::string OptionText(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  if (value.is_number()) return value.dump();
  Refuse("an option is neither a text nor a number nor true or false");
}

}  // namespace

Json TextSchema(std::string_view description) { return {{"type", "string"}, {"description", description}}; }
Json TextsSchema(std::string_view description) {
  return {{"type", "array"}, {"items", {{"type", "string"}}}, {"description", description}};
}
Json NumberSchema(std::string_view description) { return {{"type", "integer"}, {"description", description}}; }

Json ObjectSchema(Json properties, Json required) {
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"required", std::move(required)},
          {"additionalProperties", false}};
}

Json ProgramSchema(const Json& more, Json required) {
  Json properties = {
      {"sources",
       TextsSchema("the files of one program, in their order, relative to the server's folder; else plcxx.yaml")},
      {"project", TextSchema("a plcxx.yaml that says sources and options; else that of the server's folder")},
      {"program", TextSchema("which program of plcxx.yaml, where it has several")},
      {"dialect",
       TextSchema("nc110, technol, host50, prostep, hnc or classicladder; else told by extension, then by content")},
      {"options", {{"type", "object"}, {"description", "options of the dialect, as --set key=value"}}},
      {"encoding", TextSchema("of the sources: utf-8, cp866, gb18030, ...; else detected")},
      {"include", TextsSchema("folders where files that options or sources name are looked for")},
      {"define", TextsSchema("macros of dialect hnc, NAME or NAME=TEXT")},
      {"seconds", NumberSchema("of real time, at most; 60 if nothing is said")}};
  properties.update(more);
  return ObjectSchema(std::move(properties), std::move(required));
}

std::vector<std::string> TextsOf(const Json& arguments, const char* key) {
  std::vector<std::string> texts;
  if (!arguments.contains(key) || arguments[key].is_null()) return texts;
  for (const Json& text : rpc::ArrayOf(arguments, key)) {
    if (!text.is_string()) Refuse("'" + std::string(key) + "' holds something that is not a string");
    texts.push_back(text.get<std::string>());
  }
  return texts;
}

Command::Command(const Workplace& workplace, const Json& arguments, std::string_view subcommand)
    : workplace_(workplace), arguments_(arguments), words_{workplace.plcxx, std::string(subcommand)} {
  const int64_t seconds = rpc::OptionalNumber(arguments, "seconds").value_or(60);
  if (seconds < 1) Refuse("'seconds' is a number from 1");
  seconds_ = static_cast<int>(std::min<int64_t>(seconds, workplace.most_seconds));
}

std::string Command::Checked(const std::string& path) const {
  if (path.empty() || path.starts_with('-')) Refuse("'" + path + "' names no file");
  const std::filesystem::path whole = std::filesystem::path(workplace_.folder) / path;
  if (!source::LiesBelow(whole.string(), workplace_.folder)) {
    Refuse("'" + path + "' is outside of the server's folder");
  }
  return path;
}

void Command::AddPath(const std::string& path) { words_.push_back(Checked(path)); }

void Command::AddWord(const std::string& word) {
  if (word.empty() || word.starts_with('-')) Refuse("'" + word + "' is not a value here");
  words_.push_back(word);
}

void Command::AddSources() {
  const std::vector<std::string> sources = TextsOf(arguments_, "sources");
  if (sources.empty()) return AddProject();
  for (const std::string& source : sources) AddPath(source);
}

/// Named in any case: without a name plcxx would look above the server's folder, too.
void Command::AddProject() {
  const std::string project = rpc::OptionalText(arguments_, "project").value_or("plcxx.yaml");
  Add("--project");
  AddPath(project);
  if (!std::filesystem::is_regular_file(std::filesystem::path(workplace_.folder) / project)) {
    Refuse("'sources' names no file, and there is no " + project);
  }
  if (const auto program = rpc::OptionalText(arguments_, "program")) {
    Add("--program");
    AddWord(*program);
  }
}

void Command::AddTime(size_t questions) {
  constexpr int64_t kMsPerSecond = 1000;
  // The rest is for compiling, and for saying what was found.
  const int64_t ms = seconds_ * kMsPerSecond * 3 / 4 / static_cast<int64_t>(questions);
  words_.push_back("--time=" + std::to_string(std::max<int64_t>(ms, 1)) + "ms");
}

void Command::AddProgram() {
  if (const auto dialect = rpc::OptionalText(arguments_, "dialect")) {
    Add("--dialect");
    AddWord(*dialect);
  }
  if (const auto encoding = rpc::OptionalText(arguments_, "encoding")) {
    Add("--encoding");
    AddWord(*encoding);
  }
  for (const std::string& directory : TextsOf(arguments_, "include")) {
    Add("-I");
    AddPath(directory);
  }
  for (const std::string& macro : TextsOf(arguments_, "define")) {
    Add("-D");
    AddWord(macro);
  }
  if (!arguments_.contains("options") || arguments_["options"].is_null()) return;
  const std::vector<std::filesystem::path> folders = FoldersOfOptions();
  for (const auto& [key, value] : rpc::ObjectOf(arguments_, "options").items()) {
    const std::string setting = key + "=" + OptionText(value);
    // Which of them name files is the dialect's to know, which may only be told by the sources: no value may lead
    // outside.
    const std::string named = setting.substr(setting.find('=') + 1);
    if (named.starts_with('-')) Refuse("'" + named + "' is not a value here");
    for (const std::filesystem::path& folder : folders) {
      if (!source::LiesBelow((folder / named).string(), workplace_.folder)) {
        Refuse("'" + named + "' is outside of the server's folder");
      }
    }
    Add("--set");
    AddWord(setting);
  }
}

std::vector<std::filesystem::path> Command::FoldersOfOptions() const {
  const std::filesystem::path whole = workplace_.folder;
  std::vector<std::filesystem::path> folders = {whole};
  for (const std::string& folder : TextsOf(arguments_, "include")) folders.push_back(whole / folder);
  if (!TextsOf(arguments_, "sources").empty()) return folders;
  const std::filesystem::path project = whole / rpc::OptionalText(arguments_, "project").value_or("plcxx.yaml");
  const project::ProjectOrErrors read = project::ReadProject(project.string());
  const auto* found = std::get_if<project::Project>(&read);
  if (found == nullptr) return folders;  // no program is made of it
  for (const project::Program& program : found->programs) {
    folders.emplace_back(program.folder);
    folders.insert(folders.end(), program.include.begin(), program.include.end());
  }
  return folders;
}

ChildResult Command::Run() const {
  return RunChild(words_, workplace_.folder, {.seconds = seconds_, .output_bytes = workplace_.most_bytes});
}

Json ResultOf(const ChildResult& run) {
  Json result = {{"exitCode", run.exit_code}};
  if (run.timed_out) result["timedOut"] = true;
  if (run.cut_off) result["cutOff"] = true;
  if (!run.errors.empty()) result["messages"] = run.errors;
  return result;
}

Json JsonResultOf(const ChildResult& run, const char* key) {
  Json result = ResultOf(run);
  Json output = Json::parse(run.output, nullptr, false);
  if (output.is_discarded()) {
    if (!run.output.empty()) result["output"] = run.output;
  } else {
    result[key] = std::move(output);
  }
  return result;
}

Json TextResultOf(const ChildResult& run, const char* key) {
  Json result = ResultOf(run);
  result[key] = run.output;
  return result;
}

}  // namespace plcxx::mcp
