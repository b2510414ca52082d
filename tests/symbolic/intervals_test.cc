// No value of a term is outside of its bounds, where what was assumed holds; what bounds say never holds, never does.
#include "transpiler/symbolic/terms/intervals.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "transpiler/symbolic/terms/evaluate.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::terms {
namespace {

constexpr std::array kOperations = {TermKind::kAnd, TermKind::kOr,   TermKind::kXor,  TermKind::kAdd,  TermKind::kSub,
                                    TermKind::kMul, TermKind::kUdiv, TermKind::kUrem, TermKind::kSdiv, TermKind::kSrem,
                                    TermKind::kShl, TermKind::kLshr, TermKind::kAshr};

/// Operands of 8 bits; conditions over them.
struct RandomTerms {
  Terms terms;
  std::vector<TermId> numbers, conditions;

  explicit RandomTerms(Random& random) {
    for (int i = 0; i < 4; ++i) numbers.push_back(terms.Variable("v", 8));
    for (int i = 0; i < 3; ++i) numbers.push_back(terms.Const(random.OneIn(2) ? random.Next() & 15 : random.Next(), 8));
    const auto any = [&] { return numbers[random.Next() % numbers.size()]; };
    conditions.push_back(terms.Ult(any(), any()));
    const auto condition = [&] { return conditions[random.Next() % conditions.size()]; };
    for (int i = 0; i < 30; ++i) {
      switch (random.Next() % 8) {
        case 0:
          conditions.push_back(random.OneIn(2) ? terms.Ult(any(), any()) : terms.Slt(any(), any()));
          break;
        case 1:
          conditions.push_back(random.OneIn(2) ? terms.Eq(any(), any()) : terms.Not(condition()));
          break;
        case 2:
          conditions.push_back(random.OneIn(2) ? terms.And(condition(), condition())
                                               : terms.Or(condition(), condition()));
          break;
        case 3:
          numbers.push_back(terms.Ite(condition(), any(), any()));
          break;
        case 4: {
          const TermId number = any();
          numbers.push_back(terms.Ite(terms.Extract(number, 7, 1), terms.Neg(number), number));
          break;
        }
        case 5: {
          const TermId wide = random.OneIn(2) ? terms.Sext(any(), 16) : terms.Zext(any(), 16);
          const TermId other = random.OneIn(2) ? terms.Sext(any(), 16) : terms.Zext(any(), 16);
          const Term term{kOperations[random.Next() % kOperations.size()], 16};
          const std::array operands{wide, other};
          numbers.push_back(terms.Extract(terms.Rebuild(term, operands), static_cast<uint8_t>(random.Next() % 9), 8));
          break;
        }
        default: {
          const Term term{kOperations[random.Next() % kOperations.size()], 8};
          const std::array operands{any(), any()};
          numbers.push_back(terms.Rebuild(term, operands));
        }
      }
    }
  }
  std::vector<uint64_t> Values(Random& random) const {
    std::vector<uint64_t> values;
    for (uint32_t i = 0; i < terms.variable_count(); ++i)
      values.push_back((random.OneIn(3) ? random.Next() & 7 : random.Next()) & 0xFF);
    return values;
  }
};

TEST(Intervals, HoldEveryValue) {
  Random random(2711);
  int told = 0;
  for (int round = 0; round < 400; ++round) {
    RandomTerms all(random);
    Intervals intervals(all.terms);
    const TermId given = all.conditions[random.Next() % all.conditions.size()];
    const bool possible = intervals.Assume(given, true);
    std::vector<Interval> bounds;
    for (const TermId id : all.numbers) bounds.push_back(intervals.Of(id));
    for (int i = 0; i < 200; ++i) {
      const std::vector<uint64_t> values = all.Values(random);
      if (Evaluate(all.terms, given, values) == 0) continue;
      ASSERT_TRUE(possible);
      for (size_t k = 0; k < bounds.size(); ++k) {
        const uint64_t value = Evaluate(all.terms, all.numbers[k], values);
        const uint8_t width = all.terms.Width(all.numbers[k]);
        ASSERT_LE(bounds[k].low, value);
        ASSERT_GE(bounds[k].high, value);
        ASSERT_LE(bounds[k].least, AsSigned(value, width));
        ASSERT_GE(bounds[k].greatest, AsSigned(value, width));
      }
    }
    for (const Interval& one : bounds) told += one.high - one.low < 128 || one.greatest - one.least < 128 ? 1 : 0;
  }
  EXPECT_GT(told, 1000) << "so many say something";
}

TEST(Intervals, WhatNeverHoldsHasNoValue) {
  Random random(99);
  int never = 0;
  for (int round = 0; round < 3000; ++round) {
    RandomTerms all(random);
    const TermId condition = all.conditions.back();
    if (all.terms.IsConst(condition) || !NeverHolds(all.terms, condition)) continue;
    ++never;
    for (int i = 0; i < 2000; ++i) ASSERT_EQ(Evaluate(all.terms, condition, all.Values(random)), 0U);
  }
  EXPECT_GT(never, 20);
}

/// Conditions and choices may be as long as a program.
TEST(Intervals, LongRowsEndEarly) {
  Terms terms;
  TermId row = terms.Variable("first", 1), choice = terms.Variable("choice", 8), sum = choice;
  for (int i = 0; i < 100'000; ++i) {
    const TermId bit = terms.Variable("bit", 1);
    row = i % 2 == 0 ? terms.And(row, bit) : terms.Or(row, bit);
    choice = terms.Ite(terms.Ult(choice, terms.Const(static_cast<uint64_t>(i) & 127, 8)), sum, choice);
    sum = terms.Xor(terms.Add(sum, terms.Const(3, 8)), terms.Const(5, 8));
  }
  EXPECT_FALSE(NeverHolds(terms, terms.And(row, terms.Ult(choice, terms.Const(4, 8)))));
  TermId all = terms.Bit(true);
  for (int i = 0; i < 100'000; ++i) all = terms.And(all, terms.Variable("bit", 1));
  EXPECT_FALSE(NeverHolds(terms, all));
}

/// A speed of 16 bits in percent of another one, in steps of a converter: no division is larger than what it divides.
TEST(Intervals, ProductsAndQuotientsOfSmallNumbers) {
  Terms terms;
  const TermId speed = terms.Variable("speed", 16), top = terms.Variable("top", 16), key = terms.Variable("key", 8);
  const TermId percent =
      terms.Add(terms.Const(50, 32), terms.Mul(terms.Zext(terms.Extract(key, 0, 3), 32), terms.Const(10, 32)));
  const TermId part = terms.Sdiv(terms.Mul(terms.Sext(speed, 32), percent), terms.Const(100, 32));
  const TermId steps = terms.Sdiv(terms.Mul(part, terms.Const(4095, 32)), terms.Sext(top, 32));
  const auto within = [&](TermId number, int64_t least, int64_t greatest) {
    const auto constant = [&](int64_t value) { return terms.Const(static_cast<uint64_t>(value), 32); };
    return terms.And(terms.Sle(constant(least), number), terms.Sle(number, constant(greatest)));
  };
  const TermId above_zero = terms.Slt(terms.Const(0, 16), top);
  constexpr int64_t kMost = 32768 * 120 / 100;
  EXPECT_TRUE(NeverHolds(terms, terms.Not(within(part, -kMost, kMost))));
  EXPECT_FALSE(NeverHolds(terms, terms.Not(within(part, -kMost + 10, kMost))));
  const TermId far = terms.Not(within(steps, -kMost * 4095, kMost * 4095));
  EXPECT_TRUE(NeverHolds(terms, terms.And(above_zero, far)));
  EXPECT_TRUE(NeverHolds(terms, terms.And(far, above_zero))) << "in any order";
  EXPECT_FALSE(NeverHolds(terms, far)) << "of a divisor of 0 nothing is known";
  // Known in the branch where it is divided.
  const TermId chosen = terms.Ite(above_zero, steps, terms.Const(0, 32));
  EXPECT_TRUE(NeverHolds(terms, terms.Not(within(chosen, -kMost * 4095, kMost * 4095))));
}

}  // namespace
}  // namespace plcxx::terms
