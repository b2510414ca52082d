// Warnings that follow from the order in which instructions are executed, and from what all modules together read and
// write (specification section 10).
//
// In: a tree without errors. Out: diagnostics. Not its job: what the text alone tells (parser.h, program_checks.h).
#pragma once

#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/prostep/analysis/paths.h"
#include "transpiler/dialects/prostep/machine/options.h"
#include "transpiler/dialects/prostep/syntax/syntax.h"

namespace plcxx::prostep {

/// By ModuleId.
using Paths = std::vector<ModulePaths>;

/// Lost conditions (W11), operand-less O without effect (W12), backward jumps (W15).
void CheckSequences(const Program& program, const Paths& paths, diag::Engine& diagnostics);
/// Registers on the paths from the scheduler (W10, W13, W14, W22, W23, W43, W44), instructions that none reaches (W28).
void CheckPaths(const Program& program, const Paths& paths, const Settings& settings, diag::Engine& diagnostics);
/// Sequences whose result nothing uses (W42).
void CheckResults(const Program& program, const Paths& paths, const Settings& settings, diag::Engine& diagnostics);
/// Does the functional module leave a result in S?
bool SetsS(Function function);
/// Bits assigned in several places (W18), or assigned and set (W19).
void CheckCoils(const Program& program, const Paths& paths, diag::Engine& diagnostics);
/// Memory without writer or reader (W37), against its direction (W38), overwritten outputs (W39), shared by fast and
/// slow modules (W40).
void CheckMemory(const Program& program, diag::Engine& diagnostics);

/// All of them.
void CheckWhatIsExecuted(const Program& program, const Settings& settings, diag::Engine& diagnostics);

/// By ModuleId: can the module be reached by calls from PM first ... PM last?
std::vector<bool> ReachedFrom(const Program& program, uint32_t first, uint32_t last);

}  // namespace plcxx::prostep
