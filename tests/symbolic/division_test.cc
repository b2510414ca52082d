// Divisions by constants as compilers write them: recognized where they are divisions, and only there.
#include "transpiler/symbolic/terms/division.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "transpiler/symbolic/terms/evaluate.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove {
namespace {

/// All products of a number of 6 bits and every factor, shifted by every number of bits, for every number.
TEST(Division, ProductsThatAreShifted) {
  constexpr uint8_t kBits = 6, kWidth = 14;
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", kBits);
  struct Shifted {
    terms::TermId result;
    uint64_t factor;
    uint8_t shift;
  };
  std::vector<Shifted> all;
  size_t recognized = 0;
  for (uint64_t factor = 0; factor < 600; ++factor) {
    const terms::TermId product = terms.Mul(terms.Zext(x, kWidth), terms.Const(factor, kWidth));
    for (uint8_t shift = 0; shift < kWidth; ++shift) {
      if (terms::QuotientOfProduct(terms, product, shift).valid()) ++recognized;
      all.push_back({terms.Lshr(product, terms.Const(shift, kWidth)), factor, shift});
    }
  }
  EXPECT_GT(recognized, 100U);
  for (uint64_t value = 0; value >> kBits == 0; ++value) {
    const std::array variables = {value};
    const std::vector<uint64_t> values = terms::EvaluateAll(terms, variables, terms::TermId(terms.size() - 1));
    for (const Shifted& one : all) {
      ASSERT_EQ(values[one.result.index], terms::Masked(value * one.factor, kWidth) >> one.shift)
          << value << " * " << one.factor << " >> " << int{one.shift};
    }
  }
}

/// The low bits of a number and of a multiple of a quotient of it, or of another number.
TEST(Division, RemaindersOfSums) {
  constexpr uint8_t kBits = 6;
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", kBits), y = terms.Variable("y", kBits);
  struct Sum {
    terms::TermId result, rest, quotient;
    uint64_t factor;
  };
  std::vector<Sum> sums;
  size_t recognized = 0;
  for (uint64_t divisor = 2; divisor < 24; ++divisor) {
    const terms::TermId quotient = terms.Udiv(x, terms.Const(divisor, kBits));
    for (const uint8_t width : {uint8_t{3}, uint8_t{4}, kBits, uint8_t{9}}) {
      for (const uint64_t factor : {0 - divisor, divisor, 0 - divisor - 1, 0 - 2 * divisor}) {
        for (const terms::TermId rest : {terms.Resize(x, width), terms.Resize(y, width)}) {
          const terms::TermId low = terms.Resize(quotient, width);
          const terms::TermId multiple = terms.Mul(low, terms.Const(factor, width));
          if (terms::RemainderOfSum(terms, rest, multiple).valid()) ++recognized;
          sums.push_back({terms.Add(rest, multiple), rest, low, factor});
        }
      }
    }
  }
  EXPECT_GT(recognized, 40U);
  for (uint64_t value = 0; value >> (2 * kBits) == 0; value += 5) {
    const std::array variables = {terms::Masked(value, kBits), value >> kBits};
    const std::vector<uint64_t> values = terms::EvaluateAll(terms, variables, terms::TermId(terms.size() - 1));
    for (const Sum& sum : sums) {
      const uint64_t all = values[sum.rest.index] + sum.factor * values[sum.quotient.index];
      ASSERT_EQ(values[sum.result.index], terms::Masked(all, terms.Width(sum.result)));
    }
  }
}

/// As digits are taken from a word of 16 bits: by 32-bit multiplications, in words that are cut to bytes.
TEST(Division, DigitsAreOneTermOnBothSides) {
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 16);
  const terms::TermId ten = terms.Const(10, 16), wide = terms.Zext(x, 32);
  const auto tenth = [&terms](terms::TermId number) {
    return terms.Lshr(terms.Mul(number, terms.Const(52429, 32)), terms.Const(19, 32));
  };
  EXPECT_EQ(tenth(wide), terms.Zext(terms.Udiv(x, ten), 32));
  EXPECT_EQ(tenth(tenth(wide)), terms.Zext(terms.Udiv(terms.Udiv(x, ten), ten), 32));
  const terms::TermId low = terms.Extract(tenth(wide), 0, 8);
  EXPECT_EQ(terms.Add(terms.Extract(x, 0, 8), terms.Mul(low, terms.Const(246, 8))),
            terms.Extract(terms.Urem(x, ten), 0, 8));
  EXPECT_TRUE(terms.IsZero(terms.Extract(terms.Urem(x, ten), 4, 12)));
  // One bit more, and it is not exact.
  const terms::TermId y = terms.Zext(terms.Variable("y", 19), 36);
  EXPECT_FALSE(terms::QuotientOfProduct(terms, terms.Mul(y, terms.Const(52429, 36)), 19).valid());
}

/// A clamped number is divided in as many bits as its bound needs, as compilers do.
TEST(Division, NumbersThatAreBounded) {
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 64);
  const auto clamped = [&terms](terms::TermId number, uint64_t bound) {
    const terms::TermId constant = terms.Const(bound, terms.Width(number));
    return terms.Ite(terms.Ult(constant, number), constant, number);
  };
  const terms::TermId wide = clamped(x, 19900);
  EXPECT_EQ(terms::GreatestOf(terms, wide), 19900U);
  EXPECT_EQ(terms.Udiv(wide, terms.Const(100, 64)),
            terms.Zext(terms.Udiv(terms.Extract(wide, 0, 16), terms.Const(100, 16)), 64));
  EXPECT_EQ(terms.Urem(wide, terms.Const(10, 64)),
            terms.Zext(terms.Urem(terms.Extract(wide, 0, 16), terms.Const(10, 16)), 64));
  EXPECT_TRUE(terms.IsZero(terms.Udiv(wide, terms.Const(19901, 64))));
  EXPECT_EQ(terms.Urem(wide, terms.Const(19901, 64)), wide);
  // A choice that says nothing of what is chosen.
  const terms::TermId other = terms.Ite(terms.Ult(x, terms.Const(5, 64)), terms.Variable("y", 64), terms.Const(7, 64));
  EXPECT_EQ(terms::GreatestOf(terms, other), ~uint64_t{0});
}

/// All numbers of 10 bits, bounded in several ways, against the processor.
TEST(Division, BoundedNumbersAreDividedAlike) {
  constexpr uint8_t kBits = 10;
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", kBits);
  const auto constant = [&terms](uint64_t value) { return terms.Const(value, kBits); };
  std::vector<terms::TermId> numbers = {x};
  for (const uint64_t bound : {3, 100, 255, 256, 700}) {
    numbers.push_back(terms.Ite(terms.Ult(x, constant(bound)), x, constant(bound)));
    numbers.push_back(terms.Ite(terms.Ult(x, constant(bound)), constant(bound), x));
    numbers.push_back(terms.Zext(terms.Extract(numbers[1], 0, 7), kBits));
    numbers.push_back(terms.Udiv(x, constant(bound)));
    numbers.push_back(terms.Urem(x, constant(bound)));
    numbers.push_back(terms.Ite(terms.Extract(x, 3, 1), numbers.back(), constant(2)));
  }
  struct Divided {
    terms::TermId number, quotient, rest;
    uint64_t divisor;
  };
  std::vector<Divided> all;
  for (const terms::TermId number : numbers) {
    for (const uint64_t divisor : {3, 7, 100, 129, 300})
      all.push_back({number, terms.Udiv(number, constant(divisor)), terms.Urem(number, constant(divisor)), divisor});
  }
  for (uint64_t value = 0; value >> kBits == 0; ++value) {
    const std::array variables = {value};
    const std::vector<uint64_t> values = terms::EvaluateAll(terms, variables, terms::TermId(terms.size() - 1));
    for (const Divided& one : all) {
      const uint64_t number = values[one.number.index];
      ASSERT_LE(number, terms::GreatestOf(terms, one.number));
      ASSERT_EQ(values[one.quotient.index], number / one.divisor);
      ASSERT_EQ(values[one.rest.index], number % one.divisor);
    }
  }
}

/// All parts of quotients and remainders of a number of 8 bits, for every number; above what they reach there are
/// zeros.
TEST(Division, PartsOfQuotientsAndRemainders) {
  constexpr uint8_t kBits = 8;
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", kBits);
  struct Part {
    terms::TermId whole, part;
    uint8_t low, width;
  };
  std::vector<Part> all;
  size_t zeros = 0;
  for (const uint64_t divisor : {3, 7, 10, 100, 129}) {
    const terms::TermId by = terms.Const(divisor, kBits);
    for (const terms::TermId whole :
         {terms.Udiv(x, by), terms.Urem(x, by), terms.Udiv(terms.Urem(x, by), terms.Const(10, kBits))}) {
      for (uint8_t low = 0; low < kBits; ++low) {
        for (uint8_t width = 1; low + width <= kBits; ++width) {
          all.push_back({whole, terms.Extract(whole, low, width), low, width});
          if (terms.IsZero(all.back().part)) ++zeros;
        }
      }
    }
  }
  EXPECT_GT(zeros, 100U);
  EXPECT_TRUE(terms.IsZero(terms.Extract(terms.Urem(x, terms.Const(10, kBits)), 4, 4)));
  for (uint64_t value = 0; value >> kBits == 0; ++value) {
    const std::array variables = {value};
    const std::vector<uint64_t> values = terms::EvaluateAll(terms, variables, terms::TermId(terms.size() - 1));
    for (const Part& one : all)
      ASSERT_EQ(values[one.part.index], terms::Masked(values[one.whole.index] >> one.low, one.width));
  }
}

/// Every number with a sign by every divisor that has none, 0 among them, which divides as Evaluate says.
TEST(Division, SignedNumbersByOnesWithoutSign) {
  constexpr uint8_t kBits = 5, kDivisorBits = 3;
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", kBits), narrow = terms.Variable("d", kDivisorBits);
  const terms::TermId divisor = terms.Zext(narrow, kBits);
  const terms::TermId quotient = terms.Sdiv(x, divisor), rest = terms.Srem(x, divisor);
  EXPECT_NE(terms[quotient].kind, terms::TermKind::kSdiv);
  EXPECT_NE(terms[rest].kind, terms::TermKind::kSrem);
  for (uint64_t value = 0; value >> kBits == 0; ++value) {
    for (uint64_t by = 0; by >> kDivisorBits == 0; ++by) {
      const std::array variables = {value, by};
      const std::vector<uint64_t> values = terms::EvaluateAll(terms, variables, terms::TermId(terms.size() - 1));
      const int64_t number = terms::AsSigned(value, kBits), whole = static_cast<int64_t>(by);
      const int64_t expected = whole == 0 ? (number < 0 ? 1 : -1) : number / whole;
      ASSERT_EQ(values[quotient.index], terms::Masked(static_cast<uint64_t>(expected), kBits));
      ASSERT_EQ(values[rest.index], terms::Masked(static_cast<uint64_t>(whole == 0 ? number : number % whole), kBits));
    }
  }
}

TEST(Division, ComparisonsHaveOneSpelling) {
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 16);
  const auto constant = [&terms](uint64_t value) { return terms.Const(value, 16); };
  EXPECT_EQ(terms.Ult(constant(1), x), terms.Not(terms.Ult(x, constant(2))));
  EXPECT_EQ(terms.Slt(constant(0xFFFF), x), terms.Not(terms.Extract(x, 15, 1)));
  EXPECT_EQ(terms.Slt(constant(7), x), terms.Not(terms.Slt(x, constant(8))));
  EXPECT_TRUE(terms.IsFalse(terms.Slt(constant(0x7FFF), x)));
  EXPECT_EQ(terms.Ult(terms.Const(255, 32), terms.Sext(x, 32)), terms.Ult(constant(255), x));
  EXPECT_EQ(terms.Slt(terms.Sext(x, 32), terms.Const(0xFFFFFFF0, 32)), terms.Slt(x, constant(0xFFF0)));
  EXPECT_TRUE(terms.IsTrue(terms.Slt(terms.Sext(x, 32), terms.Const(0x8000, 32))));
}

}  // namespace
}  // namespace plcxx::prove
