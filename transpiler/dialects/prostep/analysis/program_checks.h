// Checks of a whole program that need no control flow (specification sections 4, 7, 8.3, 9 and 10).
//
// In: the tree. Out: diagnostics. What is missing somewhere is only asked for in a tree without errors, because it may
// stand in a line that was not understood.
#pragma once

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/prostep/syntax/syntax.h"
#include "transpiler/source/source.h"

namespace plcxx::prostep {

/// Undefined modules (E21), rings of calls (E22), calls of PM 0 to 16 (W31), deep nesting (W32). Fills
/// Instruction::module.
void ResolveCalls(Program& program, diag::Engine& diagnostics);

// The rest wants a tree without errors.

/// Subroutines that nothing calls (W35).
void CheckUncalled(const Program& program, diag::Engine& diagnostics);
/// Modules that nothing activates (W30, W35).
void CheckActivity(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics);
/// Labels that nothing jumps to (W29).
void CheckLabels(const Program& program, diag::Engine& diagnostics);
/// Message bits without text, texts without message bit (W33, W34).
void CheckMessages(const Program& program, diag::Engine& diagnostics);
/// Edge memories with several users (W17), timers and counters without start or reader (W36).
void CheckTimersAndCounters(const Program& program, diag::Engine& diagnostics);
/// Writes to input bytes that the refresh overwrites (W20).
void CheckInputWrites(const Program& program, diag::Engine& diagnostics);

}  // namespace plcxx::prostep
