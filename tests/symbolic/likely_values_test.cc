// Values that tell terms apart: what a program asks for is among them.
#include "transpiler/symbolic/terms/likely_values.h"

#include <gtest/gtest.h>

#include <array>

#include "transpiler/symbolic/solver/sweep.h"

namespace plcxx::prove {
namespace {

/// As an index into a table is checked: a base is taken off, and what is left is below the length.
terms::TermId IsInTable(terms::Terms& terms, terms::TermId index) {
  return terms.Ult(terms.Add(terms.Zext(index, 32), terms.Const(0xFFFFFFFF - 40'000 + 1, 32)), terms.Const(3, 32));
}

TEST(LikelyValues, AreWhatIsAskedFor) {
  terms::Terms terms;
  const terms::TermId index = terms.Variable("index", 16), other = terms.Variable("other", 16);
  const std::array cone{IsInTable(terms, index)};
  terms::LikelyValues likely(terms);
  likely.NoteComparisons(cone);
  int inside = 0, of_other = 0;
  for (int vector = 0; vector < 64; ++vector) {
    const auto is_inside = [](uint64_t value) { return value >= 40'000 && value < 40'003; };
    inside += is_inside(terms::Masked(likely.Of(vector, index), 16)) ? 1 : 0;
    of_other += is_inside(terms::Masked(likely.Of(vector, other), 16)) ? 1 : 0;
  }
  EXPECT_GE(inside, 4);
  EXPECT_LE(of_other, 2);
}

/// Whatever a function gives instead, it stays a function, and has its width.
TEST(LikelyValues, FunctionsStayFunctions) {
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 8);
  const terms::TermId applied = terms.Apply(terms.Function("f", 16), {&x, 1});
  const std::array cone{terms.Eq(applied, terms.Const(1234, 16))};
  terms::LikelyValues likely(terms);
  likely.NoteComparisons(cone);
  int asked_for = 0;
  for (uint64_t made_up = 0; made_up < 64; ++made_up) {
    const uint64_t value = likely.ResultOf(0, terms[applied], made_up);
    EXPECT_EQ(likely.ResultOf(0, terms[applied], made_up), value);
    asked_for += value == 1234 ? 1 : 0;
  }
  EXPECT_EQ(asked_for, 32);
}

/// Two of them are compared, too: in some vectors most are equal.
TEST(LikelyValues, ResultsAreEqualInSomeVectors) {
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 8);
  const terms::TermId applied = terms.Apply(terms.Function("f", 16), {&x, 1});
  const terms::LikelyValues likely(terms);
  for (uint64_t made_up = 0; made_up < 0x10000; made_up += 77)
    EXPECT_LE(likely.ResultOf(3, terms[applied], made_up), 1U);
}

/// Counts what it is asked; knows nothing.
class CountingSolver : public solver::Solver {
 public:
  void Assume(terms::TermId) override {}
  void Push() override {}
  void Pop() override {}
  solver::Answer Check(std::span<const terms::TermId>, const solver::Limit&) override {
    ++questions;
    return solver::Answer::kUnknown;
  }
  uint64_t ValueOf(terms::TermId) override { return 0; }

  int questions = 0;
};

/// Finds out what it is asked for the second time, when there is more time for it, and of one question only.
class PatientSolver : public solver::Solver {
 public:
  explicit PatientSolver(terms::TermId solved) : solved_(solved) {}
  void Assume(terms::TermId) override {}
  void Push() override {}
  void Pop() override {}
  solver::Answer Check(std::span<const terms::TermId> conditions, const solver::Limit&) override {
    const bool is_answered = conditions.front() == solved_ && ++times_ > 1;
    return is_answered ? solver::Answer::kNever : solver::Answer::kUnknown;
  }
  uint64_t ValueOf(terms::TermId) override { return 0; }

 private:
  terms::TermId solved_;
  int times_ = 0;
};

/// What a question about a pair has shown helps the pairs that are computed from it.
TEST(Sweep, EqualPairsAreOneInLaterQuestions) {
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 8), y = terms.Variable("y", 8), z = terms.Variable("z", 8);
  const terms::TermId one = terms.And(x, terms.Or(y, z)), other = terms.Or(terms.And(x, y), terms.And(x, z));
  const terms::TermId three = terms.Const(3, 8);
  const std::array pairs{solver::TermPair{terms.Add(one, three), terms.Add(other, three)},
                         solver::TermPair{one, other}};
  PatientSolver solver(terms.Ne(one, other));
  const std::vector<solver::Verdict> verdicts = solver::Compare(terms, solver, pairs, {});
  EXPECT_EQ(verdicts, (std::vector{solver::Verdict::kEqual, solver::Verdict::kEqual}));
}

/// What is 0 but for three values of an index is not taken for 0: nothing is asked of the terms inside, nor of the
/// pair.
TEST(LikelyValues, TermsThatDifferForFewValuesAreNoCandidates) {
  terms::Terms terms;
  const terms::TermId index = terms.Variable("index", 16), zero = terms.Const(0, 16);
  const terms::TermId element = terms.Ite(IsInTable(terms, index), terms.Xor(index, terms.Const(5, 16)), zero);
  const solver::TermPair pair{terms.Mul(element, element), zero};
  CountingSolver counting;
  solver::SweepLimits limits;
  limits.any_values_count = true;
  EXPECT_EQ(solver::Compare(terms, counting, {&pair, 1}, limits).front(), solver::Verdict::kDifferent);
  EXPECT_EQ(counting.questions, 0);
}

}  // namespace
}  // namespace plcxx::prove
