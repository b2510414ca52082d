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
// later begins earlier. A label right after a statement's marker counts as standing before it, so that the marker
// stays with what follows it. A condition that is itself negated is used without the negation. An If made of a jump
// says so (Inst, kIf), for a statement that is switched off does not jump.
//
//   label L1                              loop @1 budget rounds {
//   stmt s1                                 body {
//   jump L1 if %0 budget rounds     ->        stmt s1
//     refused { host fault () }               repeat @1 if %0 refused { host fault () }
//   stmt s2                                 }
//                                         }
//                                         stmt s2
//
// A loop (structure_loops.cc) goes from its label to the end of the statement that jumps back last. Loops that would
// cross become one; a loop that is entered in its middle begins where the way in begins. Whatever does not begin at
// the loop's head is reached by a place `resume`, a choice at the head and forward jumps: every graph of jumps
// becomes loops and blocks, and no instruction is there twice.
//
// In: jumps to labels of their region or of one around it (Verify, Stage::kLowered). Out: no Jump, no Label
// (Stage::kStructured).
#pragma once

#include "transpiler/ir/program.h"

namespace plcxx::passes {

void Structure(ir::Program& program);

/// Loops one in the other; compilers refuse brackets that are deeper than 256.
inline constexpr uint32_t kDeepestLoops = 32;

/// The outermost loops of one region, before its forward jumps: their jumps back are Repeats afterwards. Their bodies
/// may hold inner loops that are still to be made, up to kDeepestLoops with the `loops` around the region: in the
/// innermost one all jumps back are its own, as where loops cross.
void MakeLoops(ir::Program& program, ir::RegionId region, uint32_t loops);

}  // namespace plcxx::passes
