// Floating point of IEEE 754 as terms: binary32 are terms of 32 bits, binary64 terms of 64.
//
// What only moves bits is made of bits: signs, and comparisons, which are exact that way. What rounds is a named
// function ("f32.add") that a solver knows nothing of but that equal operands give equal results, and that has a value
// for concrete operands: rounded to nearest even, every NaN the same one. The typed IR and compiled code must use the
// same functions, so each is brought to one form: a - b is a + (-b), a / 4 is a * 0.25, a * 2 is a + a, operands that
// may be swapped stand in the order of their ids, conversions of integers go by way of 64 bits. NaN is not further told
// apart: where the sign or the payload of a NaN would matter, these functions are no description of a processor.
#pragma once

#include <cstdint>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

/// Operands and result are of one format, which their width says.
TermId FloatAdd(Terms& terms, TermId a, TermId b);
TermId FloatSub(Terms& terms, TermId a, TermId b);
TermId FloatMul(Terms& terms, TermId a, TermId b);
TermId FloatDiv(Terms& terms, TermId a, TermId b);
TermId FloatSqrt(Terms& terms, TermId a);
/// To a whole number, ties to even.
TermId FloatRint(Terms& terms, TermId a);
/// To a whole number: downward, upward, toward zero. A zero keeps the sign that the number had.
TermId FloatFloor(Terms& terms, TermId a);
TermId FloatCeil(Terms& terms, TermId a);
TermId FloatTrunc(Terms& terms, TermId a);

/// Bits: the sign inverted, cleared, taken from another number; also of NaN.
TermId FloatNegate(Terms& terms, TermId a);
TermId FloatAbs(Terms& terms, TermId a);
TermId FloatCopySign(Terms& terms, TermId a, TermId sign);

/// Of width 1. The ordered comparisons, false with a NaN; a > b is FloatLess(b, a).
TermId FloatIsNan(Terms& terms, TermId a);
TermId FloatEqual(Terms& terms, TermId a, TermId b);
TermId FloatLess(Terms& terms, TermId a, TermId b);
TermId FloatLessEqual(Terms& terms, TermId a, TermId b);

/// The nearest number to an integer of any width; `width` (32 or 64) is of the result.
TermId FloatFromSigned(Terms& terms, TermId integer, uint8_t width);
TermId FloatFromUnsigned(Terms& terms, TermId integer, uint8_t width);
/// Toward zero, to an integer of `width` bits; what does not fit gives some integer, as in C++: ask for the range
/// first.
TermId FloatToSigned(Terms& terms, TermId a, uint8_t width);
TermId FloatToUnsigned(Terms& terms, TermId a, uint8_t width);

/// Between binary32 and binary64.
TermId FloatWiden(Terms& terms, TermId a);
TermId FloatNarrow(Terms& terms, TermId a);

/// The number of this format as a term.
TermId FloatConst(Terms& terms, double value, uint8_t width);

}  // namespace plcxx::terms
