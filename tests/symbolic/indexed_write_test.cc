// A write at an index that is a term: each element is written when the index is its own, and what is written says by
// itself which element it was computed from. Elements that are read where something is known of the index.
#include "transpiler/symbolic/terms/indexed_write.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "transpiler/symbolic/terms/evaluate.h"
#include "transpiler/symbolic/terms/look_up.h"
#include "transpiler/symbolic/terms/specialization.h"

namespace plcxx::prove {
namespace {

using terms::TermId;

class IndexedWriteTest : public ::testing::Test {
 protected:
  static constexpr uint64_t kElements = 12;

  IndexedWriteTest() {
    for (uint64_t i = 0; i < kElements; ++i) elements_.push_back(terms_.Variable("e" + std::to_string(i), 8));
  }
  std::vector<terms::TableElement> Table() const {
    std::vector<terms::TableElement> table;
    for (uint64_t i = 0; i < kElements; ++i) table.push_back({i, elements_[i]});
    return table;
  }
  TermId Read(TermId given, TermId index) { return terms::LookUp(terms_, given, index, Table(), terms_.Const(0, 8)); }
  /// Of every value of `a_`, where `given` holds.
  void ExpectWrites(TermId given, TermId index, TermId value) {
    terms::IndexedWrite write(terms_, given, index, value);
    for (uint64_t i = 0; i < kElements; ++i) {
      const auto [when, written] = write.At(i);
      for (uint64_t a = 0; a < 256; ++a) {
        std::vector<uint64_t> values = {a, a * 7 % 4};
        for (uint64_t k = 0; k < kElements; ++k) values.push_back((a * 31 + k * 57 + 5) & 255);
        if (terms::Evaluate(terms_, given, values) == 0) continue;
        const bool here = terms::Evaluate(terms_, index, values) == i;
        ASSERT_EQ(terms::Evaluate(terms_, when, values), here ? 1 : 0) << "element " << i << ", a = " << a;
        if (!here) continue;
        ASSERT_EQ(terms::Evaluate(terms_, written, values), terms::Evaluate(terms_, value, values))
            << "element " << i << ", a = " << a;
      }
    }
  }

  terms::Terms terms_;
  const TermId a_ = terms_.Variable("a", 8), b_ = terms_.Variable("b", 2);
  std::vector<TermId> elements_;
  const TermId always_ = terms_.Bit(true), mask_ = terms_.Const(0x40, 8);
};

TEST_F(IndexedWriteTest, ReadsWhatElseThereIsWhereNoElementCanBeMeant) {
  const TermId never = terms_.And(terms_.Ult(a_, terms_.Const(2, 8)), terms_.Ult(terms_.Const(5, 8), a_));
  const TermId otherwise = terms_.Const(7, 8);
  for (const TermId given : {never, always_}) EXPECT_EQ(terms::LookUp(terms_, given, a_, {}, otherwise), otherwise);
}

TEST_F(IndexedWriteTest, MeansTheSameForEveryIndex) {
  const TermId small = terms_.Ult(a_, terms_.Const(9, 8)), odd = terms_.Extract(a_, 0, 1);
  const TermId low = terms_.Zext(terms_.Extract(a_, 0, 3), 8);
  const std::vector<TermId> indices = {a_,
                                       low,
                                       terms_.Add(a_, terms_.Const(3, 8)),
                                       terms_.Mul(a_, terms_.Const(3, 8)),
                                       terms_.Mul(low, terms_.Const(5, 8)),
                                       terms_.Ite(small, a_, terms_.Const(2, 8)),
                                       terms_.Add(low, terms_.Zext(b_, 8))};
  for (const TermId index : indices) {
    for (const TermId given : {always_, small, terms_.And(small, odd), terms_.Not(small), terms_.Extract(b_, 1, 1)}) {
      ExpectWrites(given, index, terms_.Or(Read(given, index), mask_));
      ExpectWrites(given, index, terms_.Ite(odd, Read(given, index), terms_.Xor(a_, elements_[3])));
    }
  }
}

TEST_F(IndexedWriteTest, WhatIsWrittenIsOfTheElementItself) {
  const TermId index = terms_.Mul(a_, terms_.Const(3, 8));
  terms::IndexedWrite write(terms_, terms_.Ult(a_, terms_.Const(4, 8)), index, terms_.Or(Read(always_, index), mask_));
  EXPECT_EQ(write.At(3).value, terms_.Or(elements_[3], mask_));
  EXPECT_EQ(write.At(9).value, terms_.Or(elements_[9], mask_));
  EXPECT_TRUE(terms_.IsFalse(write.At(4).when)) << "no multiple of three";
}

/// However the index is computed, the terms are the same.
TEST_F(IndexedWriteTest, TwoWaysToAnIndexGiveTheSameTerms) {
  const TermId in_range = terms_.Ult(a_, terms_.Const(4, 8));
  const TermId one = terms_.Mul(terms_.Zext(a_, 32), terms_.Const(3, 32));
  const TermId other = terms_.Ite(in_range, terms_.Add(a_, terms_.Add(a_, a_)), terms_.Const(0, 8));
  terms::IndexedWrite first(terms_, in_range, one, terms_.Or(Read(in_range, one), mask_));
  terms::IndexedWrite second(terms_, in_range, other, terms_.Or(Read(in_range, other), mask_));
  for (uint64_t i = 0; i < kElements; ++i) {
    EXPECT_EQ(first.At(i).when, second.At(i).when) << i;
    EXPECT_EQ(first.At(i).value, second.At(i).value) << i;
  }
}

TEST_F(IndexedWriteTest, AnElementThatCannotBeReadNeedsNoChoice) {
  const TermId below_two = terms_.Ult(a_, terms_.Const(2, 8));
  EXPECT_EQ(Read(below_two, a_), terms_.Ite(terms_.Extract(a_, 0, 1), elements_[1], elements_[0]));
  EXPECT_EQ(Read(terms_.And(terms_.Extract(b_, 0, 1), terms_.Eq(a_, terms_.Const(5, 8))), a_), elements_[5]);
}

TEST_F(IndexedWriteTest, BitsThatAConditionTells) {
  const TermId condition =
      terms_.And(terms_.Ult(a_, terms_.Const(16, 8)), terms_.And(terms_.Extract(b_, 1, 1), terms_.Extract(a_, 0, 1)));
  const terms::KnownIndexBits known = terms::KnownWhere(terms_, condition);
  ASSERT_EQ(known.bits.size(), 6U);
  EXPECT_EQ(known.ones, 0b100001U) << "a is odd, b has its high bit";
  EXPECT_EQ(known.zeros, 0b011110U) << "a is small";
  EXPECT_EQ(terms::WhereKnown(terms_, terms_.Add(a_, terms_.Zext(b_, 8)), known),
            terms_.Add(terms_.Concat(terms_.Concat(terms_.Const(0, 4), terms_.Extract(a_, 1, 3)), terms_.Bit(true)),
                       terms_.Concat(terms_.Const(1, 7), terms_.Extract(b_, 0, 1))));
  EXPECT_TRUE(terms::KnownWhere(terms_, terms_.Bit(false)).bits.empty());
}

}  // namespace
}  // namespace plcxx::prove
