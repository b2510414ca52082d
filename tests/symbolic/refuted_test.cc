// What is asked of a series of growing conditions, and what is passed over.
#include "transpiler/symbolic/solver/refuted.h"

#include <gtest/gtest.h>

namespace plcxx::solver {
namespace {

constexpr uint64_t kMs = 60'000;

struct Conditions {
  terms::Terms terms;
  terms::TermId x = terms.Variable("x", 64), y = terms.Variable("y", 64);

  /// Not known in little time: factors of a product of two primes of 31 bits.
  terms::TermId Hard(uint64_t tag) {
    const terms::TermId product = terms.Const(2147483647ull * 2147483629ull, 64), one = terms.Const(1, 64);
    const terms::TermId limit = terms.Const(1ull << 32, 64);
    terms::TermId both = terms.Eq(terms.Mul(x, y), product);
    for (const terms::TermId factor : {x, y})
      both = terms.And(both, terms.And(terms.Ult(one, factor), terms.Ult(factor, limit)));
    return terms.And(both, terms.Not(terms.Eq(x, terms.Const(tag, 64))));
  }
  terms::TermId Never(uint64_t tag) {
    return terms.And(terms.Ult(x, terms.Const(5 + tag, 64)), terms.Ult(terms.Const(900, 64), x));
  }
};

TEST(Refuted, BehindWhatIsTooMuchTheNextOnesArePassedOver) {
  Conditions all;
  Refuted refuted(all.terms);
  EXPECT_TRUE(refuted.Has(all.Never(0), 1, kMs));
  EXPECT_FALSE(refuted.Has(all.Hard(1000), 1, kMs));
  EXPECT_FALSE(refuted.Has(all.Never(1), 1, kMs)) << "passed over: one after one in vain";
  EXPECT_TRUE(refuted.Has(all.Never(2), 2, kMs)) << "another series";
  EXPECT_TRUE(refuted.Has(all.Never(1), 1, kMs)) << "asked when it comes again";
  EXPECT_TRUE(refuted.Has(all.Never(3), 1, kMs)) << "an answer begins anew";
}

TEST(Refuted, MoreArePassedOverEachTime) {
  Conditions all;
  Refuted refuted(all.terms);
  for (uint64_t tag = 0; tag < 2; ++tag) {
    EXPECT_FALSE(refuted.Has(all.Hard(1000 + tag), 1, kMs));
    if (tag == 0) EXPECT_FALSE(refuted.Has(all.Never(0), 1, kMs));
  }
  for (uint64_t tag = 1; tag <= 3; ++tag) EXPECT_FALSE(refuted.Has(all.Never(tag), 1, kMs)) << tag;
  EXPECT_TRUE(refuted.Has(all.Never(4), 1, kMs));
}

}  // namespace
}  // namespace plcxx::solver
