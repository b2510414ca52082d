// What is said to be known of a term's bits is so for every value of the unknown bits of its variables.
#include "transpiler/symbolic/terms/known_bits.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "transpiler/symbolic/terms/evaluate.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::terms {
namespace {

constexpr std::array kBinary = {TermKind::kAnd,  TermKind::kOr,   TermKind::kXor,  TermKind::kAdd,
                                TermKind::kSub,  TermKind::kMul,  TermKind::kUdiv, TermKind::kUrem,
                                TermKind::kSdiv, TermKind::kSrem, TermKind::kShl,  TermKind::kLshr,
                                TermKind::kAshr, TermKind::kEq,   TermKind::kUlt,  TermKind::kSlt};

struct KnownTerms {
  Terms terms;
  std::vector<TermId> all;
  std::vector<KnownBits> variables, known;

  /// Operands of 8 bits, operators of all kinds; every term is 8 bits wide at last.
  explicit KnownTerms(Random& random) {
    for (int i = 0; i < 6; ++i) all.push_back(terms.Variable("v", 8));
    all.push_back(terms.Const(random.Next() & 7, 8));
    const auto any = [&] { return all[random.Next() % all.size()]; };
    for (int i = 0; i < 40; ++i) {
      const uint64_t what = random.Next() % 20;
      TermId made;
      if (what == 0) {
        made = terms.Not(any());
      } else if (what == 1) {
        made = terms.Ite(terms.Extract(any(), static_cast<uint8_t>(random.Next() % 8), 1), any(), any());
      } else if (what == 2) {
        made = terms.Extract(terms.Concat(any(), any()), static_cast<uint8_t>(random.Next() % 9), 8);
      } else {
        const Term term{kBinary[random.Next() % kBinary.size()], 8};
        const std::array operands{any(), any()};
        made = terms.Zext(terms.Rebuild(term, operands), 8);
      }
      all.push_back(made);
    }
    for (uint32_t i = 0; i < terms.variable_count(); ++i) {
      const uint64_t value = random.Next() & 0xFF, mask = random.OneIn(4) ? 0xFF : random.Next() & 0xFF;
      variables.push_back({.zeros = ~value & mask & 0xFF, .ones = value & mask});
    }
    known.resize(terms.size());
    for (uint32_t i = 0; i < terms.size(); ++i) {
      known[i] = KnownBitsOf(
          terms, terms[TermId(i)], [this](TermId id) { return known[id.index]; },
          [this](uint32_t number) { return variables[number]; });
    }
  }
};

TEST(KnownBits, HoldForEveryValueOfTheOthers) {
  Random random(0x5851F42D4C957F2D);
  uint64_t said = 0;
  for (int program = 0; program < 400; ++program) {
    const KnownTerms of(random);
    for (int attempt = 0; attempt < 12; ++attempt) {
      std::vector<uint64_t> values;
      for (const KnownBits& bits : of.variables) values.push_back((random.Next() & ~bits.zeros & 0xFF) | bits.ones);
      const std::vector<uint64_t> all = EvaluateAll(of.terms, values, TermId(of.terms.size() - 1));
      for (uint32_t i = 0; i < of.terms.size(); ++i) {
        const KnownBits& bits = of.known[i];
        ASSERT_EQ(bits.zeros & bits.ones, 0U);
        ASSERT_EQ(all[i] & bits.zeros, 0U) << "term " << i;
        ASSERT_EQ(~all[i] & bits.ones, 0U) << "term " << i;
        said += bits.zeros != 0 || bits.ones != 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(said, 100'000U);
}

TEST(KnownBits, AreFoundWhereOneOperandDecides) {
  Terms terms;
  const TermId x = terms.Variable("x", 8), low = terms.And(x, terms.Const(0x0F, 8));
  const auto known_of = [&](TermId id) {
    std::vector<KnownBits> known(terms.size());
    for (uint32_t i = 0; i < terms.size(); ++i) {
      known[i] = KnownBitsOf(
          terms, terms[TermId(i)], [&known](TermId one) { return known[one.index]; },
          [](uint32_t) { return KnownBits(); });
    }
    return known[id.index];
  };
  EXPECT_EQ(known_of(low).zeros, 0xF0U);
  EXPECT_EQ(known_of(terms.Ult(low, terms.Const(0x10, 8))), AllKnown(1, 1));
  EXPECT_EQ(known_of(terms.Or(x, terms.Const(0x81, 8))).ones, 0x81U);
}

}  // namespace
}  // namespace plcxx::terms
