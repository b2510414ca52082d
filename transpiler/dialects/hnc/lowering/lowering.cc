#include "transpiler/dialects/hnc/lowering/lowering.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "transpiler/dialects/hnc/analysis/checks.h"
#include "transpiler/dialects/hnc/lowering/accesses.h"
#include "transpiler/dialects/hnc/lowering/addresses.h"
#include "transpiler/dialects/hnc/lowering/branches.h"
#include "transpiler/dialects/hnc/lowering/calls.h"
#include "transpiler/dialects/hnc/lowering/cell_places.h"
#include "transpiler/dialects/hnc/lowering/conversions.h"
#include "transpiler/dialects/hnc/lowering/critical_sections.h"
#include "transpiler/dialects/hnc/lowering/dispatcher.h"
#include "transpiler/dialects/hnc/lowering/expressions.h"
#include "transpiler/dialects/hnc/lowering/faults.h"
#include "transpiler/dialects/hnc/lowering/functions.h"
#include "transpiler/dialects/hnc/lowering/gotos.h"
#include "transpiler/dialects/hnc/lowering/handlers.h"
#include "transpiler/dialects/hnc/lowering/host_calls.h"
#include "transpiler/dialects/hnc/lowering/initialisers.h"
#include "transpiler/dialects/hnc/lowering/intervals.h"
#include "transpiler/dialects/hnc/lowering/jumps.h"
#include "transpiler/dialects/hnc/lowering/library_calls.h"
#include "transpiler/dialects/hnc/lowering/live_path.h"
#include "transpiler/dialects/hnc/lowering/locals.h"
#include "transpiler/dialects/hnc/lowering/loop_bounds.h"
#include "transpiler/dialects/hnc/lowering/loop_paths.h"
#include "transpiler/dialects/hnc/lowering/loops.h"
#include "transpiler/dialects/hnc/lowering/memory.h"
#include "transpiler/dialects/hnc/lowering/operators.h"
#include "transpiler/dialects/hnc/lowering/pointers.h"
#include "transpiler/dialects/hnc/lowering/records.h"
#include "transpiler/dialects/hnc/lowering/reference_writer.h"
#include "transpiler/dialects/hnc/lowering/returns.h"
#include "transpiler/dialects/hnc/lowering/schedule.h"
#include "transpiler/dialects/hnc/lowering/stated_facts.h"
#include "transpiler/dialects/hnc/lowering/statement_writer.h"
#include "transpiler/dialects/hnc/lowering/statements.h"
#include "transpiler/dialects/hnc/lowering/switches.h"
#include "transpiler/dialects/hnc/lowering/symbols.h"
#include "transpiler/dialects/hnc/lowering/system_calls.h"
#include "transpiler/dialects/hnc/lowering/system_routines.h"
#include "transpiler/support/beside_work.h"

namespace plcxx::hnc {

namespace {

using HasErrors = std::function<bool()>;

/// The collaborators of one lowering. Each is given those that it uses, and no other; those that evaluate expressions
/// and those that lower statements use each other, as the language nests them.
class Lowering {
 public:
  Lowering(Scope scope, const Unit& unit, const Objects& objects, const Facts& facts, const Settings& settings,
           const source::SourceManager& sources, diag::Engine& diagnostics)
      : scope_(scope), translation_(unit, objects, facts, settings, sources, diagnostics) {}

  /// `has_errors`: whether something else has found that the program is wrong; asked when all functions are lowered.
  ir::Program Run(const HasErrors& has_errors);
  /// Of the program that Run has given.
  ir::Reference Describe(const ir::Program& program) const { return reference_.Describe(program); }

 private:
  Scope scope_;
  Translation translation_;
  Context context_{translation_};

  StatedFacts stated_{context_};
  HostCalls host_calls_{context_};
  CriticalSections critical_{context_, host_calls_, memory_};
  Faults faults_{context_, host_calls_, memory_};
  Memory memory_{context_};
  CellPlaces places_{context_, memory_};
  Locals locals_{context_};
  Symbols symbols_{context_, memory_};
  Jumps jumps_{context_};
  LivePath path_{context_};
  Intervals intervals_{context_};
  LoopPaths paths_{context_, jumps_};
  LoopBounds loop_bounds_{context_, jumps_, intervals_, paths_};
  StatementWriter writer_{context_};
  Conversions conversions_{context_, stated_};
  Operators operators_{context_, stated_, faults_, conversions_};
  Pointers pointers_{context_, conversions_};
  Accesses accesses_{context_, stated_, faults_, places_, locals_, intervals_, conversions_, operators_, pointers_};
  Records records_{context_, places_, locals_, accesses_};
  Addresses addresses_{context_,  locals_,  intervals_,   conversions_, pointers_,
                       accesses_, records_, expressions_, calls_};
  Expressions expressions_{context_,   stated_,   locals_,   intervals_, conversions_,
                           operators_, pointers_, accesses_, addresses_, calls_};
  Calls calls_{context_, intervals_, conversions_, pointers_, records_, addresses_, expressions_, system_calls_};
  SystemCalls system_calls_{context_,     stated_,      host_calls_,      faults_,  locals_,  intervals_,
                            conversions_, expressions_, system_routines_, library_, handlers_};
  SystemRoutines system_routines_{context_, memory_, places_, locals_};
  LibraryCalls library_{context_,  faults_,   locals_,    intervals_,  conversions_,
                        pointers_, accesses_, addresses_, expressions_};
  Handlers handlers_{context_, memory_};
  Dispatcher dispatcher_{context_, memory_, locals_, handlers_};
  Schedule schedule_{context_, host_calls_,      critical_, faults_,    memory_,
                     places_,  system_routines_, handlers_, dispatcher_};
  Loops loops_{context_, faults_, jumps_, path_, intervals_, loop_bounds_, writer_, expressions_, statements_};
  Gotos gotos_{context_, stated_, faults_, locals_, jumps_, path_, intervals_, loop_bounds_, loops_, statements_};
  Switches switches_{context_, jumps_, path_, intervals_, writer_, conversions_, expressions_, statements_};
  Initialisers initialisers_{context_, writer_, conversions_, pointers_, accesses_, records_, addresses_, expressions_};
  Branches branches_{context_, jumps_, path_, intervals_, writer_, expressions_, statements_};
  Returns returns_{context_, path_, conversions_, pointers_, records_, addresses_, expressions_};
  Statements statements_{context_, critical_, jumps_,    path_,         writer_,   expressions_,
                         loops_,   gotos_,    switches_, initialisers_, branches_, returns_};
  Functions functions_{scope_,     context_, memory_,  places_, locals_,   jumps_,   path_,
                       intervals_, writer_,  records_, gotos_,  switches_, returns_, statements_};
  ReferenceWriter reference_{context_, host_calls_,      critical_, faults_,
                             memory_,  system_routines_, handlers_, schedule_};
};

ir::Program Lowering::Run(const HasErrors& has_errors) {
  translation_.program.dialect = "hnc";
  memory_.AddSpaces();
  memory_.AddVariables();
  places_.CollectNames();
  schedule_.AddScalars();
  faults_.AddRoutine();
  stated_.Begin();
  functions_.AddRoutines();
  for (const FunctionId id : functions_.CalleesFirst()) functions_.Lower(id);
  if (scope_ == Scope::kAll) return {};
  if (translation_.diagnostics.HasErrors() || has_errors()) return {};  // a missing entry is an error
  schedule_.AddRoutines();
  symbols_.Add();
  symbols_.Document();
  memory_.Finish();
  return std::move(translation_.program);
}

}  // namespace

ir::Program Lower(const Unit& unit, const Objects& objects, const Facts& facts, const Settings& settings,
                  const source::SourceManager& sources, diag::Engine& diagnostics) {
  const auto lower = [&](diag::Engine& engine, const HasErrors& has_errors) {
    const bool unreached = std::ranges::any_of(unit.definitions, [&](FunctionId id) { return facts.PartsOf(id) == 0; });
    // What is reported of a function twice is kept once.
    if (unreached) Lowering(Scope::kAll, unit, objects, facts, settings, sources, engine).Run(has_errors);
    return Lowering(Scope::kReached, unit, objects, facts, settings, sources, engine).Run(has_errors);
  };
  // Beside one another, as both only read the tree: checks take more than a quarter of the time of the two.
  diag::Engine of_lowering = diagnostics.Fork();
  support::BesideWork checks(support::kDeepStackBytes, [&] { Check(unit, objects, facts, sources, diagnostics); });
  const uint32_t before = of_lowering.error_count();
  const auto has_errors_of_checks = [&] {
    checks.Wait();
    return diagnostics.error_count() > before;
  };
  ir::Program program = lower(of_lowering, has_errors_of_checks);
  // What follows from an error that has been told is not told as one of its own: lowered once more, with them.
  if (has_errors_of_checks()) return lower(diagnostics, [] { return true; });
  diagnostics.Join(std::move(of_lowering));
  return program;
}

ir::Reference DescribeLowered(const Unit& unit, const Settings& settings, const source::SourceManager& sources,
                              diag::Engine& diagnostics) {
  const Objects objects(unit);
  const Facts facts(unit, objects);
  Lowering lowering(Scope::kReached, unit, objects, facts, settings, sources, diagnostics);
  const ir::Program program = lowering.Run([] { return false; });
  if (program.routines.empty()) return {.reason = "the program has errors"};
  return lowering.Describe(program);
}

}  // namespace plcxx::hnc
