// Each effect is spelled exactly once in its function; a record that says otherwise is refused before anything is
// there.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/ir/reader.h"

namespace plcxx::emit::print {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::string_view kMap = R"(
space m 4 volatile little
space r 8 routine little
state C5 decade_counter
place a bit m[0].0
place b bit m[0].1
place c bit m[0].2
place w i8 m[1]
place rounds i32 r[0]
host ask (width : i8) -> bit
)";

ir::Program Fast(std::string_view body) {
  return ir::ReadOrDie(std::string(kMap) + "routine fast fast {\n" + std::string(body) + "}\n");
}

std::string Source(const ir::Program& program) {
  return PrintCpp(legalize::Legalize(program, {.name = "p"}), source::SourceManager()).back().text;
}

TEST(SpelledOnce, AStepWhoseExitLeadsNowhereElseIsALine) {
  EXPECT_THAT(Source(Fast("block @1 {\n%0 = load a\n%1 = step.count_up C5 %0\nexit @1 if %1\n}\n")),
              HasSubstr("  CountUp(m[C5], m[a]);\n"));
}

TEST(SpelledOnce, AValueThatOnlySuchAnExitAsksForIsNotThere) {
  const std::string source =
      Source(Fast("stmt s1\n%0 = load a\nstore b %0\nblock @1 {\n%1 = load c\n%2 = not.bit %1\nexit @1 if %2\n}\n"));
  EXPECT_THAT(source, Not(HasSubstr("m[c]")));
}

TEST(SpelledOnce, AStepAskedForInTheNextBlockIsThere) {
  const std::string source = Source(
      Fast("%0 = load a\n%1 = step.count_up C5 %0\nblock @1 {\n%2 = not.bit %1\nif %2 {\n%3 = load b\nstore c %3\n"
           "exit @1\n}\n%4 = load c\nstore b %4\n}\n"));
  EXPECT_THAT(source, HasSubstr("  if (!CountUp(m[C5], m[a])) {\n"));
  EXPECT_EQ(source.find("CountUp(m"), source.rfind("CountUp(m"));
}

TEST(SpelledOnce, AnEffectStaysBeforeWhatIsReadBehindIt) {
  // %1 is needed twice, so that it has a line; the call may not come behind that.
  const std::string source = Source(
      Fast("block @1 {\nstmt s1\n%0 = load w\n%2 = host ask (%0)\n%1 = load a\nexit @1 if %2\nstore b %1\nstore c %1\n"
           "}\nstmt s2\n%0 = load b\nstore a %0\n"));
  const size_t call = source.find("= ask(host, m[w]);");
  ASSERT_NE(call, std::string::npos) << source;
  EXPECT_LT(call, source.find("= m[a];")) << source;
}

TEST(SpelledOnce, AnEffectInALoopsConditionIsThereOnce) {
  const std::string source = Source(Fast(
      "loop @1 guard 3 {\ncondition {\n%0 = load w\n%1 = host ask (%0)\n}\nbody {\n%2 = load a\nstore b %2\n}\n}\n"));
  EXPECT_EQ(source.find("ask(host"), source.rfind("ask(host")) << source;
  EXPECT_THAT(source, HasSubstr("    if (!ask(host, m[w])) break;\n"));
}

TEST(SpelledOnce, LoopsAreRecordedWithTheirLines) {
  const ir::Program program = Fast(
      "stmt s1\n%0 = load w\nloop @1 budget 0 rounds {\nbody {\nloop @2 guard 3 {\nbody {\n%2 = load a\nstore b "
      "%2\n}\n}\n"
      "%1 = load a\nrepeat @1 if %1\n}\n}\n");
  const OutputFile file = PrintCpp(legalize::Legalize(program, {.name = "p"}), source::SourceManager()).back();
  ASSERT_EQ(file.loops.size(), 2u);
  const auto line = [&](uint32_t number) {
    size_t at = 0;
    for (uint32_t i = 1; i < number; ++i) at = file.text.find('\n', at) + 1;
    return file.text.substr(at, file.text.find('\n', at) - at);
  };
  EXPECT_EQ(line(file.loops[0].line), "  for (;;) {");
  EXPECT_EQ(file.loops[0].budget, program.loops[ir::LoopId(1)].budget);
  EXPECT_EQ(line(file.loops[1].line), "    for (uint32_t round = 0;; ++round) {");
  EXPECT_EQ(file.loops[1].rounds, 3u);
}

class Damaged : public testing::Test {
 protected:
  const ir::Program program_ =
      Fast("%0 = load a\n%1 = step.count_up C5 %0\n%2 = not.bit %1\nif %2 {\n%3 = load b\nstore c %3\n}\n");
  Emittable emittable_ = legalize::Legalize(program_, {.name = "p"});

  Form& FormOf(ir::OpKind op) {
    for (const ir::InstId id : PrintedInsts(program_, {})) {
      if (program_[id].op == op) return emittable_.forms[id.index];
    }
    ADD_FAILURE();
    return emittable_.forms[0];
  }
  void ExpectRefused() {
    EXPECT_EXIT(PrintCpp(emittable_, source::SourceManager()), testing::ExitedWithCode(3),
                "each_effect_is_spelled_once");
  }
};
using DamagedDeathTest = Damaged;

TEST_F(DamagedDeathTest, AsItIsItIsPrinted) { EXPECT_EQ(PrintCpp(emittable_, source::SourceManager()).size(), 2u); }

TEST_F(DamagedDeathTest, AStepOnALineOfItsOwnToo) {
  FormOf(ir::OpKind::kCountUp) = Form::kLine;
  ExpectRefused();
}

TEST_F(DamagedDeathTest, AStoreThatIsNowhere) {
  FormOf(ir::OpKind::kStore) = Form::kNowhere;
  ExpectRefused();
}

TEST_F(DamagedDeathTest, AStepThatIsInsideOfNothing) {
  FormOf(ir::OpKind::kIf) = Form::kNowhere;
  ExpectRefused();
}

}  // namespace
}  // namespace plcxx::emit::print
