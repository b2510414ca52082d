// The solver for very many small questions: answers, values, which conditions an answer needs, and what it does not
// know.
#include "transpiler/symbolic/solver/bit_solver.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

namespace plcxx::prove {
namespace {

constexpr uint32_t kTime = 60'000;

TEST(BitSolver, TellsNeverFromPossibleAndGivesValues) {
  terms::Terms terms;
  const std::unique_ptr<solver::BitSolver> solver = solver::LoadBitSolver(terms);
  ASSERT_NE(solver, nullptr);
  const terms::TermId x = terms.Variable("x", 8), y = terms.Variable("y", 8);
  const terms::TermId sum = terms.Eq(terms.Add(x, y), terms.Const(200, 8));
  const terms::TermId small = terms.And(terms.Ult(x, terms.Const(100, 8)), terms.Ult(y, terms.Const(100, 8)));
  const std::array both{sum, small};
  EXPECT_EQ(solver->Check(both, solver::Limit::Effort(kTime)), solver::Answer::kNever);
  ASSERT_EQ(solver->Check({&sum, 1}, solver::Limit::Effort(kTime)), solver::Answer::kPossible);
  EXPECT_EQ((solver->ValueOf(x) + solver->ValueOf(y)) & 0xFF, 200U);
}

TEST(BitSolver, EffortIsCountedInSteps) {
  terms::Terms terms;
  const std::unique_ptr<solver::BitSolver> solver = solver::LoadBitSolver(terms);
  // The only factors below 2^32 of a product of two primes.
  const terms::TermId x = terms.Variable("x", 64), y = terms.Variable("y", 64), border = terms.Const(1ULL << 32U, 64);
  const terms::TermId product = terms.Eq(terms.Mul(x, y), terms.Const(4294967291ULL * 4294967279ULL, 64));
  const terms::TermId hard = terms.And(product, terms.And(terms.Ult(x, border), terms.Ult(y, border)));
  EXPECT_EQ(solver->Check({&hard, 1}, {.effort_ms = 50, .clock_ms = solver::Limit::kNone}), solver::Answer::kUnknown);
  // No time is not all the time that there is.
  EXPECT_EQ(solver->Check({&hard, 1}, solver::Limit::Clock(0)), solver::Answer::kUnknown);
  EXPECT_EQ(solver->Check({&hard, 1}, {.effort_ms = 0, .clock_ms = solver::Limit::kNone}), solver::Answer::kUnknown);
}

TEST(BitSolver, SaysWhichConditionsTheAnswerNeeds) {
  terms::Terms terms;
  const std::unique_ptr<solver::BitSolver> solver = solver::LoadBitSolver(terms);
  ASSERT_NE(solver, nullptr);
  const terms::TermId a = terms.Variable("a", 1), b = terms.Variable("b", 1), c = terms.Variable("c", 1);
  solver->Assume(terms.Or(terms.Not(a), terms.Not(b)));
  const std::array all{c, a, b};
  ASSERT_EQ(solver->Check(all, solver::Limit::Effort(kTime)), solver::Answer::kNever);
  EXPECT_EQ(solver->needed(), (std::vector<bool>{false, true, true}));
  // The same condition twice is needed twice, so that either may stay.
  const std::array twice{a, c, a, b};
  ASSERT_EQ(solver->Check(twice, solver::Limit::Effort(kTime)), solver::Answer::kNever);
  EXPECT_EQ(solver->needed(), (std::vector<bool>{true, false, true, true}));
  const std::array without{c, a};
  EXPECT_EQ(solver->Check(without, solver::Limit::Effort(kTime)), solver::Answer::kPossible);
  EXPECT_EQ(solver->ValueOf(b), 0U);
}

TEST(BitSolver, ConditionsEndWithTheirQuestionAndAssumptionsStay) {
  terms::Terms terms;
  const std::unique_ptr<solver::BitSolver> solver = solver::LoadBitSolver(terms);
  ASSERT_NE(solver, nullptr);
  const terms::TermId a = terms.Variable("a", 1), b = terms.Variable("b", 1);
  const terms::TermId not_a = terms.Not(a);
  ASSERT_EQ(solver->Check({&a, 1}, solver::Limit::Effort(kTime)), solver::Answer::kPossible);
  ASSERT_EQ(solver->Check({&not_a, 1}, solver::Limit::Effort(kTime)), solver::Answer::kPossible);
  solver->Assume(not_a);
  EXPECT_EQ(solver->Check({&a, 1}, solver::Limit::Effort(kTime)), solver::Answer::kNever);
  EXPECT_EQ(solver->Check({&b, 1}, solver::Limit::Effort(kTime)), solver::Answer::kPossible);
}

TEST(BitSolver, KnowsNothingOfFunctionsWithoutMeaning) {
  terms::Terms terms;
  const std::unique_ptr<solver::BitSolver> solver = solver::LoadBitSolver(terms);
  ASSERT_NE(solver, nullptr);
  const terms::TermId x = terms.Variable("x", 8), y = terms.Variable("y", 8);
  const terms::FunctionId f = terms.Function("f", 4);
  const std::array conditions{terms.Eq(x, y), terms.Ne(terms.Apply(f, {&x, 1}), terms.Apply(f, {&y, 1}))};
  // Equal arguments give equal results, but not here: what is possible for this solver need not be.
  EXPECT_EQ(solver->Check(conditions, solver::Limit::Effort(kTime)), solver::Answer::kPossible);
  const terms::TermId differs = terms.Ne(terms.Apply(f, {&x, 1}), terms.Const(3, 4));
  EXPECT_EQ(solver->Check({&differs, 1}, solver::Limit::Effort(kTime)), solver::Answer::kPossible);
}

TEST(BitSolver, AgreesWithTryingAllValues) {
  std::mt19937_64 random(7);
  for (int round = 0; round < 100; ++round) {
    terms::Terms terms;
    const std::unique_ptr<solver::BitSolver> solver = solver::LoadBitSolver(terms);
    ASSERT_NE(solver, nullptr);
    const terms::TermId x = terms.Variable("x", 4), y = terms.Variable("y", 4);
    const uint64_t factor = random() % 16, offset = random() % 16, limit = random() % 4;
    const terms::TermId sum = terms.Add(terms.Mul(x, terms.Const(factor, 4)), terms.Add(y, terms.Const(offset, 4)));
    const std::array conditions{terms.Ult(sum, terms.Const(limit, 4)), terms.Ult(x, y)};
    bool possible = false;
    for (uint64_t i = 0; i < 16; ++i) {
      for (uint64_t j = i + 1; j < 16; ++j) possible = possible || ((i * factor + j + offset) & 15) < limit;
    }
    EXPECT_EQ(solver->Check(conditions, solver::Limit::Effort(kTime)),
              possible ? solver::Answer::kPossible : solver::Answer::kNever);
    if (!possible) continue;
    const uint64_t i = solver->ValueOf(x), j = solver->ValueOf(y);
    EXPECT_LT(i, j);
    EXPECT_LT((i * factor + j + offset) & 15, limit);
  }
}

}  // namespace
}  // namespace plcxx::prove
