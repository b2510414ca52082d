// Facts that decisions rest on, proved for every state: by the function alone, by its callers, in loops; and those that
// do not hold, with a state.
#include "transpiler/prove/verify/facts/facts.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/ir/reader.h"
#include "transpiler/prove/verify/verify.h"

namespace plcxx::prove::verify::facts {
namespace {

constexpr std::string_view kMemory = R"(program p test
space M 40 volatile little host_visible
space L 8 routine little
place byte i8 M[0]
place word i16 M[2]
place table i8 M[8] stride 1 low 8 high 40 indexed
place number i8 L[0]
place count i32 L[4]
host false_fact (kind : i8 = (COMPARISON, DIVISION, SHIFT, SIGN, VARIABLE, INDEX, LOOP, REGISTER, RESULT), statement : i32, value : i32)
)";

/// "%v" is below `most` + 1; an i32.
std::string Fact(const std::string& value, int most, const std::string& prefix) {
  const std::string p = "%" + prefix;
  return p + "m = const i32 " + std::to_string(most) + "\n" + p + "h = ule.i32 " + value + " " + p + "m\n" + p +
         "w = not.bit " + p + "h\nif " + p + "w {\n" + p + "k = const i8 5\n" + p +
         "s = const i32 1\nhost false_fact (" + p + "k, " + p + "s, " + value + ")\n}\n";
}

std::vector<FactProof> Proofs(const std::string& routines) {
  const ir::Program program = ir::ReadOrDie(std::string(kMemory) + routines);
  const emit::Emittable emittable = emit::legalize::Legalize(program, {.name = "p"});
  return ProveFacts(emittable, verify::RoutinesToVerify(program), {});
}

FactProof OnlyProof(const std::string& routines) {
  std::vector<FactProof> proofs = Proofs(routines);
  EXPECT_EQ(proofs.size(), 1U);
  return proofs.empty() ? FactProof() : proofs.front();
}

std::string Fast(const std::string& body) { return "routine fast fast {\n" + body + "}\n"; }

TEST(Facts, ByTheFunctionAlone) {
  const std::string body = "%0 = load byte\n%1 = const i8 31\n%2 = and.i8 %0 %1\n%3 = zext.i8.i32 %2\n";
  EXPECT_EQ(OnlyProof(Fast(body + Fact("%3", 31, "a"))).result, FactResult::kProved);
}

TEST(Facts, ViolatedWithAState) {
  const std::string body = "%0 = load byte\n%1 = const i8 31\n%2 = and.i8 %0 %1\n%3 = zext.i8.i32 %2\n";
  const FactProof proof = OnlyProof(Fast(body + Fact("%3", 30, "a")));
  ASSERT_EQ(proof.result, FactResult::kViolated);
  EXPECT_EQ(proof.value, 31U);
  ASSERT_FALSE(proof.violation.state.empty());
}

TEST(Facts, OnlyWhereExecutionComes) {
  const std::string body =
      "%0 = load byte\n%1 = const i8 9\n%2 = ult.i8 %0 %1\n%3 = zext.i8.i32 %0\nif %2 {\n" + Fact("%3", 8, "a") + "}\n";
  EXPECT_EQ(OnlyProof(Fast(body)).result, FactResult::kProved);
}

/// The subroutine alone does not know what it is called with.
TEST(Facts, ByTheCallersArguments) {
  const std::string callee =
      "routine check subroutine (number : i8 = number) {\n%0 = load number\n%1 = zext.i8.i32 %0\n" +
      Fact("%1", 15, "a") + "}\n";
  const auto caller = [](int mask) {
    return Fast("%0 = load byte\n%1 = const i8 " + std::to_string(mask) + "\n%2 = and.i8 %0 %1\ncall check (%2)\n");
  };
  EXPECT_EQ(OnlyProof(callee + caller(15)).result, FactResult::kProved);
  const FactProof wrong = OnlyProof(callee + caller(16));
  EXPECT_EQ(wrong.result, FactResult::kViolated);
  EXPECT_EQ(wrong.value, 16U);
}

/// All iterations are the first ones.
TEST(Facts, InALoopThatItselfEnds) {
  const auto loop = [](int most) {
    return Fast(
        "%0 = const i32 0\nstore count %0\nloop @1 guard 9 {\ncondition {\n%1 = load count\n%2 = const i32 9\n"
        "%4 = ult.i32 %1 %2\n}\nbody {\n%5 = load count\n" +
        Fact("%5", most, "a") +
        "}\nstep {\n%8 = load count\n%9 = const i32 1\n%10 = add.i32 %8 %9\nstore count %10\n}\n}\n");
  };
  EXPECT_EQ(OnlyProof(loop(8)).result, FactResult::kProved);
  EXPECT_EQ(OnlyProof(loop(7)).result, FactResult::kViolated);
}

/// The state says how many iterations there are: an arbitrary one is executed.
TEST(Facts, InALoopThatTheStateEnds) {
  const auto loop = [](int most, const std::string& exhausted) {
    return Fast(
        "%0 = const i32 0\nstore count %0\nloop @1 guard 256 {\ncondition {\n%1 = load count\n%2 = load byte\n"
        "%3 = zext.i8.i32 %2\n%4 = ult.i32 %1 %3\n}\nbody {\n%5 = load count\n" +
        Fact("%5", most, "a") +
        "%6 = const i8 0\n%7 = load count\nstore table[%7] %6\n}\nstep {\n%8 = load count\n%9 = const i32 1\n"
        "%10 = add.i32 %8 %9\nstore count %10\n}\n" +
        exhausted + "}\n");
  };
  EXPECT_EQ(OnlyProof(loop(254, "")).result, FactResult::kProved);
  EXPECT_NE(OnlyProof(loop(100, "")).result, FactResult::kProved);
  // That it ends after so many iterations.
  const std::string exhausted =
      "exhausted {\n%xk = const i8 6\n%xs = const i32 1\n%xv = const i32 256\nhost false_fact (%xk, %xs, %xv)\n}\n";
  const std::vector<FactProof> both = Proofs(loop(254, exhausted));
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0].result, FactResult::kProved) << both[0].reason;
  EXPECT_EQ(both[1].result, FactResult::kProved) << both[1].reason;
}

}  // namespace
}  // namespace plcxx::prove::verify::facts
