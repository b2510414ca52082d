// A program as a fleet executes it: what constants decide is decided, so that less depends on the lane.
//
//   for (a = 0; a < 3; a++) jog(a);      ->      jog_0(); jog_1(); jog_2();
//   G[a * 10] in jog                     ->      G[0], G[10], G[20]
//
// Loops whose rounds follow from constants are unrolled; a routine that is called with constants gets a copy for them;
// an index that is a constant becomes a place of its own; named locals that only one routine uses (Space::own) are
// followed. In: a structured, optimized program. Out: one with the same memory, which does the same to it and calls
// the same host functions; local bytes that nobody reads may differ. Not its job: what is the same in every machine
// (same_everywhere.h).
#pragma once

#include "transpiler/ir/program.h"

namespace plcxx::fleet {

ir::Program Specialize(const ir::Program& program);

}  // namespace plcxx::fleet
