// A sliced routine becomes a choice of pieces (nc110, section 4.2).
//
//   routine slow (slice) sliced slices 2 {        routine slow (slice) sliced slices 2 {
//     prologue { text.update ... }                  body {
//     body {                                          %0 = load slice
//       stmt s1 ...                                   switch %0 {
//       stmt s2 ...                           ->        case 0 { text.update ...; stmt s1 ... }
//     }                                                 case 1 { stmt s2 ... }
//     epilogue { step.expire ... }                    }
//   }                                               }
//                                                   epilogue { %0 = load slice; %1 = eq %0 1; if %1 { step.expire ... }
//                                                   }
//
// Item i (ir/items.h: never a part of a statement or of a chain of blocks) goes to slice
// floor(slices * (weights before i) / (all weights)). A slice may be empty.
//
// The epilogue stays a region of its own: after the last statement's marker it would be that statement's, and would
// not be executed where a debugger switches the statement off. For the same reason a routine with one slice is left as
// it is: its prologue, body and epilogue run one after the other anyway.
#pragma once

#include <cstdint>
#include <span>

#include "transpiler/ir/program.h"

namespace plcxx::passes {

/// `weights`: one for each of Items(program, body). Routine::slices says how many pieces.
void CutSlices(ir::Program& program, ir::RoutineId routine, std::span<const uint64_t> weights);

}  // namespace plcxx::passes
