// A routine that goes on where it was left becomes a switch whose cases run on into each other.
//
//   block @1 {                           switch %0 {
//     block @2 {                           default {
//       switch %0 {                          stmt s1
//         case 1 { exit @2 }                 falls through
//         case 2 { exit @1 }               }
//       }                         ->       case 1 {
//       stmt s1                              stmt s2
//     }                                      falls through
//     stmt s2                              }
//   }                                      case 2 {
//   stmt s3                                  stmt s3
//                                          }
//                                        }
//
// Only what a routine begins with: the switch stands before the first statement, for one inside a statement would be
// skipped together with it when that statement is switched off. A block that something else leaves, too, stays, and
// so do the ones around it; cases that go to those keep their exits.
//
// In and out: structured IR (Verify, Stage::kStructured).
#pragma once

#include "transpiler/ir/program.h"

namespace plcxx::passes {

void EnterSwitches(ir::Program& program);

}  // namespace plcxx::passes
