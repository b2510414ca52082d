// Packed decimal digits as numbers, for operations of several families.
#pragma once

#include <cstdint>

#include "transpiler/symbolic/meaning/value.h"

namespace plcxx::meaning {

/// The last `count` decimal digits of a number, four bits each.
Value DigitsOf(Value number, uint8_t count);
/// Every four bits as a digit, also above 9, with its decimal weight; modulo 2^width.
Value NumberOfDigits(Value digits, uint8_t width);

}  // namespace plcxx::meaning
