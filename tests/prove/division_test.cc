// Divisions by constants as compilers write them: recognized where they are divisions, and only there.
#include "transpiler/prove/terms/division.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "transpiler/prove/terms/evaluate.h"
#include "transpiler/prove/terms/terms.h"

namespace plcxx::prove {
namespace {

/// All products of a number of 6 bits and every factor, shifted by every number of bits, for every number.
TEST(Division, ProductsThatAreShifted) {
  constexpr uint8_t kBits = 6, kWidth = 14;
  Terms terms;
  const TermId x = terms.Variable("x", kBits);
  struct Shifted {
    TermId result;
    uint64_t factor;
    uint8_t shift;
  };
  std::vector<Shifted> all;
  size_t recognized = 0;
  for (uint64_t factor = 0; factor < 600; ++factor) {
    const TermId product = terms.Mul(terms.Zext(x, kWidth), terms.Const(factor, kWidth));
    for (uint8_t shift = 0; shift < kWidth; ++shift) {
      if (QuotientOfProduct(terms, product, shift).valid()) ++recognized;
      all.push_back({terms.Lshr(product, terms.Const(shift, kWidth)), factor, shift});
    }
  }
  EXPECT_GT(recognized, 100U);
  for (uint64_t value = 0; value >> kBits == 0; ++value) {
    const std::array variables = {value};
    const std::vector<uint64_t> values = EvaluateAll(terms, variables, TermId(terms.size() - 1));
    for (const Shifted& one : all) {
      ASSERT_EQ(values[one.result.index], Masked(value * one.factor, kWidth) >> one.shift)
          << value << " * " << one.factor << " >> " << int{one.shift};
    }
  }
}

/// The low bits of a number and of a multiple of a quotient of it, or of another number.
TEST(Division, RemaindersOfSums) {
  constexpr uint8_t kBits = 6;
  Terms terms;
  const TermId x = terms.Variable("x", kBits), y = terms.Variable("y", kBits);
  struct Sum {
    TermId result, rest, quotient;
    uint64_t factor;
  };
  std::vector<Sum> sums;
  size_t recognized = 0;
  for (uint64_t divisor = 2; divisor < 24; ++divisor) {
    const TermId quotient = terms.Udiv(x, terms.Const(divisor, kBits));
    for (const uint8_t width : {uint8_t{3}, uint8_t{4}, kBits, uint8_t{9}}) {
      for (const uint64_t factor : {0 - divisor, divisor, 0 - divisor - 1, 0 - 2 * divisor}) {
        for (const TermId rest : {terms.Resize(x, width), terms.Resize(y, width)}) {
          const TermId low = terms.Resize(quotient, width);
          const TermId multiple = terms.Mul(low, terms.Const(factor, width));
          if (RemainderOfSum(terms, rest, multiple).valid()) ++recognized;
          sums.push_back({terms.Add(rest, multiple), rest, low, factor});
        }
      }
    }
  }
  EXPECT_GT(recognized, 40U);
  for (uint64_t value = 0; value >> (2 * kBits) == 0; value += 5) {
    const std::array variables = {Masked(value, kBits), value >> kBits};
    const std::vector<uint64_t> values = EvaluateAll(terms, variables, TermId(terms.size() - 1));
    for (const Sum& sum : sums) {
      const uint64_t all = values[sum.rest.index] + sum.factor * values[sum.quotient.index];
      ASSERT_EQ(values[sum.result.index], Masked(all, terms.Width(sum.result)));
    }
  }
}

/// As digits are taken from a word of 16 bits: by 32-bit multiplications, in words that are cut to bytes.
TEST(Division, DigitsAreOneTermOnBothSides) {
  Terms terms;
  const TermId x = terms.Variable("x", 16);
  const TermId ten = terms.Const(10, 16), wide = terms.Zext(x, 32);
  const auto tenth = [&terms](TermId number) {
    return terms.Lshr(terms.Mul(number, terms.Const(52429, 32)), terms.Const(19, 32));
  };
  EXPECT_EQ(tenth(wide), terms.Zext(terms.Udiv(x, ten), 32));
  EXPECT_EQ(tenth(tenth(wide)), terms.Zext(terms.Udiv(terms.Udiv(x, ten), ten), 32));
  const TermId low = terms.Extract(tenth(wide), 0, 8);
  EXPECT_EQ(terms.Add(terms.Extract(x, 0, 8), terms.Mul(low, terms.Const(246, 8))),
            terms.Extract(terms.Urem(x, ten), 0, 8));
  EXPECT_TRUE(terms.IsZero(terms.Extract(terms.Urem(x, ten), 4, 12)));
  // One bit more, and it is not exact.
  const TermId y = terms.Zext(terms.Variable("y", 19), 36);
  EXPECT_FALSE(QuotientOfProduct(terms, terms.Mul(y, terms.Const(52429, 36)), 19).valid());
}

TEST(Division, ComparisonsHaveOneSpelling) {
  Terms terms;
  const TermId x = terms.Variable("x", 16);
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
