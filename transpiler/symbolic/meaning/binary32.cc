// Floating point, binary32: HOST50 6.3 to 6.5.
#include "transpiler/symbolic/meaning/comparisons.h"
#include "transpiler/symbolic/meaning/rows.h"
#include "transpiler/symbolic/terms/floats.h"

namespace plcxx::meaning {
namespace {

Value Number(Value like, double value) { return like.With(terms::FloatConst(*like.terms, value, 32)); }

}  // namespace

F32 AddF32(F32 a, F32 b) { return a.With(terms::FloatAdd(*a.terms, a.id, b.id)); }
F32 SubF32(F32 a, F32 b) { return a.With(terms::FloatSub(*a.terms, a.id, b.id)); }
F32 MulF32(F32 a, F32 b) { return a.With(terms::FloatMul(*a.terms, a.id, b.id)); }
/// By a zero of either sign: the dividend.
F32 QuotientOrDividendF32(F32 a, F32 b) {
  return Select(IsEqual(b, Number(b, 0.0)), a, a.With(terms::FloatDiv(*a.terms, a.id, b.id)));
}
F32 NegateF32(F32 a) { return a.With(terms::FloatNegate(*a.terms, a.id)); }
I32 BitsOfF32(F32 a) { return a; }
F32 SignedToF32(I32 a) { return a.With(terms::FloatFromSigned(*a.terms, a.id, 32)); }

/// Toward zero; NaN is 0, and what lies beyond a word is its last number on that side.
I32 TruncateF32(F32 a) {
  const Value is_nan = a.With(terms::FloatIsNan(*a.terms, a.id));
  const Value above = IsAtMost(Number(a, 2147483648.0), a), below = IsAtMost(a, Number(a, -2147483648.0));
  const Value whole = a.With(terms::FloatToSigned(*a.terms, a.id, 32));
  return Select(is_nan, a.Same(0), Select(above, a.Same(0x7FFFFFFF), Select(below, a.Same(0x80000000), whole)));
}

/// To the nearest, ties away from zero. From 2^23 on there is no fraction; below, number minus whole part is exact.
I32 RoundF32(F32 a) {
  const Value whole = TruncateF32(a);
  const Value fraction = SubF32(a, SignedToF32(whole));
  const Value may_have_fraction = IsLess(Number(a, -8388608.0), a) & IsLess(a, Number(a, 8388608.0));
  const Value up = IsAtMost(Number(a, 0.5), fraction), down = IsAtMost(fraction, Number(a, -0.5));
  return Select(may_have_fraction, Select(up, whole + 1, Select(down, whole - 1, whole)), whole);
}

Bit EqualF32(F32 a, F32 b) { return IsEqual(a, b); }
Bit NotEqualF32(F32 a, F32 b) { return Not(IsEqual(a, b)); }
Bit LessF32(F32 a, F32 b) { return IsLess(a, b); }
Bit LessEqualF32(F32 a, F32 b) { return IsAtMost(a, b); }
Bit GreaterF32(F32 a, F32 b) { return IsLess(b, a); }
Bit GreaterEqualF32(F32 a, F32 b) { return IsAtMost(b, a); }

}  // namespace plcxx::meaning
