// Blocks that are left by a few exits become nested ifs, so that generated code has no goto where none is needed.
//
//   block @1 {                       %1 = not.bit %0       block @1 {                  if %0 {
//     exit @1 if %0                  if %1 {                 if %0 {                     stmt s2
//     stmt s2                 ->       stmt s2               stmt s2         ->        } else {
//   }                                }                       exit @1                     stmt s3
//                                                          }                           }
//                                                          stmt s3
//                                                        }
//
// What follows an exit goes into the arm that is executed when the exit is not taken; nothing is ever duplicated.
// A block that would need that, or that has too many exits to be read as nested ifs, stays. An exit of a block that
// ends with a loop or with another block leaves that one instead.
//
// In and out: structured IR (Verify, Stage::kStructured).
#pragma once

#include "transpiler/ir/program.h"

namespace plcxx::passes {

/// Exits of one block that become nested ifs; more are a chain that reads better as it is.
inline constexpr uint32_t kMostNestedExits = 5;

void NestBlocks(ir::Program& program);

}  // namespace plcxx::passes
