// What the facts of a program in its checked flavour (ir/facts.h) lack when the front end has stated them: the
// statement they belong to, and for each loop that is called proved the fact that it ends.
//
//   stmt s3                                    stmt s3
//   loop @1 proven 8 {             ->          loop @1 guard 8 {
//     condition { ... }                          condition { ... }
//     body { ... }                               body { ... }
//   }                                            exhausted { host false_fact (LOOP, id of s3, 8) }
//                                              }
//
// In and out: structured IR (Verify, Stage::kStructured). A program whose facts are trusted is left as it is.
#pragma once

#include "transpiler/ir/program.h"

namespace plcxx::passes {

void CompleteFacts(ir::Program& program);

}  // namespace plcxx::passes
