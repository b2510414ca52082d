#include "transpiler/symbolic/terms/floats.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace plcxx::terms {
namespace {

/// What a format is made of: sign, exponent, fraction from the top.
struct Format {
  uint8_t width;
  uint8_t fraction_bits;
  std::string_view name;

  uint64_t sign() const { return uint64_t{1} << (width - 1); }
  uint64_t infinity() const { return (sign() - 1) & ~((uint64_t{1} << fraction_bits) - 1); }
  uint64_t bias() const { return infinity() >> (fraction_bits + 1); }
  /// 2^power, of a power that is in the range of normal numbers.
  uint64_t PowerOfTwo(int power) const {
    return (bias() + static_cast<uint64_t>(static_cast<int64_t>(power))) << fraction_bits;
  }
};
constexpr Format kBinary32{32, 23, "f32"};
constexpr Format kBinary64{64, 52, "f64"};

Format FormatOf(uint8_t width) {
  PLCXX_CHECK(width == 32 || width == 64);
  return width == 32 ? kBinary32 : kBinary64;
}
Format FormatOf(const Terms& terms, TermId a) { return FormatOf(terms.Width(a)); }

// --- values of concrete numbers -----------------------------------------------------------------------------------

template <class T>
T FromBits(uint64_t bits) {
  if constexpr (std::is_same_v<T, float>) return std::bit_cast<float>(static_cast<uint32_t>(bits));
  if constexpr (std::is_same_v<T, double>) return std::bit_cast<double>(bits);
}

/// Every NaN as one.
template <class T>
uint64_t ToBits(T value) {
  if constexpr (std::is_same_v<T, float>) {
    return std::isnan(value) ? uint32_t{0x7FC00000} : std::bit_cast<uint32_t>(value);
  } else {
    return std::isnan(value) ? uint64_t{0x7FF8000000000000} : std::bit_cast<uint64_t>(value);
  }
}

using Evaluation = uint64_t (*)(std::span<const uint64_t>);
/// The evaluation for binary32 and for binary64.
using Evaluations = std::array<Evaluation, 2>;

/// Both evaluations of an operation that `kOperation` computes for operands of type float or double.
template <auto kOperation>
constexpr Evaluations OfUnary() {
  return {[](std::span<const uint64_t> a) { return ToBits<float>(kOperation(FromBits<float>(a[0]))); },
          [](std::span<const uint64_t> a) { return ToBits<double>(kOperation(FromBits<double>(a[0]))); }};
}
template <auto kOperation>
constexpr Evaluations OfBinary() {
  return {
      [](std::span<const uint64_t> a) {
        return ToBits<float>(kOperation(FromBits<float>(a[0]), FromBits<float>(a[1])));
      },
      [](std::span<const uint64_t> a) {
        return ToBits<double>(kOperation(FromBits<double>(a[0]), FromBits<double>(a[1])));
      },
  };
}

constexpr Evaluations kFromSigned = {
    [](std::span<const uint64_t> a) { return ToBits(static_cast<float>(static_cast<int64_t>(a[0]))); },
    [](std::span<const uint64_t> a) { return ToBits(static_cast<double>(static_cast<int64_t>(a[0]))); }};
constexpr Evaluations kFromUnsigned = {[](std::span<const uint64_t> a) { return ToBits(static_cast<float>(a[0])); },
                                       [](std::span<const uint64_t> a) { return ToBits(static_cast<double>(a[0])); }};

/// Every binary32 is a binary64, so one conversion serves both. What does not fit is 0.
uint64_t SignedOf(double value) {
  if (!(value >= -0x1p63 && value < 0x1p63)) return 0;
  return static_cast<uint64_t>(static_cast<int64_t>(value));
}
uint64_t UnsignedOf(double value) { return value > -1.0 && value < 0x1p64 ? static_cast<uint64_t>(value) : 0; }

constexpr Evaluations kToSigned = {[](std::span<const uint64_t> a) { return SignedOf(FromBits<float>(a[0])); },
                                   [](std::span<const uint64_t> a) { return SignedOf(FromBits<double>(a[0])); }};
constexpr Evaluations kToUnsigned = {[](std::span<const uint64_t> a) { return UnsignedOf(FromBits<float>(a[0])); },
                                     [](std::span<const uint64_t> a) { return UnsignedOf(FromBits<double>(a[0])); }};

// --- terms --------------------------------------------------------------------------------------------------------

/// The named function `operation` of a format.
TermId Apply(Terms& terms, Format format, std::string_view operation, uint8_t result_width, Evaluations evaluate,
             std::span<const TermId> operands) {
  const std::string name = std::string(format.name) + "." + std::string(operation);
  return terms.Apply(terms.Function(name, result_width, evaluate[format.width == 32 ? 0 : 1]), operands);
}

TermId ApplyCommutative(Terms& terms, std::string_view operation, Evaluations evaluate, TermId a, TermId b) {
  // Numbers last: the order of others depends on which side has made them first.
  if (terms.IsConst(a) || (!terms.IsConst(b) && b < a)) std::swap(a, b);
  const Format format = FormatOf(terms, a);
  PLCXX_CHECK(terms.Width(b) == format.width);
  const std::array operands{a, b};
  return Apply(terms, format, operation, format.width, evaluate, operands);
}

/// A function of a choice is a choice of functions where that makes one of them a constant, as compilers have it.
template <class Make>
TermId OverChoices(Terms& terms, TermId a, Make&& make, int depth = 16) {
  const Term term = terms[a];
  if (term.kind != TermKind::kIte || depth == 0 || (!terms.IsConst(TermId(term.b)) && !terms.IsConst(TermId(term.c)))) {
    return make(a);
  }
  const TermId then = OverChoices(terms, TermId(term.b), make, depth - 1);
  return terms.Ite(TermId(term.a), then, OverChoices(terms, TermId(term.c), make, depth - 1));
}

bool IsConstOf(const Terms& terms, TermId a, uint64_t bits) { return terms.IsConst(a) && terms.Value(a) == bits; }

constexpr std::string_view kFromS64 = "from_s64", kFromU64 = "from_u64", kToF64 = "to_f64", kToF32 = "to_f32";

TermId Magnitude(Terms& terms, TermId a) { return terms.Extract(a, 0, static_cast<uint8_t>(terms.Width(a) - 1)); }
TermId Sign(Terms& terms, TermId a) { return terms.Extract(a, static_cast<uint8_t>(terms.Width(a) - 1), 1); }
/// Of a conversion, the integer; else none.
TermId IntegerOf(const Terms& terms, TermId a) {
  const Term& term = terms[a];
  if (term.kind != TermKind::kApply) return {};
  const std::string_view name = terms.Info(FunctionId(term.a)).name;
  return name.ends_with(kFromS64) || name.ends_with(kFromU64) ? terms.Arguments(term).front() : TermId();
}

TermId IsZero(Terms& terms, TermId a) {
  // Compilers ask the integer.
  if (const TermId integer = IntegerOf(terms, a); integer.valid()) return terms.Eq(integer, terms.Const(0, 64));
  const TermId magnitude = Magnitude(terms, a);
  return terms.Eq(magnitude, terms.Const(0, terms.Width(magnitude)));
}
TermId SignMask(Terms& terms, Format format) { return terms.Const(format.sign(), format.width); }

/// Without the sign that was put before it: of a constant, or by FloatNegate.
TermId WithoutSign(Terms& terms, Format format, TermId a, bool& negative) {
  const Term term = terms[a];
  if (term.kind == TermKind::kConst && (terms.Value(a) & format.sign()) != 0) {
    negative = !negative;
    return terms.Const(terms.Value(a) & ~format.sign(), format.width);
  }
  if (term.kind != TermKind::kXor) return a;
  for (const auto& [mask, other] : {std::pair(term.a, term.b), std::pair(term.b, term.a)}) {
    if (!IsConstOf(terms, TermId(mask), format.sign())) continue;
    negative = !negative;
    return TermId(other);
  }
  return a;
}

bool TakeSign(Terms& terms, Format format, TermId& a) {
  bool negative = false;
  a = WithoutSign(terms, format, a, negative);
  return negative;
}

/// Of a product or a quotient: compilers move a sign from one operand to the other, and to the result. Whether the
/// result of what `a` and `b` are then has to be negated.
bool TakeSigns(Terms& terms, Format format, TermId& a, TermId& b) {
  bool negative = false;
  a = WithoutSign(terms, format, a, negative);
  b = WithoutSign(terms, format, b, negative);
  return negative;
}

/// Of numbers that have a fraction, or may: below 2^fraction_bits.
TermId IsBelowWholeNumbers(Terms& terms, TermId a) {
  const Format format = FormatOf(terms, a);
  return FloatLess(terms, FloatAbs(terms, a), terms.Const(format.PowerOfTwo(format.fraction_bits), format.width));
}
/// Toward zero, of numbers below 2^fraction_bits.
TermId WholePart(Terms& terms, TermId a) { return FloatFromSigned(terms, FloatToSigned(terms, a, 64), terms.Width(a)); }
/// `whole`, and where that is zero the zero with the sign of `a`; numbers that have no fraction stay.
TermId RoundedTo(Terms& terms, TermId a, TermId whole) {
  const TermId zero = terms.And(a, SignMask(terms, FormatOf(terms, a)));
  return terms.Ite(IsBelowWholeNumbers(terms, a), terms.Ite(IsZero(terms, whole), zero, whole), a);
}

}  // namespace

TermId FloatAdd(Terms& terms, TermId a, TermId b) {
  constexpr Evaluations kEvaluations = OfBinary<[](auto x, auto y) { return x + y; }>();
  const Format format = FormatOf(terms, a);
  // Only the negative zero changes no number.
  if (IsConstOf(terms, a, format.sign())) return b;
  if (IsConstOf(terms, b, format.sign())) return a;
  if (a == b && TakeSign(terms, format, a)) return FloatNegate(terms, FloatAdd(terms, a, a));
  return ApplyCommutative(terms, "add", kEvaluations, a, b);
}

TermId FloatSub(Terms& terms, TermId a, TermId b) { return FloatAdd(terms, a, FloatNegate(terms, b)); }

TermId FloatMul(Terms& terms, TermId a, TermId b) {
  constexpr Evaluations kEvaluations = OfBinary<[](auto x, auto y) { return x * y; }>();
  const Format format = FormatOf(terms, a);
  const uint64_t one = format.PowerOfTwo(0), two = format.PowerOfTwo(1);
  for (const auto& [constant, other] : {std::pair(a, b), std::pair(b, a)}) {
    if (IsConstOf(terms, constant, one)) return other;
    // A number and itself, exact as the product is, and what compilers make of it.
    if (IsConstOf(terms, constant, two)) return FloatAdd(terms, other, other);
  }
  if (TakeSigns(terms, format, a, b)) return FloatNegate(terms, FloatMul(terms, a, b));
  return ApplyCommutative(terms, "mul", kEvaluations, a, b);
}

TermId FloatDiv(Terms& terms, TermId a, TermId b) {
  constexpr Evaluations kEvaluations = OfBinary<[](auto x, auto y) { return x / y; }>();
  const Format format = FormatOf(terms, a);
  PLCXX_CHECK(terms.Width(b) == format.width);
  if (terms.IsConst(b)) {
    // By a power of two whose inverse is a normal number, both exact.
    const uint64_t divisor = terms.Value(b), magnitude = divisor & ~format.sign();
    const uint64_t exponent = magnitude >> format.fraction_bits;
    if (magnitude == exponent << format.fraction_bits && exponent >= 1 && exponent < 2 * format.bias()) {
      const uint64_t inverse = (2 * format.bias() - exponent) << format.fraction_bits;
      return FloatMul(terms, a, terms.Const(inverse | (divisor & format.sign()), format.width));
    }
  }
  if (TakeSigns(terms, format, a, b)) return FloatNegate(terms, FloatDiv(terms, a, b));
  const std::array operands{a, b};
  return Apply(terms, format, "div", format.width, kEvaluations, operands);
}

TermId FloatSqrt(Terms& terms, TermId a) {
  constexpr Evaluations kEvaluations = OfUnary<[](auto x) { return std::sqrt(x); }>();
  const Format format = FormatOf(terms, a);
  return Apply(terms, format, "sqrt", format.width, kEvaluations, {&a, 1});
}

TermId FloatRint(Terms& terms, TermId a) {
  constexpr Evaluations kEvaluations = OfUnary<[](auto x) { return std::nearbyint(x); }>();
  const Format format = FormatOf(terms, a);
  return Apply(terms, format, "rint", format.width, kEvaluations, {&a, 1});
}

TermId FloatFloor(Terms& terms, TermId a) {
  const TermId whole = WholePart(terms, a);
  const TermId below = FloatAdd(terms, whole, FloatConst(terms, -1.0, terms.Width(a)));
  return RoundedTo(terms, a, terms.Ite(FloatLess(terms, a, whole), below, whole));
}

TermId FloatCeil(Terms& terms, TermId a) { return FloatNegate(terms, FloatFloor(terms, FloatNegate(terms, a))); }

TermId FloatTrunc(Terms& terms, TermId a) { return RoundedTo(terms, a, WholePart(terms, a)); }

TermId FloatNegate(Terms& terms, TermId a) { return terms.Xor(a, SignMask(terms, FormatOf(terms, a))); }

TermId FloatAbs(Terms& terms, TermId a) { return terms.And(a, terms.Not(SignMask(terms, FormatOf(terms, a)))); }

TermId FloatCopySign(Terms& terms, TermId a, TermId sign) {
  return terms.Or(FloatAbs(terms, a), terms.And(sign, SignMask(terms, FormatOf(terms, sign))));
}

TermId FloatIsNan(Terms& terms, TermId a) {
  const Format format = FormatOf(terms, a);
  // Compilers leave out the question where the number comes from an integer.
  if (IntegerOf(terms, a).valid()) return terms.Bit(false);
  const Term term = terms[a];
  if (term.kind == TermKind::kApply) {
    const std::string_view name = terms.Info(FunctionId(term.a)).name;
    if (name.ends_with(kToF64) || name.ends_with(kToF32)) return FloatIsNan(terms, terms.Arguments(term).front());
  }
  return terms.Ult(terms.Const(format.infinity(), static_cast<uint8_t>(format.width - 1)), Magnitude(terms, a));
}

TermId FloatEqual(Terms& terms, TermId a, TermId b) {
  if (terms.IsConst(a)) std::swap(a, b);
  if (terms.IsConst(b) && terms.IsTrue(IsZero(terms, b))) return IsZero(terms, a);
  const TermId numbers = terms.Not(terms.Or(FloatIsNan(terms, a), FloatIsNan(terms, b)));
  const TermId zeros = terms.And(IsZero(terms, a), IsZero(terms, b));
  return terms.And(numbers, terms.Or(terms.Eq(a, b), zeros));
}

TermId FloatLess(Terms& terms, TermId a, TermId b) {
  const TermId numbers = terms.Not(terms.Or(FloatIsNan(terms, a), FloatIsNan(terms, b)));
  const TermId zeros = terms.And(IsZero(terms, a), IsZero(terms, b));
  const TermId size_a = Magnitude(terms, a), size_b = Magnitude(terms, b);
  const TermId sign_a = Sign(terms, a), sign_b = Sign(terms, b);
  const TermId less = terms.Ite(sign_a, terms.Ite(sign_b, terms.Ult(size_b, size_a), terms.Not(zeros)),
                                terms.And(terms.Not(sign_b), terms.Ult(size_a, size_b)));
  return terms.And(numbers, less);
}

TermId FloatLessEqual(Terms& terms, TermId a, TermId b) {
  const TermId numbers = terms.Not(terms.Or(FloatIsNan(terms, a), FloatIsNan(terms, b)));
  return terms.And(numbers, terms.Not(FloatLess(terms, b, a)));
}

TermId FloatFromSigned(Terms& terms, TermId integer, uint8_t width) {
  return OverChoices(terms, integer, [&](TermId value) {
    const TermId wide = terms.Sext(value, 64);
    return Apply(terms, FormatOf(width), kFromS64, width, kFromSigned, {&wide, 1});
  });
}

TermId FloatFromUnsigned(Terms& terms, TermId integer, uint8_t width) {
  return OverChoices(terms, integer, [&](TermId value) {
    if (terms.Width(value) < 64) return FloatFromSigned(terms, terms.Zext(value, 64), width);
    return Apply(terms, FormatOf(width), kFromU64, width, kFromUnsigned, {&value, 1});
  });
}

TermId FloatToSigned(Terms& terms, TermId a, uint8_t width) {
  return OverChoices(terms, a, [&](TermId value) {
    return terms.Extract(Apply(terms, FormatOf(terms, value), "to_s64", 64, kToSigned, {&value, 1}), 0, width);
  });
}

TermId FloatToUnsigned(Terms& terms, TermId a, uint8_t width) {
  if (width < 64) return FloatToSigned(terms, a, width);
  return OverChoices(terms, a, [&](TermId value) {
    return Apply(terms, FormatOf(terms, value), "to_u64", 64, kToUnsigned, {&value, 1});
  });
}

TermId FloatWiden(Terms& terms, TermId a) {
  constexpr Evaluation kEvaluate = [](std::span<const uint64_t> x) {
    return ToBits(static_cast<double>(FromBits<float>(x[0])));
  };
  return OverChoices(terms, a, [&](TermId value) {
    PLCXX_CHECK(terms.Width(value) == 32);
    return Apply(terms, kBinary32, kToF64, 64, {kEvaluate, kEvaluate}, {&value, 1});
  });
}

TermId FloatNarrow(Terms& terms, TermId a) {
  constexpr Evaluation kEvaluate = [](std::span<const uint64_t> x) {
    return ToBits(static_cast<float>(FromBits<double>(x[0])));
  };
  return OverChoices(terms, a, [&](TermId value) {
    PLCXX_CHECK(terms.Width(value) == 64);
    return Apply(terms, kBinary64, kToF32, 32, {kEvaluate, kEvaluate}, {&value, 1});
  });
}

TermId FloatConst(Terms& terms, double value, uint8_t width) {
  return terms.Const(width == 32 ? ToBits(static_cast<float>(value)) : ToBits(value), width);
}

}  // namespace plcxx::terms
