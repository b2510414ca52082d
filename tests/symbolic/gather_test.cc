// Bits that are a word again: what words are chosen from, masked by or added to may look otherwise bit by bit.
#include "transpiler/symbolic/terms/gather.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::prove {
namespace {

std::vector<terms::TermId> BitsOf(terms::Terms& terms, terms::TermId word) {
  std::vector<terms::TermId> bits;
  for (uint8_t i = 0; i < terms.Width(word); ++i) bits.push_back(terms.Extract(word, i, 1));
  return bits;
}

class GatherTest : public ::testing::Test {
 protected:
  void ExpectOneTerm(terms::TermId word) { EXPECT_EQ(terms::Gather(terms_, BitsOf(terms_, word)), word); }

  terms::Terms terms_;
  terms::TermId x_ = terms_.Variable("x", 32), y_ = terms_.Variable("y", 32), bit_ = terms_.Variable("bit", 1),
                other_ = terms_.Variable("other", 1);
};

/// The lowest bits of a sum are those of the word that a constant is added to.
TEST_F(GatherTest, SumsWithAConstant) {
  for (const uint64_t constant : {1U, 10U, 1024U, 0xFFFFFFFFU})
    ExpectOneTerm(terms_.Add(x_, terms_.Const(constant, 32)));
}

/// Bits of a choice are "and" and "or" where a branch is a constant.
TEST_F(GatherTest, ChoicesWithAConstant) {
  const terms::TermId sum = terms_.Add(x_, terms_.Const(10, 32));
  for (const uint64_t constant : {0U, 1U, 0xFFFFFFFFU, 0x00FF1234U}) {
    const terms::TermId other = terms_.Const(constant, 32);
    for (const terms::TermId condition : {bit_, terms_.Not(bit_), terms_.And(bit_, other_), terms_.Ult(x_, y_)}) {
      ExpectOneTerm(terms_.Ite(condition, sum, other));
      ExpectOneTerm(terms_.Ite(condition, other, sum));
      ExpectOneTerm(terms_.Ite(condition, terms_.Ite(other_, sum, y_), other));
    }
  }
}

/// The lowest bit of a number and of the number negated is the same one, and no choice any more.
TEST_F(GatherTest, ChoicesOfWhichABitIsNone) {
  const terms::TermId zero = terms_.Const(0, 32);
  ExpectOneTerm(terms_.Ite(bit_, terms_.Sub(zero, x_), x_));
  ExpectOneTerm(terms_.Ite(other_, terms_.Ite(bit_, terms_.Sub(zero, x_), x_), y_));
}

/// Bits of which each is a choice, but not all by one condition, stay what they are.
TEST_F(GatherTest, BitsThatAreNoWordMeanTheSame) {
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 4), y = terms.Variable("y", 4);
  const std::vector<terms::TermId> of_x = BitsOf(terms, x), of_y = BitsOf(terms, y);
  const std::array<std::vector<terms::TermId>, 5> rows = {{
      {terms.And(of_x[0], of_y[0]), terms.And(of_x[1], of_y[0]), terms.Not(of_y[0]), of_y[0]},
      {terms.Or(of_x[0], of_y[0]), terms.And(of_x[1], terms.Not(of_y[0])), of_y[0], terms.Bit(true)},
      {terms.Or(of_x[0], terms.Not(of_y[0])), terms.Ite(of_y[0], of_x[2], of_x[3]), terms.Bit(false), of_y[0]},
      {terms.And(of_x[0], of_x[1]), terms.And(of_x[1], of_x[2]), terms.Or(of_x[2], of_x[3]), of_x[3]},
      {of_x[0], of_x[1], of_x[3], of_x[2]},
  }};
  for (const std::vector<terms::TermId>& row : rows) {
    const terms::TermId gathered = terms::Gather(terms, row);
    for (uint64_t number = 0; number < 256; ++number) {
      const std::array values = {number & 15, number >> 4};
      uint64_t expected = 0;
      for (size_t i = 0; i < row.size(); ++i) expected |= terms::Evaluate(terms, row[i], values) << i;
      ASSERT_EQ(terms::Evaluate(terms, gathered, values), expected);
    }
  }
}

}  // namespace
}  // namespace plcxx::prove
