// Bits that the parts of a condition decide.
#include "transpiler/symbolic/execute/known_here.h"

#include <gtest/gtest.h>

#include <optional>

namespace plcxx::execute {
namespace {

TEST(KnownHere, PartsOfAConditionDecideChoices) {
  terms::Terms terms;
  const terms::TermId a = terms.Variable("a", 1), b = terms.Variable("b", 1), c = terms.Variable("c", 1),
                      word = terms.Variable("word", 16);
  const terms::TermId eight = terms.Eq(word, terms.Const(8, 16));
  // Neither a nor b, and the word is 8.
  KnownHere known(terms, terms.And(terms.Not(terms.Or(a, b)), eight));
  EXPECT_EQ(known.ValueOf(a), false);
  EXPECT_EQ(known.ValueOf(b), false);
  EXPECT_EQ(known.ValueOf(eight), true);
  EXPECT_EQ(known.ValueOf(c), std::nullopt);
  EXPECT_EQ(known.ValueOf(terms.And(c, a)), false);
  EXPECT_EQ(known.ValueOf(terms.Or(c, eight)), true);
  EXPECT_EQ(known.ValueOf(terms.Xor(c, eight)), std::nullopt);
  EXPECT_EQ(known.ValueOf(terms.Ite(a, c, terms.Not(b))), true);
  EXPECT_EQ(known.ValueOf(terms.Ite(c, a, b)), false);
  EXPECT_EQ(known.ValueOf(terms.Ite(c, a, eight)), std::nullopt);
  // A bit of a number that was chosen by what is known.
  const terms::TermId number = terms.Ite(b, word, terms.Const(4, 16));
  EXPECT_EQ(known.ValueOf(terms.Extract(number, 2, 1)), true);
  EXPECT_EQ(known.ValueOf(terms.Extract(number, 1, 1)), false);
}

TEST(KnownHere, OfAnAlternativeNothingIsKnown) {
  terms::Terms terms;
  const terms::TermId a = terms.Variable("a", 1), b = terms.Variable("b", 1);
  KnownHere either(terms, terms.Or(a, b));
  EXPECT_EQ(either.ValueOf(a), std::nullopt);
  EXPECT_EQ(either.ValueOf(terms.Or(a, b)), true);
  KnownHere not_both(terms, terms.Not(terms.And(a, b)));
  EXPECT_EQ(not_both.ValueOf(b), std::nullopt);
}

}  // namespace
}  // namespace plcxx::execute
