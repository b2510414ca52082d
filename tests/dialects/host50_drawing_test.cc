// Drawn ladders: nets, order of evaluation, errors E601 to E608.
// covers: HOST50-250..260 HOST50-341..347 HOST50-349
#include "tests/dialects/host50_parsing.h"

namespace plcxx::host50 {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// The rows of a drawing begin in line 4.
std::string Drawn(std::string_view rows) {
  return "SLOW\nNETWORK\nLADDER\n" + std::string(rows) + "\nEND_LADDER\nEND_SLOW\n";
}
std::vector<std::string> Order(std::string_view rows) { return InstructionsOf(Drawn(rows)); }
std::vector<std::string> Errors(std::string_view rows) { return ErrorsOf(Drawn(rows)); }

TEST(Host50Drawing, ParallelContacts) {
  EXPECT_THAT(Order("  |--[ %I0 ]--+--[/%I1 ]--( %Q0 )\n"
                    "  |--[ %Q0 ]--+"),
              ElementsAre("#0 AND %I0 <- rail", "#1 AND %Q0 <- rail", "#2 ANDI %I1 <- #0 #1", "#3 OUT %Q0 <- #2"));
}

TEST(Host50Drawing, OneBranchToSeveralCoils) {
  EXPECT_THAT(Order("|-[ %I0 ]-+-[ %I9 ]--( %Q0 )\n"
                    "|         +----------( %Q1 )\n"
                    "|         +-{MOV 1, %W0}"),
              ElementsAre("#0 AND %I0 <- rail", "#1 AND %I9 <- #0", "#2 OUT %Q0 <- #1", "#3 OUT %Q1 <- #0",
                          "#4 MOV 1, %W0 <- #0"));
}

TEST(Host50Drawing, Elements) {
  EXPECT_THAT(Order("|[P %I0][n %I1][ / %I2]+(S %Q0)\n"
                    "|                      +( / %Q1 )\n"
                    "|                      +(r %Q2)\n"
                    "|                      +{ EQ %W0, 3 }( %Q3 )"),
              ElementsAre("#0 ANDP %I0 <- rail", "#1 ANDF %I1 <- #0", "#2 ANDI %I2 <- #1", "#3 SET %Q0 <- #2",
                          "#4 OUTI %Q1 <- #2", "#5 RST %Q2 <- #2", "#6 EQ %W0, 3 <- #2", "#7 OUT %Q3 <- #6"));
}

TEST(Host50Drawing, EachElementOnceWhereItIsFirstNeeded) {
  EXPECT_THAT(
      Order("|--{TONS %TM1, 5}--+--[ %I1 ]--+--( %Q0 )\n"
            "|                  |           |\n"
            "|--[ %I2 ]---------+           +--{MOV 1, %W0}--( %Q1 )\n"
            "|--[ %I3 ]--( %Q2 )"),
      ElementsAre("#0 TON 1000ms %TM1, 5 <- rail", "#1 AND %I2 <- rail", "#2 AND %I1 <- #0 #1", "#3 OUT %Q0 <- #2",
                  "#4 MOV 1, %W0 <- #2", "#5 OUT %Q1 <- #4", "#6 AND %I3 <- rail", "#7 OUT %Q2 <- #6"));
}

TEST(Host50Drawing, AnInputFromALowerRow) {
  EXPECT_THAT(Order("|               +--( %Q0 )\n"
                    "|--[ %I0 ]------+\n"
                    "|--( %Q1 )"),
              ElementsAre("#0 AND %I0 <- rail", "#1 OUT %Q0 <- #0", "#2 OUT %Q1 <- rail"));
}

TEST(Host50Drawing, WideCharactersTakeTwoColumns) {
  const std::string symbols = "SYMBOLS\n%I0 泵\n%I1 e\xCC\x81\nEND_SYMBOLS\n";
  EXPECT_THAT(ErrorsOf(symbols + Drawn("|-[ 泵 ]-+-( %Q0 )\n"
                                       "|-[%I1]-+")),
              ElementsAre("9:8 E604"))
      << "seven characters are wider than two";
  EXPECT_THAT(ErrorsOf(symbols + Drawn("|-[ 泵 ]--+-( %Q0 )\n"
                                       "|-[ %I1 ]-+\n"
                                       "|-[ e\xCC\x81   ]-+")),
              IsEmpty());
}

TEST(Host50Drawing, PrefixesAndSymbolsOfOneLetter) {
  const std::string symbols = "SYMBOLS\n%I0 P\n%Q0 S\n%I1 N\nEND_SYMBOLS\n";
  EXPECT_THAT(InstructionsOf(symbols + Drawn("|-[P]-[ P ]-[P P]-[N %I3]-( S )")),
              ElementsAre("#0 AND %I0:P <- rail", "#1 AND %I0:P <- #0", "#2 ANDP %I0:P <- #1", "#3 ANDF %I3 <- #2",
                          "#4 OUT %Q0:S <- #3"));
  EXPECT_THAT(ErrorsOf(symbols + Drawn("|-[S %I0]-( %Q0 )")), ElementsAre("9:6 E102"));
}

TEST(Host50Drawing, Comments) {
  Parsed parsed;
  ParseInto(
      parsed,
      {Drawn("; above\n|--[ %I0 ]--{TONS %TM1, 5}--( %Q0 ) ; row\n|--[ %I1 ]--+ ; second\n|           +--( %Q1 )")});
  EXPECT_THAT(parsed.Errors(), IsEmpty());
  const auto comments = [&](uint32_t index) {
    std::vector<std::string> texts;
    const Span span = parsed.program.instructions[InstructionId(index)].comments;
    for (uint32_t i = 0; i < span.count; ++i) {
      texts.emplace_back(parsed.sources.Text(parsed.program.comments[span.first + i].range));
    }
    return texts;
  };
  EXPECT_THAT(comments(0), IsEmpty());
  EXPECT_THAT(comments(1), ElementsAre("; above", "; row")) << "the first action of the row";
  EXPECT_THAT(comments(3), ElementsAre("; second")) << "the first element of a row without actions";
}

TEST(Host50Drawing, NothingDrawn) {
  EXPECT_THAT(Errors(""), IsEmpty());
  EXPECT_THAT(Errors("  |\n  |\n\n  ; comment\n  |"), IsEmpty());
}

TEST(Host50Drawing, RowsThatCannotBeRead) {
  EXPECT_THAT(Errors("|--\t( %Q0 )"), ElementsAre("4:4 E601"));
  EXPECT_THAT(Errors("|--*--( %Q0 )"), ElementsAre("4:4 E601"));
  EXPECT_THAT(Errors("|--( %Q0 )\n --( %Q1 )\n|--( %X )"), ElementsAre("5:2 E601", "6:6 E103"));
  EXPECT_THAT(Errors("--( %Q0 )\n |--( %Q1 )\n|--( %Q2 )"), ElementsAre("4:1 E601", "6:1 E601"));
  EXPECT_THAT(Errors("|--[ ]--( %Q0 )"), ElementsAre("4:4 E601"));
  EXPECT_THAT(Errors("|--[ / ]--( %Q0 )"), ElementsAre("4:4 E601"));
  EXPECT_THAT(Errors("|--( %Q0 ) ; \t comment"), IsEmpty());
  EXPECT_THAT(Errors("|--[ %I0 --( %Q0 )"), ElementsAre("4:4 E602"));
  EXPECT_THAT(Errors("|--{COMP \"%W0 = 1}--( %Q0 )"), ElementsAre("4:4 E602"));
}

TEST(Host50Drawing, ContentsOfElements) {
  EXPECT_THAT(Errors("|--[ 1 ]--( %Q0 )"), ElementsAre("4:6 E107"));
  EXPECT_THAT(Errors("|--[ %I0 %I1 ]--( %Q0 )"), ElementsAre("4:10 E102"));
  EXPECT_THAT(Errors("|--{OUT %Q0}"), ElementsAre("4:5 E101"));
  EXPECT_THAT(Errors("|--{RUNG}--( %Q0 )"), ElementsAre("4:5 E101"));
  EXPECT_THAT(Errors("|--{CNUD %C1, 8, P=0}--( %Q0 )"), ElementsAre("4:4 E209"));
  EXPECT_THAT(Errors("|--{CNUD %C1, 8, P=0, M=0, N=1}--( %Q0 )"), IsEmpty());
  EXPECT_THAT(Errors("|--{COMP 'x;y' > 1}--( %Q0 )"), ElementsAre("4:12 E111"));
}

TEST(Host50Drawing, NotConnected) {
  EXPECT_THAT(Errors("|  [ %I0 ]--( %Q0 )"), ElementsAre("4:4 E603"));
  EXPECT_THAT(Errors("|  --( %Q0 )"), ElementsAre("4:4 E603"));
  EXPECT_THAT(Errors("|--( %Q0 )\n|  +--( %Q1 )\n|  +--( %Q2 )"), ElementsAre("5:4 E603")) << "a net without a source";
}

TEST(Host50Drawing, Dangling) {
  EXPECT_THAT(Errors("|--( %Q0 )\n|--"), ElementsAre("5:3 E604"));
  EXPECT_THAT(Errors("|--( %Q0 )\n|--[ %I0 ]"), ElementsAre("5:4 E604"));
  EXPECT_THAT(Errors("|--{EQ 1, %W0}"), ElementsAre("4:4 E604"));
  EXPECT_THAT(Errors("|--{TONS %TM1, 5}"), IsEmpty());
  EXPECT_THAT(Errors("|--+--( %Q0 )\n|  |"), ElementsAre("5:4 E604"));
  EXPECT_THAT(Errors("|--+--( %Q0 )\n\n|  +--( %Q1 )"), ElementsAre("6:4 E603")) << "an empty row breaks the link";
  EXPECT_THAT(Errors("|--[ %I0 ]--+"), ElementsAre("4:11 E604"));
}

TEST(Host50Drawing, CrossingLines) {
  EXPECT_THAT(Errors("|--+-----( %Q0 )\n"
                     "|--|--[ %I0 ]--( %Q2 )\n"
                     "|  +-----( %Q1 )"),
              ElementsAre("5:3 E604", "5:5 E603"));
}

TEST(Host50Drawing, Bypassed) {
  EXPECT_THAT(Errors("|--+--[ %I0 ]--+--( %Q0 )\n"
                     "|  +-----------+"),
              ElementsAre("4:7 E605"));
  EXPECT_THAT(Errors("|--+--[ %I0 ]--+--( %Q0 )\n"
                     "|              |\n"
                     "|--------------+"),
              ElementsAre("4:7 E605"));
}

TEST(Host50Drawing, Cycles) {
  // The lower row leads from behind I1 to in front of I0.
  EXPECT_THAT(Errors("|--[ %I9 ]--+--[ %I0 ]--+--[ %I1 ]--+--( %Q0 )\n"
                     "|           |           |           |\n"
                     "|           +--[ %I2 ]--|--[ %I3 ]--+\n"),
              testing::Not(IsEmpty()));
}

TEST(Host50Drawing, RightOfACoil) {
  EXPECT_THAT(Errors("|--( %Q0 )--"), ElementsAre("4:4 E608"));
  EXPECT_THAT(Errors("|--( %Q0 )( %Q1 )"), ElementsAre("4:4 E608"));
  EXPECT_THAT(Errors("|--( %Q0 )--[ %I0 ]--( %Q1 )"), ElementsAre("4:4 E608"));
}

TEST(Host50Drawing, TooMany) {
  std::string row = "|";
  for (int i = 0; i < 9; ++i) row += "[ %I0 ]";
  EXPECT_THAT(Errors(row + "( %Q0 )"), ElementsAre("4:65 E606"));
  std::string rows;
  for (int i = 0; i < 51; ++i) rows += "|\n\n";
  EXPECT_THAT(Errors(rows), ElementsAre("104:1 E606"));
}

TEST(Host50Drawing, AVeryLongRow) {
  std::string row = "|";
  for (int i = 0; i < 9000; ++i) row += "[%I0]";
  EXPECT_THAT(Errors(row + "(%Q0)").size(), 1u);
}

TEST(Host50Drawing, MixedWithInstructions) {
  EXPECT_THAT(ErrorsOf("SLOW\nNETWORK\nLD 1\nOUT %Q0\nLADDER\n|\nEND_LADDER\nEND_SLOW"), ElementsAre("5:1 E607"));
  EXPECT_THAT(ErrorsOf("SLOW\nNETWORK\nLADDER\n|\nEND_LADDER\nLD 1\nOUT %Q0\nEND_SLOW"), ElementsAre("6:1 E607"));
  EXPECT_THAT(ErrorsOf("SLOW\nNETWORK\nLADDER\nEND_LADDER\nLADDER\nEND_LADDER\nEND_SLOW"), ElementsAre("5:1 E607"));
  EXPECT_THAT(ErrorsOf("SLOW\nNETWORK\nREMARK a\nLADDER\n|\nEND_LADDER\nREMARK b\nEND_SLOW"), IsEmpty());
}

TEST(Host50Drawing, NotClosed) {
  EXPECT_THAT(ErrorsOf("SLOW\nNETWORK\nLADDER\n|--( %Q0 )\nEND_SLOW"), ElementsAre("3:1 E311"));
  EXPECT_THAT(ErrorsOf("SLOW\nNETWORK\nLADDER\n|\nNETWORK\nLD 1\nOUT %Q0\nEND_SLOW"), ElementsAre("3:1 E311"));
  EXPECT_THAT(ErrorsOf("SLOW\nNETWORK\nLADDER\n|\nLD 1"), ElementsAre("1:1 E311", "3:1 E311", "5:1 E601"));
}

}  // namespace
}  // namespace plcxx::host50
