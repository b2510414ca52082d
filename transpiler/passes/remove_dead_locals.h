// Removes stores to named locals (places of lifetime kRoutine) that nothing reads.
//
//   stmt s1                                stmt s1
//   %0 = load I1                           %0 = load I1
//   store O1 %0                  ->        store O1 %0
//   store S %0       ; for whoever asks    stmt s2
//   stmt s2                                %0 = load I2
//   %0 = load I2                           store O2 %0
//   store O2 %0
//   store S %0
//
// Front ends of accumulator languages spill their registers wherever control flow joins or leaves; here is decided
// which of that anybody sees. A subroutine shares its caller's locals: what it reads first is read by the call, and
// what one of its callers reads after a call is read after its end. A partition's locals end with it.
//
// Backward liveness: exact over if, switch, block and loop, joined over the callers of a subroutine. In and out:
// structured IR without dead values (run RemoveDead before and after).
#pragma once

#include "transpiler/ir/program.h"

namespace plcxx::passes {

void RemoveDeadLocals(ir::Program& program);

}  // namespace plcxx::passes
