// An if of which only one arm is ever executed becomes that arm, where no statement of the source is in either.
//
//   %0 = const bit 0
//   if %0 {                        %3 = load Y2
//     %1 = load Y2                 %4 = const i8 127
//     ...                    ->    %5 = and.i8 %3 %4
//     store Y2 %2                  store Y2 %5
//   } else {
//     %3 = load Y2
//     ...
//   }
//
// `Y_MAG_BACK(0)`, of which the macro says `if (v) ... else ...`, is one statement: nobody wrote the other arm. An if
// that holds statements stays, so that the reader finds them. So does one whose other arm has the only access to some
// place, for it would be gone from the machine's signals, or calls something, which then would be called by nobody.
//
// In and out: structured IR (Verify, Stage::kStructured), with folded constants.
#pragma once

#include "transpiler/ir/program.h"

namespace plcxx::passes {

void SpliceConstantIfs(ir::Program& program);

}  // namespace plcxx::passes
