// Operations on integer constants that have one meaning wherever bits are numbers, and pairs of one value's own halves.
//
//   %0 = const i32 5                     %0 = const i32 5
//   %1 = const i32 7            ->       %1 = const i32 7
//   %2 = ugt.i32 %0 %1                   %2 = const bit 0
//
//   %1 = low_half.i32 %0
//   %2 = high_half.i32 %0       ->       (users of %3 use %0)
//   %3 = pair.i32 %1 %2
//
// Arithmetic is not among them: what it does at its limits is the runtime's to say, which passes may not include.
#pragma once

#include <optional>

#include "transpiler/ir/program.h"

namespace plcxx::passes {

/// The operation's value, when its operands are constants.
std::optional<uint64_t> FoldedInteger(const ir::Program& program, const ir::Inst& inst);
/// The value that the operation puts together again; none: it does not.
ir::ValueId WholeOfHalves(const ir::Program& program, const ir::Inst& inst);

}  // namespace plcxx::passes
