#include "transpiler/prove/verify/local_sweep.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "transpiler/symbolic/solver/solver.h"

namespace plcxx::prove::verify {
namespace {

constexpr uint64_t kMilliseconds = 60'000;

class LocalSweepTest : public ::testing::Test {
 protected:
  terms::TermId Variable(const std::string& name) { return terms_.Variable(name, 16); }
  terms::TermId Constant(uint64_t value) { return terms_.Const(value, 16); }

  /// Equal, for no square has this remainder by 4; to see it one has to look into the square, which both have.
  solver::TermPair ElementOf(terms::TermId square, uint64_t number) {
    const std::string name = std::to_string(number);
    const terms::TermId v = Variable("v" + name), w = Variable("w" + name);
    const terms::TermId scaled = terms_.Add(terms_.Mul(square, Constant(7)), Constant(3));
    const terms::TermId here = terms_.Eq(scaled, Constant(7 * (4 * number + 2) + 3));
    return {terms_.Ite(here, v, w), terms_.Ite(here, terms_.Xor(v, w), w)};
  }

  size_t Open(const std::vector<solver::TermPair>& pairs) {
    size_t open = 0;
    for (const solver::TermPair& pair : MakeAlike(terms_, *solver_.solver, pairs, kMilliseconds, answered_))
      open += pair.a == pair.b ? 0 : 1;
    return open;
  }

  terms::Terms terms_;
  solver::LoadedSolver solver_ = solver::LoadSolver(terms_);
  solver::AnsweredForms answered_;
};

/// How deep one has to look is found out once. Each look is at a copy, and so makes terms.
TEST_F(LocalSweepTest, ElementsOfAnArrayAreDecidedAlike) {
  const terms::TermId u = Variable("u"), square = terms_.Mul(u, u);
  const auto made_for = [&](const std::vector<solver::TermPair>& pairs) {
    const size_t before = terms_.size();
    EXPECT_EQ(Open(pairs), 0U);
    return terms_.size() - before;
  };
  std::vector<solver::TermPair> elements;
  for (uint64_t i = 400; i < 410; ++i) elements.push_back(ElementOf(square, i));
  const size_t of_one = made_for({ElementOf(square, 300)}), of_ten = made_for(elements);
  EXPECT_LT(of_ten, 8 * of_one);
}

/// What is looked into for the one before is too much for the next, of which it is enough that both have it.
TEST_F(LocalSweepTest, OneThatIsDecidedInAnotherWayThanTheOneBefore) {
  const terms::TermId u = Variable("u"), square = terms_.Mul(u, u);
  std::vector<terms::TermId> arguments;
  for (int i = 0; i < 700; ++i) arguments.push_back(terms_.Not(Variable("x" + std::to_string(i))));
  const terms::TermId large = terms_.Apply(terms_.Function("f", 16), arguments), v = Variable("v");
  const solver::TermPair shallow = {terms_.Sub(terms_.Add(large, v), terms_.And(large, v)), terms_.Or(large, v)};
  EXPECT_EQ(Open({ElementOf(square, 300), shallow, ElementOf(square, 500)}), 0U);
}

/// That they differ is seen at any depth.
TEST_F(LocalSweepTest, WhatDiffersStaysAsItIs) {
  const terms::TermId u = Variable("u"), square = terms_.Mul(u, u);
  const solver::TermPair different = {terms_.Add(square, Variable("v")), terms_.Add(square, Variable("w"))};
  EXPECT_EQ(Open({ElementOf(square, 300), different, ElementOf(square, 500)}), 1U);
}

}  // namespace
}  // namespace plcxx::prove::verify
