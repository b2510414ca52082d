// Rungs: expressions, results that wait, edges, conditions (specification 6.1, 6.2, 7.1), and what a statement is.

#include "host50_lowered.h"

namespace plcxx::host50 {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// covers: HOST50-070..076 HOST50-083
TEST(Host50Lowering, ARungIsOneExpression) {
  EXPECT_THAT(SlowBody("LD %I0;OR %Q0;ANI %I1;OUT %Q0"),
              ElementsAre("stmt Q0", "%0 = load I0", "%1 = load Q0", "%2 = or.bit %0 %1", "%3 = load I1",
                          "%4 = not.bit %3", "%5 = and.bit %2 %4", "store Q0 %5"));
}

// covers: HOST50-077 HOST50-078
TEST(Host50Lowering, JoinsTakeTheLeftBlockFirst) {
  EXPECT_THAT(SlowBody("LD %I0;LD %I1;OR %I2;ANB;OUT %Q0"),
              ElementsAre("stmt Q0", "%0 = load I1", "%1 = load I2", "%2 = or.bit %0 %1", "%3 = load I0",
                          "%4 = and.bit %3 %2", "store Q0 %4"));
  EXPECT_THAT(SlowBody("LD %I0;AND %I1;LD %I2;AND %I3;ORB;OUT %Q0"),
              ElementsAre("stmt Q0", "%0 = load I0", "%1 = load I1", "%2 = and.bit %0 %1", "%3 = load I2",
                          "%4 = load I3", "%5 = and.bit %3 %4", "%6 = or.bit %2 %5", "store Q0 %6"));
}

// covers: HOST50-072
TEST(Host50Lowering, ConstantsFold) {
  EXPECT_THAT(SlowBody("LD 1;AND %I0;OUT %Q0"),
              ElementsAre("stmt Q0", "%0 = const bit 1", "%1 = load I0", "store Q0 %1"));
  EXPECT_THAT(SlowBody("LDI 1;OR %I0;OUT %Q0"),
              ElementsAre("stmt Q0", "%0 = const bit 1", "%1 = const bit 0", "%2 = load I0", "store Q0 %2"));
}

// covers: HOST50-080 HOST50-083
TEST(Host50Lowering, WhatIsUsedTwiceIsComputedOnceButAContactIsReadAgain) {
  EXPECT_THAT(
      SlowBody("LD %I0;AND %I1;OUT %Q0;OUT %Q1"),
      ElementsAre("stmt Q0", "%0 = load I0", "%1 = load I1", "%2 = and.bit %0 %1", "store Q0 %2", "store Q1 %2"));
  EXPECT_THAT(SlowBody("LD %I0;MPS;AND %I1;OUT %Q0;MPP;ANI %I2;OUT %Q1"),
              ElementsAre("stmt Q0", "%0 = load I0", "%1 = load I1", "%2 = and.bit %0 %1", "store Q0 %2",
                          "%3 = load I0", "%4 = load I2", "%5 = not.bit %4", "%6 = and.bit %3 %5", "store Q1 %6"));
}

// covers: HOST50-085
TEST(Host50Lowering, AResultIsTakenBeforeItsContactChanges) {
  EXPECT_THAT(SlowBody("LD %Q0;MPS;AND %I0;OUT %Q0;MPP;OUT %Q1"),
              ElementsAre("stmt Q0", "%0 = load Q0", "%1 = load I0", "%2 = and.bit %0 %1", "%3 = load Q0",
                          "store Q0 %2", "store Q1 %3"));
  // A compare that waits for its join, and a counter that the block between steps.
  EXPECT_THAT(SlowBody("LD 1;EQ %C1.V, 3;LD %I0;CNUD %C1, 5, P=0, M=0, N=0;ANB;OUT %Q0"),
              ElementsAre("stmt C1", "%0 = load I0", "%1 = const bit 1", "%2 = load C1.V", "%3 = const i32 3",
                          "%4 = eq.i32 %2 %3", "%5 = const i32 5", "%6 = const bit 0", "%7 = const bit 0",
                          "%8 = const bit 0", "%9 = counter_pins %6 %7 %8", "%10 = step.count_ring C1 %0 %5 %9",
                          "%11 = and.bit %4 %10", "store Q0 %11"));
  // A subroutine may write anything.
  LoweredProgram lowered;
  LowerInto(lowered, {"SLOW\nNETWORK\nLD %I0\nAND %I1\nMPS\nAND %I2\nCALL SR1\nMPP\nOUT %Q1\nEND_SLOW\n"
                      "SUB SR1\nNETWORK\nEND_SUB\n"});
  EXPECT_THAT(lowered.Routine("slow"),
              ElementsAre("stmt SR1", "%0 = load I0", "%1 = load I1", "%2 = and.bit %0 %1", "%3 = load I2",
                          "%4 = and.bit %2 %3", "if %4 {", "call SR1 ()", "}", "store Q1 %2"));
}

// covers: HOST50-084
TEST(Host50Lowering, OutiInvertsForItselfOnly) {
  EXPECT_THAT(SlowBody("LD %I0;OUTI %Q0;OUT %Q1"),
              ElementsAre("stmt Q0", "%0 = load I0", "%1 = not.bit %0", "store Q0 %1", "%2 = load I0", "store Q1 %2"));
}

// covers: HOST50-086 HOST50-136
TEST(Host50Lowering, NeighboursOfOneInputShareTheirCondition) {
  EXPECT_THAT(SlowBody("LD %I0;SET %Q0;RST %Q1;MOV 5, %W0;LD %I1;SET %Q2"),
              ElementsAre("stmt Q0", "%0 = load I0", "if %0 {", "%1 = const bit 1", "store Q0 %1", "%2 = const bit 0",
                          "store Q1 %2", "%3 = const i32 5", "store W0 %3", "}", "stmt Q2", "%0 = load I1", "if %0 {",
                          "%1 = const bit 1", "store Q2 %1", "}"));
  // An output between them has its place in the order.
  EXPECT_THAT(SlowBody("LD %I0;SET %Q0;OUT %Q1;SET %Q2"),
              ElementsAre("stmt Q0", "%0 = load I0", "if %0 {", "%1 = const bit 1", "store Q0 %1", "}", "%2 = load I0",
                          "store Q1 %2", "%3 = load I0", "if %3 {", "%4 = const bit 1", "store Q2 %4", "}"));
  // The left rail needs no condition.
  EXPECT_THAT(SlowBody("LD 1;RST %Q0"), ElementsAre("stmt Q0", "%0 = const bit 1", "%1 = const bit 0", "store Q0 %1"));
}

TEST(Host50Lowering, AConditionOutlivesWhatItsBlocksWrite) {
  EXPECT_THAT(SlowBody("LD %B0;RST %B0;SET %B1"),
              ElementsAre("stmt B0", "%0 = load B0", "%1 = load B0", "if %0 {", "%2 = const bit 0", "store B0 %2",
                          "%3 = const bit 1", "store B1 %3", "}"));
}

// covers: HOST50-088..095
TEST(Host50Lowering, EdgesStandWhereTheirInstructionStands) {
  EXPECT_THAT(SlowBody("LD %I0;ANDP %I1;OUT %Q0"), ElementsAre("stmt Q0", "%0 = load I1", "%1 = step.rising I1_edge %0",
                                                               "%2 = load I0", "%3 = and.bit %2 %1", "store Q0 %3"));
  EXPECT_THAT(SlowBody("LD %I0;OUT %Q0;ANDF %Q0;OUT %Q1"),
              ElementsAre("stmt Q0", "%0 = load I0", "store Q0 %0", "%1 = load Q0", "%2 = step.falling Q0_edge %1",
                          "%3 = load I0", "%4 = and.bit %3 %2", "store Q1 %4"));
}

// A comparison whose words nothing writes meanwhile is computed where it is used.
TEST(Host50Lowering, WhatNothingChangesIsComputedWhereItIsUsed) {
  EXPECT_THAT(SlowBody("LD %I0;COMP %W0 + 1 > %W1;ANDP %I1;OUT %Q0"),
              ElementsAre("stmt Q0", "%0 = load I1", "%1 = step.rising I1_edge %0", "%2 = load I0", "%3 = load W0",
                          "%4 = const i32 1", "%5 = add.i32 %3 %4", "%6 = load W1", "%7 = sgt.i32 %5 %6",
                          "%8 = and.bit %2 %7", "%9 = and.bit %8 %1", "store Q0 %9"));
  // An edge that was taken does not change with its contact, which the counter of the second block writes.
  EXPECT_THAT(SlowBody("LD %I1;ANDP %C1.Q;LD %I0;CNUD %C1, 5, P=0, M=0, N=0;ANB;OUT %Q0"),
              ElementsAre("stmt C1", "%0 = load C1.Q", "%1 = step.rising C1.Q_edge %0", "%2 = load I0",
                          "%3 = const i32 5", "%4 = const bit 0", "%5 = const bit 0", "%6 = const bit 0",
                          "%7 = counter_pins %4 %5 %6", "%8 = step.count_ring C1 %2 %3 %7", "%9 = load I1",
                          "%10 = and.bit %9 %1", "%11 = and.bit %10 %8", "store Q0 %11"));
  EXPECT_THAT(SlowBody("LD 1;COMP 3 > %W1;LD %I0;CNUD %C1, 5, P=0, M=0, N=0;ANB;OUT %Q0"),
              ElementsAre("stmt C1", "%0 = load I0", "%1 = const i32 5", "%2 = const bit 0", "%3 = const bit 0",
                          "%4 = const bit 0", "%5 = counter_pins %2 %3 %4", "%6 = step.count_ring C1 %0 %1 %5",
                          "%7 = const bit 1", "%8 = const i32 3", "%9 = load W1", "%10 = sgt.i32 %8 %9",
                          "%11 = and.bit %10 %6", "store Q0 %11"));
}

// covers: HOST50-094
TEST(Host50Lowering, EdgesOfOneOperandAreNamedByTheirStatements) {
  LoweredProgram one, two;
  LowerInto(one, {"SYMBOLS\n%I0 START\nEND_SYMBOLS\n" + Slow("LDP START\nOUT %Q0\nLDP %I1\nOUT %Q1\n")});
  EXPECT_THAT(one.Printed(), HasSubstr("state START_edge edge_memory\n"));
  EXPECT_THAT(one.Printed(), HasSubstr("state I1_edge edge_memory\n"));
  const auto names = [](const LoweredProgram& lowered) {
    Text result;
    for (const ir::StateInstance& state : lowered.program.states) result.push_back(state.name);
    return result;
  };
  LoweredProgram before;
  LowerInto(before, {Slow("LDP %I0\nOUT %Q0\nLDF %I0\nOUT %Q1\n")});
  LowerInto(two, {Slow("LDP %I0\nOUT %Q9\nLDP %I0\nOUT %Q0\nLDF %I0\nOUT %Q1\n")});
  ASSERT_EQ(names(before).size(), 2u);
  ASSERT_EQ(names(two).size(), 3u);
  EXPECT_EQ(names(before)[0], names(two)[1]) << "an inserted rung renames no other one's memory";
  EXPECT_EQ(names(before)[1], names(two)[2]);
}

// covers: HOST50-008 HOST50-101
TEST(Host50Lowering, StatementsAreRungsWithTheirComments) {
  LoweredProgram lowered;
  LowerInto(lowered, {"; above the part\nSLOW ; on its line\n; above the network\nNETWORK L7 \"pump\"\n  ; above\n"
                      "  LD %I0 ; start\n  OUT %Q0 ; pump \t\n  REMARK \"a remark\"\n  LD %I1\n  REMARK inside\n"
                      "  OUT %Q1\t \n; last\nEND_SLOW\n"});
  const auto& statements = lowered.program.statements;
  ASSERT_EQ(statements.size(), 3u);
  const auto comments = [&](uint32_t index) {
    Text texts;
    for (const source::Range& range : statements[ir::StatementId(index)].comments) {
      texts.emplace_back(lowered.sources.Text(range));
    }
    return texts;
  };
  const auto text = [&](uint32_t index) {
    return std::string(lowered.sources.Text(statements[ir::StatementId(index)].range));
  };
  EXPECT_THAT(comments(0),
              ElementsAre(" above the part", " on its line", " above the network", "NETWORK L7 \"pump\"", " above"));
  EXPECT_EQ(text(0), "LD %I0 ; start\n  OUT %Q0 ; pump");
  EXPECT_THAT(comments(1), ElementsAre("a remark"));
  EXPECT_EQ(text(1), "LD %I1\n  REMARK inside\n  OUT %Q1");
  EXPECT_EQ(text(2), " last");
  EXPECT_EQ(statements[ir::StatementId(0)].subject, "Q0");
}

// The head of a file, though tables stand in front of its first section; what is behind a drawing and the last part.
TEST(Host50Lowering, CommentsAroundTablesDrawingsAndSectionsAreKept) {
  LoweredProgram lowered;
  LowerInto(
      lowered,
      {"; lathe, version 3\n\n; names\nSYMBOLS\n%B1 start\nEND_SYMBOLS\n; period\nSLOWDIV 4\n; fast\nFAST\nNETWORK\n"
       "LADDER\n  |--[ %I1 ]--( %Q1 )\nEND_LADDER ; drawn\nNETWORK\nLADDER\n  |--[ %I2 ]--( %Q2 )\n"
       "END_LADDER ; the end\nEND_FAST ; of fast\n; behind\n"});
  Text comments;
  for (const ir::Statement& statement : lowered.program.statements) {
    for (const source::Range& range : statement.comments) comments.emplace_back(lowered.sources.Text(range));
    if (statement.subject.empty()) comments.emplace_back(lowered.sources.Text(statement.range));
  }
  EXPECT_THAT(comments, ElementsAre(" lathe, version 3", " names", " period", " fast", "NETWORK", " drawn", "NETWORK",
                                    " the end", " of fast", " behind"));
}

TEST(Host50Lowering, NumbersOfStatementsComeFromTheirText) {
  LoweredProgram one, two;
  LowerInto(one, {Slow("LD %I0\nOUT %Q0\nLD %I1\nOUT %Q1\n")});
  LowerInto(two, {Slow("LD %I5\nOUT %Q5\n  LD  %I0 ; comment\n  OUT %Q0\nLD %I1\nOUT %Q1\n")});
  const auto id = [](const LoweredProgram& lowered, uint32_t index) {
    return lowered.program.statements[ir::StatementId(index)].id;
  };
  EXPECT_EQ(id(one, 0), id(two, 1));
  EXPECT_EQ(id(one, 1), id(two, 2));

  LoweredProgram quoted, spaced, other;  // blanks count in quotes only
  LowerInto(quoted, {Slow("LD %I1\nREMARK \"on the rung\"\nOUT %Q1\n")});
  LowerInto(spaced, {Slow("LD\t%I1\nREMARK  \"on the rung\" \nOUT %Q1\n")});
  LowerInto(other, {Slow("LD %I1\nREMARK \"on  the rung\"\nOUT %Q1\n")});
  EXPECT_EQ(id(quoted, 0), id(spaced, 0));
  EXPECT_NE(id(quoted, 0), id(other, 0));
}

// covers: HOST50-250..253 HOST50-255
TEST(Host50Lowering, ADrawingGoesTheSameWay) {
  LoweredProgram lowered;
  LowerInto(lowered, {"SLOW\nNETWORK\nLADDER\n"
                      "  |--[ %I0 ]--+--[/%I1 ]--( %Q0 )\n"
                      "  |           |\n"
                      "  |--[ %Q0 ]--+--[P %I2 ]-(S %Q1 )\n"
                      "  |\n"
                      "  |--( %Q2 )\n"
                      "END_LADDER\nEND_SLOW\n"});
  EXPECT_THAT(
      lowered.Routine("slow"),
      ElementsAre("stmt Q0", "%0 = load I0", "%1 = load Q0", "%2 = or.bit %0 %1", "%3 = load I1", "%4 = not.bit %3",
                  "%5 = and.bit %2 %4", "%6 = load Q0", "store Q0 %5", "%7 = load I2", "%8 = step.rising I2_edge %7",
                  "%9 = load I0", "%10 = or.bit %9 %6", "%11 = and.bit %10 %8", "if %11 {", "%12 = const bit 1",
                  "store Q1 %12", "}", "stmt Q2", "%0 = const bit 1", "store Q2 %0"));
  const source::Range range = lowered.program.statements[ir::StatementId(0)].range;
  EXPECT_THAT(std::string(lowered.sources.Text(range)), testing::StartsWith("  |--[ %I0 ]--+--[/%I1 ]"));
}

// covers: HOST50-254
TEST(Host50Lowering, ABlockWithoutQConductsItsInput) {
  LoweredProgram lowered;
  LowerInto(lowered, {"SLOW\nNETWORK\nLADDER\n  |--{EQ %W0, 1}--{MOV 2, %W0}--( %Q0 )\nEND_LADDER\nEND_SLOW\n"});
  EXPECT_THAT(lowered.Routine("slow"),
              ElementsAre("stmt W0", "%0 = const bit 1", "%1 = load W0", "%2 = const i32 1", "%3 = eq.i32 %1 %2",
                          "if %3 {", "%4 = const i32 2", "store W0 %4", "}", "store Q0 %3"));
}

TEST(Host50Lowering, LongChainsNeedNoDeepStack) {
  std::string text = "LD %I0\n";
  for (int i = 0; i < 50000; ++i) text += "AND %I1\n";
  LoweredProgram lowered;
  LowerInto(lowered, {Slow(text + "OUT %Q0\n")});
  EXPECT_EQ(lowered.program.statements.size(), 1u);
}

// covers: HOST50-027 HOST50-033 HOST50-057
TEST(Host50Lowering, RetentivePartsAreSpacesOfTheirOwn) {
  LoweredProgram lowered;
  LowerInto(lowered, {Slow("LD %B500\nOUT %B501\nMOV %W100, %W101\nMOV %F100, %F101\n")}, {{"channels", "2"}});
  const std::string text = lowered.Printed();
  EXPECT_THAT(text, HasSubstr("space B_retentive 63 retentive"));
  EXPECT_THAT(text, HasSubstr("place B500 bit B_retentive[62].4\n"));
  EXPECT_THAT(text, HasSubstr("place B501 bit B[62].5\n"));
  EXPECT_THAT(text, HasSubstr("place W100 i32 W_retentive[400]\n"));
  EXPECT_THAT(text, HasSubstr("place W101 i32 W[404]\n"));
  EXPECT_THAT(text, HasSubstr("place F100 f32 F_retentive[400]\n"));
  EXPECT_THAT(text, HasSubstr("space Q 501 volatile"));
  EXPECT_THAT(text, HasSubstr("space QF 2004 volatile"));
}

// covers: HOST50-014 HOST50-015 HOST50-231
TEST(Host50Lowering, SymbolsNamePlacesAndInstances) {
  LoweredProgram lowered;
  LowerInto(lowered, {"SYMBOLS\n%Q0 PUMP \"the pump\"\n%TM1 T_RUN\n%W1 'axis4-'\nEND_SYMBOLS\n" +
                      Slow("LD %I0\nTONS T_RUN, 3\nOUT %Q0\nLD T_RUN.Q\nMOV %TM1.V, 'axis4-'\n")});
  const std::string text = lowered.Printed();
  EXPECT_THAT(text, HasSubstr("place PUMP bit Q[0].0 address Q0\n"));
  EXPECT_THAT(text, HasSubstr("state T_RUN unit_timer\n"));
  EXPECT_THAT(text, HasSubstr("place T_RUN.Q bit field T_RUN output address TM1.Q\n"));
  EXPECT_THAT(text, HasSubstr("place T_RUN.V i32 field T_RUN value address TM1.V\n"));
  EXPECT_THAT(text, HasSubstr("axis4-"));
  const auto& documentation = lowered.program.documentation;
  const auto pump = std::ranges::find(documentation, "Q0", &ir::Documentation::address);
  ASSERT_NE(pump, documentation.end());
  EXPECT_EQ(pump->symbols, "PUMP");
  EXPECT_EQ(pump->meaning, "the pump");
}

}  // namespace
}  // namespace plcxx::host50
