// Sums, products and quotients, all modulo 2^width: NC110 6.4, PROSTEP FM 0 to 3 and 60 to 63, HOST50 6.3, TECHNOL 6.5
// and 6.9, HNC 6.2.
#include "transpiler/symbolic/meaning/rows.h"

namespace plcxx::meaning {
namespace {

/// |value| as a word without sign: of the lowest number it is that word itself.
Value Magnitude(Value value) { return Select(Sign(value), Minus(value), value); }

Value QuotientOrZero(Value a, Value b) { return Select(b == 0, a.Same(0), Quotient(a, b)); }
Value RemainderOrZero(Value a, Value b) { return Select(b == 0, a.Same(0), Remainder(a, b)); }
Value RemainderOrDividend(Value a, Value b) { return Select(b == 0, a, Remainder(a, b)); }

/// Toward zero: the quotient of the magnitudes, negative where the signs differ.
Value SignedQuotientOrZero(Value a, Value b) {
  const Value magnitude = QuotientOrZero(Magnitude(a), Magnitude(b));
  return Select(Sign(a) ^ Sign(b), Minus(magnitude), magnitude);
}
/// The remainder of the magnitudes with the sign of the dividend.
Value WithSignOf(Value a, Value magnitude) { return Select(Sign(a), Minus(magnitude), magnitude); }

}  // namespace

I8 Add8(I8 a, I8 b) { return a + b; }
I16 Add16(I16 a, I16 b) { return a + b; }
I32 Add32(I32 a, I32 b) { return a + b; }
I8 Sub8(I8 a, I8 b) { return a - b; }
I16 Sub16(I16 a, I16 b) { return a - b; }
I32 Sub32(I32 a, I32 b) { return a - b; }
I16 Mul16(I16 a, I16 b) { return a * b; }
I32 Mul32(I32 a, I32 b) { return a * b; }
I64 Mul64(I64 a, I64 b) { return a * b; }

I8 Abs8(I8 value) { return Magnitude(value); }
I16 Abs16(I16 value) { return Magnitude(value); }
I32 Abs32(I32 value) { return Magnitude(value); }
I16 Minus16(I16 value) { return Minus(value); }
I32 Minus32(I32 value) { return Minus(value); }

// By zero: what the name says; where it says nothing, the quotient is 0 and the remainder the dividend, but for words
// of 16 bits 0 (HNC 6.2).
I16 UnsignedDiv16(I16 a, I16 b) { return QuotientOrZero(a, b); }
I32 UnsignedDiv32(I32 a, I32 b) { return QuotientOrZero(a, b); }
I64 UnsignedDiv64(I64 a, I64 b) { return QuotientOrZero(a, b); }
I16 UnsignedRem16(I16 a, I16 b) { return RemainderOrZero(a, b); }
I32 UnsignedRem32(I32 a, I32 b) { return RemainderOrDividend(a, b); }
I64 UnsignedRem64(I64 a, I64 b) { return RemainderOrDividend(a, b); }
I32 UnsignedRemOrZero32(I32 a, I32 b) { return RemainderOrZero(a, b); }

I16 SignedDiv16(I16 a, I16 b) { return SignedQuotientOrZero(a, b); }
I32 SignedDiv32(I32 a, I32 b) { return SignedQuotientOrZero(a, b); }
I64 SignedDiv64(I64 a, I64 b) { return SignedQuotientOrZero(a, b); }
I32 QuotientOrDividend32(I32 a, I32 b) { return Select(b == 0, a, SignedQuotientOrZero(a, b)); }
I16 SignedRem16(I16 a, I16 b) { return WithSignOf(a, RemainderOrZero(Magnitude(a), Magnitude(b))); }
I32 SignedRem32(I32 a, I32 b) { return WithSignOf(a, RemainderOrDividend(Magnitude(a), Magnitude(b))); }
I64 SignedRem64(I64 a, I64 b) { return WithSignOf(a, RemainderOrDividend(Magnitude(a), Magnitude(b))); }
I32 SignedRemOrZero32(I32 a, I32 b) { return WithSignOf(a, RemainderOrZero(Magnitude(a), Magnitude(b))); }

}  // namespace plcxx::meaning
