// Floating point as terms against the processor's, and the forms that make different spellings one term.
#include "transpiler/symbolic/terms/floats.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::prove {
namespace {

template <class T>
constexpr uint8_t kWidth = sizeof(T) * 8;

template <class T>
uint64_t BitsOf(T value) {
  if constexpr (std::is_same_v<T, float>) return std::bit_cast<uint32_t>(value);
  if constexpr (std::is_same_v<T, double>) return std::bit_cast<uint64_t>(value);
}
template <class T>
T OfBits(uint64_t bits) {
  if constexpr (std::is_same_v<T, float>) return std::bit_cast<float>(static_cast<uint32_t>(bits));
  if constexpr (std::is_same_v<T, double>) return std::bit_cast<double>(bits);
}

template <class T>
class Floats : public testing::Test {
 protected:
  /// Numbers of every kind, the borders of the formats and of integers among them.
  static std::vector<T> Numbers() {
    using Limits = std::numeric_limits<T>;
    std::vector<T> numbers = {0,
                              Limits::denorm_min(),
                              Limits::min(),
                              Limits::max(),
                              Limits::infinity(),
                              Limits::quiet_NaN(),
                              T(0.5),
                              T(0.49999997),
                              T(1),
                              T(1.5),
                              T(2),
                              T(2.5),
                              T(3)};
    for (const int power : {22, 23, 24, 31, 32, 51, 52, 53, 62, 63, 64}) {
      const T border = std::ldexp(T(1), power);
      for (const T number : {std::nextafter(border, T(0)), border, std::nextafter(border, Limits::infinity())}) {
        numbers.push_back(number);
      }
    }
    std::mt19937_64 random(5);
    for (int i = 0; i < 30; ++i) {
      numbers.push_back(OfBits<T>(random()));
      numbers.push_back(static_cast<T>(static_cast<double>(random() % 20000) / 64.0));
    }
    const size_t positive = numbers.size();
    for (size_t i = 0; i < positive; ++i) numbers.push_back(-numbers[i]);
    return numbers;
  }

  static void ExpectSame(uint64_t bits, T expected) {
    const T value = OfBits<T>(bits);
    if (std::isnan(expected)) {
      EXPECT_TRUE(std::isnan(value));
    } else {
      EXPECT_EQ(bits, BitsOf(expected)) << value << " for " << expected;
    }
  }

  template <class Make, class Function>
  void ExpectUnary(Make&& make, Function&& function) {
    const terms::TermId x = terms_.Variable("x", kWidth<T>);
    const terms::TermId result = make(terms_, x);
    for (const T a : Numbers()) {
      std::vector<uint64_t> variables(terms_.variable_count());
      variables.back() = BitsOf(a);
      SCOPED_TRACE(a);
      ExpectSame(terms::Evaluate(terms_, result, variables), function(a));
      const terms::TermId folded = make(terms_, terms_.Const(BitsOf(a), kWidth<T>));
      ASSERT_TRUE(terms_.IsConst(folded));
      ExpectSame(terms_.Value(folded), function(a));
    }
  }

  /// With each operand as a variable and as a constant.
  template <class Make, class Check>
  void ExpectBinary(Make&& make, Check&& check) {
    terms::Terms terms;
    const terms::TermId x = terms.Variable("x", kWidth<T>), y = terms.Variable("y", kWidth<T>);
    const terms::TermId of_variables = make(terms, x, y);
    const std::vector<T> numbers = Numbers();
    for (size_t i = 0; i < numbers.size(); ++i) {
      for (size_t k = i % 11; k < numbers.size(); k += 11) {
        const T a = numbers[i], b = numbers[k];
        const std::vector<uint64_t> variables = {BitsOf(a), BitsOf(b)};
        SCOPED_TRACE(testing::Message() << a << " and " << b);
        check(terms::Evaluate(terms, of_variables, variables), a, b);
        terms::Terms others;
        const terms::TermId z = others.Variable("z", kWidth<T>);
        check(terms::Evaluate(others, make(others, z, others.Const(BitsOf(b), kWidth<T>)), {variables.data(), 1}), a,
              b);
        check(terms::Evaluate(others, make(others, others.Const(BitsOf(a), kWidth<T>), z), {variables.data() + 1, 1}),
              a, b);
      }
    }
  }

  template <class Make, class Function>
  void ExpectArithmetic(Make&& make, Function&& function) {
    ExpectBinary(make, [&](uint64_t bits, T a, T b) { ExpectSame(bits, function(a, b)); });
  }
  template <class Make, class Function>
  void ExpectComparison(Make&& make, Function&& function) {
    ExpectBinary(make, [&](uint64_t bit, T a, T b) { EXPECT_EQ(bit, function(a, b) ? 1U : 0U); });
  }

  terms::Terms terms_;
};

using Formats = testing::Types<float, double>;
TYPED_TEST_SUITE(Floats, Formats);

TYPED_TEST(Floats, Arithmetic) {
  this->ExpectArithmetic(terms::FloatAdd, [](auto a, auto b) { return a + b; });
  this->ExpectArithmetic(terms::FloatSub, [](auto a, auto b) { return a - b; });
  this->ExpectArithmetic(terms::FloatMul, [](auto a, auto b) { return a * b; });
  this->ExpectArithmetic(terms::FloatDiv, [](auto a, auto b) { return a / b; });
  this->ExpectArithmetic(terms::FloatCopySign, [](auto a, auto b) { return std::copysign(a, b); });
}

TYPED_TEST(Floats, Comparisons) {
  this->ExpectComparison(terms::FloatEqual, [](auto a, auto b) { return a == b; });
  this->ExpectComparison(terms::FloatLess, [](auto a, auto b) { return a < b; });
  this->ExpectComparison(terms::FloatLessEqual, [](auto a, auto b) { return a <= b; });
  this->ExpectComparison(
      [](terms::Terms& terms, terms::TermId a, terms::TermId) { return terms::FloatIsNan(terms, a); },
      [](auto a, auto) { return std::isnan(a); });
}

TYPED_TEST(Floats, FunctionsOfOneNumber) {
  this->ExpectUnary(terms::FloatNegate, [](auto a) { return -a; });
  this->ExpectUnary(terms::FloatAbs, [](auto a) { return std::fabs(a); });
  this->ExpectUnary(terms::FloatFloor, [](auto a) { return std::floor(a); });
  this->ExpectUnary(terms::FloatCeil, [](auto a) { return std::ceil(a); });
  this->ExpectUnary(terms::FloatTrunc, [](auto a) { return std::trunc(a); });
  this->ExpectUnary(terms::FloatRint, [](auto a) { return std::nearbyint(a); });
  this->ExpectUnary(terms::FloatSqrt, [](auto a) { return std::sqrt(a); });
}

TYPED_TEST(Floats, Integers) {
  std::mt19937_64 random(6);
  for (const uint8_t width : std::initializer_list<uint8_t>{8, 16, 32, 64}) {
    terms::Terms terms;
    const terms::TermId x = terms.Variable("x", width), y = terms.Variable("y", kWidth<TypeParam>);
    const terms::TermId from_signed = terms::FloatFromSigned(terms, x, kWidth<TypeParam>);
    const terms::TermId from_unsigned = terms::FloatFromUnsigned(terms, x, kWidth<TypeParam>);
    const terms::TermId to_signed = terms::FloatToSigned(terms, y, width),
                        to_unsigned = terms::FloatToUnsigned(terms, y, width);
    for (int i = 0; i < 500; ++i) {
      const uint64_t bits = terms::Masked(i % 3 == 0 ? uint64_t{0} - random() % 3 : random() >> random() % 64, width);
      const int64_t number = terms::AsSigned(bits, width);
      const std::vector<uint64_t> variables = {bits};
      this->ExpectSame(terms::Evaluate(terms, from_signed, variables), static_cast<TypeParam>(number));
      this->ExpectSame(terms::Evaluate(terms, from_unsigned, variables), static_cast<TypeParam>(bits));
      // Back, of numbers that are in the range.
      const auto inside = static_cast<TypeParam>(number / 4) + TypeParam(0.25);
      const std::vector<uint64_t> back = {0, BitsOf(inside)};
      EXPECT_EQ(terms::Evaluate(terms, to_signed, back),
                terms::Masked(static_cast<uint64_t>(static_cast<int64_t>(inside)), width));
      const auto positive = static_cast<TypeParam>(bits / 4 * 3) + TypeParam(0.75);
      const std::vector<uint64_t> back_unsigned = {0, BitsOf(positive)};
      EXPECT_EQ(terms::Evaluate(terms, to_unsigned, back_unsigned), static_cast<uint64_t>(positive));
    }
  }
}

TEST(FloatFormats, AreConverted) {
  terms::Terms terms;
  const terms::TermId single = terms.Variable("single", 32), twice = terms.Variable("double", 64);
  const terms::TermId wide = terms::FloatWiden(terms, single), narrow = terms::FloatNarrow(terms, twice);
  for (const double number : {0.0, -0.0, 1.0 / 3.0, 1e39, -1e-46, 3.4e38, 16777217.0}) {
    const std::vector<uint64_t> variables = {BitsOf(static_cast<float>(number)), BitsOf(number)};
    EXPECT_EQ(terms::Evaluate(terms, wide, variables), BitsOf(static_cast<double>(static_cast<float>(number))));
    EXPECT_EQ(terms::Evaluate(terms, narrow, variables), BitsOf(static_cast<float>(number)));
  }
}

// What compilers make of each other's spellings.
TEST(FloatForms, OfOneMeaningAreOneTerm) {
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 64), y = terms.Variable("y", 64), n = terms.Variable("n", 32);
  const auto number = [&](double value) { return terms::FloatConst(terms, value, 64); };
  EXPECT_EQ(terms::FloatAdd(terms, x, y), terms::FloatAdd(terms, y, x));
  EXPECT_EQ(terms::FloatMul(terms, x, y), terms::FloatMul(terms, y, x));
  EXPECT_EQ(terms::FloatSub(terms, x, number(1.0)), terms::FloatAdd(terms, x, number(-1.0)));
  EXPECT_EQ(terms::FloatDiv(terms, x, number(4.0)), terms::FloatMul(terms, x, number(0.25)));
  EXPECT_NE(terms::FloatDiv(terms, x, number(3.0)), terms::FloatMul(terms, x, number(1.0 / 3.0)));
  EXPECT_EQ(terms::FloatMul(terms, number(2.0), x), terms::FloatAdd(terms, x, x));
  EXPECT_EQ(terms::FloatDiv(terms, x, number(-0.5)), terms::FloatNegate(terms, terms::FloatAdd(terms, x, x)));
  EXPECT_EQ(terms::FloatMul(terms, terms::FloatNegate(terms, x), number(2.0)),
            terms::FloatSub(terms, terms::FloatNegate(terms, x), x));
  EXPECT_NE(terms::FloatMul(terms, x, number(3.0)), terms::FloatAdd(terms, terms::FloatAdd(terms, x, x), x));
  EXPECT_EQ(terms::FloatNegate(terms, terms::FloatNegate(terms, x)), x);
  EXPECT_EQ(terms::FloatFromSigned(terms, terms.Sext(n, 64), 64), terms::FloatFromSigned(terms, n, 64));
  EXPECT_EQ(terms::FloatFromUnsigned(terms, n, 64), terms::FloatFromSigned(terms, terms.Zext(n, 64), 64));
  // A choice of a number and a constant.
  const terms::TermId c = terms.Variable("c", 1);
  EXPECT_EQ(terms::FloatFromSigned(terms, terms.Ite(c, n, terms.Const(7, 32)), 64),
            terms.Ite(c, terms::FloatFromSigned(terms, n, 64), number(7.0)));
}

}  // namespace
}  // namespace plcxx::prove
