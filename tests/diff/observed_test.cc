// plcxx diff: everything that docs/review.md says is observed is compared.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/diff/compared_texts.h"

namespace plcxx::review::diff {
namespace {

using testing::HasSubstr;

void ExpectDifferent(const Diff& diff, const std::string& name) {
  const DiffItem* const item = ItemNamed(diff, name);
  ASSERT_NE(item, nullptr) << name << " is not among: " << NamesIn(diff);
  EXPECT_EQ(item->verdict, ItemVerdict::kDifferent) << item->reason;
}

TEST(Observed, TheOrderOfCallsOfTwoFunctions) {
  const std::string write = ":JU FM 51\n: IB 106\n: K 41\n: K 1\n", read = ":JU FM 41\n: K 41\n: K 1\n: OB 106\n";
  const std::string program =
      ":MOD PM 9\n:A I 20.1\n@:= F 100.0\n:END PM 9\n:MOD PM 0\n:A I 20.1\n:S F 251.0\n:END PM 0\n";
  const Diff diff = ComparedUntilShown(kProstep, With(program, write + read), With(program, read + write),
                                       {"OB 106", "order of calls"});
  // The control gives back what was written.
  ExpectDifferent(diff, "OB 106");
  ExpectDifferent(diff, "order of calls");
  EXPECT_TRUE(ComparedTexts(kProstep, With(program, write + read), With(program, write + read)).items.empty());
}

TEST(Observed, AStatementThatMovesIntoTheFastPart) {
  ExpectDifferent(ComparedTexts(kNc110, "$\nU4A0=I0A0\n", "U4A0=I0A0\n$\n"), "U4A0");
  EXPECT_TRUE(ComparedTexts(kNc110, "U4A0=I0A0\nU4A1=I0A1\n$\n", "U4A1=I0A1\nU4A0=I0A0\n$\n").items.empty());
}

TEST(Observed, AStatementThatMovesIntoAnotherSlice) {
  const auto compared = [](const std::string& old_text, const std::string& new_text) {
    const testing_support::TemporaryDirectory directory;
    const auto side = [&](const std::string& name, const std::string& text) {
      compilation::CompilationRequest request;
      request.sources = {directory.Write(name + ".plc", text)};
      request.options = {{"slices", "2"}};
      return MakeDiffSide(name, request);
    };
    DiffSide old_side = side("old", old_text), new_side = side("new", new_text);
    return CompareSides(old_side, new_side, {});
  };
  const std::string fast = "U100K0=/U100K0\n$\n", three = "U4A1=I0A1\nU4A2=I0A2\nU4A3=I0A3\n", moved = "U4A0=U100K0\n";
  const Diff diff = compared(fast + moved + three, fast + three + moved);
  const DiffItem* const item = ItemNamed(diff, "between slices");
  ASSERT_NE(item, nullptr);
  EXPECT_THAT(item->through, testing::Contains("U4A0"));
  EXPECT_THAT(item->reason, HasSubstr("U4A0"));
  // What is not proved slice by slice does not count among what is.
  EXPECT_EQ(diff.equal + item->through.size(), compared(fast + moved + three, fast + moved + three).equal)
      << item->reason;
  EXPECT_TRUE(compared(fast + moved + three, fast + moved + three).items.empty());
}

// A signal that the control owns and the program sets: where the control leaves it alone, the next period reads what
// the program wrote.
TEST(Observed, WhatTheProgramWritesIntoTheInputsMayStayThere) {
  const std::string read = "$\nU5A0=U9K7*I0A2\n";
  ExpectDifferent(ComparedTexts(kNc110, read + "U9K7=I0A0*I0A1\n", read + "U9K7=I0A0\n"), "U5A0");
  EXPECT_TRUE(ComparedTexts(kNc110, read + "U9K7=I0A0*I0A1\n", read + "U9K7=I0A1*I0A0\n").items.empty());
}

// Lamps of the mode keys: the base software drives U159K6 to U159K13, whatever the program writes into their bytes.
TEST(Observed, OneBitOfAByteMayBeTheControls) {
  const std::string lamps = "U159K5=I0A0\nU159K6=I0A0*/I0A0\n";
  ExpectDifferent(ComparedTexts(kNc110, "$\nU5A0=U159K6*I0A2\n" + lamps, "$\nU5A0=U159K6*I0A3\n" + lamps), "U5A0");
  // The bit beside it is the program's own, and never 1.
  const std::string own = "U159K5=I0A0*/I0A0\n";
  EXPECT_TRUE(ComparedTexts(kNc110, "$\nU5A0=U159K5*I0A2\n" + own, "$\nU5A0=U159K5*I0A3\n" + own).items.empty());
}

// The NC clears the request O 26.6 when the register of the travelled distance is cleared; O 26.5 is the program's.
TEST(Observed, OneBitOfAByteMayBeClearedByTheControl) {
  const auto program = [](const std::string& bit) {
    return ":MOD PM 9\n:A I 0.1\n@:= O 0.0\n:END PM 9\n:MOD PM 0\n:A I 20.1\n:S " + bit + "\n:S F 251.0\n:END PM 0\n";
  };
  const std::string left = program("O 26.6"), kept = program("O 26.5");
  ExpectDifferent(ComparedUntilShown(kProstep, With(left, ""), With(left, ":A O 26.6\n"), {"O 0.0"}), "O 0.0");
  EXPECT_TRUE(ComparedTexts(kProstep, With(kept, ""), With(kept, ":A O 26.5\n")).items.empty());
}

// Free memory that the control writes, as the option says: the program's own write is not all that comes there.
TEST(Observed, OneBitOfAByteMayBeNamedByTheOptionExtern) {
  const auto compared = [](const std::string& external) {
    const testing_support::TemporaryDirectory directory;
    const auto side = [&](const std::string& name, const std::string& input) {
      compilation::CompilationRequest request;
      request.sources = {directory.Write(
          name + ".plc", "$\nU5A0=U100K0*U100K1*" + input + "\nU100K0=I0A0\nU100K1=/I0A0\nU100K7=I0A1\n")};
      request.options = {{"extern", external}};
      return MakeDiffSide(name, request);
    };
    DiffSide old_side = side("old", "I0A2"), new_side = side("new", "I0A3");
    return CompareSides(old_side, new_side, {});
  };
  ExpectDifferent(compared("U100K0"), "U5A0");
  EXPECT_TRUE(compared("U100K7").items.empty());
}

TEST(Observed, TheVerdictNamesWhatOneVersionAloneHasInside) {
  const std::string output = "$\nU4A0=I0A0\n", flag = "U100K0=I0A0\n";
  const Diff gone = ComparedTexts(kNc110, output + flag, output);
  EXPECT_TRUE(gone.items.empty());
  EXPECT_THAT(gone.old_only, testing::ElementsAre("U100K0"));
  EXPECT_THAT(gone.not_looked_at, testing::Contains("internal memory that only the old version writes (U100K0)"));
  const Diff added = ComparedTexts(kNc110, output, output + "T5I(10)=I0A0\n");
  EXPECT_THAT(added.new_only, testing::Not(testing::IsEmpty()));
  EXPECT_TRUE(added.old_only.empty());
  // What the other version reads is compared.
  EXPECT_TRUE(ComparedTexts(kNc110, output + flag, output + flag).not_looked_at.empty());
  EXPECT_TRUE(ComparedTexts(kNc110, flag + output, output + "U4A1=U100K0\n").old_only.empty());
}

TEST(Observed, MemoryThatOneVersionNeverWritesMayBeSet) {
  const Diff diff = ComparedTexts(kNc110, "$\nU4A0=I0A0*/U100K0\n", "$\nU100K0=I0A0*/I0A0\nU4A0=I0A0*/U100K0\n");
  ExpectDifferent(diff, "U4A0");
}

TEST(Observed, TextsOfMessages) {
  const std::string program =
      "%PLC X\nDM 1 .@\n:MOD PM 1\n:A I 0.0\n:= F 213.0\n:END PM 1\n:MOD PM 0\n:A I 20.1\n:S F 250.0\n:END PM 0\n";
  const Diff diff = ComparedTexts(kProstep, With(program, "STOP"), With(program, "GO"));
  ExpectDifferent(diff, "message 1");
  EXPECT_THAT(ItemNamed(diff, "message 1")->declared->new_text, HasSubstr("GO"));
}

TEST(Observed, PeriodsAndInitialBytes) {
  const testing_support::TemporaryDirectory directory;
  const std::string source = directory.Write("p.plc", "$\nU4A0=/U4A0\n");
  const auto side = [&](const std::string& clo) {
    compilation::CompilationRequest request;
    request.sources = {source};
    request.options = {{"clo", clo}};
    return MakeDiffSide(clo, request);
  };
  DiffSide quick = side("10,2"), slow = side("40,2");
  const Diff periods = CompareSides(quick, slow, {});
  ExpectDifferent(periods, "period");
  EXPECT_EQ(ItemNamed(periods, "period")->declared->old_text, "10 ms");
  EXPECT_EQ(ItemNamed(periods, "period")->declared->new_text, "40 ms");

  // Nothing reads the second word of the table but the host.
  const std::string table =
      "        DATA\nIN0: DFM KUS\nOUT0: DFM CHOD\nTAB: DW @\n        DATA_END\n        MODULE_MAIN\n"
      "        LDR KUS\n        WR CHOD\n        MODULE_MAIN_END\n        STOP\n";
  EXPECT_FALSE(ComparedTexts(kTechnol, With(table, "7"), With(table, "8")).items.empty());
}

}  // namespace
}  // namespace plcxx::review::diff
