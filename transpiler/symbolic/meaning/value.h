// Terms with operators, so that a meaning reads like its definition.
//
// A Value is a term and the table it is in. Integers have no sign, as in the IR: what depends on it is a function by
// name. Numbers stand for constants of the other operand's width. Comparisons give terms, not bools.
#pragma once

#include <cstdint>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::meaning {

struct Value {
  terms::Terms* terms = nullptr;
  terms::TermId id;

  uint8_t width() const { return terms->Width(id); }
  Value With(terms::TermId term) const { return {terms, term}; }
  /// A constant: of this width, of another one, a single bit.
  Value Same(uint64_t value) const { return With(terms->Const(value, width())); }
  Value Const(uint64_t value, uint8_t bits) const { return With(terms->Const(value, bits)); }
  Value Bit(bool value) const { return With(terms->Bit(value)); }
};

inline Value operator&(Value a, Value b) { return a.With(a.terms->And(a.id, b.id)); }
inline Value operator|(Value a, Value b) { return a.With(a.terms->Or(a.id, b.id)); }
inline Value operator^(Value a, Value b) { return a.With(a.terms->Xor(a.id, b.id)); }
inline Value operator+(Value a, Value b) { return a.With(a.terms->Add(a.id, b.id)); }
inline Value operator-(Value a, Value b) { return a.With(a.terms->Sub(a.id, b.id)); }
inline Value operator*(Value a, Value b) { return a.With(a.terms->Mul(a.id, b.id)); }
inline Value operator==(Value a, Value b) { return a.With(a.terms->Eq(a.id, b.id)); }
inline Value operator!=(Value a, Value b) { return a.With(a.terms->Ne(a.id, b.id)); }
/// Shifts that bring in zeros; the count has the width of the value, and by the width or more nothing is left.
inline Value operator<<(Value a, Value count) { return a.With(a.terms->Shl(a.id, count.id)); }
inline Value operator>>(Value a, Value count) { return a.With(a.terms->Lshr(a.id, count.id)); }

inline Value operator&(Value a, uint64_t b) { return a & a.Same(b); }
inline Value operator|(Value a, uint64_t b) { return a | a.Same(b); }
inline Value operator+(Value a, uint64_t b) { return a + a.Same(b); }
inline Value operator-(Value a, uint64_t b) { return a - a.Same(b); }
inline Value operator*(Value a, uint64_t b) { return a * a.Same(b); }
inline Value operator==(Value a, uint64_t b) { return a == a.Same(b); }
inline Value operator!=(Value a, uint64_t b) { return a != a.Same(b); }
inline Value operator<<(Value a, uint64_t count) { return a << a.Same(count); }
inline Value operator>>(Value a, uint64_t count) { return a >> a.Same(count); }

/// Every bit complemented; of a bit: not.
inline Value Not(Value a) { return a.With(a.terms->Not(a.id)); }
inline Value Minus(Value a) { return a.With(a.terms->Neg(a.id)); }
/// Without sign; the divisor must not be 0.
inline Value Quotient(Value a, Value b) { return a.With(a.terms->Udiv(a.id, b.id)); }
inline Value Remainder(Value a, Value b) { return a.With(a.terms->Urem(a.id, b.id)); }
inline Value Quotient(Value a, uint64_t b) { return Quotient(a, a.Same(b)); }
inline Value Remainder(Value a, uint64_t b) { return Remainder(a, a.Same(b)); }

/// Without sign.
inline Value Less(Value a, Value b) { return a.With(a.terms->Ult(a.id, b.id)); }
inline Value AtMost(Value a, Value b) { return a.With(a.terms->Ule(a.id, b.id)); }
inline Value Less(Value a, uint64_t b) { return Less(a, a.Same(b)); }
inline Value AtMost(Value a, uint64_t b) { return AtMost(a, a.Same(b)); }
/// As two's complement.
inline Value SignedLess(Value a, Value b) { return a.With(a.terms->Slt(a.id, b.id)); }
inline Value SignedAtMost(Value a, Value b) { return a.With(a.terms->Sle(a.id, b.id)); }

inline Value Select(Value condition, Value then, Value otherwise) {
  return condition.With(condition.terms->Ite(condition.id, then.id, otherwise.id));
}
/// `field` becomes `value` where `condition` holds.
inline void SetIf(Value condition, Value& field, Value value) { field = Select(condition, value, field); }

inline Value Join(Value high, Value low) { return high.With(high.terms->Concat(high.id, low.id)); }
/// `count` bits from bit `low` on.
inline Value Bits(Value a, uint8_t low, uint8_t count) { return a.With(a.terms->Extract(a.id, low, count)); }
inline Value Low(Value a, uint8_t count) { return Bits(a, 0, count); }
inline Value High(Value a, uint8_t count) { return Bits(a, static_cast<uint8_t>(a.width() - count), count); }
/// The highest bit.
inline Value Sign(Value a) { return High(a, 1); }
inline Value Zext(Value a, uint8_t width) { return a.With(a.terms->Zext(a.id, width)); }
inline Value Sext(Value a, uint8_t width) { return a.With(a.terms->Sext(a.id, width)); }

}  // namespace plcxx::meaning
