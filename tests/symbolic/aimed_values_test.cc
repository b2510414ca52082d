// Conditions that random values hardly ever meet are met by values that are aimed at them.
#include "transpiler/symbolic/terms/aimed_values.h"

#include <gtest/gtest.h>

#include <vector>

#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::prove {
namespace {

/// How many of twenty aims at `term` being `value` are met; other variables are 0.
int Met(const terms::Terms& terms, const std::vector<terms::TermId>& variables, terms::TermId term, uint64_t value) {
  terms::AimedValues aimed(terms, 7);
  int met = 0;
  for (int time = 0; time < 20; ++time) {
    aimed.AimAt(term, value);
    std::vector<uint64_t> values;
    for (const terms::TermId variable : variables) values.push_back(aimed.Of(variable, 0));
    met += terms::Evaluate(terms, term, values) == value ? 1 : 0;
  }
  return met;
}

TEST(AimedValues, MeetAConjunctionOfComparisons) {
  terms::Terms terms;
  const terms::TermId state = terms.Variable("state", 8), scans = terms.Variable("scans", 16);
  const terms::TermId enable = terms.Variable("enable", 1), stop = terms.Variable("stop", 1);
  const terms::TermId is_late = terms.Not(terms.Ult(terms.Add(scans, terms.Const(3, 16)), terms.Const(20'000, 16)));
  const terms::TermId rare =
      terms.And(terms.And(terms.Eq(state, terms.Const(0x4B, 8)), is_late), terms.And(enable, terms.Not(stop)));
  EXPECT_EQ(Met(terms, {state, scans, enable, stop}, rare, 1), 20);
}

TEST(AimedValues, MeetAValueOfAChoiceOfWords) {
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 16), y = terms.Variable("y", 16), c = terms.Variable("c", 1);
  const terms::TermId choice = terms.Ite(terms.And(c, terms.Slt(x, terms.Const(0, 16))), terms.Sub(y, x), y);
  const terms::TermId parts = terms.Concat(terms.Extract(choice, 8, 8), terms.Extract(choice, 0, 8));
  EXPECT_GE(Met(terms, {x, y, c}, terms.Eq(parts, terms.Const(0x1234, 16)), 1), 10);
}

/// One of two is enough for a disjunction, and another one another time.
TEST(AimedValues, ChooseByChance) {
  terms::Terms terms;
  const terms::TermId a = terms.Variable("a", 1), b = terms.Variable("b", 1);
  terms::AimedValues aimed(terms, 7);
  int first = 0;
  for (int time = 0; time < 40; ++time) {
    aimed.AimAt(terms.Or(a, b), 1);
    EXPECT_EQ(aimed.Of(a, 0) + aimed.Of(b, 0), 1U);
    first += aimed.Of(a, 0) != 0 ? 1 : 0;
  }
  EXPECT_GT(first, 5);
  EXPECT_LT(first, 35);
}

TEST(AimedValues, LeaveWhatIsNotAskedFor) {
  terms::Terms terms;
  const terms::TermId word = terms.Variable("word", 16), other = terms.Variable("other", 16);
  terms::AimedValues aimed(terms, 7);
  aimed.AimAt(terms.Extract(word, 4, 1), 1);
  EXPECT_EQ(aimed.Of(word, 0xFF00), 0xFF10U);
  EXPECT_EQ(aimed.Of(other, 0x1234), 0x1234U);
}

}  // namespace
}  // namespace plcxx::prove
