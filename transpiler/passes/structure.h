// Jumps become regions: the phase between lowering and everything else.
//
//   jump L1 if %0          block @1 {              jump L1 if %0         %1 = not.bit %0
//   stmt s2                  exit @1 if %0         stmt s2               if %1 {
//   jump L1 if %1      ->    stmt s2               stmt s3         ->      stmt s2
//   stmt s3                  exit @1 if %1         label L1                stmt s3
//   label L1                 stmt s3                                     }
//                          }
//
// A block begins at the first jump to its label and ends at the label; where two blocks would cross, the one that ends
// later begins earlier. A label right behind a statement's marker counts as standing before it, so that the marker
// stays with what follows it. A condition that is itself negated is used without the negation.
//
// In: forward jumps within their regions (Verify, Stage::kLowered). Out: no Jump, no Label (Stage::kStructured).
#pragma once

#include "transpiler/ir/program.h"

namespace plcxx::passes {

void Structure(ir::Program& program);

}  // namespace plcxx::passes
