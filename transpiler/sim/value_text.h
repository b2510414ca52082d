// A value as people read it: integers in decimal digits, floats as the shortest number that means the same bits.
//
// In: raw bits and the type that says what they are. Out: text. Not its job: hexadecimal and other notations beside it.
#pragma once

#include <cstdint>
#include <string>

#include "transpiler/ir/types.h"

namespace plcxx::sim {

/// "18", "12.5", "-0", "nan", "inf", "-inf". Integers have no sign here: -1 of 32 bits is "4294967295".
std::string ValueDigits(ir::Type type, uint64_t value);

constexpr bool IsFloat(ir::Type type) { return type == ir::Type::kF32 || type == ir::Type::kF64; }

/// The same bits, or two floats that are no numbers.
bool SameValue(ir::Type type, uint64_t a, uint64_t b);

}  // namespace plcxx::sim
