// Constants disappear from expressions.
//
//   %0 = const bit 1                          %0 = const bit 1
//   %1 = load a                               %1 = load a
//   %2 = and.bit %1 %0        ->              %2 = and.bit %1 %0     (nothing uses it; RemoveDead takes it)
//   %3 = not.bit %0                           %3 = const bit 0
//   store b %2                                store b %1
//
// Modest on purpose. And, or and not of bits, and what fold_integers.h lists: their meaning cannot differ from the
// runtime's, which passes may not include. An If on a constant condition stays, for it holds statements, and no
// statement of the source disappears; the C++ compiler takes it out of the object code.
#pragma once

#include "transpiler/ir/program.h"

namespace plcxx::passes {

void FoldConstants(ir::Program& program);

}  // namespace plcxx::passes
