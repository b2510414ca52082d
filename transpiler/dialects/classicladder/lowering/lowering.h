// Lowers a ClassicLadder project to IR.
//
// In: a tree without errors, its settings, the sources. Out: a program with the routines init, fast and period, one for
// each subroutine that is called; its memory map, its schedule, what is known of its variables.
//
// The engine goes through a rung column by column; so does the lowering, each element where it stands. Timers and
// counters are records of plain memory and compute with the operations that everything else uses.
#pragma once

#include "transpiler/dialects/classicladder/machine/options.h"
#include "transpiler/dialects/classicladder/syntax/syntax.h"
#include "transpiler/ir/program.h"

namespace plcxx::classicladder {

ir::Program Lower(const Program& tree, const Settings& settings, const source::SourceManager& sources);

}  // namespace plcxx::classicladder
