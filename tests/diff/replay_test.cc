// plcxx diff: a difference counts when a run of both versions shows it, and its scenario passes on the old one alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/diff/compared_texts.h"
#include "transpiler/engines/platform.h"

namespace plcxx::review::diff {
namespace {

using testing::HasSubstr;

const Language kHnc{"hnc", ".cld"};

/// A program of one line in plc1, behind declarations.
std::string Hnc(const std::string& declarations, const std::string& line) {
  return "#include \"plc.h\"\n" + declarations + "\nvoid init() { plc1_time = 8; plc2_time = 16; }\nvoid plc1() { " +
         line + " }\nvoid plc2() { }\n";
}

const DiffItem* Shown(const Diff& diff, const std::string& name) {
  const DiffItem* const item = ItemNamed(diff, name);
  EXPECT_NE(item, nullptr) << NamesIn(diff);
  if (item == nullptr) return nullptr;
  EXPECT_EQ(item->verdict, ItemVerdict::kDifferent) << item->reason;
  EXPECT_TRUE(item->counterexample.has_value());
  return item->counterexample ? item : nullptr;
}

TEST(DiffReplay, ValuesThatTheSolverMakesUpForFloatsAreEvaluated) {
  const std::string floats = "float f, g;\nlong r;";
  const std::string set = "f = X[0]; g = X[1]; ";
  const Diff diff = ComparedTexts(kHnc, Hnc(floats, set + "r = (long)((f - g) * 16.0); Y[0] = r;"),
                                  Hnc(floats, set + "r = (long)(-(g - f) * 16.0); Y[0] = r;"), {.time_ms = 5000});
  for (const DiffItem& item : diff.items) EXPECT_EQ(item.verdict, ItemVerdict::kUndecided) << item.name;
  const Diff real = ComparedTexts(kHnc, Hnc(floats, set + "r = (long)((f - g) * 16.0); Y[0] = r;"),
                                  Hnc(floats, set + "r = (long)((f - g) * 8.0); Y[0] = r;"), {.time_ms = 5000});
  Shown(real, "r");
}

TEST(DiffReplay, AWiderVariableIsFoundByItsName) {
  const std::string line = "n = X[0]; o = X[1]; Y[0] = n + o;";
  const Diff same = ComparedTexts(kHnc, Hnc("int n, o;", line), Hnc("long n, o;", line));
  EXPECT_TRUE(same.items.empty()) << NamesIn(same);
  const Diff changed =
      ComparedTexts(kHnc, Hnc("int n, o;", line), Hnc("long n, o;", "n = X[0]; o = X[1] + 1; Y[0] = n;"));
  Shown(changed, "o");
  EXPECT_EQ(ItemNamed(changed, "n"), nullptr);
}

TEST(DiffReplay, WhatHasNoNameInTheProgramHasItsWord) {
  // The code that the handler waits for is read by the dispatcher alone.
  const auto program = [](const std::string& step) {
    return "#include \"plc.h\"\nunsigned calls;\nvoid exec_M(int ch) { calls" + step +
           "; mod_M_code(ch) = -1; }\nvoid init(void) { set_mst_func(0, 'M', exec_M); plc1_time = 8; plc2_time = 16; "
           "}\nvoid plc1(void) { plc1_time = 8; }\nvoid plc2(void) { plc2_time = 16; }\n";
  };
  const Diff diff = ComparedUntilShown(kHnc, program("++"), program(" += 2"), {"calls"});
  const DiffItem* const item = Shown(diff, "calls");
  ASSERT_NE(item, nullptr);
  EXPECT_EQ(item->counterexample->replay, Replay::kSimulator);
  EXPECT_THAT(item->counterexample->scenario, HasSubstr("'F[163]': 256"));
}

TEST(DiffReplay, CallsOfAPolledFunctionAreExpectedByItsName) {
  const std::string program = R"(        DATA
IN0: DFM KUS
OUT0: DFM CHOD
        DATA_END
        MODULE_MAIN
        LDR KUS
        FL @,REQ_CLOSE_ALL
        WR CHOD
        MODULE_MAIN_END
        STOP
)";
  const Diff diff = ComparedTexts(kTechnol, With(program, "0"), With(program, "1"));
  for (const char* const calls : {"calls of request", "calls of close_all"}) {
    const DiffItem* const item = Shown(diff, calls);
    ASSERT_NE(item, nullptr);
    EXPECT_EQ(item->counterexample->replay, Replay::kSimulator) << item->counterexample->scenario;
    EXPECT_THAT(item->counterexample->scenario, HasSubstr(": none}]"));
  }
}

TEST(DiffReplay, WordsBelowZeroHaveTheirSign) {
  const std::string program = "SLOW\nNETWORK L0000\nLD %I0\nMOV @, %W10\nEND_SLOW\n";
  const Diff diff = ComparedTexts(kHost50, With(program, "-5"), With(program, "-6"));
  const DiffItem* const item = Shown(diff, "W10");
  ASSERT_NE(item, nullptr);
  EXPECT_EQ(item->counterexample->old_value, "-5");
  EXPECT_EQ(item->counterexample->new_value, "-6");
  EXPECT_THAT(item->counterexample->scenario, HasSubstr("expect: {W10: -5}"));
}

TEST(DiffReplay, TheGeneratedCodeOfBothVersionsShowsIt) {
  const Diff diff = ComparedTexts(kNc110, "$\nU4A8=I0A3\n", "$\nU4A8=I0A4\n", {.compiler = engines::FindCompiler()});
  const DiffItem* const item = Shown(diff, "U4A8");
  ASSERT_NE(item, nullptr);
  EXPECT_EQ(item->counterexample->replay, Replay::kCompiled);
  EXPECT_EQ(diff.not_compiled, "");
  const Diff without = ComparedTexts(kNc110, "$\nU4A8=I0A3\n", "$\nU4A8=I0A4\n", {.compiler = "no-such-compiler"});
  EXPECT_THAT(without.not_compiled, HasSubstr("no-such-compiler"));
  EXPECT_EQ(Shown(without, "U4A8")->counterexample->replay, Replay::kSimulator);
}

}  // namespace
}  // namespace plcxx::review::diff
