// The rung machine: what each instruction takes, and what is wrong with a rung.
// covers: HOST50-078..085 HOST50-098..103 HOST50-199 HOST50-200 HOST50-311..319 HOST50-350 HOST50-383
#include "tests/dialects/host50_parsing.h"

namespace plcxx::host50 {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> Rung(std::string_view instructions) { return InstructionsOf(InNetwork(instructions)); }

TEST(Host50Rungs, SeriesAndParallel) {
  EXPECT_THAT(Rung("LD %I0\nANI %I2\nOR %I4\nOUT %Q0"),
              ElementsAre("#0 LD %I0", "#1 ANDI %I2 <- #0", "#2 OR %I4 <- #1", "#3 OUT %Q0 <- #2"));
}

TEST(Host50Rungs, BlocksAreJoinedInTheirOrder) {
  EXPECT_THAT(Rung("LD %I0\nLD %I1\nLD %I2\nORB\nANB\nOUT %Q0"),
              ElementsAre("#0 LD %I0", "#1 LD %I1", "#2 LD %I2", "#3 ORB <- #2 with #1", "#4 ANB <- #3 with #0",
                          "#5 OUT %Q0 <- #4"));
}

TEST(Host50Rungs, Branches) {
  EXPECT_THAT(Rung("LD %I0\nMPS\nAND %I1\nOUT %Q0\nMRD\nLD %I2\nANB\nOUT %Q1\nMPP\nOUT %Q2"),
              ElementsAre("#0 LD %I0", "#1 MPS", "#2 AND %I1 <- #0", "#3 OUT %Q0 <- #2", "#4 MRD", "#5 LD %I2",
                          "#6 ANB <- #5 with #0", "#7 OUT %Q1 <- #6", "#8 MPP", "#9 OUT %Q2 <- #0"));
}

TEST(Host50Rungs, OutputsPassAccOn) {
  EXPECT_THAT(Rung("LD %I0\nOUT %B0\nAND %I5\nMOV 1, %W0\nREMARK x\nOUTI %Q1\nLD %I1\nOUT %Q2"),
              ElementsAre("#0 LD %I0", "#1 OUT %B0 <- #0", "#2 AND %I5 <- #0", "#3 MOV 1, %W0 <- #2", "#4 REMARK x",
                          "#5 OUTI %Q1 <- #2", "#6 LD %I1", "#7 OUT %Q2 <- #6"));
}

TEST(Host50Rungs, PinsFromTheStack) {
  EXPECT_THAT(Rung("LD %I0\nLD %I1\nOR %I2\nLD 0\nLD 1\nCNUD %C1, 8\nOUT %Q0"),
              ElementsAre("#0 LD %I0", "#1 LD %I1", "#2 OR %I2 <- #1", "#3 LD 0", "#4 LD 1",
                          "#5 CNUD %C1, 8, P=#2, M=#3, N=#4 <- #0", "#6 OUT %Q0 <- #5"));
  EXPECT_THAT(Rung("LD %I0\nLD %I1\nCNUD %C1, 8, N=1, m=!%B0"),
              ElementsAre("#0 LD %I0", "#1 LD %I1", "#2 CNUD %C1, 8, P=#1, M=!%B0, N=1 <- #0"));
  EXPECT_THAT(Rung("LD %I9\nLD %I0\nLD %I1\nROT 8, 1, 2, %W0\nANB\nOUT %Q0"),
              ElementsAre("#0 LD %I9", "#1 LD %I0", "#2 LD %I1", "#3 ROT 8, 1, 2, %W0, M=#2 <- #1",
                          "#4 ANB <- #3 with #0", "#5 OUT %Q0 <- #4"));
}

TEST(Host50Rungs, TimersMayEndARung) {
  EXPECT_THAT(NetworkErrors("LD %I0\nTONS %TM1, 3"), IsEmpty());
  EXPECT_THAT(NetworkErrors("LD %I0\nTONS %TM1, 3\nREMARK x\nRUNG\nLD %I1\nOUT %Q0"), IsEmpty());
  EXPECT_THAT(NetworkErrors("LD %I0\nMPS\nTONS %TM1, 3\nMRD\nMPP\nOUT %Q0"), IsEmpty());
  EXPECT_THAT(NetworkErrors("LD %I0\nEQ %W0, 3"), ElementsAre("4:1 E206"));
}

TEST(Host50Rungs, AnEmptyNetworkIsComplete) {
  EXPECT_THAT(NetworkErrors(""), IsEmpty());
  EXPECT_THAT(NetworkErrors("REMARK x\nRUNG\nRUNG"), IsEmpty());
}

TEST(Host50Rungs, NothingIsLoaded) {
  for (const char* first : {"AND %I0", "OR %I0", "OUT %Q0", "MPS", "EQ 1, 2", "MOV 1, %W0"}) {
    EXPECT_THAT(NetworkErrors(first), ElementsAre("3:1 E201")) << first;
  }
}

TEST(Host50Rungs, NothingIsOpen) {
  EXPECT_THAT(NetworkErrors("ANB"), ElementsAre("3:1 E202"));
  EXPECT_THAT(NetworkErrors("LD %I0\nORB\nOUT %Q0"), ElementsAre("4:1 E202"));
  EXPECT_THAT(NetworkErrors("LD %I0\nOUT %Q0\nANB"), ElementsAre("5:1 E202"));
}

TEST(Host50Rungs, SomethingIsOpen) {
  for (const char* place : {"OUT %Q0", "MOV 1, %W0", "MPS"}) {
    EXPECT_THAT(NetworkErrors("LD %I0\nLD %I1\n" + std::string(place)), ElementsAre("5:1 E203")) << place;
  }
  EXPECT_THAT(NetworkErrors("LD %I0\nMPS\nLD %I1\nLD %I2\nMPP"), ElementsAre("7:1 E203"));
  EXPECT_THAT(NetworkErrors("LD %I0\nLD %I1\nTONS %TM1, 1\nREMARK x"), ElementsAre("5:1 E203"));
}

TEST(Host50Rungs, ATimerThatWasMeantToEndItsRung) {
  Parsed parsed;
  ParseInto(parsed, {InNetwork("LD %I0\nTONS %TM1, 5\nLD %I1\nOUT %Q0")});
  EXPECT_THAT(parsed.Errors(), ElementsAre("6:1 E203"));
  EXPECT_THAT(parsed.diagnostics.all().front().remedy, testing::HasSubstr("RUNG"));
}

TEST(Host50Rungs, BranchesWithoutBeginningOrEnd) {
  EXPECT_THAT(NetworkErrors("LD %I0\nMRD\nOUT %Q0"), ElementsAre("4:1 E204"));
  EXPECT_THAT(NetworkErrors("MPP"), ElementsAre("3:1 E204"));
  EXPECT_THAT(NetworkErrors("LD %I0\nMPS\nOUT %Q0"), ElementsAre("4:1 E205"));
  EXPECT_THAT(NetworkErrors("LD %I0\nMPS\nOUT %Q0\nLD %I1\nOUT %Q1"), ElementsAre("4:1 E205"));
  EXPECT_THAT(NetworkErrors("LD %I0\nMPS\nMPS\nOUT %Q0\nRUNG"), ElementsAre("5:1 E205")) << "the innermost one";
}

TEST(Host50Rungs, NothingComesOut) {
  EXPECT_THAT(NetworkErrors("LD %I0\nAND %I1\nREMARK x"), ElementsAre("4:1 E206"));
  EXPECT_THAT(NetworkErrors("LD %I0\nMPS\nAND %I1\nMPP\nOUT %Q0"), ElementsAre("5:1 E206"));
  EXPECT_THAT(NetworkErrors("LD %I0\nMPS\nOUT %Q0\nMPP"), ElementsAre("6:1 E206"));
}

TEST(Host50Rungs, OrAfterAnOutput) {
  EXPECT_THAT(NetworkErrors("LD %I0\nOUT %Q0\nOR %I1\nOUT %Q1"), ElementsAre("5:1 E207"));
}

TEST(Host50Rungs, Depth) {
  const auto blocks = [](uint32_t depth) {
    std::string text;
    for (uint32_t i = 0; i <= depth; ++i) text += "LD %I0\n";
    for (uint32_t i = 0; i < depth; ++i) text += "ORB\n";
    return text + "OUT %Q0";
  };
  EXPECT_THAT(NetworkErrors(blocks(32)), IsEmpty());
  EXPECT_THAT(NetworkErrors(blocks(33)), ElementsAre("36:1 E208"));
  const auto branches = [](uint32_t depth) {
    std::string text = "LD %I0\n";
    for (uint32_t i = 0; i < depth; ++i) text += "MPS\nAND %I1\n";
    text += "OUT %Q0\n";
    for (uint32_t i = 0; i < depth; ++i) text += "MPP\nOUT %Q1\n";
    return text;
  };
  EXPECT_THAT(NetworkErrors(branches(16)), IsEmpty());
  EXPECT_THAT(NetworkErrors(branches(17)), ElementsAre("36:1 E208"));
  Parsed parsed;
  ParseInto(parsed, {InNetwork(blocks(9) + "\n" + branches(12))});
  EXPECT_THAT(parsed.Notes(), ElementsAre("12:1 N03", "46:1 N03"));
}

TEST(Host50Rungs, MissingPins) {
  EXPECT_THAT(NetworkErrors("LD %I0\nLD %I1\nCNUD %C1, 8"), ElementsAre("5:1 E209"));
  EXPECT_THAT(NetworkErrors("LD %I0\nROT 8, 1, 2, %W0\nOUT %Q0"), ElementsAre("4:1 E209"));
}

TEST(Host50Rungs, AWrongOperandCausesNothingElse) {
  EXPECT_THAT(NetworkErrors("LD %I0\nOUT %B2001"), ElementsAre("4:5 E104")) << "the rung has an output";
  EXPECT_THAT(NetworkErrors("LD %X0\nOUT %Q0"), ElementsAre("3:4 E103"));
  EXPECT_THAT(NetworkErrors("LD %I0\nLD %I1\nCNUD %C1, 8, X=1\nOUT %Q0"), ElementsAre("5:14 E209"));
}

TEST(Host50Rungs, AfterAnErrorOfTheRungOnlyOperandsAreChecked) {
  EXPECT_THAT(NetworkErrors("AND %I0\nANB\nOUT %Q3000\nLD %I0\nRUNG\nOR %I1"),
              ElementsAre("3:1 E201", "5:5 E104", "8:1 E201"));
  EXPECT_THAT(NetworkErrors("LD %I0\nFOO\nANB\nMPP\nCNUD %C1, 8, P=0, P=1"), ElementsAre("4:1 E101", "7:19 E209"));
}

}  // namespace
}  // namespace plcxx::host50
