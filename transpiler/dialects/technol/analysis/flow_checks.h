// What is wrong with the paths through a program, and what is suspicious on them (specification 6.4, 6.7, 6.9, 10.2,
// 10.3): TE049 to TE051, TE056 to TE058, TE071, TE072, TE078; TW005, TW020, TW022, TW023, TW026.
#pragma once

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/technol/analysis/flow.h"

namespace plcxx::technol {

/// Errors of paths. Faulty instructions give none.
void CheckPaths(const Flow& flow, diag::Engine& diagnostics);
/// PUSH and POP (TE071).
void CheckStack(const Flow& flow, diag::Engine& diagnostics);
/// Values that are read before anything is loaded: TE056, TE057, TE072, TW023.
void CheckLoads(const Flow& flow, diag::Engine& diagnostics);
/// More places to go on at than a step has numbers for (TE078); only of a program without errors.
void CheckResumePoints(const Flow& flow, diag::Engine& diagnostics);
/// Warnings; only of a program without errors.
void WarnOfPaths(const Flow& flow, diag::Engine& diagnostics);

}  // namespace plcxx::technol
