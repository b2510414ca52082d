// Every error that needs no control flow, at its place; one message for one cause.
#include "tests/dialects/prostep_parsing.h"

namespace plcxx::prostep {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Of a module's lines: the first is line 2.
std::vector<std::string> InModuleErrors(std::string_view lines) { return ErrorsOf(InModule(lines)); }

std::string FirstTextOf(const std::string& text) {
  Parsed parsed;
  ParseInto(parsed, {text});
  return parsed.FirstText();
}

TEST(ProstepErrors, OutsideAModule) {
  EXPECT_THAT(ErrorsOf(":A I 0.0\n"), ElementsAre("1:2 E03"));
  EXPECT_THAT(ErrorsOf(": K 5\n"), ElementsAre("1:3 E03"));
  EXPECT_THAT(ErrorsOf("X:\n"), ElementsAre("1:1 E03"));
  EXPECT_THAT(ErrorsOf(":BLAD\n"), ElementsAre("1:2 E03"));
  EXPECT_THAT(ErrorsOf(":K\n"), ElementsAre("1:2 E03"));
  EXPECT_THAT(ErrorsOf(":\n:  ; text\n"), IsEmpty());
  EXPECT_THAT(FirstTextOf(": K 5\n"), HasSubstr("'K 5' outside"));
  EXPECT_THAT(ErrorsOf("two words: x\n"), ElementsAre("1:1 E05"));
}

TEST(ProstepErrors, OneMessageForOneCause) {
  EXPECT_THAT(ErrorsOf(":MOD PM 9\n:NOP\n:BE\n:MOD PM 20\n:NOP\n:END PM 20\n"), ElementsAre("3:2 E08"));
  EXPECT_THAT(ErrorsOf(":MOD PM 9\n:NOP\n:END PM 9\n:MOD PM 9\n:NOP\n:END PM 10\n"), ElementsAre("4:2 E20"));
  Parsed parsed;
  ParseInto(parsed, {InModule(":A I 0.0\n:SR T 1 K 2010D\n:= O 0.0\n:A I 0.0\n:SR T 2 K 2010D\n: K 2010D\n:= O 0.0")});
  EXPECT_THAT(parsed.Errors(), ElementsAre("3:2 E09"));
  EXPECT_THAT(parsed.Warnings(), testing::Contains("6:9 W03"));
  EXPECT_THAT(parsed.Warnings(), testing::Not(testing::Contains("3:9 W03")));
}

TEST(ProstepErrors, WhatIsMeantIsTheRemedy) {
  const auto remedy = [](std::string_view lines) {
    Parsed parsed;
    ParseInto(parsed, {InModule(lines)});
    return parsed.diagnostics.all().empty() ? "" : parsed.diagnostics.all().front().remedy;
  };
  EXPECT_THAT(remedy(":OI 20.1"), HasSubstr("O I"));
  EXPECT_THAT(remedy(":JCKROK"), HasSubstr("JC KROK"));
  EXPECT_THAT(remedy(":FM 0"), HasSubstr("JU FM"));
  EXPECT_THAT(remedy(":A I 0.0\n:SR T 1\n: K 2010\n:= O 0.0"), HasSubstr("K 2010D"));
}

/// One MOD that is missing is one error (section 10), up to the next MOD or END.
TEST(ProstepErrors, AMissingModIsOneCause) {
  EXPECT_THAT(ErrorsOf(":A I 0.0\n:\nX:\n:BLAD\n: K 5\n:= O 0.0\n:END PM 9\n"), ElementsAre("1:2 E03"));
  EXPECT_THAT(ErrorsOf(":NOP\n:NOP\n:MOD PM 1\n:BLAD\n:END PM 1\n:NOP\n:NOP\n"),
              ElementsAre("1:2 E03", "4:2 E08", "6:2 E03"));
  EXPECT_THAT(ErrorsOf(":NOP\n:END PM 9\n:NOP\n:END PM 10\n:END PM 11\n"),
              ElementsAre("1:2 E03", "3:2 E03", "5:2 E20"));
}

TEST(ProstepErrors, Labels) {
  EXPECT_THAT(InModuleErrors("TOOLONG:NOP\n1A:NOP\nA,B:NOP\nPM:NOP\nfm20:NOP\nA B:NOP"),
              ElementsAre("2:1 E05", "3:1 E05", "4:1 E05", "5:1 E05", "6:1 E05", "7:1 E05"));
  EXPECT_THAT(InModuleErrors(":JU TOOLONG\n:JC 5\n:JU A,B"), ElementsAre("2:5 E05", "3:5 E05", "4:5 E05"));
  EXPECT_THAT(InModuleErrors("PMX:NOP\nFM2A:NOP\n:JU PMX\n:JU FM2A"), IsEmpty());
  EXPECT_THAT(InModuleErrors(":L\nX:K 5"), ElementsAre("3:1 E05"));
  EXPECT_THAT(ErrorsOf("X:MOD PM 1\n:END PM 1\n"), ElementsAre("1:1 E05"));
  EXPECT_THAT(InModuleErrors("A:NOP\na:NOP\n:JU A"), ElementsAre("3:1 E06"));
  EXPECT_THAT(InModuleErrors(":JU X"), ElementsAre("2:5 E13"));
  EXPECT_THAT(ErrorsOf(InModule(":JU X") + ":MOD PM 21\nX:NOP\n:END PM 21\n"), ElementsAre("2:5 E13"));
}

TEST(ProstepErrors, UnknownInstructions) {
  EXPECT_THAT(
      InModuleErrors(":BLAD\n:AI0.0\n:== \n:AN( \n:<>\n:X I 0.0\n:5\n:MODPM 1\n:T5"),
      ElementsAre("2:2 E08", "3:2 E08", "4:2 E08", "5:2 E08", "6:2 E08", "7:2 E08", "8:2 E08", "9:2 E08", "10:2 E08"));
  Parsed parsed;
  ParseInto(parsed, {InModule(":<>")});
  EXPECT_THAT(parsed.diagnostics.all()[0].remedy, HasSubstr("'><'"));
  EXPECT_THAT(InModuleErrors(":SD T 5\n: K 20D\n:NOP"), ElementsAre("2:2 E08")) << "its operand lines are its own";
}

TEST(ProstepErrors, OperandLines) {
  EXPECT_THAT(InModuleErrors(":SP T 1"), ElementsAre("2:2 E09"));
  EXPECT_THAT(InModuleErrors(":SP T 1\n:NOP\n:K 5"), ElementsAre("2:2 E09", "4:2 E09"));
  EXPECT_THAT(InModuleErrors(":SP T 1\nX:\n:K 5\n:JU X"), ElementsAre("2:2 E09")) << "missing, then found";
  EXPECT_THAT(InModuleErrors(":L DB 1\n:K 5\n:ID 4"), ElementsAre("3:2 E09")) << "one mistake";
  EXPECT_THAT(InModuleErrors(":L DB 1\n:K 5\n:T DB 2\n:ID 4"), ElementsAre("3:2 E09", "5:2 E09"));
  EXPECT_THAT(InModuleErrors(":JU FM 0\n:K 1\n:K 2"), ElementsAre("2:2 E09"));
  EXPECT_THAT(InModuleErrors(":JU FM 64\n:DB 1"), ElementsAre("2:2 E09"));
  EXPECT_THAT(InModuleErrors(":JU FM 4\n:DB 1"), ElementsAre("3:2 E09"));
  EXPECT_THAT(FirstTextOf(InModule(":JU FM 0\n:K 1\n:K 2")), HasSubstr("'JU FM 0'"));
  EXPECT_THAT(ErrorsOf(":MOD PM 1\n:>"), ElementsAre("1:2 E20", "2:2 E09"));
}

TEST(ProstepErrors, OperandClasses) {
  EXPECT_THAT(InModuleErrors(":A IB 5\n:A X 5\n:A\n:A 5.0\n:A I\n:A I 5\n:L FB 5.1\n:L DD 100\n:= C 5\n:CU T 1"),
              ElementsAre("2:4 E10", "3:4 E10", "4:2 E10", "5:4 E10", "6:4 E10", "7:4 E10", "8:4 E10", "9:4 E10",
                          "10:4 E10", "11:5 E10"));
  EXPECT_THAT(InModuleErrors(":O DB 10\n:O 10.1\n:O abc 5\n:L I 0.0\n:> C 5"),
              ElementsAre("2:4 E10", "3:4 E10", "5:4 E10", "6:4 E10"));
  EXPECT_THAT(InModuleErrors(":SP T 1\n:DB 5\n:L\n:I 0.0\n:JU FM 0\n:C 1\n:K 1\n:ID 4"),
              ElementsAre("3:2 E10", "5:2 E10", "7:2 E10", "9:2 E10"));
  EXPECT_THAT(ErrorsOf(":MOD\n:END PM 1\n"), ElementsAre("1:2 E10"));
  EXPECT_THAT(ErrorsOf(":MOD FM 1\n:END PM 1\n"), ElementsAre("1:6 E10"));
  EXPECT_THAT(InModuleErrors(":JU PM\n:JU\n:JU DB 5"), ElementsAre("2:5 E10", "3:2 E10", "4:5 E13"));
}

TEST(ProstepErrors, Numbers) {
  EXPECT_THAT(InModuleErrors(":A I 0.0X\n:A I 0.\n:A I 0.0.0\n:L\n:K FFH\n:L\n:K 1AD\n:L\n:K\n:L\n:K -\n:L\n:K D"),
              ElementsAre("2:6 E11", "3:6 E11", "4:6 E11", "6:4 E11", "8:4 E11", "10:2 E11", "12:4 E11", "14:4 E11"));
  EXPECT_THAT(InModuleErrors(":L\n:K 65536\n:L\n:K -32769\n:L\n:K 10000H\n:L\n:K 12345D"),
              ElementsAre("3:2 E12", "5:2 E12", "7:2 E12", "9:2 E12"));
  EXPECT_THAT(InModuleErrors(":A I 0.8\n:A I 256.0\n:A F 99999999999.0\n:L IW 255\n:L DB 1000\n:L DW 999\n:A T 64"),
              ElementsAre("2:4 E12", "3:4 E12", "4:4 E12", "5:4 E12", "6:4 E12", "7:4 E12", "8:4 E12"));
  EXPECT_THAT(InModuleErrors(":A P 23.0\n:A P 24.0\n:= P 11.0\n:= P 12.0\n:A P 100.0\n:L PW 23\n:T PB 132\n:T PW 130"),
              ElementsAre("3:4 E12", "5:4 E12", "6:4 E12", "7:4 E12", "8:4 E12"));
  EXPECT_THAT(ErrorsOf(":MOD PM 100\n:END PM 100\n"), ElementsAre("1:6 E12"));
}

TEST(ProstepErrors, TimesAndPresets) {
  EXPECT_THAT(InModuleErrors(":SP T 1\n:K 4000D\n:SP T 1\n:K 10\n:SP T 1\n:K 01A0H\n:S C 1\n:K 1000D\n:S C 1\n:K -1"),
              ElementsAre("3:2 E12", "5:2 E12", "7:2 E12", "9:2 E12", "11:2 E12"));
  EXPECT_THAT(InModuleErrors(":SP T 1\n:K 3999D\n:S C 1\n:K 999D\n:SP T 1\n:K 0100H"), IsEmpty());
}

TEST(ProstepErrors, Brackets) {
  EXPECT_THAT(InModuleErrors(":)"), ElementsAre("2:2 E15"));
  EXPECT_THAT(InModuleErrors(":A(\n:)\n:= O 0.0"), ElementsAre("3:2 E15"));
  EXPECT_THAT(InModuleErrors(":A(\n:L\n:K 1\n:)"), ElementsAre("5:2 E15"));
  EXPECT_THAT(InModuleErrors(":A(\n:A I 0.0\n:= O 0.0\n:)\n:= O 0.1"), ElementsAre("4:2 E15")) << "one cause";
  EXPECT_THAT(InModuleErrors(":A(\n:A I 0.0\n:JC X\nX:NOP"), ElementsAre("4:2 E15"));
  EXPECT_THAT(InModuleErrors(":A(\n:A I 0.0"), ElementsAre("4:2 E15"));
  EXPECT_THAT(InModuleErrors(":A(\n:>\n:K 1\n:)\n:O(\n:A(\n:A I 0.0\n:)\n:)"), IsEmpty());
  std::string deep;
  for (int i = 0; i < 8; ++i) deep += ":A(\n";
  deep += ":A I 0.0\n";
  for (int i = 0; i < 8; ++i) deep += ":)\n";
  EXPECT_THAT(InModuleErrors(deep), IsEmpty());
  EXPECT_THAT(InModuleErrors(":A(\n" + deep + ":)"), ElementsAre("10:2 E15"));
}

TEST(ProstepErrors, LabelsInsideBracketsAndStrings) {
  EXPECT_THAT(InModuleErrors(":A(\nX:A I 0.0\n:)\n:JU X"), ElementsAre("3:1 E14"));
  EXPECT_THAT(InModuleErrors(":A I 0.0\n:O\n:A I 0.1\nX:= O 0.0\n:JU X"), ElementsAre("5:1 E14"));
  EXPECT_THAT(InModuleErrors(":O\n:A I 0.0\n:JC Y\nX:A I 0.1\nY:= O 0.0\n:JU X"), IsEmpty()) << "a jump folds";
  EXPECT_THAT(InModuleErrors(":O\n:O I 0.0\nX:A I 0.1\n:JU X"), IsEmpty()) << "the next O folds";
  EXPECT_THAT(InModuleErrors(":O\n:>\n:K 1\nX:A I 0.1\n:JU X"), IsEmpty()) << "a comparison drops it";
}

TEST(ProstepErrors, ModulesInModules) {
  EXPECT_THAT(ErrorsOf(":MOD PM 1\n:MOD PM 2\n:END PM 2\n:A I 0.0\n:END PM 1\n"), ElementsAre("2:2 E20"));
  EXPECT_THAT(ErrorsOf(":MOD PM 1\n:MOD PM 2\n:END PM 1\n:END PM 2\n"), ElementsAre("2:2 E20"));
  EXPECT_THAT(ErrorsOf(":MOD PM 1\n:END PM 2\n"), ElementsAre("2:2 E20"));
  EXPECT_THAT(ErrorsOf(":END PM 2\n"), ElementsAre("1:2 E20"));
  EXPECT_THAT(ErrorsOf(":MOD PM 1\n:NOP\n"), ElementsAre("1:2 E20"));
  EXPECT_THAT(ErrorsOf(":MOD PM 1\n:END PM 1\n:MOD PM 1\n:JU X\n:END PM 1\n"), ElementsAre("3:2 E20", "4:5 E13"));
  Parsed parsed;
  ParseInto(parsed, {":MOD PM 1\n", ":END PM 1\n"});
  EXPECT_THAT(parsed.Errors(), ElementsAre("1:2 E20", "1:2 E20"));
}

TEST(ProstepErrors, Calls) {
  EXPECT_THAT(InModuleErrors(":JU PM 21"), ElementsAre("2:2 E21"));
  EXPECT_THAT(InModuleErrors(":JU FM 43\n:K 1\n:K 2\n:DB 5\n:NOP\n:JU FM 99999999999\n:DB 5"),
              ElementsAre("2:5 E23", "7:5 E23"));
  EXPECT_THAT(InModuleErrors(":JU PM 20"), ElementsAre("2:2 E22"));
  EXPECT_THAT(ErrorsOf(":MOD PM 20\n:JU PM 21\n:END PM 20\n:MOD PM 21\n:JC PM 22\n:JC PM 20\n:END PM 21\n"
                       ":MOD PM 22\n:JU PM 21\n:END PM 22\n"),
              ElementsAre("6:2 E22", "9:2 E22"));
}

TEST(ProstepErrors, Arguments) {
  EXPECT_THAT(InModuleErrors(":JU FM 0\n:K 1\n:K 2\n:K 3"), ElementsAre("5:2 E24"));
  EXPECT_THAT(InModuleErrors(":JU FM 15\n:K 1\n:K 2\n:JU FM 54\n:K 1\n:K 1\n:K 1\n:JU FM 44\n:K 1\n:K 1\n:K 1"),
              ElementsAre("3:2 E24", "6:2 E24", "12:2 E24"));
  EXPECT_THAT(InModuleErrors(":JU FM 2\n:K 1\n:K 2\n:PB 5\n:JU FM 15\n:PW 0\n:K 2\n:JU FM 71\n:PB 1"),
              ElementsAre("5:2 E10", "7:2 E10", "10:2 E10"));
  EXPECT_THAT(InModuleErrors(":JU FM 71\n:FB 253\n:JU FM 71\n:DW 497\n:JU FM 71\n:DB 997\n:JU FM 71\n:DB 496"),
              ElementsAre("3:2 E12", "5:2 E12", "7:2 E12"));
  EXPECT_THAT(InModuleErrors(":JU FM 62\n:FB 0\n:FB 4\n:FB 249\n:JU FM 62\n:FB 0\n:FB 4\n:DB 493"),
              ElementsAre("5:2 E12", "9:2 E12"));
  EXPECT_THAT(InModuleErrors(":JU FM 16\n:IW 255\n:K 2\n:JU FM 0\n:PB 23\n:K 1\n:PB 12"), ElementsAre("8:2 E12"));
}

TEST(ProstepErrors, GoOnInTheOrderOfLines) {
  EXPECT_THAT(InModuleErrors(":JU PM 30\n:BLAD\n:A(\n:A X\n:A I 0.9\n:)\n:JU X\n:= O 0.0"),
              ElementsAre("2:2 E21", "3:2 E08", "5:4 E10", "6:4 E12", "8:5 E13"));
}

}  // namespace
}  // namespace plcxx::prostep
