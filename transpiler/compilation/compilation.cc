#include "transpiler/compilation/compilation.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "transpiler/checks/checks.h"
#include "transpiler/compilation/estimates.h"
#include "transpiler/compilation/option_check.h"
#include "transpiler/compilation/source_loading.h"
#include "transpiler/emit/legalize/names.h"
#include "transpiler/ir/verifier.h"
#include "transpiler/passes/complete_facts.h"
#include "transpiler/passes/nest_blocks.h"
#include "transpiler/passes/pipeline.h"
#include "transpiler/passes/structure.h"
#include "transpiler/source/characters.h"
#include "transpiler/source/decode.h"
#include "transpiler/support/check.h"
#include "transpiler/support/fnv1a.h"
#include "transpiler/support/hex.h"

namespace plcxx::compilation {
namespace {

void CheckIr(const ir::Program& program, ir::Stage stage) {
  const std::vector<std::string> broken = ir::Verify(program, stage);
  if (!broken.empty()) support::InternalFault(broken.front().c_str(), __FILE__, __LINE__);
}

/// Six digits that tell names apart.
std::string HashDigits(std::string_view name) {
  uint32_t hash = support::HashOf32(name);
  std::string digits;
  for (hash ^= hash >> 24; digits.size() < 6; hash >>= 4) digits += support::kHexDigits[hash & 15];
  return digits;
}

/// The stem of the first logic source: of the file that holds the first statement, because a file of names has none.
std::string DefaultName(const Compilation& compilation) {
  const ir::Program& program = compilation.program;
  source::FileId file = compilation.files.front();
  if (!program.statements.empty()) {
    // A file that a source includes does not name the program.
    const source::FileId first = compilation.sources->FileAt(program.statements[ir::StatementId(0)].range.begin);
    if (std::ranges::find(compilation.files, first) != compilation.files.end()) file = first;
  }
  const std::string& path = compilation.sources->Get(file).path;
  if (path.starts_with('<')) return "program";  // standard input
  const std::string stem = std::filesystem::path(path).stem().string();
  return NameFrom(stem);
}

bool IsOn(const std::map<std::string, std::string>& options, const std::string& key) {
  const auto option = options.find(key);
  return option != options.end() && (option->second == "on" || option->second == "true");
}

bool AssertsFacts(const ir::Program& program) {
  if (!ir::FalseFactOf(program).valid()) return false;
  return std::ranges::any_of(program.insts, [&](const ir::Inst& inst) { return ir::IsFalseFact(program, inst); });
}

/// The phases up to `until`; each is left out after an error in one before it.
class Pipeline {
 public:
  Pipeline(const CompilationRequest& request, Stage until, Compilation& compilation)
      : request_(request), until_(until), compilation_(compilation) {}

  void Run() {
    Load();
    if (Reach(Stage::kLoaded)) Lower();
    if (Reach(Stage::kLowered)) Structure();
    if (Reach(Stage::kStructured)) Check();
    if (Reach(Stage::kChecked)) Optimize();
    Reach(Stage::kOptimized);
  }

 private:
  /// Ends `stage`; true when the next one is wanted and can be done.
  bool Reach(Stage stage) {
    if (stopped_ || !compilation_.ok()) {
      stopped_ = true;
      return false;
    }
    compilation_.reached = stage;
    stopped_ = stage == until_;
    return !stopped_;
  }
  void Show(std::string_view phase) const {
    if (request_.progress) request_.progress(phase);
  }

  void Load();
  void Lower();
  void Structure();
  void Estimate();
  void Check();
  void Optimize();

  const CompilationRequest& request_;
  Stage until_;
  Compilation& compilation_;
  bool stopped_ = false;
};

void Pipeline::Load() {
  Show("reading");
  LoadSources(request_, compilation_);
  if (compilation_.dialect == nullptr) return;
  const uint32_t before = compilation_.diagnostics.error_count();
  for (const auto& [name, value] : request_.options) {
    // The one option that is the same in every dialect: it is about how plcxx decides, not about a control.
    if (name == kFactsOption) {
      compilation_.facts = ReadFacts(value, compilation_.diagnostics);
      continue;
    }
    SetOption(*compilation_.dialect, name, value, compilation_.options);
  }
  compilation_.dialect->check_options(compilation_.options, compilation_.diagnostics);
  if (!request_.macros.empty() && !compilation_.dialect->takes_macros) {
    compilation_.diagnostics.Report({}, diag::UnknownOption, request_.macros.front().text ? "-D" : "-U",
                                    compilation_.dialect->name, "those of --set, and -I", "");
  }
  if (!request_.system_include_directories.empty() && !compilation_.dialect->takes_system_includes) {
    compilation_.diagnostics.Report({}, diag::UnknownOption, "--system-include", compilation_.dialect->name,
                                    "those of --set, and -I", "");
  }
  if (compilation_.diagnostics.error_count() > before) compilation_.wrong_use = true;
}

void Pipeline::Lower() {
  Show("translating");
  dialects::Request request = compilation_.MakeRequest();
  request.lists = request_.lists;
  request.kept = request_.kept;
  dialects::Lowered lowered = compilation_.dialect->lower(request);
  // More sources than a program of the language has: the command line is wrong, not the program.
  compilation_.wrong_use = std::ranges::any_of(compilation_.diagnostics.all(), [](const diag::Diagnostic& diagnostic) {
    return diagnostic.row->code == diag::HncOneSource.row.code;
  });
  compilation_.program = std::move(lowered.program);
  compilation_.summary = std::move(lowered.summary);
  compilation_.data_files = std::move(lowered.data_files);
  compilation_.has_program = lowered.has_program;
  compilation_.name = request_.name.empty() ? DefaultName(compilation_) : request_.name;
  compilation_.program.name = compilation_.name;
  if (compilation_.ok()) CheckIr(compilation_.program, ir::Stage::kLowered);
}

void Pipeline::Structure() {
  Show("structuring");
  passes::Structure(compilation_.program);
  passes::NestBlocks(compilation_.program);
  passes::CompleteFacts(compilation_.program);
  CheckIr(compilation_.program, ir::Stage::kStructured);
}

/// Assertions cost time that no machine ever spends: periods, limits and slices are those of the program without them.
void Pipeline::Estimate() {
  if (!AssertsFacts(compilation_.program)) return EstimateCosts(compilation_);
  CompilationRequest request = request_;
  request.progress = {};
  request.kept = nullptr;
  std::erase_if(request.options, [](const auto& option) { return option.first == kFactsOption; });
  Compilation shipped = Compile(request, Stage::kStructured);
  EstimateCosts(shipped);
  TakeCosts(compilation_, shipped);
}

void Pipeline::Check() {
  Show("checking");
  Estimate();  // before the checks: one of them asks for the number of slices
  checks::RunAll(compilation_.program, compilation_.dialect->lints, compilation_.diagnostics);
  CheckBudgets(compilation_);
}

void Pipeline::Optimize() {
  Show("optimizing");
  OptimizeProgram(compilation_);
}

}  // namespace

std::string NameFrom(std::string_view text) {
  if (source::IsAscii(text)) return emit::legalize::SafeIdentifier(text);
  // Names in other scripts are written in Latin letters; what tells them apart may get lost in that, so that a few
  // digits of the name's hash follow.
  return emit::legalize::SafeIdentifier(source::InLatinLetters(text) + "_" + HashDigits(text));
}

void OptimizeProgram(Compilation& compilation) {
  passes::Optimize(compilation.program);
  CutSlices(compilation);  // last: what it puts around the pieces is no statement's
  CheckIr(compilation.program, ir::Stage::kStructured);
  compilation.reached = Stage::kOptimized;
}

dialects::Request Compilation::MakeRequest() {
  dialects::Request request;
  request.sources = sources.get();
  request.files = files;
  request.options = options;
  request.load = load;
  request.diagnostics = &diagnostics;
  request.encoding = encoding;
  request.include_directories = include_directories;
  request.system_include_directories = system_include_directories;
  request.macros = macros;
  request.facts = facts;
  return request;
}

Compilation Compile(const CompilationRequest& request, Stage until) {
  Compilation compilation;
  compilation.sources = std::make_unique<source::SourceManager>();
  compilation.diagnostics = diag::Engine(request.warnings);
  compilation.encoding = request.encoding;
  compilation.include_directories = request.include_directories;
  compilation.system_include_directories = request.system_include_directories;
  compilation.macros = request.macros;
  Pipeline(request, until, compilation).Run();
  ReportUnread(compilation);  // at the end: the dialect loads files, too
  compilation.diagnostics.SortBySource();
  if (IsOn(compilation.options, "stop-on-error")) compilation.diagnostics.KeepFirstErrorOnly();
  return compilation;
}

}  // namespace plcxx::compilation
