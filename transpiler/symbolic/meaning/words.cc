// Bits and words as rows of bits: NC110 6.1, 6.2 and 6.6, PROSTEP FM 6 to 10, HOST50 6.3 and 6.4.
#include "transpiler/symbolic/meaning/rows.h"

namespace plcxx::meaning {
namespace {

/// Whether bit `number` is 1; a bit beyond the word is 0.
Bit TestBit(Value word, Value number) { return Low(word >> number, 1); }

}  // namespace

Bit BitAnd(Bit a, Bit b) { return a & b; }
Bit BitOr(Bit a, Bit b) { return a | b; }
Bit BitXor(Bit a, Bit b) { return a ^ b; }
Bit BitNot(Bit a) { return Not(a); }

I8 And8(I8 a, I8 b) { return a & b; }
I8 Or8(I8 a, I8 b) { return a | b; }
I8 Xor8(I8 a, I8 b) { return a ^ b; }
I8 Not8(I8 a) { return Not(a); }
I16 And16(I16 a, I16 b) { return a & b; }
I16 Or16(I16 a, I16 b) { return a | b; }
I16 Xor16(I16 a, I16 b) { return a ^ b; }
I16 Not16(I16 a) { return Not(a); }
I32 And32(I32 a, I32 b) { return a & b; }
I32 Or32(I32 a, I32 b) { return a | b; }
I32 Xor32(I32 a, I32 b) { return a ^ b; }
I32 Not32(I32 a) { return Not(a); }

/// ENC: the number of the highest 1, the lowest bit being number 1; 0 for 0.
I8 HighestBit8(I8 value) {
  Value number = value.Same(0);
  for (uint8_t bit = 0; bit < 8; ++bit) SetIf(Bits(value, bit, 1), number, value.Same(bit + 1));
  return number;
}

/// DEC: 1..8 to the word with that bit, all others to 0.
I8 OneHot8(I8 number) {
  Value word = number == 8;
  for (uint8_t bit = 7; bit > 0; --bit) word = Join(word, number == bit);
  return word;
}

I8 HighNibble8(I8 value) { return Zext(High(value, 4), 8); }
I8 LowNibble8(I8 value) { return Zext(Low(value, 4), 8); }
I8 SwapNibbles8(I8 value) { return Join(Low(value, 4), High(value, 4)); }
Bit SignBit8(I8 value) { return Sign(value); }

Bit TestBit8(I8 word, I8 number) { return TestBit(word, number); }
Bit TestBit32(I32 word, I32 number) { return TestBit(word, number); }
I32 BitAt32(Bit bit, I32 position) { return Zext(bit, 32) << position; }

I16 ShiftLeft16(I16 value, I16 count) { return value << count; }
I16 ShiftRight16(I16 value, I16 count) { return value >> count; }
I32 ShiftLeft32(I32 value, I32 count) { return value << count; }
I32 ShiftRight32(I32 value, I32 count) { return value >> count; }
/// Beyond the width only the sign is left.
I16 ArithmeticShiftRight16(I16 value, I16 count) { return value.With(value.terms->Ashr(value.id, count.id)); }
I32 ArithmeticShiftRight32(I32 value, I32 count) { return value.With(value.terms->Ashr(value.id, count.id)); }

// The parts of a wider word. A pair names its low half first.
I16 Pair16(I8 low, I8 high) { return Join(high, low); }
I32 Pair32(I16 low, I16 high) { return Join(high, low); }
I64 Pair64(I32 low, I32 high) { return Join(high, low); }
I8 LowByte16(I16 value) { return Low(value, 8); }
I8 HighByte16(I16 value) { return High(value, 8); }
I16 WithLowByte16(I16 word, I8 low) { return Join(High(word, 8), low); }
I8 LowByte32(I32 value) { return Low(value, 8); }
I16 LowHalf32(I32 value) { return Low(value, 16); }
I16 HighHalf32(I32 value) { return High(value, 16); }
I32 LowHalf64(I64 value) { return Low(value, 32); }
I32 HighHalf64(I64 value) { return High(value, 32); }

// The same number in a wider word.
I16 Widen1To16(Bit value) { return Zext(value, 16); }
I32 Widen1To32(Bit value) { return Zext(value, 32); }
I16 Widen8To16(I8 value) { return Zext(value, 16); }
I32 Widen8To32(I8 value) { return Zext(value, 32); }
I32 Widen16To32(I16 value) { return Zext(value, 32); }
I64 Widen32To64(I32 value) { return Zext(value, 64); }
I16 SignExtend8To16(I8 value) { return Sext(value, 16); }
I32 SignExtend8To32(I8 value) { return Sext(value, 32); }
I32 SignExtend16To32(I16 value) { return Sext(value, 32); }
I64 SignExtend32To64(I32 value) { return Sext(value, 64); }

Bit Select1(Bit condition, Bit a, Bit b) { return Select(condition, a, b); }
I8 Select8(Bit condition, I8 a, I8 b) { return Select(condition, a, b); }
I16 Select16(Bit condition, I16 a, I16 b) { return Select(condition, a, b); }
I32 Select32(Bit condition, I32 a, I32 b) { return Select(condition, a, b); }

}  // namespace plcxx::meaning
