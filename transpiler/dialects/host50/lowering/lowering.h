// Lowers a syntax tree of dialect host50 to IR (specification sections 4 to 8).
//
// In: a tree without errors, its settings. Out: a program with the routines init, fast, slow, one for each subroutine,
// and period (the tick of 4.3); its memory map, its schedule, its tables and documentation.
//
// One statement is a rung: instructions whose results no instruction outside of them uses; of a drawing whole rows.
// Results are computed where they are used, so that a rung reads as one expression; what an instruction between would
// change is computed before it, and edges and blocks, which have a state, where they stand.
#pragma once

#include "transpiler/dialects/host50/syntax/syntax.h"
#include "transpiler/ir/program.h"
#include "transpiler/source/source.h"

namespace plcxx::host50 {

ir::Program Lower(const Program& tree, const Settings& settings, const source::SourceManager& sources);

}  // namespace plcxx::host50
