// Flags, rotations and decimal adjustment of a processor's registers: TECHNOL 6.5 and 6.9.
#include "transpiler/symbolic/meaning/rows.h"

namespace plcxx::meaning {
namespace {

/// What came into the highest bit of a sum from below, by the sum's own bit there.
Value CarryIntoSign(Value a, Value b, Value sum) { return Sign(a) ^ Sign(b) ^ Sign(sum); }

/// At least two of three.
Value Majority(Value a, Value b, Value c) { return (a & b) | (a & c) | (b & c); }

/// The carry out of the highest bit of `sum` = a + b, or a + b + 1.
Bit CarryOfAdd(Value a, Value b, Value sum) { return Majority(Sign(a), Sign(b), CarryIntoSign(a, b, sum)); }
/// The borrow of `difference` = a - b, or a - b - 1.
Bit BorrowOfSub(Value a, Value b, Value difference) {
  return Majority(Not(Sign(a)), Sign(b), CarryIntoSign(a, b, difference));
}
/// Two numbers of one sign and a sum of the other one.
Bit OverflowOfAdd(Value a, Value b, Value sum) { return Not(Sign(a) ^ Sign(b)) & (Sign(a) ^ Sign(sum)); }
/// Two numbers of different signs and a difference that has not the sign of the first.
Bit OverflowOfSub(Value a, Value b, Value difference) { return (Sign(a) ^ Sign(b)) & (Sign(a) ^ Sign(difference)); }

/// The low bits of `count` modulo the width of `value`, in that width.
Value CountWithin(Value value, Value count) {
  const Value within = Remainder(count, value.width());
  return value.width() < within.width() ? Low(within, value.width()) : Zext(within, value.width());
}

Value RotateLeft(Value value, Value count) {
  const Value left = CountWithin(value, count);
  return (value << left) | (value >> (value.Same(value.width()) - left));
}
Value RotateRight(Value value, Value count) {
  const Value right = CountWithin(value, count);
  return (value >> right) | (value << (value.Same(value.width()) - right));
}

/// The value with the carry above it, one bit wider, rotated as a whole.
Value RotateWithCarry(Value value, Value carry, Value count) { return RotateLeft(Join(carry, value), count); }
Value RotateCarryLeft(Value value, Value carry, Value count) {
  return Low(RotateWithCarry(value, carry, count), value.width());
}
Bit CarryAfterRotate(Value value, Value carry, Value count) { return Sign(RotateWithCarry(value, carry, count)); }

/// 6 for the low digit and 60h for the high one, where they are to be adjusted.
Value Adjustment(Value low, Value high) {
  return Select(low, low.Const(0x06, 8), low.Const(0, 8)) + Select(high, high.Const(0x60, 8), high.Const(0, 8));
}

}  // namespace

Bit CarryOfAdd8(I8 a, I8 b, I8 sum) { return CarryOfAdd(a, b, sum); }
Bit CarryOfAdd16(I16 a, I16 b, I16 sum) { return CarryOfAdd(a, b, sum); }
Bit CarryOfAdd32(I32 a, I32 b, I32 sum) { return CarryOfAdd(a, b, sum); }
Bit BorrowOfSub8(I8 a, I8 b, I8 difference) { return BorrowOfSub(a, b, difference); }
Bit BorrowOfSub16(I16 a, I16 b, I16 difference) { return BorrowOfSub(a, b, difference); }
Bit BorrowOfSub32(I32 a, I32 b, I32 difference) { return BorrowOfSub(a, b, difference); }
Bit OverflowOfAdd8(I8 a, I8 b, I8 sum) { return OverflowOfAdd(a, b, sum); }
Bit OverflowOfAdd16(I16 a, I16 b, I16 sum) { return OverflowOfAdd(a, b, sum); }
Bit OverflowOfAdd32(I32 a, I32 b, I32 sum) { return OverflowOfAdd(a, b, sum); }
Bit OverflowOfSub8(I8 a, I8 b, I8 difference) { return OverflowOfSub(a, b, difference); }
Bit OverflowOfSub16(I16 a, I16 b, I16 difference) { return OverflowOfSub(a, b, difference); }
Bit OverflowOfSub32(I32 a, I32 b, I32 difference) { return OverflowOfSub(a, b, difference); }
/// Between the nibbles a bit has been carried or borrowed where the result's bit 4 is not that of the operands alone.
Bit HalfCarry8(I8 a, I8 b, I8 result) { return Bits(a, 4, 1) ^ Bits(b, 4, 1) ^ Bits(result, 4, 1); }

I8 RotateLeft8(I8 value, I32 count) { return RotateLeft(value, count); }
I16 RotateLeft16(I16 value, I32 count) { return RotateLeft(value, count); }
I32 RotateLeft32(I32 value, I32 count) { return RotateLeft(value, count); }
I8 RotateRight8(I8 value, I32 count) { return RotateRight(value, count); }
I16 RotateRight16(I16 value, I32 count) { return RotateRight(value, count); }
I32 RotateRight32(I32 value, I32 count) { return RotateRight(value, count); }
I8 RotateCarryLeft8(I8 value, Bit carry, I32 count) { return RotateCarryLeft(value, carry, count); }
I16 RotateCarryLeft16(I16 value, Bit carry, I32 count) { return RotateCarryLeft(value, carry, count); }
I32 RotateCarryLeft32(I32 value, Bit carry, I32 count) { return RotateCarryLeft(value, carry, count); }
Bit CarryAfterRotate8(I8 value, Bit carry, I32 count) { return CarryAfterRotate(value, carry, count); }
Bit CarryAfterRotate16(I16 value, Bit carry, I32 count) { return CarryAfterRotate(value, carry, count); }
Bit CarryAfterRotate32(I32 value, Bit carry, I32 count) { return CarryAfterRotate(value, carry, count); }

I8 AdjustAfterAdd8(I8 value, Bit low, Bit high) { return value + Adjustment(low, high); }
I8 AdjustAfterSub8(I8 value, Bit low, Bit high) { return value - Adjustment(low, high); }

}  // namespace plcxx::meaning
