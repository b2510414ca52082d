// Long and much shared terms: no recursion that is as deep as they are, no work that doubles with each sharing.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "transpiler/symbolic/terms/evaluate.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove {
namespace {

constexpr int kLongChain = 100'000;

TEST(TermsSize, PartsOfLongChainsOfChoices) {
  terms::Terms terms;
  terms::TermId chain = terms.Variable("start", 16);
  for (int i = 0; i < kLongChain; ++i) {
    chain = terms.Ite(terms.Variable("c", 1), terms.Variable("v", 16), chain);
  }
  const terms::TermId bit = terms.Extract(chain, 5, 1);
  EXPECT_EQ(terms.Width(bit), 1);
  EXPECT_EQ(terms.Extract(chain, 5, 1), bit);
  // All conditions 0: the start.
  std::vector<uint64_t> variables(2 * kLongChain + 1);
  variables[0] = 1 << 5;
  EXPECT_EQ(terms::Evaluate(terms, bit, variables), 1U);
  EXPECT_EQ(terms::Evaluate(terms, chain, variables), 32U);
}

TEST(TermsSize, PartsOfLongChainsOfSums) {
  terms::Terms terms;
  terms::TermId sum = terms.Variable("start", 32);
  for (int i = 0; i < kLongChain; ++i) sum = terms.Add(terms.Variable("v", 32), terms.Not(sum));
  EXPECT_EQ(terms.Width(terms.Extract(sum, 0, 8)), 8);
  EXPECT_EQ(terms.Width(terms.Extract(sum, 8, 8)), 8);
  EXPECT_LT(terms.size(), 10U * kLongChain);
}

TEST(TermsSize, PartsOfSharedTermsAreMadeOnce) {
  terms::Terms terms;
  terms::TermId x = terms.Variable("x", 32);
  const terms::TermId y = terms.Variable("y", 32);
  for (int i = 0; i < 1000; ++i) {
    const terms::TermId mixed = terms.Xor(terms.And(x, y), terms.Not(x));
    x = terms.Ite(terms.Variable("c", 1), mixed, terms.Or(x, y));
    // Its bytes the other way round.
    const terms::TermId high = terms.Concat(terms.Extract(x, 0, 8), terms.Extract(x, 8, 8));
    x = terms.Xor(x, terms.Concat(high, terms.Concat(terms.Extract(x, 16, 8), terms.Extract(x, 24, 8))));
  }
  for (uint8_t bit = 0; bit < 32; ++bit) terms.Extract(x, bit, 1);
  EXPECT_LT(terms.size(), 500'000U);
}

TEST(TermsSize, MemoryBitByBit) {
  // A word written one bit at a time under conditions, read as a whole: what a ladder does with a row of flags.
  terms::Terms terms;
  std::vector<terms::TermId> bits;
  for (int i = 0; i < 64; ++i) bits.push_back(terms.Variable("m", 1));
  for (int i = 0; i < 10'000; ++i) {
    terms::TermId& bit = bits[static_cast<size_t>(i * 37 % 64)];
    bit = terms.Ite(terms.Variable("c", 1), terms.And(bit, bits[static_cast<size_t>(i % 64)]), terms.Not(bit));
  }
  terms::TermId word = bits[0];
  for (size_t i = 1; i < 64; ++i) word = terms.Concat(bits[i], word);
  for (uint8_t i = 0; i < 64; ++i) EXPECT_EQ(terms.Extract(word, i, 1), bits[i]);
  EXPECT_LT(terms.size(), 100'000U);
}

}  // namespace
}  // namespace plcxx::prove
