// Warnings that follow from the paths through the modules, and from what all modules read and write.

#include "tests/dialects/prostep_lowered.h"

namespace plcxx::prostep {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// PM 9 alone; line 2 is the first of `statements`.
std::vector<std::string> InLoop(const std::string& statements, const OptionMap& options = {}) {
  return Warnings(":MOD PM 9\n" + statements + ":END PM 9\n", options);
}

// covers: PS-089, PS-280
TEST(ProstepPaths, AConjunctionBehindAnUntakenJumpIs0) {
  EXPECT_THAT(InLoop(":A I 0.0\n:JC X\n:A I 0.1\n:A I 0.2\nX := O 0.0\n"), ElementsAre("4 W14"));
  EXPECT_THAT(InLoop(":A I 0.0\n:JC X\n:O I 0.1\n:A I 0.2\nX := O 0.0\n"), IsEmpty());
  EXPECT_THAT(InLoop(":A I 0.0\n:JC X\n:A(\n:O I 0.1\n:O I 0.2\n:)\nX := O 0.0\n"), ElementsAre("4 W14"));
  // Behind a setting operation it is the first of a sequence.
  EXPECT_THAT(InLoop(":A I 0.0\n:= O 0.1\n:JC X\n:A I 0.1\nX := O 0.0\n"), IsEmpty());
}

// covers: PS-087
TEST(ProstepPaths, WhereTheFirstChecksDiffer) {
  EXPECT_THAT(InLoop(":A I 0.0\n:JU X\nX :A I 0.1\n:= O 0.0\n"), IsEmpty());
  EXPECT_THAT(InLoop(":A I 0.0\n:JC X\n:= O 0.1\nX :A I 0.1\n:= O 0.0\n"), ElementsAre("5 W10"));
  EXPECT_THAT(InLoop(":A I 0.0\n:= O 0.1\n:JC X\n:A I 0.2\nX :O I 0.1\n:= O 0.0\n"), ElementsAre("6 W10"));
}

// covers: PS-154
TEST(ProstepPaths, AConstantComparedWithAByte) {
  EXPECT_THAT(InLoop(":L FW 200\n:L FB 201\n:>\n: K 5\n:= O 0.0\n"), ElementsAre("4 W13"));
  EXPECT_THAT(InLoop(":L FB 201\n:>\n: K 5\n:= O 0.0\n"), IsEmpty());  // AX is 0 at the entry
  EXPECT_THAT(InLoop(":L\n: K 0\n:L FB 201\n:>\n: K 5\n:= O 0.0\n"), IsEmpty());
  EXPECT_THAT(InLoop(":L FW 200\n:JU FM 8\n: K 0FFH\n:L FB 201\n:>\n: K 5\n:= O 0.0\n"), IsEmpty());
  EXPECT_THAT(InLoop(":A I 0.0\n:= O 0.1\n:JC X\n:L FW 200\nX :L FB 201\n:>\n: K 5\n:= O 0.0\n"), ElementsAre("7 W13"));
}

// covers: PS-282
TEST(ProstepPaths, RegistersUsedBeforeTheyAreSet) {
  EXPECT_THAT(InLoop(":= O 0.0\n:S O 0.1\n"), ElementsAre("2 W23"));
  EXPECT_THAT(InLoop(":T OB 0\n:T OB 1\n"), ElementsAre("2 W22"));
  EXPECT_THAT(InLoop(":JU FM 80\n: DB 500\n: DB 504\n:= O 0.0\n"), IsEmpty());
  EXPECT_THAT(InLoop(":JC X\n:A I 0.0\nX := O 0.0\n"), ElementsAre("2 W23"));
}

// covers: PS-282
TEST(ProstepPaths, WhatASubroutineLeaves) {
  const std::string sets = ":MOD PM 20\n:L FW 200\n:A I 0.0\n:END PM 20\n";
  const std::string may = ":MOD PM 20\n:A I 0.0\n:JC X\n:L FW 200\nX :END PM 20\n";
  const std::string caller = ":MOD PM 9\n:JU PM 20\n:T OB 0\n:= O 0.0\n:END PM 9\n";
  EXPECT_THAT(Warnings(caller + sets), IsEmpty());
  EXPECT_THAT(Warnings(caller + may), ElementsAre("3 W22"));
  // Used in the subroutine: on the path from PM 10 only.
  EXPECT_THAT(Warnings(":MOD PM 9\n:L FW 200\n:JU PM 20\n:END PM 9\n:MOD PM 10\n:JU PM 20\n:END PM 10\n"
                       ":MOD PM 20\n:T OB 0\n:END PM 20\n"),
              ElementsAre("9 W22"));
}

// covers: PS-283
TEST(ProstepPaths, InstructionsThatNothingReaches) {
  EXPECT_THAT(InLoop(":A I 0.0\n:= O 0.0\n:JU X\n:L FB 200\n:T OB 5\nX :A I 0.1\n:= O 0.1\n"), ElementsAre("5 W28"));
  EXPECT_THAT(InLoop(":EM\n:A I 0.0\n:= O 0.0\n"), ElementsAre("3 W28"));
}

// covers: PS-053, PS-054, PS-155, PS-171
TEST(ProstepPaths, SequencesThatLoseSomething) {
  EXPECT_THAT(InLoop(":A I 0.0\n:L FW 200\n:>\n: K 5\n:= O 0.0\n"), ElementsAre("4 W11"));
  EXPECT_THAT(InLoop(":L FW 200\n:>\n: K 5\n:JC X\n:<\n: K 3\nX := O 0.0\n"), IsEmpty());
  EXPECT_THAT(InLoop(":A I 0.0\n:O\n:L FW 200\n:>\n: K 5\n:= O 0.0\n"), ElementsAre("5 W11"));
  EXPECT_THAT(InLoop(":O\n:A I 0.0\n:= O 0.0\n"), ElementsAre("2 W12"));
  EXPECT_THAT(InLoop(":A I 0.0\n:O\n:= O 0.0\n"), ElementsAre("3 W12"));
  EXPECT_THAT(InLoop(":A I 0.0\n:O\n:O\n:A I 0.1\n:= O 0.0\n"), ElementsAre("3 W12"));
  EXPECT_THAT(InLoop("X :A I 0.0\n:= O 0.0\n:JC X\n"), ElementsAre("4 W15"));
}

// covers: PS-281
TEST(ProstepPaths, CoilsOfOnePass) {
  EXPECT_THAT(InLoop(":A I 0.0\n:= O 0.0\n:A I 0.1\n:= O 0.0\n"), ElementsAre("5 W18"));
  EXPECT_THAT(InLoop(":A I 0.0\n:= F 1.0\n:JC X\n:= O 0.0\n:EM\nX := O 0.0\n"), IsEmpty());
  // One in a fast, one in a slow module: no pass reaches both. Twice the same call: one place.
  EXPECT_THAT(
      Warnings(":MOD PM 9\n:A I 0.0\n:JC PM 20\n:JC PM 20\n:END PM 9\n:MOD PM 20\n:A I 0.1\n:= O 0.0\n:END PM 20\n"),
      IsEmpty());
  EXPECT_THAT(
      Warnings(":MOD PM 9\n:A I 0.0\n:JC PM 20\n:= O 0.0\n:END PM 9\n:MOD PM 20\n:A I 0.1\n:= O 0.0\n:END PM 20\n"),
      ElementsAre("8 W18"));
  EXPECT_THAT(InLoop(":A I 0.0\n:R O 0.0\n:A I 0.1\n:= O 0.0\n"), ElementsAre("5 W19"));
}

// covers: PS-280, PS-284
TEST(ProstepPaths, Memory) {
  EXPECT_THAT(InLoop(":A I 0.0\n:S I 28.0\n:R I 62.0\n:R F 208.0\n"), ElementsAre("3 W38"));
  EXPECT_THAT(Warnings("DDW 498 1\n:MOD PM 9\n:A I 0.0\n:= P 0.1\n:= P 1.1\n:L IB 30\n:T PB 0\n:END PM 9\n"),
              ElementsAre("4 W39", "7 W39"));
  EXPECT_THAT(Warnings(":MOD PM 1\n:A I 0.0\n:S F 1.0\n:END PM 1\n:MOD PM 9\n:L IB 30\n:T FW 0\n:END PM 9\n"),
              ElementsAre("7 W40"));
}

/// Only what is missing: W37.
std::vector<std::string> Unused(const std::string& statements) {
  LoweredProgram lowered;
  LowerInto(lowered, ":MOD PM 9\n" + statements + ":END PM 9\n");
  std::vector<std::string> reported = lowered.Reported();
  std::erase_if(reported, [](const std::string& line) { return !line.ends_with("W37"); });
  return reported;
}

// covers: PS-280
TEST(ProstepPaths, MemoryWithoutWriterOrReader) {
  EXPECT_THAT(Unused(":A F 10.0\n:= F 11.0\n:A F 10.0\n:= O 0.0\n"), ElementsAre("2 W37", "3 W37"));
  EXPECT_THAT(Unused(":A F 10.0\n:= O 0.0\n:L IB 30\n:T FW 9\n"), IsEmpty());
  EXPECT_THAT(Unused(":L IB 30\n:T DB 20\n:T FB 222\n"), IsEmpty());  // the number of a message
  EXPECT_THAT(Unused(":L IB 30\n:T DB 20\n:JU FM 15\n: DB 0\n: DW 500\n"), ElementsAre("6 W37"));
}

// covers: PS-013
TEST(ProstepPaths, StrictMakesErrors) {
  LoweredProgram lowered;
  LowerInto(lowered, ":MOD PM 9\n:L FW 200\n:L FB 201\n:>\n: K 5\n:= O 0.0\n:END PM 9\n", {{"strict", "on"}});
  EXPECT_TRUE(lowered.diagnostics.HasErrors());
}

}  // namespace
}  // namespace plcxx::prostep
