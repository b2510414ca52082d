#include "transpiler/prove/verify/operand_pairs.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace plcxx::prove::verify {
namespace {

class OperandPairsTest : public ::testing::Test {
 protected:
  std::vector<PairWhere> Pairs(terms::TermId a, terms::TermId b, Choices choices = Choices::kAsked) {
    return OperandPairs(terms_, {{a, b}, given_}, choices);
  }
  static bool IsPair(const PairWhere& one, terms::TermId a, terms::TermId b) {
    return (one.pair.a == a && one.pair.b == b) || (one.pair.a == b && one.pair.b == a);
  }

  terms::Terms terms_;
  const terms::TermId given_ = terms_.Variable("given", 1), c_ = terms_.Variable("c", 1);
  const terms::TermId u_ = terms_.Variable("u", 8), v_ = terms_.Variable("v", 8), x_ = terms_.Variable("x", 8),
                      y_ = terms_.Variable("y", 8);
};

TEST_F(OperandPairsTest, FactorsOfProductsInSums) {
  const std::vector<PairWhere> pairs = Pairs(terms_.Add(terms_.Mul(x_, u_), v_), terms_.Add(terms_.Mul(y_, u_), v_));
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_TRUE(IsPair(pairs[0], x_, y_));
  EXPECT_EQ(pairs[0].given, given_);
}

TEST_F(OperandPairsTest, WhatIsNotMultipliedIsLeftToTheSolver) {
  EXPECT_TRUE(Pairs(terms_.Add(x_, u_), terms_.Add(y_, u_)).empty());
  EXPECT_TRUE(Pairs(terms_.Mul(x_, u_), terms_.Add(y_, u_)).empty());
  EXPECT_TRUE(Pairs(terms_.Mul(x_, u_), terms_.Udiv(y_, u_)).empty());
}

TEST_F(OperandPairsTest, AChoiceBesideOneOfItsBranches) {
  const terms::TermId quotient_x = terms_.Udiv(x_, u_), quotient_y = terms_.Udiv(v_, y_);
  const terms::TermId chosen = terms_.Ite(c_, terms_.Add(quotient_x, y_), quotient_y);
  ASSERT_EQ(terms_[chosen].kind, terms::TermKind::kIte);
  // x / u + y is no quotient: it is asked about as it is, where it was chosen.
  const std::vector<PairWhere> pairs = Pairs(terms_.Mul(chosen, u_), terms_.Mul(quotient_y, u_));
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_TRUE(IsPair(pairs[0], terms_.Add(quotient_x, y_), quotient_y));
  EXPECT_EQ(pairs[0].given, terms_.And(given_, c_));
}

TEST_F(OperandPairsTest, ChoicesAreTakenApartWhereThatIsAskedFor) {
  const terms::TermId d = terms_.Variable("d", 1);
  const terms::TermId one = terms_.Ite(c_, terms_.Mul(x_, u_), v_), other = terms_.Ite(d, terms_.Mul(y_, u_), v_);
  EXPECT_TRUE(Pairs(one, other).empty());
  const std::vector<PairWhere> pairs = Pairs(one, other, Choices::kTakenApart);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_TRUE(IsPair(pairs[0], c_, d));
  EXPECT_TRUE(IsPair(pairs[1], x_, y_));
}

TEST_F(OperandPairsTest, MoreThanAFewAreNone) {
  terms::TermId one = terms_.Mul(x_, u_), other = terms_.Mul(y_, u_);
  for (int i = 0; i < 20; ++i) {
    one = terms_.Add(one, terms_.Ite(terms_.Variable("p", 1), terms_.Variable("a", 8), u_));
    other = terms_.Add(other, terms_.Ite(terms_.Variable("q", 1), terms_.Variable("b", 8), u_));
  }
  EXPECT_TRUE(Pairs(one, other).empty());
}

}  // namespace
}  // namespace plcxx::prove::verify
