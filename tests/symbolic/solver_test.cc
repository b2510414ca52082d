// The solver behind its interface: answers, models, and the same questions put to a second solver as SMT-LIB text.
#include "transpiler/symbolic/solver/solver.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <limits>
#include <random>
#include <span>
#include <string_view>
#include <thread>
#include <vector>

#include "tests/symbolic/smt_text.h"
#include "tests/temporary_directory.h"
#include "transpiler/symbolic/solver/deadline.h"
#include "transpiler/symbolic/solver/sweep.h"
#include "transpiler/symbolic/terms/evaluate.h"
#include "transpiler/symbolic/terms/floats.h"

namespace plcxx::prove {
namespace {

std::unique_ptr<solver::Solver> Load(const terms::Terms& terms) {
  solver::LoadedSolver loaded = solver::LoadSolver(terms);
  EXPECT_NE(loaded.solver, nullptr) << loaded.reason;
  return std::move(loaded.solver);
}

TEST(Solver, TellsNeverFromPossibleAndGivesValues) {
  terms::Terms terms;
  const std::unique_ptr<solver::Solver> solver = Load(terms);
  const terms::TermId x = terms.Variable("x", 8), y = terms.Variable("y", 8);
  const terms::TermId sum = terms.Eq(terms.Add(x, y), terms.Const(200, 8));
  const terms::TermId small = terms.And(terms.Ult(x, terms.Const(100, 8)), terms.Ult(y, terms.Const(100, 8)));
  const std::array both{sum, small};
  EXPECT_EQ(solver->Check(both, solver::Limit::Effort(10'000)), solver::Answer::kNever);
  ASSERT_EQ(solver->Check({&sum, 1}, solver::Limit::Effort(10'000)), solver::Answer::kPossible);
  EXPECT_EQ((solver->ValueOf(x) + solver->ValueOf(y)) & 0xFF, 200U);
}

TEST(Solver, AssumptionsEndWithTheirPop) {
  terms::Terms terms;
  const std::unique_ptr<solver::Solver> solver = Load(terms);
  const terms::TermId a = terms.Variable("a", 1);
  solver->Push();
  solver->Assume(terms.Not(a));
  EXPECT_EQ(solver->Check({&a, 1}, solver::Limit::Effort(10'000)), solver::Answer::kNever);
  solver->Pop();
  EXPECT_EQ(solver->Check({&a, 1}, solver::Limit::Effort(10'000)), solver::Answer::kPossible);
}

TEST(Solver, UnknownFunctionsGiveEqualResultsForEqualArguments) {
  terms::Terms terms;
  const std::unique_ptr<solver::Solver> solver = Load(terms);
  const terms::TermId x = terms.Variable("x", 8), y = terms.Variable("y", 8);
  const terms::FunctionId f = terms.Function("f", 4);
  const std::array conditions{terms.Eq(x, y), terms.Ne(terms.Apply(f, {&x, 1}), terms.Apply(f, {&y, 1}))};
  EXPECT_EQ(solver->Check(conditions, solver::Limit::Effort(10'000)), solver::Answer::kNever);
  EXPECT_EQ(solver->Check({&conditions[1], 1}, solver::Limit::Effort(10'000)), solver::Answer::kPossible);
}

using FloatOperation = terms::TermId (*)(terms::Terms&, terms::TermId, terms::TermId);

/// Whether a function of floating point gives for numbers of every kind what it has as their value, asked of the
/// solver.
void ExpectFloatsAsEvaluated(const char* name, FloatOperation operation, uint8_t width,
                             std::span<const double> numbers) {
  constexpr size_t kAtOnce = 8;
  const bool is_number = std::string_view(name) != "ToSigned";
  terms::Terms terms;
  const std::unique_ptr<solver::Solver> solver = Load(terms);
  terms::TermId any = terms.Bit(false);
  std::vector<terms::TermId> conditions;
  const auto ask = [&] {
    conditions.push_back(any);
    EXPECT_EQ(solver->Check(conditions, solver::Limit::Effort(10'000)), solver::Answer::kNever) << name << +width;
    conditions.clear();
    any = terms.Bit(false);
  };
  for (const double a : numbers) {
    for (const double b : numbers) {
      const terms::TermId of_a = terms::FloatConst(terms, a, width), of_b = terms::FloatConst(terms, b, width);
      const terms::TermId x = terms.Variable("x", width), y = terms.Variable("y", width);
      conditions.push_back(terms.And(terms.Eq(x, of_a), terms.Eq(y, of_b)));
      const terms::TermId of_variables = operation(terms, x, y), of_numbers = operation(terms, of_a, of_b);
      // Of a sign before an operand NaN has it, too; nobody looks at it.
      const terms::TermId is_nan = is_number && terms.IsTrue(terms::FloatIsNan(terms, of_numbers))
                                       ? terms::FloatIsNan(terms, of_variables)
                                       : terms.Bit(false);
      any = terms.Or(any, terms.And(terms.Ne(of_variables, of_numbers), terms.Not(is_nan)));
      if (conditions.size() == kAtOnce) ask();
    }
  }
  if (!conditions.empty()) ask();
}

TEST(Solver, FloatingPointIsAsItIsEvaluated) {
  using Limits = std::numeric_limits<float>;
  const std::array numbers{0.0,
                           -0.0,
                           1.0,
                           -2.5,
                           3.6,
                           100.0,
                           double{Limits::denorm_min()},
                           double{Limits::max()},
                           1e-3,
                           0x1p63,
                           0.5,
                           -1.5,
                           -double{Limits::infinity()},
                           double{Limits::quiet_NaN()}};
  for (const uint8_t width : {uint8_t{32}, uint8_t{64}}) {
    ExpectFloatsAsEvaluated("Add", terms::FloatAdd, width, numbers);
    ExpectFloatsAsEvaluated("Mul", terms::FloatMul, width, numbers);
    ExpectFloatsAsEvaluated("Div", terms::FloatDiv, width, numbers);
    ExpectFloatsAsEvaluated(
        "Sqrt", [](terms::Terms& t, terms::TermId a, terms::TermId) { return terms::FloatSqrt(t, a); }, width, numbers);
    ExpectFloatsAsEvaluated(
        "Rint", [](terms::Terms& t, terms::TermId a, terms::TermId) { return terms::FloatRint(t, a); }, width, numbers);
    ExpectFloatsAsEvaluated(
        "ToSigned", [](terms::Terms& t, terms::TermId a, terms::TermId) { return terms::FloatToSigned(t, a, 64); },
        width, numbers);
    // A number's bits are an integer, too.
    ExpectFloatsAsEvaluated(
        "FromSigned", [](terms::Terms& t, terms::TermId a, terms::TermId) { return terms::FloatFromSigned(t, a, 32); },
        width, numbers);
    ExpectFloatsAsEvaluated(
        "Convert",
        [](terms::Terms& t, terms::TermId a, terms::TermId) {
          return t.Width(a) == 32 ? terms::FloatWiden(t, a) : terms::FloatNarrow(t, a);
        },
        width, numbers);
  }
}

TEST(Solver, FindsTheNumberThatAProductHasToBeOf) {
  terms::Terms terms;
  const std::unique_ptr<solver::Solver> solver = Load(terms);
  const terms::TermId x = terms.Variable("x", 32);
  const auto product_is = [&](double factor, double product) {
    return terms.Eq(terms::FloatMul(terms, x, terms::FloatConst(terms, factor, 32)),
                    terms::FloatConst(terms, product, 32));
  };
  const terms::TermId hundred = product_is(3.6, 100.0);
  ASSERT_EQ(solver->Check({&hundred, 1}, solver::Limit::Effort(10'000)), solver::Answer::kPossible);
  EXPECT_EQ(std::bit_cast<float>(static_cast<uint32_t>(solver->ValueOf(x))) * 3.6F, 100.0F);
  // The products of two numbers beside each other leave one out.
  const terms::TermId left_out = product_is(1.5, double{std::bit_cast<float>(0x3FCCCCCDU)});
  EXPECT_EQ(solver->Check({&left_out, 1}, solver::Limit::Effort(10'000)), solver::Answer::kNever);
}

/// How far a solver comes must not depend on how much else the machine has to do: no clock ends this question.
TEST(Solver, EffortIsCountedInSteps) {
  terms::Terms terms;
  const std::unique_ptr<solver::Solver> solver = Load(terms);
  // The only factors below 2^32 of a product of two primes.
  const terms::TermId x = terms.Variable("x", 64), y = terms.Variable("y", 64), border = terms.Const(1ULL << 32U, 64);
  const terms::TermId product = terms.Eq(terms.Mul(x, y), terms.Const(4294967291ULL * 4294967279ULL, 64));
  const terms::TermId hard = terms.And(product, terms.And(terms.Ult(x, border), terms.Ult(y, border)));
  EXPECT_EQ(solver->Check({&hard, 1}, {.effort_ms = 50, .clock_ms = solver::Limit::kNone}), solver::Answer::kUnknown);
  // No time is not all the time that there is.
  EXPECT_EQ(solver->Check({&hard, 1}, solver::Limit::Clock(0)), solver::Answer::kUnknown);
  EXPECT_EQ(solver->Check({&hard, 1}, {.effort_ms = 0, .clock_ms = solver::Limit::kNone}), solver::Answer::kUnknown);
  const terms::TermId easy = terms.Eq(x, y);
  EXPECT_EQ(solver->Check({&easy, 1}, {.effort_ms = 50, .clock_ms = solver::Limit::kNone}), solver::Answer::kPossible);
}

TEST(Solver, LimitsOfEffortWaitForASlowMachineButNotBeyondTheCommandsTime) {
  const solver::Limit limit = solver::Limit::Effort(100);
  EXPECT_EQ(limit.effort_ms, 100U);
  EXPECT_EQ(limit.clock_ms, 100 * solver::Limit::kPatience);
  EXPECT_EQ(limit.Within(7).clock_ms, 7U);
  EXPECT_EQ(limit.Within(7).effort_ms, 100U);
  EXPECT_EQ(limit.Within(1'000'000).clock_ms, limit.clock_ms);
  EXPECT_EQ(solver::Limit::Effort(solver::Limit::kNone - 1).clock_ms, solver::Limit::kNone);
  EXPECT_EQ(solver::Limit::Clock(5).effort_ms, solver::Limit::kNone);
}

/// Who waits has had no processor.
TEST(Deadline, OfTheProcessorWaitsForIt) {
  const solver::Deadline wall(solver::Clock::kWall, 30), processor(solver::Clock::kProcessor, 30);
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  EXPECT_TRUE(wall.IsOver());
  EXPECT_FALSE(processor.IsOver());
  while (!processor.IsOver()) continue;
  EXPECT_EQ(processor.RestMs(), 0U);
}

TEST(Deadline, QuestionsEndWithIt) {
  const solver::Deadline wall(solver::Clock::kWall, 5'000), processor(solver::Clock::kProcessor, 5'000);
  EXPECT_EQ(wall.LimitFor(100).effort_ms, 100U);
  EXPECT_LE(wall.LimitFor(100'000).clock_ms, 5'000U);
  EXPECT_EQ(processor.LimitFor(100).effort_ms, 100U);
  // A step may take longer than it counts.
  EXPECT_LE(processor.LimitFor(100'000).effort_ms, 2'500U);
  EXPECT_GT(processor.LimitFor(100'000).effort_ms, 2'000U);
  EXPECT_GT(solver::Deadline(solver::Clock::kWall, ~uint64_t{0}).RestMs(), 1'000'000'000U);
  EXPECT_EQ(solver::Deadline(solver::Clock::kWall, 0).LimitFor(100).clock_ms, 1U);
}

/// A term over the variables, of random shape.
terms::TermId RandomTerm(terms::Terms& terms, std::mt19937_64& random, const std::vector<terms::TermId>& variables,
                         int depth) {
  if (depth == 0) return variables[random() % variables.size()];
  const terms::TermId a = RandomTerm(terms, random, variables, depth - 1),
                      b = RandomTerm(terms, random, variables, depth - 1);
  const uint8_t width = terms.Width(a);
  switch (random() % 14) {
    case 0:
      return terms.Not(a);
    case 1:
      return terms.And(a, b);
    case 2:
      return terms.Or(a, b);
    case 3:
      return terms.Xor(a, b);
    case 4:
      return terms.Add(a, b);
    case 5:
      return terms.Sub(a, b);
    case 6:
      return terms.Mul(a, b);
    case 7:
      return terms.Udiv(a, b);
    case 8:
      return terms.Srem(a, b);
    case 9:
      return terms.Shl(a, b);
    case 10:
      return terms.Ashr(a, b);
    case 11:
      return terms.Ite(terms.Slt(a, b), a, b);
    case 12:
      return terms.Concat(terms.Extract(a, 0, static_cast<uint8_t>(width / 2)),
                          terms.Extract(b, static_cast<uint8_t>(width / 2), static_cast<uint8_t>(width - width / 2)));
    default:
      return terms.Sext(terms.Extract(a, 1, static_cast<uint8_t>(width - 2)), width);
  }
}

/// "sat", "unsat" or what else it says; empty: there is no cvc5.
std::string AskCvc5(const std::string& text) {
  const testing_support::TemporaryDirectory directory;
  const std::string path = directory.File("question.smt2");
  std::ofstream(path) << text;
  FILE* const pipe = popen(("cvc5 --lang smt2 --tlimit=20000 " + path + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return {};
  std::array<char, 4096> buffer{};
  const size_t size = fread(buffer.data(), 1, buffer.size() - 1, pipe);
  pclose(pipe);
  return {buffer.data(), size};
}

TEST(SmtText, AnotherSolverAgrees) {
  if (std::system("command -v cvc5 > /dev/null 2>&1") != 0) GTEST_SKIP() << "cvc5 is not installed";
  std::mt19937_64 random(20);
  int never = 0;
  for (int i = 0; i < 25; ++i) {
    terms::Terms terms;
    const std::unique_ptr<solver::Solver> solver = Load(terms);
    std::vector<terms::TermId> variables;
    for (const char* name : {"x", "a |b\\", "z"}) variables.push_back(terms.Variable(name, 6));
    const terms::FunctionId f = terms.Function("answer of |f", 6);
    variables.push_back(terms.Apply(f, {variables.data(), 2}));
    // Half of the questions have the same term on both sides in two ways of writing, so that the answer is "never".
    const terms::TermId a = RandomTerm(terms, random, variables, 3), b = RandomTerm(terms, random, variables, 3);
    const terms::TermId question =
        i % 2 == 0 ? terms.Ne(terms.Add(a, b), terms.Sub(a, terms.Not(terms.Sub(b, terms.Const(1, 6)))))
                   : terms.And(terms.Slt(a, b), terms.Ult(terms.Xor(a, b), terms.Const(5, 6)));
    if (terms.IsConst(question)) continue;
    const solver::Answer answer = solver->Check({&question, 1}, solver::Limit::Effort(20'000));
    never += answer == solver::Answer::kNever ? 1 : 0;
    EXPECT_EQ(AskCvc5(solver::SmtText(terms, {&question, 1})), answer == solver::Answer::kNever ? "unsat\n" : "sat\n")
        << solver::SmtText(terms, {&question, 1});
  }
  EXPECT_GE(never, 3);
}

TEST(Sweep, FindsEqualityThroughManyRewrittenParts) {
  terms::Terms terms;
  const std::unique_ptr<solver::Solver> solver = Load(terms);
  std::vector<solver::TermPair> pairs;
  terms::TermId a = terms.Variable("start", 1), b = a;
  for (int i = 0; i < 200; ++i) {
    const terms::TermId x = terms.Variable("x" + std::to_string(i), 1), y = terms.Variable("y" + std::to_string(i), 1);
    // The same step by two laws: or distributes over and.
    a = terms.Or(x, terms.And(y, a));
    b = terms.And(terms.Or(x, y), terms.Or(x, b));
    pairs.push_back({a, b});
  }
  const std::vector<solver::Verdict> verdicts = solver::Compare(terms, *solver, pairs, {});
  EXPECT_EQ(std::count(verdicts.begin(), verdicts.end(), solver::Verdict::kEqual), 200);
}

TEST(Sweep, TellsADifferenceFromWhatHidesIt) {
  terms::Terms terms;
  const std::unique_ptr<solver::Solver> solver = Load(terms);
  const terms::TermId x = terms.Variable("x", 32), y = terms.Variable("y", 32);
  // Differs for one pair of values in 2^64: no random value finds it.
  const terms::TermId rare =
      terms.And(terms.Eq(x, terms.Const(0x12345678, 32)), terms.Eq(y, terms.Const(0x9ABCDEF0, 32)));
  const terms::TermId sum = terms.Add(x, y);
  const std::array pairs{solver::TermPair{sum, terms.Ite(rare, terms.Const(0, 32), sum)},
                         solver::TermPair{terms.Mul(x, terms.Const(3, 32)), terms.Add(x, terms.Add(x, x))}};
  const std::vector<solver::Verdict> verdicts = solver::Compare(terms, *solver, pairs, {});
  EXPECT_EQ(verdicts[0], solver::Verdict::kDifferent);
  EXPECT_EQ(verdicts[1], solver::Verdict::kEqual);
}

}  // namespace
}  // namespace plcxx::prove
