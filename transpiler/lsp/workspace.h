// The programs of the client's folders, and which file belongs to which.
//
// A program is a row of the client's initialization options, one of the plcxx.yaml of a file's folder or of one above
// it, or one file that is no part of any. Each is compiled anew after an edit of one of its files, when the client is
// waited for or asks for something.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/lsp/analysis.h"
#include "transpiler/lsp/documents.h"
#include "transpiler/lsp/scenario_answers.h"
#include "transpiler/yaml/place.h"

namespace plcxx::lsp {

/// By FileIdentity; each diagnostic as it is sent: a text costs far less than a tree, and a program may have thousands.
using FileDiagnostics = std::map<std::string, std::vector<std::string>>;

struct WorkspaceProgram {
  compilation::CompilationRequest request;
  std::string name;             // in the project
  project::Baseline baseline;   // warnings that the project accepts
  std::string project;          // path of the plcxx.yaml that says it; empty: none does
  bool is_single_file = false;  // not configured: it goes with its document
  bool changed = true;          // since `analysis`
  std::unique_ptr<Analysis> analysis;
  std::unique_ptr<dialects::Kept> kept;  // of the last analysis for the next one
  /// The last one without errors: names keep their meaning while a statement is being typed.
  std::unique_ptr<Analysis> whole;
  FileDiagnostics diagnostics;
  std::string plant, panel;                                   // files of the machine around it; empty: none
  std::vector<std::string> scenario_paths;                    // files and folders, as the project says
  mutable std::optional<std::vector<std::string>> scenarios;  // those of the program, when somebody has asked

  const Analysis& Meaning() const { return whole != nullptr ? *whole : *analysis; }
};

class Workspace {
 public:
  /// Without answers no scenario is known.
  explicit Workspace(ScenarioAnswers answers = {}) : answers_(std::move(answers)) {}

  using Publish = std::function<void(std::string_view identity)>;

  void SetUnits(Units units) { units_ = units; }
  Units units() const { return units_; }
  /// `initializationOptions` of the client; throws rpc::Error where they are wrong.
  void Configure(const Json& options);

  Documents& documents() { return documents_; }
  const Documents& documents() const { return documents_; }
  /// To be called after a document was opened or changed, by its identity.
  void Changed(const std::string& identity);
  void Closed(const std::string& identity, const Publish& publish);
  /// Files on the disk have changed.
  void ChangedOnDisk();

  /// Programs of the plcxx.yaml that a file belongs to are known from now on, whether it is open or not.
  void OpenProjectOf(const std::string& path);

  /// Analyses one program that has changed; false: there is none.
  bool AnalyseNext(const Publish& publish);
  /// The program that a file belongs to, up to date; null: none.
  WorkspaceProgram* ProgramOf(const std::string& identity, const Publish& publish);
  const std::vector<std::unique_ptr<WorkspaceProgram>>& programs() const { return programs_; }

  /// The scenarios that run a program, as they were on the disk when it was asked first after a change there.
  const std::vector<std::string>& ScenariosOf(const WorkspaceProgram& program) const;
  /// What `plcxx why` says of the texts as they are, saved or not.
  std::string Why(const WorkspaceProgram& program, const std::string& scenario, const std::string& signal) const;

  /// What has been found in a file, by whichever program reads it: an array as JSON.
  std::string DiagnosticsOf(std::string_view identity) const;

 private:
  void PublishWaiting(const Publish& publish);
  /// The programs of a plcxx.yaml, in place of what it said before.
  void ReadProjectFile(const std::string& project);
  /// The accepted warnings of a program; a fault of their file is shown in the plcxx.yaml.
  void ReadBaselineOf(WorkspaceProgram& program, const std::string& path);
  /// A file that has got a program is none by itself.
  void DropSingleFiles();
  void Drop(size_t index);
  void Analyse(WorkspaceProgram& program, const Publish& publish);
  /// What is wrong with its plant and panel goes to its diagnostics.
  void CheckMachine(WorkspaceProgram& program) const;
  FileText TextOf(const std::string& path) const;
  /// Does the program read the file, as far as is known?
  static bool Reads(const WorkspaceProgram& program, const std::string& identity);

  ScenarioAnswers answers_;
  Units units_ = Units::kUtf16;
  Documents documents_;
  std::set<std::string> projects_;  // paths
  FileDiagnostics project_faults_;
  std::set<std::string> to_publish_;  // identities, beside what an analysis publishes
  std::vector<std::unique_ptr<WorkspaceProgram>> programs_;
};

/// Its plant, or its panel; `identity` is a FileIdentity.
bool IsMachineFile(const WorkspaceProgram& program, std::string_view identity);

/// The diagnostics of one compilation.
FileDiagnostics DiagnosticsByFile(const Analysis& analysis);
/// What is wrong with a YAML file, as diagnostics.
std::vector<std::string> ProjectFaults(const std::vector<yaml::Error>& errors);

}  // namespace plcxx::lsp
