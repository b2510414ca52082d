// What an operation without effects gives for constants: the function of runtime_support that everybody calls.
#pragma once

#include <array>
#include <cstdint>

#include "transpiler/ir/op.h"

namespace plcxx::fleet {

/// Raw bits, of as many operands as the operation has.
uint64_t ValueOf(ir::OpKind op, const std::array<uint64_t, 3>& operands);

}  // namespace plcxx::fleet
