#include "tests/dialects/prostep_parsing.h"

namespace plcxx::prostep {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(ProstepDeclarations, Data) {
  EXPECT_THAT(ItemsOf("DDB 10 -128\nDDW20 0FFFFH note\nDDD 30 12345678D\nddd 496 -1;x\nDDB 499 99D\n"),
              ElementsAre("data 10 bytes 1 = 128", "data 20 bytes 2 = 65535", "data 30 bytes 4 = 305419896",
                          "data 496 bytes 4 = 4294967295", "data 499 bytes 1 = 153"));
  EXPECT_THAT(ErrorsOf("DDB 500 1\nDDW 499 1\nDDD 497 1\nDDD 99999999999 1\n"),
              ElementsAre("1:1 E16", "2:1 E16", "3:1 E16", "4:1 E16"));
  EXPECT_THAT(
      ErrorsOf("DDB 1 256\nDDB 1 -129\nDDB 1 100H\nDDB 1 100D\nDDW 1 65536\nDDD 1 4294967296\nDDB 1\nDDB 1X 5\n"
               "DDB 1 FFH\n"),
      ElementsAre("1:7 E12", "2:7 E12", "3:7 E12", "4:7 E12", "5:7 E12", "6:7 E12", "7:1 E11", "8:5 E11", "9:7 E11"));
}

TEST(ProstepDeclarations, TheLastOneWinsByteByByte) {
  Parsed parsed;
  ParseInto(parsed, {"DDD 10 01020304H\nDDB 11 0AAH\nDDW 12 0BBBBH\n"});
  EXPECT_THAT(parsed.Errors(), IsEmpty());
  EXPECT_THAT(parsed.Warnings(), ElementsAre("2:1 W06", "3:1 W06"));
  const auto data = InitialData(parsed.program);
  EXPECT_THAT((std::vector<int>{data[10], data[11], data[12], data[13], data[14]}),
              ElementsAre(0x04, 0xAA, 0xBB, 0xBB, 0));
}

TEST(ProstepDeclarations, CountsOfInputsAndOutputs) {
  EXPECT_THAT(ErrorsOf("DDW 496 25\nDDW 498 21\nDDW 496 -1\n"), ElementsAre("1:9 E17", "2:9 E17", "3:9 E17"));
  EXPECT_THAT(WarningsOf("DDW 496 24\nDDW 498 12\n"), IsEmpty());
  EXPECT_THAT(WarningsOf("DDW 498 13\n"), ElementsAre("1:9 W07"));
}

TEST(ProstepDeclarations, MFunctions) {
  EXPECT_THAT(ItemsOf("DMF 3 P S1 D2\nDMF 4 d 16 s24 p ; all\nDMF07\nDMF 30\nDMF 0 S2*x\n"),
              ElementsAre("m-function 3 after-move static 1 dynamic 2", "m-function 4 after-move static 24 dynamic 16",
                          "m-function 7", "m-function 30 after-move", "m-function 0 after-move static 2"));
  EXPECT_THAT(ErrorsOf("DMF 100 P\nDMF 5 S25\nDMF 6 D0\nDMF 7 P P\nDMF 8 X\nDMF 9 S\nDMF 10 tekst\nDMF 1X\n"),
              ElementsAre("1:5 E19", "2:7 E19", "3:7 E19", "4:9 E19", "5:7 E19", "6:7 E19", "7:8 E19", "8:5 E19"));
  EXPECT_THAT(ErrorsOf("DMF 5 P\nDMF 05\n"), ElementsAre("2:1 E18"));
  EXPECT_THAT(WarningsOf("DMF 5 S3 D4\nDMF 6 S3\nDMF 7 D4\n"), ElementsAre("2:1 W08", "3:1 W08"));
}

TEST(ProstepDeclarations, Texts) {
  EXPECT_THAT(ItemsOf("DM 1 .  ZAL ; x * y  \nDM64.\nDT 20 .  ZAL  WRZEC\n"),
              ElementsAre("message 1 \"  ZAL ; x * y\"", "message 64 \"\"", "menu 20 \"  ZAL  WRZEC\""));
  const std::string forty(40, 'x');
  EXPECT_THAT(ErrorsOf("DM 1 ." + forty + "   \nDM 2 ." + forty + "x\nDT 1 .12345678901234\nDT 2 .123456789012345\n"),
              ElementsAre("2:7 E19", "4:7 E19"));
  EXPECT_THAT(ErrorsOf("DM 0 .x\nDM 65 .x\nDT 21 .x\nDM 5 x\nDM 6\nDM 7x.\n"),
              ElementsAre("1:4 E19", "2:4 E19", "3:4 E19", "4:1 E19", "5:1 E19", "6:1 E19"));
  EXPECT_THAT(ErrorsOf("DM 5 .x\nDT 5 .x\nDM 05 .y\n"), ElementsAre("3:1 E18"));
  EXPECT_THAT(ErrorsOf("DM 1 .ąąąąąąąąąąąąąąąąąąąąąąąąąąąąąąąąąąąąąąąą\n"), IsEmpty()) << "40 characters";
}

TEST(ProstepDeclarations, CharactersThatMazoviaLacks) {
  EXPECT_THAT(WarningsOf("DM 1 .Załącz ° ─\nDM 2 .a€b€\nDT 1 .č\n"), ElementsAre("2:8 W09", "3:7 W09"));
}

TEST(ProstepDeclarations, BehindTheFirstModule) {
  EXPECT_THAT(WarningsOf("DDB 1 2\n:MOD PM 1\nDDB 2 3\n:L\nDM 1 .x\n:K 5\n:END PM 1\nDT 1 .y\n"),
              ElementsAre("3:1 W05", "5:1 W05", "8:1 W05"));
}

TEST(ProstepDeclarations, MessagesSayTheLimit) {
  const auto text_of = [](const std::string& text) {
    Parsed parsed;
    ParseInto(parsed, {text});
    return parsed.FirstText();
  };
  EXPECT_THAT(text_of("DMF 5 S25\n"), testing::AllOf(HasSubstr("DMF 5"), HasSubstr("limit"), HasSubstr("S25")));
  EXPECT_THAT(text_of("DM 5 x\n"), testing::AllOf(HasSubstr("DM 5"), HasSubstr("limit"), HasSubstr("40")));
  EXPECT_THAT(text_of("DT 1 .123456789012345\n"),
              testing::AllOf(HasSubstr("DT 1"), HasSubstr("limit"), HasSubstr("14")));
}

}  // namespace
}  // namespace plcxx::prostep
