#include "transpiler/lsp/workspace.h"

#include <algorithm>
#include <utility>

#include "transpiler/compilation/dialect_choice.h"
#include "transpiler/compilation/source_loading.h"
#include "transpiler/compilation/warning_options.h"
#include "transpiler/lsp/program_options.h"
#include "transpiler/source/find_file.h"
#include "transpiler/support/fault_guard.h"

namespace plcxx::lsp {

void Workspace::Configure(const Json& options) {
  for (compilation::CompilationRequest& request : ReadPrograms(options)) {
    auto program = std::make_unique<WorkspaceProgram>();
    program->request = std::move(request);
    programs_.push_back(std::move(program));
  }
}

bool Workspace::Reads(const WorkspaceProgram& program, const std::string& identity) {
  if (program.analysis != nullptr && program.analysis->FileOf(identity).valid()) return true;
  if (program.whole != nullptr && program.whole->FileOf(identity).valid()) return true;
  return std::ranges::any_of(program.request.sources, [&](const std::string& path) {
    return source::FileIdentity(compilation::FromBase(program.request.base_directory, path)) == identity;
  });
}

void Workspace::Changed(const std::string& identity) {
  bool found = false;
  for (const auto& program : programs_) {
    // A program that has not been analysed may include the file.
    if (!Reads(*program, identity) && program->analysis != nullptr) continue;
    program->changed = true;
    found = found || Reads(*program, identity);
  }
  const Document* document = documents_.Find(identity);
  if (found || document == nullptr) return;
  const auto text = [&](const std::string&) { return document->text; };
  if (compilation::ChooseDialect({}, {document->path}, text) == nullptr) return;  // no language of ours
  auto program = std::make_unique<WorkspaceProgram>();
  program->request.sources = {document->path};
  program->is_single_file = true;
  programs_.push_back(std::move(program));
}

void Workspace::Closed(const std::string& identity, const Publish& publish) {
  for (size_t i = 0; i < programs_.size(); ++i) {
    WorkspaceProgram& program = *programs_[i];
    if (!Reads(program, identity)) continue;
    if (!program.is_single_file) {
      program.changed = true;  // what is on the disk counts again
      continue;
    }
    const std::unique_ptr<WorkspaceProgram> gone = std::move(programs_[i]);
    programs_.erase(programs_.begin() + static_cast<ptrdiff_t>(i--));
    for (const auto& [file, found] : gone->diagnostics) publish(file);
  }
}

void Workspace::ChangedOnDisk() {
  for (const auto& program : programs_) program->changed = true;
}

void Workspace::Analyse(WorkspaceProgram& program, const Publish& publish) {
  program.changed = false;
  {
    const support::FaultGuard guard;
    auto analysis = std::make_unique<Analysis>(program.request, documents_, units_);
    if (program.analysis != nullptr && program.analysis->compilation().ok())
      program.whole = std::move(program.analysis);
    if (analysis->compilation().ok()) program.whole = nullptr;
    program.analysis = std::move(analysis);
  }
  std::set<std::string> files;
  for (const auto& [file, found] : program.diagnostics) files.insert(file);
  program.diagnostics = DiagnosticsByFile(*program.analysis);
  for (const auto& [file, found] : program.diagnostics) files.insert(file);
  for (uint32_t i = 0; i < program.analysis->sources().size(); ++i) {
    files.insert(program.analysis->IdentityOf(source::FileId(i)));
  }
  for (const std::string& file : files) publish(file);
}

bool Workspace::AnalyseNext(const Publish& publish) {
  for (const auto& program : programs_) {
    if (!program->changed) continue;
    Analyse(*program, publish);
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

Json Workspace::DiagnosticsOf(std::string_view identity) const {
  Json all = Json::array();
  for (const auto& program : programs_) {
    const auto found = program->diagnostics.find(std::string(identity));
    if (found == program->diagnostics.end()) continue;
    for (const Json& diagnostic : found->second) {
      if (programs_.size() == 1 || std::ranges::find(all, diagnostic) == all.end()) all.push_back(diagnostic);
    }
  }
  return all;
}

}  // namespace plcxx::lsp
