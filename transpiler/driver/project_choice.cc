#include "transpiler/driver/project_choice.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <utility>
#include <variant>

#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/driver/diagnostics_documents.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/gathered_output.h"
#include "transpiler/driver/output_files.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/support/listed.h"
#include "transpiler/support/near_words.h"

namespace plcxx::driver {
namespace {

bool NamesProject(const CommonOptions& options) {
  return !options.project.empty() || !options.program_names.empty() || options.all;
}

std::vector<std::string> NamesOf(const project::Project& project) {
  std::vector<std::string> names;
  for (const project::Program& program : project.programs) names.push_back(project::NameOf(program));
  return names;
}

/// nullptr: reported.
const project::Program* ProgramOf(const project::Project& project, const std::string& name) {
  const project::Program* program = project::FindProgram(project, name);
  if (program != nullptr) return program;
  const std::vector<std::string> names = NamesOf(project);
  PrintUsageError("there is no program '" + name + "' in " + project.path + support::ThereAre(name, names));
  return nullptr;
}

/// Those that have a folder of their own, with the current directory in it.
std::vector<project::Program> ProgramsHere(const project::Project& project) {
  std::error_code error;
  const std::filesystem::path here = std::filesystem::weakly_canonical(".", error);
  std::vector<project::Program> found;
  for (const project::Program& program : project.programs) {
    if (program.folder == project.folder) continue;
    const std::filesystem::path folder =
        std::filesystem::weakly_canonical(program.folder.empty() ? "." : program.folder, error);
    if (project::IsBelow(here, folder)) found.push_back(program);
  }
  return found;
}

struct ProgramValue {
  std::string program, text;
};

/// What reads JSON reads one value: an array, in which each says of which program it is, or one log with a run for
/// each. A program of which nothing was found out has printed none.
std::string OneValue(std::vector<ProgramValue> values, Result result) {
  using Json = nlohmann::ordered_json;
  std::erase_if(values, [](const ProgramValue& value) { return value.text.empty(); });
  Json all = Json::array();
  for (const ProgramValue& value : values) {
    Json one = Json::parse(value.text);
    if (result == Result::kSarif) {
      Json& run = one["runs"][0];
      run["automationDetails"] = {{"id", value.program + "/"}};  // what is shown of one run does not replace another's
      if (all.empty()) {
        all = std::move(one);
      } else {
        all["runs"].push_back(std::move(run));
      }
    } else {
      Json named = {{"program", value.program}};
      named.update(one);
      all.push_back(std::move(named));
    }
  }
  return diag::JsonForTerminals(all.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace

std::optional<std::vector<project::Program>> ChoosePrograms(CommonOptions& options) {
  if (options.all && !options.program_names.empty()) {
    PrintUsageError("--all takes every program, --program one of them: leave one of the two out");
    return std::nullopt;
  }
  if (options.project.empty()) {
    const std::optional<std::string> found = project::FindProject(".");
    if (!found) {
      PrintUsageError("no sources are named, and there is no " + std::string(project::kProjectFile) +
                      " here or above; plcxx init makes one");
      return std::nullopt;
    }
    options.project = *found;
  }
  project::ProjectOrErrors read = project::ReadProject(
      options.project, options.allow_outside ? project::Reach::kAnywhere : project::Reach::kProject);
  if (const auto* errors = std::get_if<std::vector<yaml::Error>>(&read)) {
    for (const yaml::Error& error : *errors) std::cerr << ToText(error) << '\n';
    return std::nullopt;
  }
  auto& project = std::get<project::Project>(read);
  if (!options.program_names.empty()) {
    std::vector<project::Program> chosen;
    for (const std::string& name : options.program_names) {
      const project::Program* program = ProgramOf(project, name);
      if (program == nullptr) return std::nullopt;
      const bool is_chosen = std::ranges::any_of(
          chosen, [&name](const project::Program& other) { return project::NameOf(other) == name; });
      if (!is_chosen) chosen.push_back(*program);
    }
    return chosen;
  }
  if (options.all || project.programs.size() == 1) return std::move(project.programs);
  std::vector<project::Program> here = ProgramsHere(project);
  if (here.size() == 1) return here;
  PrintUsageError("which program? --program NAME takes one of them, --all every one: " +
                  support::CommaSeparated(NamesOf(project)));
  return std::nullopt;
}

int ForEachProgram(const CommonOptions& options, const std::function<int(const CommonOptions&)>& command,
                   Result result) {
  if (!options.sources.empty()) {
    if (!NamesProject(options)) return command(options);
    return UsageError("sources and a project are named: leave one of them out");
  }
  CommonOptions own = options;
  const std::optional<std::vector<project::Program>> programs = ChoosePrograms(own);
  if (!programs) return kWrongUse;
  int code = kDone;
  const DiagnosticsDocuments as_one;
  own.is_one_of_several = programs->size() > 1;
  const bool as_value = own.is_one_of_several && (result == Result::kJson || result == Result::kSarif);
  std::vector<ProgramValue> values;
  for (const project::Program& program : *programs) {
    own.program = program;
    std::optional<OutputsOfProgram> outputs;
    if (own.is_one_of_several) outputs.emplace(project::NameOf(program));
    if (own.is_one_of_several && result == Result::kUnnamed) std::cout << project::NameOf(program) << ":\n";
    const GatheredOutput gathered(as_value);
    code = std::max(code, command(own));
    if (as_value) values.push_back({project::NameOf(program), gathered.text()});
  }
  if (as_value) std::cout << OneValue(values, result);
  return code;
}

std::string FolderOf(const CommonOptions& common, const std::string& folder) {
  if (folder.empty() || !common.is_one_of_several) return folder;
  return (std::filesystem::path(folder) / project::NameOf(*common.program)).generic_string();
}

void NameProject(CommonOptions& common) {
  if (common.sources.size() != 1) return;
  const std::filesystem::path path = common.sources.front();
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    common.project = (path / project::kProjectFile).generic_string();
  } else if (path.filename() == project::kProjectFile) {
    common.project = path.generic_string();
  } else {
    return;
  }
  common.sources.clear();
}

}  // namespace plcxx::driver
