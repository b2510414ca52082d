// What stands at the same place of two terms.
#include "transpiler/symbolic/solver/counterparts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace plcxx::prove {
namespace {

bool Always(terms::TermId, terms::TermId) { return true; }

TEST(Counterparts, AreTheConditionsOfTwoChoices) {
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 8), y = terms.Variable("y", 8);
  const terms::TermId c = terms.Ult(x, y), d = terms.Ult(y, x);
  const std::array pairs{solver::TermPair{terms.Ite(c, x, y), terms.Ite(d, x, y)}};
  const solver::CounterpartsOfTerms found = solver::Counterparts(terms, pairs, 100, Always);
  EXPECT_THAT(found.at(d.index), testing::ElementsAre(c));
  EXPECT_FALSE(found.contains(terms.Ite(c, x, y).index));
}

TEST(Counterparts, OfAConjunctionAreWhatOnlyOneHas) {
  terms::Terms terms;
  const terms::TermId a = terms.Variable("a", 1), b = terms.Variable("b", 1), c = terms.Variable("c", 1);
  const terms::TermId x = terms.Variable("x", 8), y = terms.Variable("y", 8);
  const terms::TermId one = terms.Ult(x, y), other = terms.Eq(x, y);
  const std::array pairs{
      solver::TermPair{terms.And(terms.And(a, one), terms.And(b, c)), terms.And(a, terms.And(terms.And(c, other), b))}};
  EXPECT_THAT(solver::Counterparts(terms, pairs, 100, Always).at(other.index), testing::ElementsAre(one));
}

TEST(Counterparts, HaveOneWidthAndMayBeEqual) {
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 8), y = terms.Variable("y", 8), z = terms.Variable("z", 4);
  const std::array pairs{solver::TermPair{terms.Concat(x, z), terms.Concat(z, x)},
                         solver::TermPair{terms.Add(x, y), terms.Xor(x, y)}};
  for (const auto& [newer, older] : solver::Counterparts(terms, pairs, 100, Always)) {
    for (const terms::TermId one : older) EXPECT_EQ(terms.Width(one), terms.Width(terms::TermId(newer)));
  }
  EXPECT_TRUE(solver::Counterparts(terms, pairs, 100, [](terms::TermId, terms::TermId) { return false; }).empty());
}

TEST(Counterparts, AreNotMoreThanWanted) {
  terms::Terms terms;
  terms::TermId a = terms.Variable("a", 8), b = terms.Variable("b", 8);
  for (int i = 0; i < 100; ++i) {
    a = terms.Udiv(a, terms.Variable("x", 8));
    b = terms.Udiv(b, terms.Variable("y", 8));
  }
  const std::array pairs{solver::TermPair{a, b}};
  size_t count = 0;
  for (const auto& [newer, older] : solver::Counterparts(terms, pairs, 20, Always)) count += older.size();
  EXPECT_EQ(count, 20U);
}

}  // namespace
}  // namespace plcxx::prove
