// A property that counts periods says the same as one that looks at each of them.
#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "transpiler/prove/properties/condition.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::prove {
namespace {

constexpr uint32_t kA = 0, kB = 1;  // conditions: bits of the program

properties::Property About(properties::PropertyKind kind, std::vector<properties::Condition> more, uint32_t periods) {
  properties::Property property{.kind = kind, .text = {}, .conditions = {}, .operands = {}, .periods = periods};
  for (const uint32_t bit : {kA, kB}) {
    property.operands.push_back({.text = "bit", .cells = {execute::CellId(bit)}, .width = 1, .is_bit = true});
    property.conditions.push_back({.kind = properties::ConditionKind::kOperand, .children = {}, .operand = bit});
  }
  for (properties::Condition& condition : more) property.conditions.push_back(std::move(condition));
  return property;
}

/// Both say of each period of a few random runs, up to the first violation, whether the property holds.
void ExpectSame(const properties::Property& property) {
  terms::Random random(0x9E3779B97F4A7C15);
  uint32_t violations = 0;
  for (int run = 0; run < 60; ++run) {
    terms::Terms terms;
    std::vector<std::vector<bool>> bits{{}};
    std::map<size_t, uint64_t> counts;
    const uint64_t one_in = 2 + random.Next() % 8;
    std::vector<bool> now{false, false};
    for (uint32_t period = 1; period <= 40; ++period) {
      for (size_t bit = 0; bit < now.size(); ++bit) now[bit] = random.OneIn(one_in) ? !now[bit] : now[bit];
      bits.push_back(now);
      const auto at = [&](execute::CellId cell, uint32_t when) { return terms.Bit(bits[when][cell.index]); };
      size_t number = 0;
      const auto count = [&](uint32_t most, const std::function<terms::TermId(terms::TermId)>& next) {
        EXPECT_LT(most, 256U);
        const terms::TermId after = next(terms.Const(counts[number], 8));
        counts[number++] = terms.Value(after);
        return after;
      };
      const bool one_by_one = terms.IsTrue(properties::HoldsAfter(terms, property, period, at));
      const bool counted = terms.IsTrue(
          properties::HoldsByCounting(terms, property, [&](execute::CellId cell) { return at(cell, period); }, count));
      ASSERT_EQ(counted, one_by_one) << "run " << run << ", period " << period;
      if (one_by_one) continue;
      ++violations;
      break;
    }
  }
  EXPECT_GT(violations, 0U);
}

TEST(Counting, WhatIsHeld) {
  // never (A for 6)
  properties::Property held = About(properties::PropertyKind::kAlways,
                                    {{.kind = properties::ConditionKind::kHeld, .children = {kA}, .periods = 6},
                                     {.kind = properties::ConditionKind::kNot, .children = {2}}},
                                    1);
  held.condition = 3;
  ExpectSame(held);
}

TEST(Counting, WhatIsHeldInWhatIsHeld) {
  // never ((A for 3) or B) for 9
  properties::Property held = About(properties::PropertyKind::kAlways,
                                    {{.kind = properties::ConditionKind::kHeld, .children = {kA}, .periods = 3},
                                     {.kind = properties::ConditionKind::kOr, .children = {2, kB}},
                                     {.kind = properties::ConditionKind::kHeld, .children = {3}, .periods = 9},
                                     {.kind = properties::ConditionKind::kNot, .children = {4}}},
                                    1);
  held.condition = 5;
  ExpectSame(held);
}

TEST(Counting, WhatIsWaitedFor) {
  for (const uint32_t periods : {1U, 2U, 7U}) {
    properties::Property response = About(properties::PropertyKind::kResponse, {}, periods);
    response.condition = kA;
    response.consequence = kB;
    ExpectSame(response);
  }
}

TEST(Counting, WhatIsWaitedForBehindWhatIsHeld) {
  properties::Property response =
      About(properties::PropertyKind::kResponse,
            {{.kind = properties::ConditionKind::kHeld, .children = {kA}, .periods = 4}}, 5);
  response.condition = 2;
  response.consequence = kB;
  ExpectSame(response);
}

}  // namespace
}  // namespace plcxx::prove
