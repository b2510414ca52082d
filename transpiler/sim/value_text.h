// A value as people read it: integers in decimal digits, floats as the shortest number that means the same bits.
//
// In: raw bits and the type that says what they are. Out: text. Not its job: hexadecimal and other notations beside it.
#pragma once

#include <cstdint>
#include <string>

#include "transpiler/ir/types.h"

namespace plcxx::sim {

/// Whether integers are read as two's complement; a bit never is.
enum class Sign : uint8_t { kNone, kTwosComplement };

/// "18", "-7", "12.5", "-0", "nan", "inf", "-inf".
std::string ValueDigits(ir::Type type, uint64_t value, Sign sign = Sign::kNone);

constexpr bool IsFloat(ir::Type type) { return type == ir::Type::kF32 || type == ir::Type::kF64; }

/// The same bits, or two floats that are no numbers.
bool SameValue(ir::Type type, uint64_t a, uint64_t b);

}  // namespace plcxx::sim
