// Packed decimal digits: NC110 6.6 with decision D13, PROSTEP FM 4 and 5, TECHNOL 6.6.
#include "transpiler/symbolic/meaning/digits.h"

#include "transpiler/symbolic/meaning/rows.h"

namespace plcxx::meaning {

Value DigitsOf(Value number, uint8_t count) {
  Value digits = Low(Remainder(number, 10), 4);
  for (uint8_t i = 1; i < count; ++i) {
    number = Quotient(number, 10);
    digits = Join(Low(Remainder(number, 10), 4), digits);
  }
  return digits;
}

Value NumberOfDigits(Value digits, uint8_t width) {
  // From the highest digit down; the part above the last whole nibble is a digit, too.
  uint8_t low = static_cast<uint8_t>((digits.width() + 3) / 4 * 4);
  Value number = digits.Const(0, width);
  while (low != 0) {
    low = static_cast<uint8_t>(low - 4);
    const auto bits = static_cast<uint8_t>(low + 4 > digits.width() ? digits.width() - low : 4);
    number = number * 10 + Zext(Bits(digits, low, bits), width);
  }
  return number;
}

/// The last two digits: the number modulo 100.
I8 ToBcd8(I8 number) { return DigitsOf(number, 2); }
I8 FromBcd8(I8 digits) { return NumberOfDigits(digits, 8); }
/// The last four digits.
I16 ToBcd16(I16 number) { return DigitsOf(number, 4); }
I16 FromBcd16(I16 digits) { return NumberOfDigits(digits, 16); }

/// The magnitude modulo 80,000,000 as digits below the sign; there is no negative 0.
I32 ToSignedBcd32(I32 number) {
  const Value magnitude = Remainder(Select(Sign(number), Minus(number), number), 80000000);
  return Join(Sign(number) & (magnitude != 0), Low(DigitsOf(magnitude, 8), 31));
}

I32 FromSignedBcd32(I32 digits) {
  const Value magnitude = NumberOfDigits(Low(digits, 31), 32);
  return Select(Sign(digits), Minus(magnitude), magnitude);
}

Bit HasNoDigit32(I32 digits) {
  Value found = digits.Bit(false);
  for (uint8_t low = 0; low < 32; low = static_cast<uint8_t>(low + 4))
    found = found | Not(Less(Bits(digits, low, 4), 10));
  return found;
}

}  // namespace plcxx::meaning
