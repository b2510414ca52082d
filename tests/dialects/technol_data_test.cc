// Constants, declared data and structures: values, offsets, widths and initial bytes.
#include "tests/dialects/technol_parsing.h"

namespace plcxx::technol {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

int64_t ValueOf(const std::string& expression) {
  Parsed parsed;
  ParseInto(parsed, {"S STRUC\nF1 DB ?\nF2 DD ?\nS ENDS\nK EQU " + expression + "\n" + InProgram("", "NOP\n")});
  EXPECT_THAT(parsed.Errors(), IsEmpty()) << expression;
  return parsed.Find("K")->value;
}

TEST(TechnolConstants, Numbers) {
  EXPECT_EQ(ValueOf("62"), 62);
  EXPECT_EQ(ValueOf("62D"), 62);
  EXPECT_EQ(ValueOf("0FFFFh"), 0xFFFF);
  EXPECT_EQ(ValueOf("1010b"), 10);
  EXPECT_EQ(ValueOf("0Bh"), 11);
  EXPECT_EQ(ValueOf("17q"), 15);
  EXPECT_EQ(ValueOf("17O"), 15);
  EXPECT_EQ(ValueOf("'T'"), 'T');
  EXPECT_EQ(ValueOf("0FFFFFFFFh"), 0xFFFFFFFF);
}

TEST(TechnolConstants, Expressions) {
  EXPECT_EQ(ValueOf("2+3*4"), 14);
  EXPECT_EQ(ValueOf("(2+3)*4"), 20);
  EXPECT_EQ(ValueOf("20/3 MOD 4"), 2);
  EXPECT_EQ(ValueOf("1 SHL 4 + 1"), 17);
  EXPECT_EQ(ValueOf("-16 SHR 2"), -4);
  EXPECT_EQ(ValueOf("6 AND 3 OR 8 XOR 1"), 11);
  EXPECT_EQ(ValueOf("NOT 0 AND 0FFh"), 0xFF);
  EXPECT_EQ(ValueOf("- - 5"), 5);
  EXPECT_EQ(ValueOf("SIZE S + F2"), 6);
}

TEST(TechnolConstants, Errors) {
  const auto errors = [](const std::string& line) { return ErrorsOf(line + "\n" + InProgram("", "NOP\n")); };
  EXPECT_THAT(errors("K EQU 100000000h"), ElementsAre("1:7 TE006"));
  EXPECT_THAT(errors("K EQU 0FFFFFFFFh+1"), ElementsAre("1:7 TE006"));
  EXPECT_THAT(errors("K EQU 1 SHL 70"), ElementsAre("1:7 TE006"));
  EXPECT_THAT(errors("K EQU 5 MOD 0"), ElementsAre("1:7 TE007"));
  EXPECT_THAT(errors("K EQU 12b"), ElementsAre("1:7 TE001"));
  EXPECT_THAT(errors("K EQU L"), ElementsAre("1:7 TE010"));
  EXPECT_THAT(errors("K EQU " + std::string(5000, '(')), ElementsAre("1:207 TE001"));
  EXPECT_THAT(errors("K EQU 5\nEQUI K,5\nK = 6"), ElementsAre("3:1 TE013"));
  EXPECT_THAT(errors("K = 5\nK = K+1\nA1 EQU K"), IsEmpty());
}

std::vector<int> BytesOf(const std::string& data) {
  Parsed parsed;
  ParseInto(parsed, {"S STRUC\nA1 DB 1\nA2 DW 2\nA3 DB 'ab'\nS ENDS\n" + InProgram(data, "NOP\n")});
  EXPECT_THAT(parsed.Errors(), IsEmpty()) << data;
  return {parsed.program.user_data.begin(), parsed.program.user_data.end()};
}

TEST(TechnolData, InitialBytes) {
  EXPECT_THAT(BytesOf("X DB 1,-1,?,'ab'\n"), ElementsAre(1, 255, 0, 'a', 'b'));
  EXPECT_THAT(BytesOf("X: DW 1234h,-2\nDD 1\n"), ElementsAre(0x34, 0x12, 0xFE, 0xFF, 1, 0, 0, 0));
  EXPECT_THAT(BytesOf("X DB 2 DUP (1,2 DUP (3))\n"), ElementsAre(1, 3, 3, 1, 3, 3));
  EXPECT_THAT(BytesOf("X S <,5>\nY: S <9,?,'x'>\n"), ElementsAre(1, 5, 0, 'a', 'b', 9, 0, 0, 'x', 0));
  EXPECT_THAT(BytesOf("X S 2 DUP (<>)\n"), ElementsAre(1, 2, 0, 'a', 'b', 1, 2, 0, 'a', 'b'));
  EXPECT_THAT(BytesOf("X: DS 2\nB: DFM P,,Q\nDB 7\n"), ElementsAre(0, 0, 0, 7));
}

TEST(TechnolData, CellsAndBits) {
  Parsed parsed;
  ParseInto(parsed,
            {InProgram("X: DS 1\nW DS 2\nD: DS 4\nP: DS 3\nA DW 5,6\nB: DFM B0,,B2\nOUT3: DFM O0,O1\n", "NOP\n")});
  ASSERT_THAT(parsed.Errors(), IsEmpty());
  const auto shown = [&](std::string_view name) {
    const Symbol& symbol = *parsed.Find(name);
    return std::vector<uint32_t>{symbol.offset, symbol.bytes, symbol.width};
  };
  EXPECT_THAT(shown("X"), ElementsAre(0, 1, 8));
  EXPECT_THAT(shown("W"), ElementsAre(1, 2, 16));
  EXPECT_THAT(shown("D"), ElementsAre(3, 4, 32));
  EXPECT_THAT(shown("P"), ElementsAre(7, 3, 0));
  EXPECT_THAT(shown("A"), ElementsAre(10, 4, 16));
  EXPECT_EQ(parsed.Find("B2")->bit, 2);
  EXPECT_EQ(parsed.Find("B2")->offset, 14u);
  EXPECT_EQ(parsed.Find("O1")->area, Area::kOut);
  EXPECT_EQ(parsed.Find("O1")->offset, 3u);
  EXPECT_EQ(parsed.program.user_data.size(), 15u);
}

TEST(TechnolData, TheControlsOwn) {
  Parsed parsed;
  ParseInto(parsed, {InProgram("", "NOP\n")});
  EXPECT_EQ(parsed.Find("TCH_DATA")->value, 32);
  EXPECT_EQ(parsed.Find("TCH_REZ")->width, 16);
  EXPECT_EQ(parsed.Find("TCH_FILENAME")->width, 8);
  EXPECT_EQ(parsed.Find("TAB_TECHNOLS")->bytes, 36u);
  EXPECT_EQ(parsed.Find("SET_NCTABS")->bytes, 9u);
  EXPECT_EQ(parsed.Find("LABEL_MEM")->bytes, 1000u);
  EXPECT_EQ(parsed.Find("BUKON99")->offset, 396u);
  EXPECT_EQ(parsed.Find("REQ_PIS_HALT")->bit, 6);
  EXPECT_EQ(parsed.Find("UPS_OFF")->area, Area::kSys);
}

TEST(TechnolData, Errors) {
  const auto errors = [](const std::string& data) { return ErrorsOf(InProgram(data, "NOP\n")); };
  EXPECT_THAT(errors("X: DS 65536\n"), ElementsAre("2:7 TE030"));
  EXPECT_THAT(errors("X: DS 65535\nY: DS 1\n"), ElementsAre("3:4 TE030"));
  EXPECT_THAT(errors("X DB 0 DUP (1)\n"), ElementsAre("2:6 TE031"));
  EXPECT_THAT(errors("X: DFM A,B,C,D,E,F,G,H,I\n"), ElementsAre("2:4 TE032"));
  EXPECT_THAT(errors("X DB 256\nY DB -129\nZ DW 'ab'\n"), ElementsAre("2:6 TE033", "3:6 TE033", "4:6 TE034"));
  EXPECT_THAT(errors("S STRUC\nA DB 1\nT ENDS\n"), ElementsAre("4:1 TE035"));
  EXPECT_THAT(errors("S STRUC\nA DB 1\nS ENDS\nT STRUC\nB DB 1\nA DB 1\nT ENDS\nX S <1,2>\n"),
              ElementsAre("7:1 TE014", "9:8 TE033"));
  EXPECT_THAT(errors("S STRUC\nA DB 1\n"), ElementsAre("4:1 TE035"));
  EXPECT_THAT(errors("IN0 DB 1\nX: DS 1\nx DS 2\n"), ElementsAre("2:1 TE012", "4:1 TE012"));
  Settings sensitive;
  sensitive.names = CaseRule::kSensitive;
  EXPECT_THAT(ErrorsOf(InProgram("X: DS 1\nx: DS 2\n", "lod x\nSTO WORD.x\n"), sensitive), IsEmpty());
}

}  // namespace
}  // namespace plcxx::technol
