#include "transpiler/lsp/workspace.h"

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <utility>

#include "transpiler/compilation/dialect_choice.h"
#include "transpiler/compilation/source_loading.h"
#include "transpiler/compilation/warning_options.h"
#include "transpiler/lsp/program_options.h"
#include "transpiler/project/project.h"
#include "transpiler/source/find_file.h"
#include "transpiler/source/unsaved.h"
#include "transpiler/support/fault_guard.h"
#include "transpiler/support/read_file.h"

namespace plcxx::lsp {

void Workspace::Configure(const Json& options) {
  for (compilation::CompilationRequest& request : ReadPrograms(options)) {
    auto program = std::make_unique<WorkspaceProgram>();
    program->request = std::move(request);
    programs_.push_back(std::move(program));
  }
}

bool IsMachineFile(const WorkspaceProgram& program, std::string_view identity) {
  return std::ranges::any_of(
      std::initializer_list<const std::string*>{&program.plant, &program.panel},
      [&](const std::string* path) { return !path->empty() && source::FileIdentity(*path) == identity; });
}

FileText Workspace::TextOf(const std::string& path) const {
  if (path.empty()) return {};
  if (const Document* open = documents_.Find(source::FileIdentity(path)); open != nullptr) return {path, open->text};
  std::optional<std::string> text = support::ReadFile(path);
  // That a file which plcxx.yaml names is not there is said in plcxx.yaml.
  if (!text) return {};
  return {path, *std::move(text)};
}

void Workspace::CheckMachine(WorkspaceProgram& program) const {
  const compilation::Compilation& compilation = program.Meaning().compilation();
  if (!answers_.machine_faults || !compilation.ok() || !compilation.has_program) return;
  const std::vector<yaml::Error> faults =
      answers_.machine_faults(TextOf(program.plant), TextOf(program.panel), compilation);
  for (const yaml::Error& fault : faults) {
    std::vector<std::string>& of_file = program.diagnostics[source::FileIdentity(fault.path)];
    for (std::string& one : ProjectFaults({fault})) of_file.push_back(std::move(one));
  }
}

bool Workspace::Reads(const WorkspaceProgram& program, const std::string& identity) {
  if (program.analysis != nullptr && program.analysis->FileOf(identity).valid()) return true;
  if (program.whole != nullptr && program.whole->FileOf(identity).valid()) return true;
  if (IsMachineFile(program, identity)) return true;
  return std::ranges::any_of(program.request.sources, [&](const std::string& path) {
    return source::FileIdentity(compilation::FromBase(program.request.base_directory, path)) == identity;
  });
}

void Workspace::Drop(size_t index) {
  const std::unique_ptr<WorkspaceProgram> gone = std::move(programs_[index]);
  programs_.erase(programs_.begin() + static_cast<ptrdiff_t>(index));
  for (const auto& [file, found] : gone->diagnostics) to_publish_.insert(file);
}

void Workspace::DropSingleFiles() {
  for (size_t i = programs_.size(); i-- > 0;) {
    if (!programs_[i]->is_single_file) continue;
    const std::string identity = source::FileIdentity(programs_[i]->request.sources.front());
    const auto reads_it = [&](const auto& program) { return !program->is_single_file && Reads(*program, identity); };
    if (std::ranges::any_of(programs_, reads_it)) Drop(i);
  }
}

void Workspace::ReadBaselineOf(WorkspaceProgram& program, const std::string& path) {
  std::variant<project::Baseline, yaml::Error> read = project::ReadBaseline(path);
  if (auto* baseline = std::get_if<project::Baseline>(&read)) {
    program.baseline = std::move(*baseline);
    return;
  }
  // What names the file is open in an editor rather than the file itself.
  const yaml::Error& error = std::get<yaml::Error>(read);
  const yaml::Error fault{program.project, {}, ToText(error)};
  std::vector<std::string>& faults = project_faults_[source::FileIdentity(program.project)];
  for (std::string& one : ProjectFaults({fault})) faults.push_back(std::move(one));
}

void Workspace::ReadProjectFile(const std::string& project) {
  for (size_t i = programs_.size(); i-- > 0;) {
    if (programs_[i]->project == project) Drop(i);
  }
  const std::string identity = source::FileIdentity(project);
  to_publish_.insert(identity);
  project_faults_.erase(identity);
  const Document* open = documents_.Find(identity);
  const project::ProjectOrErrors read =
      open != nullptr ? project::ParseProject(project, open->text) : project::ReadProject(project);
  if (const auto* errors = std::get_if<std::vector<yaml::Error>>(&read)) {
    project_faults_[identity] = ProjectFaults(*errors);
    return;
  }
  for (const project::Program& said : std::get<project::Project>(read).programs) {
    auto program = std::make_unique<WorkspaceProgram>();
    program->request = project::RequestOf(said);
    program->project = project;
    program->name = project::NameOf(said);
    program->scenario_paths = said.scenarios;
    program->plant = said.plant;
    program->panel = said.panel;
    if (!said.baseline.empty()) ReadBaselineOf(*program, said.baseline);
    programs_.push_back(std::move(program));
  }
  DropSingleFiles();
}

void Workspace::OpenProjectOf(const std::string& path) {
  const std::optional<std::string> project = project::FindProject(path);
  if (project && projects_.insert(*project).second) ReadProjectFile(*project);
}

void Workspace::Changed(const std::string& identity) {
  const Document* document = documents_.Find(identity);
  if (document != nullptr && std::filesystem::path(identity).filename() == project::kProjectFile) {
    projects_.insert(document->path);
    return ReadProjectFile(document->path);
  }
  bool found = std::ranges::any_of(programs_, [&](const auto& program) { return Reads(*program, identity); });
  if (!found && document != nullptr) OpenProjectOf(document->path);
  for (const auto& program : programs_) {
    const bool reads = Reads(*program, identity);
    // A program that has not been analysed may include the file.
    if (reads || program->analysis == nullptr) program->changed = true;
    found = found || reads;
  }
  if (found || document == nullptr) return;
  const auto text = [&](const std::string&) { return document->text; };
  // A client that names a language has had it from its user.
  const dialects::Dialect* named = dialects::DialectByName(document->language);
  if (named == nullptr && compilation::ChooseDialect({}, {document->path}, text) == nullptr) return;  // none of ours
  auto program = std::make_unique<WorkspaceProgram>();
  if (named != nullptr) program->request.dialect = named->name;
  program->request.sources = {document->path};
  program->is_single_file = true;
  programs_.push_back(std::move(program));
}

void Workspace::Closed(const std::string& identity, const Publish& publish) {
  for (size_t i = programs_.size(); i-- > 0;) {
    if (!Reads(*programs_[i], identity)) continue;
    programs_[i]->changed = true;  // what is on the disk counts again
    if (programs_[i]->is_single_file) Drop(i);
  }
  for (const std::string& project : projects_) {
    if (source::FileIdentity(project) == identity) ReadProjectFile(project);
  }
  PublishWaiting(publish);
}

void Workspace::ChangedOnDisk() {
  for (const std::string& project : projects_) ReadProjectFile(project);
  for (const auto& program : programs_) {
    program->changed = true;
    program->scenarios = std::nullopt;
  }
}

const std::vector<std::string>& Workspace::ScenariosOf(const WorkspaceProgram& program) const {
  if (!program.scenarios) {
    program.scenarios.emplace();
    std::vector<std::string> sources;
    for (const std::string& path : program.request.sources) {
      sources.push_back(source::FileIdentity(compilation::FromBase(program.request.base_directory, path)));
    }
    if (answers_.of_program) program.scenarios = answers_.of_program(program.scenario_paths, sources);
  }
  return *program.scenarios;
}

std::string Workspace::Why(const WorkspaceProgram& program, const std::string& scenario,
                           const std::string& signal) const {
  const source::UnsavedScope scope(program.analysis->unsaved());
  return answers_.why(scenario, signal);
}

void Workspace::PublishWaiting(const Publish& publish) {
  for (const std::string& file : std::exchange(to_publish_, {})) publish(file);
}

void Workspace::Analyse(WorkspaceProgram& program, const Publish& publish) {
  program.changed = false;
  std::unique_ptr<Analysis> before;  // goes when the messages are out
  {
    const support::FaultGuard guard;
    auto analysis = std::make_unique<Analysis>(program.request, program.baseline, documents_, units_, &program.kept);
    if (program.analysis != nullptr && program.analysis->compilation().ok())
      program.whole = std::move(program.analysis);
    before = std::exchange(program.analysis, std::move(analysis));
    if (program.analysis->compilation().ok()) before = std::move(program.whole);
  }
  std::set<std::string> files;
  for (const auto& [file, found] : program.diagnostics) files.insert(file);
  program.diagnostics = DiagnosticsByFile(*program.analysis);
  CheckMachine(program);
  for (const std::string* path : {&program.plant, &program.panel}) {
    if (!path->empty()) files.insert(source::FileIdentity(*path));
  }
  for (const auto& [file, found] : program.diagnostics) files.insert(file);
  for (uint32_t i = 0; i < program.analysis->sources().size(); ++i) {
    files.insert(program.analysis->IdentityOf(source::FileId(i)));
  }
  for (const std::string& file : files) publish(file);
}

bool Workspace::AnalyseNext(const Publish& publish) {
  PublishWaiting(publish);
  for (const auto& program : programs_) {
    if (!program->changed) continue;
    Analyse(*program, publish);
    // What it includes was taken for a program by itself while nobody knew.
    DropSingleFiles();
    PublishWaiting(publish);
    return true;
  }
  return false;
}

WorkspaceProgram* Workspace::ProgramOf(const std::string& identity, const Publish& publish) {
  // What a program includes is known when it has been analysed.
  for (const auto& program : programs_) {
    if (program->analysis == nullptr && program->changed) Analyse(*program, publish);
  }
  for (const auto& program : programs_) {
    if (!Reads(*program, identity)) continue;
    if (program->changed) Analyse(*program, publish);
    return program->analysis == nullptr ? nullptr : program.get();
  }
  return nullptr;
}

std::string Workspace::DiagnosticsOf(std::string_view identity) const {
  const std::string file(identity);
  std::string array = "[";
  std::set<std::string_view> seen;
  const auto add = [&](const FileDiagnostics& by_file) {
    const auto found = by_file.find(file);
    if (found == by_file.end()) return;
    for (const std::string& diagnostic : found->second) {
      // Several programs that read one file find the same in it.
      if (programs_.size() > 1 && !seen.insert(diagnostic).second) continue;
      if (array.size() > 1) array += ',';
      array += diagnostic;
    }
  };
  add(project_faults_);
  for (const auto& program : programs_) add(program->diagnostics);
  return array + "]";
}

}  // namespace plcxx::lsp
