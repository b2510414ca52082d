#include "transpiler/project/project.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

#include "transpiler/compilation/source_loading.h"
#include "transpiler/compilation/warning_options.h"
#include "transpiler/project/program.h"
#include "transpiler/project/values.h"
#include "transpiler/yaml/document.h"

namespace plcxx::project {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxProjectBytes = 1u << 20;
constexpr size_t kMaxWords = 100'000;

std::vector<yaml::Error> Refuse(const std::string& path, yaml::Fault fault) {
  return {{path, fault.mark, std::move(fault.message)}};
}

/// Two programs of one name are one too many: --program could not name them.
void CheckNames(const Project& project, const std::vector<yaml::Place>& marks, yaml::Reader& reader) {
  std::map<std::string, size_t> seen;
  for (size_t i = 0; i < project.programs.size(); ++i) {
    const auto [it, first] = seen.emplace(NameOf(project.programs[i]), i);
    if (first) continue;
    reader.Fail(marks[i], "a second program called '" + it->first + "'", "give each its own 'name'");
  }
}

}  // namespace

bool IsNoScenario(const std::string& path) {
  const std::string name = fs::path(path).filename().string();
  if (name == kProjectFile) return true;
  for (const std::string_view own : {"plant.yaml", "panel.yaml"}) {
    if (name == own || name.ends_with("." + std::string(own))) return true;
  }
  return false;
}

std::optional<std::string> FindProject(const std::string& path) {
  std::error_code error;
  fs::path folder = fs::is_directory(path, error) ? fs::path(path) : fs::path(path).parent_path();
  const bool is_relative = folder.is_relative();
  fs::path absolute = fs::absolute(folder.empty() ? fs::path(".") : folder, error).lexically_normal();
  if (absolute.filename().empty()) absolute = absolute.parent_path();
  for (;; absolute = absolute.parent_path()) {
    const fs::path file = absolute / kProjectFile;
    if (fs::is_regular_file(file, error)) {
      const fs::path working = fs::current_path(error);
      return is_relative ? file.lexically_relative(working).generic_string() : file.generic_string();
    }
    if (IsVersioned(absolute.string()) || absolute == absolute.parent_path()) return std::nullopt;
  }
}

ProjectOrErrors ReadProject(const std::string& path, Reach reach) {
  std::variant<std::string, yaml::Fault> text = yaml::ReadText(path, kMaxProjectBytes, "project");
  if (auto* fault = std::get_if<yaml::Fault>(&text)) return Refuse(path, std::move(*fault));
  return ParseProject(path, std::get<std::string>(text), reach);
}

ProjectOrErrors ParseProject(const std::string& path, const std::string& text, Reach reach) {
  std::variant<YAML::Node, yaml::Fault> root = yaml::Load(text);
  if (auto* fault = std::get_if<yaml::Fault>(&root)) return Refuse(path, std::move(*fault));
  if (std::get<YAML::Node>(root).IsNull()) return Refuse(path, {{}, "the file says nothing: 'sources' is missing"});
  yaml::Reader reader(path, kMaxWords);
  std::vector<NamedValue> keys = ReadKeys(std::get<YAML::Node>(root), reader);
  Project project{.path = path, .folder = fs::path(path).parent_path().string(), .programs = {}};
  const auto programs = std::ranges::find(keys, Key::kPrograms, [](const NamedValue& key) { return key.row->key; });
  std::vector<yaml::Place> marks;
  if (!reader.errors().empty()) return std::move(reader.errors());  // what is built on it would be told twice
  if (programs == keys.end()) {
    project.programs.push_back(MakeProgram(keys, yaml::Reader::Mark(std::get<YAML::Node>(root)), reach, reader));
    if (!reader.errors().empty()) return std::move(reader.errors());
    return project;
  }
  const std::vector<NamedValue> own = std::move(programs->value.entries);
  keys.erase(programs);
  for (const NamedValue& program : own) {
    project.programs.push_back(MakeProgram(Merged(keys, program.value.entries), program.value.mark, reach, reader));
    marks.push_back(program.value.mark);
  }
  CheckNames(project, marks, reader);
  if (!reader.errors().empty()) return std::move(reader.errors());
  return project;
}

compilation::CompilationRequest RequestOf(const Program& program) {
  compilation::CompilationRequest request;
  request.sources = program.sources;
  request.dialect = program.dialect;
  if (!program.encoding.empty()) request.encoding = source::EncodingByName(program.encoding);
  request.options = program.options;
  std::vector<std::string> unknown;  // none: the reader has looked
  request.warnings = compilation::ReadWarningOptions(program.warnings, unknown);
  request.base_directory = program.folder;
  request.include_directories = program.include;
  request.system_include_directories = program.system_include;
  request.macros = program.macros;
  request.name = program.name;
  return request;
}

std::string NameOf(const Program& program) {
  if (!program.name.empty()) return program.name;
  const std::string folder = fs::path(program.folder).filename().string();
  if (!folder.empty() && folder != "." && folder != "..") return folder;
  return program.sources.empty() ? std::string() : fs::path(program.sources.front()).stem().string();
}

const Program* FindProgram(const Project& project, std::string_view name) {
  for (const Program& program : project.programs) {
    if (NameOf(program) == name) return &program;
  }
  return nullptr;
}

}  // namespace plcxx::project
