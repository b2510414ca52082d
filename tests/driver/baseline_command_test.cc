// Warnings that are accepted by statement: check --write-baseline, and what counts afterwards.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Two statements write one coil (W356).
constexpr const char* kDoubleCoil = "$\nU4A0=I0A0\nU4A0=I0A1\n";

class BaselineCommand : public ::testing::Test {
 protected:
  BaselineCommand() {
    work_.Write("p.plc", kDoubleCoil);
    work_.Write("plcxx.yaml", "dialect: nc110\nsources: p.plc\nwarnings: {errors: all, baseline: accepted.txt}\n");
  }

  Workplace work_;
};

TEST_F(BaselineCommand, AcceptsTodaysWarningsAndShowsNewOnes) {
  const Ran missing = work_.Run("check");
  EXPECT_EQ(missing.code, 2);
  EXPECT_THAT(missing.errors, AllOf(HasSubstr("accepted.txt: there is no such file"), HasSubstr("--write-baseline")));
  const Ran written = work_.Run("check --write-baseline");
  EXPECT_EQ(written.code, 0) << written;
  EXPECT_THAT(written.errors, HasSubstr("wrote accepted.txt: 2 warnings accepted"));
  EXPECT_THAT(work_.Read("accepted.txt"), HasSubstr("nc110-W356\t1\tp.plc\tU4A0=I0A1\n"));
  const Ran quiet = work_.Run("check");
  EXPECT_EQ(quiet.code, 0) << quiet;
  EXPECT_EQ(quiet.errors, "p: no errors, no warnings\naccepted.txt: 2 accepted warnings\n");
  EXPECT_EQ(work_.Run("emit -q -o out").code, 0);

  // Moved and indented anew it is the same statement.
  work_.Write("p.plc", "; a line\n$\n; and another one\nU4A0=I0A0\n   U4A0=I0A1\n");
  EXPECT_EQ(work_.Run("check").code, 0);
  // Changed it is another one, and the old entry is no use.
  work_.Write("p.plc", "$\nU4A0=I0A0\nU4A0=I0A2\n");
  const Ran changed = work_.Run("check");
  EXPECT_EQ(changed.code, 1) << changed;
  EXPECT_THAT(changed.errors, AllOf(HasSubstr("error: "), HasSubstr("W356"), HasSubstr("1 more that are gone")));
  EXPECT_EQ(work_.Run("emit -q -o out2").code, 1);
  EXPECT_FALSE(work_.Has("out2"));
  // One more of the same statement is one too many.
  work_.Write("p.plc", "$\nU4A0=I0A0\nU4A0=I0A1\nU4A0=I0A1\n");
  EXPECT_EQ(work_.Run("check").code, 1);
}

TEST_F(BaselineCommand, CountsForEveryCommandThatShowsWarnings) {
  EXPECT_EQ(work_.Run("check --write-baseline").code, 0);
  for (const std::string command :
       {"check", "emit -q -o out", "sim --watch U4A0 --cycles 1", "print ir", "report -q -o page.html",
        "report --ladder-text", "report --print-symbols", "identify page.html"}) {
    const Ran ran = work_.Run(command);
    if (command != "identify page.html") {  // which finds no program in it
      EXPECT_EQ(ran.code, 0) << command << "\n" << ran;
    }
    EXPECT_THAT(ran.errors, Not(HasSubstr("W356"))) << command;
  }
}

TEST_F(BaselineCommand, WithoutAProject) {
  EXPECT_THAT(work_.Run("check p.plc --write-baseline --baseline b.txt").errors, HasSubstr("wrote b.txt"));
  const Ran accepted = work_.Run("check p.plc -Werror --baseline b.txt");
  EXPECT_EQ(accepted.code, 0) << accepted;
  EXPECT_THAT(work_.Run("check p.plc --baseline b.txt --diagnostics=json").out, Not(HasSubstr("W356")));
}

// As an editor saves it that marks UTF-8.
TEST_F(BaselineCommand, AByteOrderMarkIsNoneOfItsText) {
  EXPECT_EQ(work_.Run("check --write-baseline").code, 0);
  for (const char* const file : {"accepted.txt", "plcxx.yaml", "p.plc"})
    work_.Write(file, "\xEF\xBB\xBF" + work_.Read(file));
  const Ran quiet = work_.Run("check");
  EXPECT_EQ(quiet.code, 0) << quiet;
  EXPECT_THAT(quiet.errors, HasSubstr("2 accepted warnings"));
  work_.Write("p.prop", "\xEF\xBB\xBFnever U4A0 and not U4A0\n");
  EXPECT_EQ(work_.Run("prove p.plc --property p.prop").code, 0);
  work_.Write("p.yaml", "\xEF\xBB\xBFproperties: [never U4A0 and not U4A0, never NONE]\nsources: [p.plc]\n");
  EXPECT_THAT(work_.Run("prove p.yaml").errors, HasSubstr("p.yaml:1:"));
  work_.Write("p.vcd", "\xEF\xBB\xBF$timescale 1ms $end\n$var wire 1 ! I0A0 $end\n$enddefinitions $end\n#0\n1!\n#40\n");
  EXPECT_EQ(work_.Run("why U4A0 p.plc --vcd p.vcd").code, 0);
}

TEST_F(BaselineCommand, AWrongFileIsSaid) {
  work_.Write("accepted.txt", "# heading\nnc110-W356 1 p.plc U4A0\n");
  const Ran wrong = work_.Run("check");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.errors, HasSubstr("accepted.txt:2:1: an entry is a code, a count, a file and a statement"));
  work_.Write("p.plc", kBadProgram);
  const Ran errors = work_.Run("check --write-baseline");
  EXPECT_EQ(errors.code, 1);
  EXPECT_THAT(errors.errors, HasSubstr("a program with errors has no baseline"));
  EXPECT_THAT(work_.Read("accepted.txt"), HasSubstr("heading"));
}

}  // namespace
}  // namespace plcxx::driver
