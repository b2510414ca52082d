// Floating point, binary64: HNC 6.1, 6.2 and 6.11.
#include "transpiler/symbolic/meaning/comparisons.h"
#include "transpiler/symbolic/meaning/rows.h"
#include "transpiler/symbolic/terms/floats.h"

namespace plcxx::meaning {
namespace {}  // namespace

F64 AddF64(F64 a, F64 b) { return a.With(terms::FloatAdd(*a.terms, a.id, b.id)); }
F64 SubF64(F64 a, F64 b) { return a.With(terms::FloatSub(*a.terms, a.id, b.id)); }
F64 MulF64(F64 a, F64 b) { return a.With(terms::FloatMul(*a.terms, a.id, b.id)); }
F64 DivF64(F64 a, F64 b) { return a.With(terms::FloatDiv(*a.terms, a.id, b.id)); }
F64 NegateF64(F64 a) { return a.With(terms::FloatNegate(*a.terms, a.id)); }
F64 AbsF64(F64 a) { return a.With(terms::FloatAbs(*a.terms, a.id)); }
F64 FloorF64(F64 a) { return a.With(terms::FloatFloor(*a.terms, a.id)); }
F64 CeilF64(F64 a) { return a.With(terms::FloatCeil(*a.terms, a.id)); }
F64 SqrtF64(F64 a) { return a.With(terms::FloatSqrt(*a.terms, a.id)); }
F64 SignedToF64(I32 a) { return a.With(terms::FloatFromSigned(*a.terms, a.id, 64)); }
F64 UnsignedToF64(I32 a) { return a.With(terms::FloatFromUnsigned(*a.terms, a.id, 64)); }

/// Toward zero to 64 bits, of which the low half counts; from 2^63 on, and of NaN, 0.
I32 TruncateF64(F64 a) {
  const Value limit = a.With(terms::FloatConst(*a.terms, 0x1p63, 64));
  const Value whole = a.With(terms::FloatToSigned(*a.terms, a.id, 64));
  return Select(IsLess(NegateF64(limit), a) & IsLess(a, limit), Low(whole, 32), a.Const(0, 32));
}

F64 WidenF32(F32 a) { return a.With(terms::FloatWiden(*a.terms, a.id)); }
F32 NarrowF64(F64 a) { return a.With(terms::FloatNarrow(*a.terms, a.id)); }

Bit EqualF64(F64 a, F64 b) { return IsEqual(a, b); }
Bit NotEqualF64(F64 a, F64 b) { return Not(IsEqual(a, b)); }
Bit LessF64(F64 a, F64 b) { return IsLess(a, b); }
Bit LessEqualF64(F64 a, F64 b) { return IsAtMost(a, b); }
Bit GreaterF64(F64 a, F64 b) { return IsLess(b, a); }
Bit GreaterEqualF64(F64 a, F64 b) { return IsAtMost(b, a); }
F64 SelectF64(Bit condition, F64 a, F64 b) { return Select(condition, a, b); }

}  // namespace plcxx::meaning
