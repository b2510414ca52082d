// Errors E101 to E505, each at its place.
// covers: HOST50-044 HOST50-300..310 HOST50-320..340 HOST50-348 HOST50-351
#include "tests/dialects/host50_parsing.h"

namespace plcxx::host50 {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// One instruction behind LD %I0, in line 4.
std::vector<std::string> After(const std::string& instruction) { return NetworkErrors("LD %I0\n" + instruction); }

TEST(Host50Errors, Instructions) {
  EXPECT_THAT(After("FOO 1\nOUT %Q0"), ElementsAre("4:1 E101"));
  EXPECT_THAT(After("%I0"), ElementsAre("4:1 E101"));
  EXPECT_THAT(After("启动 %I0"), ElementsAre("4:1 E101"));
}

/// What ends a part is misspelt: the part ends.
TEST(Host50Errors, AMisspeltEndIsOneError) {
  const std::string slow = "SLOW\nNETWORK\nLD %I0\nOUT %Q0\n";
  for (const char* end : {"END_SLWO", "ENDSLOW", "END_SLO", "END SLOW"}) {
    EXPECT_THAT(ErrorsOf(slow + end + "\nSUB SR1\nEND_SUB\n"), ElementsAre("5:1 E101")) << end;
  }
  for (const char* end : {"ENDSYMBOLS", "END_SYMBOL", "END"}) {
    EXPECT_THAT(ErrorsOf("SYMBOLS\n%I0 START\n" + std::string(end) + "\nSLOW\nNETWORK\nLD START\nOUT %Q0\nEND_SLOW\n"),
                ElementsAre("3:1 E101"))
        << end;
  }
  EXPECT_THAT(ErrorsOf(slow + "END_SLWO\nLD %I1\nOUT %Q1\nEND_SLOW\n"), ElementsAre("5:1 E101"));
}

TEST(Host50Errors, AFaultyDefinitionIsOneError) {
  EXPECT_THAT(ErrorsOf("SYMBOLS\nSTART %I0 \"start\"\nEND_SYMBOLS\nSLOW\nNETWORK\nLD START\nOUT %Q0\nEND_SLOW\n"),
              ElementsAre("2:1 E103"));
  EXPECT_THAT(ErrorsOf("SLOW\nNETWORK\nLD %I0\nCALL SR4\nEND_SLOW\nSUB 4 \"coolant\"\nEND_SUB\n"),
              ElementsAre("6:5 E102"));
  EXPECT_THAT(ErrorsOf("SLOW\nNETWORK 3\nNETWORK L4 pump\nEND_SLOW\n"), ElementsAre("2:9 E102", "3:12 E102"));
}

TEST(Host50Errors, NumberOfOperands) {
  EXPECT_THAT(After("OUT"), ElementsAre("4:4 E102"));
  EXPECT_THAT(After("ADDW %W1, %W2"), ElementsAre("4:14 E102"));
  EXPECT_THAT(After("ADDW %W1 %W2, %W3"), ElementsAre("4:10 E102"));
  EXPECT_THAT(After("OUT %Q0 %Q1"), ElementsAre("4:9 E102"));
  EXPECT_THAT(After("OUT %Q0=1"), ElementsAre("4:8 E102"));
  EXPECT_THAT(After("MOV 1, %W0,"), ElementsAre("4:12 E102"));
  EXPECT_THAT(After("CNUD %C1, P=1"), ElementsAre("4:11 E102"));
  EXPECT_THAT(After("CNUD %C1, 8, P=0, M=0, N=0, %I1"), ElementsAre("4:29 E102"));
  EXPECT_THAT(After("TON %TM1, X, 5"), ElementsAre("4:11 E102"));
  EXPECT_THAT(After("TON %TM1, S"), ElementsAre("4:12 E102"));
  EXPECT_THAT(After("CALL 5"), ElementsAre("4:6 E102"));
  EXPECT_THAT(After("LBL L1"), ElementsAre("4:5 E102"));
  EXPECT_THAT(After("MOV \"1\", %W0"), ElementsAre("4:5 E102"));
  EXPECT_THAT(ErrorsOf("SLOW x\nEND_SLOW now"), ElementsAre("1:6 E102", "2:10 E102"));
  EXPECT_THAT(ErrorsOf("SUB 1\nEND_SUB\nSUB\nEND_SUB"), ElementsAre("1:5 E102", "3:4 E102"));
  EXPECT_THAT(ErrorsOf("SLOW\nNETWORK x1\nNETWORK \"a\" b\nEND_SLOW"), ElementsAre("2:9 E102", "3:13 E102"));
}

TEST(Host50Errors, Addresses) {
  for (const char* address : {"%X1", "%I", "%I1x", "%I123456", "%I1.Q", "%TM1.X", "%", "%5"}) {
    EXPECT_THAT(NetworkErrors("LD " + std::string(address) + "\nOUT %Q0"), ElementsAre("3:4 E103")) << address;
  }
  for (const char* address : {"%I2001", "%I2400", "%B2001", "%TM101", "%C101", "%Q99999"}) {
    EXPECT_THAT(NetworkErrors("LD " + std::string(address) + "\nOUT %Q0"), ElementsAre("3:4 E104")) << address;
  }
  EXPECT_THAT(NetworkErrors("LD %I2000\nAND %I00499\nMOV %IW300, %W300"), IsEmpty());
}

TEST(Host50Errors, AddressesOfChannels) {
  const std::string valid = InNetwork("LD %I2500\nOUT %Q4000\nMOV %IW499, %W0\nMOV %IW500, %W1");
  EXPECT_THAT(ErrorsOf("CHANNELS 2\n" + valid), IsEmpty());
  EXPECT_THAT(ErrorsOf(valid, {{"channels", "2"}}), IsEmpty());
  EXPECT_THAT(ErrorsOf("CHANNELS 2\n" + InNetwork("LD %I2400\nOUT %Q0")), ElementsAre("4:4 E104"));
  EXPECT_THAT(ErrorsOf("CHANNELS 2\n" + valid, {{"CHANNELS", "1"}}),
              ElementsAre("4:4 E104", "5:5 E104", "6:5 E104", "7:5 E104"));
}

TEST(Host50Errors, Symbols) {
  EXPECT_THAT(NetworkErrors("LD nowhere\nOUT %Q0"), ElementsAre("3:4 E105"));
  EXPECT_THAT(ErrorsOf(InNetwork("LD start\nOUT %Q0") + "SYMBOLS\n%I0 START\nEND_SYMBOLS"), ElementsAre("3:4 E105"));
  EXPECT_THAT(ErrorsOf(InNetwork("LD W.V\nOUT %Q0") + "SYMBOLS\n%W0 W\nEND_SYMBOLS"), ElementsAre("3:4 E105"));
}

TEST(Host50Errors, Directions) {
  for (const char* address : {"%I0", "%TM1", "%TM1.V", "%C1", "%C1.V"}) {
    EXPECT_THAT(After("SET " + std::string(address)), ElementsAre("4:5 E106")) << address;
  }
  for (const char* address : {"%TM1.V", "%TM1.Q", "%C1.Q", "%C1.P"}) {
    EXPECT_THAT(After("MOV 1, " + std::string(address)), ElementsAre("4:8 E106")) << address;
  }
  EXPECT_THAT(After("MOV 1, %C1.V"), IsEmpty());
  EXPECT_THAT(After("WTOB 1, %I0, 4"), ElementsAre("4:9 E106"));
  EXPECT_THAT(After("OPRT %TM1.P = 4"), ElementsAre("4:6 E106"));
}

TEST(Host50Errors, Types) {
  EXPECT_THAT(NetworkErrors("LD %W0\nOUT %Q0"), ElementsAre("3:4 E107"));
  EXPECT_THAT(NetworkErrors("LD 2\nOUT %Q0"), ElementsAre("3:4 E107"));
  EXPECT_THAT(NetworkErrors("LDP 1\nOUT %Q0"), ElementsAre("3:5 E107"));
  EXPECT_THAT(After("AND 1\nOUT %Q0"), ElementsAre("4:5 E107"));
  EXPECT_THAT(After("OUT %W0"), ElementsAre("4:5 E107"));
  EXPECT_THAT(After("ADDW 1.5, 1, %W0"), ElementsAre("4:6 E107"));
  EXPECT_THAT(After("ADDW %F0, 1, %W0"), ElementsAre("4:6 E107"));
  EXPECT_THAT(After("ADDW %TM1, 1, %W0"), ElementsAre("4:6 E107"));
  EXPECT_THAT(After("ADDF %W0, 1, %F0"), ElementsAre("4:6 E107"));
  EXPECT_THAT(After("ADDF 1, 1, %C1.V"), ElementsAre("4:12 E107"));
  EXPECT_THAT(After("MOV %I0, %W0"), ElementsAre("4:5 E107"));
  EXPECT_THAT(After("MOV 1, %Q0"), ElementsAre("4:8 E107"));
  EXPECT_THAT(After("BTOW %W0, %W1, 4"), ElementsAre("4:6 E107"));
  EXPECT_THAT(After("BTOW %TM1, %W1, 4"), ElementsAre("4:6 E107"));
  EXPECT_THAT(After("TONS %C1, 5"), ElementsAre("4:6 E107"));
  EXPECT_THAT(After("TONS %TM1.Q, 5"), ElementsAre("4:6 E107"));
  EXPECT_THAT(After("CNUD 1, 5, P=0, M=0, N=0"), ElementsAre("4:6 E107"));
  EXPECT_THAT(After("ROT 1, 2, 3, %W0, M=!1"), ElementsAre("4:22 E107"));
  EXPECT_THAT(After("OPRT %Q0 = 1"), ElementsAre("4:6 E107"));
}

TEST(Host50Errors, ConstantsAsDestinations) {
  for (const char* instruction : {"OUT 1", "NEG 5", "MOV 1, 2.5", "ADDW 1, 2, 3", "WTOB 1, 2, 3", "OPRT 5 = 1"}) {
    EXPECT_THAT(After(instruction).size(), 1u) << instruction;
    EXPECT_THAT(After(instruction).front(), testing::EndsWith("E108")) << instruction;
  }
}

TEST(Host50Errors, Numbers) {
  EXPECT_THAT(After("MOV 2147483648, %W0"), ElementsAre("4:5 E109"));
  EXPECT_THAT(After("MOV 2147483648, %F0"), IsEmpty());
  EXPECT_THAT(After("MOV $123456789, %W0"), ElementsAre("4:5 E109"));
  EXPECT_THAT(After("EQ 3000000000, %W0\nOUT %Q0"), ElementsAre("4:4 E109"));
  EXPECT_THAT(After("EQ 3000000000, %F0\nOUT %Q0"), IsEmpty());
  EXPECT_THAT(After("EQ 3000000000, 2.0\nOUT %Q0"), IsEmpty());
  EXPECT_THAT(After("ADDF 1e39, 1, %F0"), ElementsAre("4:6 E109"));
  EXPECT_THAT(After("LBL J10000"), ElementsAre("4:5 E109"));
  EXPECT_THAT(After("CALL SR10000"), ElementsAre("4:6 E109"));
  EXPECT_THAT(After("VELP 0, 5"), ElementsAre("4:6 E109"));
  EXPECT_THAT(After("VELP 10, 5"), IsEmpty());
  EXPECT_THAT(ErrorsOf("OPTION AXISBASE=0\n" + InNetwork("LD 1\nVELP 10, 5")), ElementsAre("5:6 E109"));
  EXPECT_THAT(ErrorsOf("SUB SR10000\nNETWORK L10000\nEND_SUB"), ElementsAre("1:5 E109", "2:9 E109"));
  EXPECT_THAT(ErrorsOf("MCODES\n1000 \"x\"\n999 \"y\"\nEND_MCODES"), ElementsAre("2:1 E109"));
}

TEST(Host50Errors, BitFields) {
  for (const char* count : {"0", "33", "$8", "-1", "%W1", "1.5"}) {
    EXPECT_THAT(After("BTOW %B0, %W0, " + std::string(count)), ElementsAre("4:16 E110")) << count;
  }
  EXPECT_THAT(After("BTOW %B1993, %W0, 8"), IsEmpty());
  EXPECT_THAT(After("BTOW %B1994, %W0, 8"), ElementsAre("4:6 E110"));
  EXPECT_THAT(ErrorsOf("CHANNELS 2\n" + InNetwork("LD 1\nWTOB 1, %Q1999, 4")), ElementsAre("5:9 E110"));
}

TEST(Host50Errors, CharactersAndStrings) {
  EXPECT_THAT(After("OUT %Q0 @"), ElementsAre("4:9 E111"));
  EXPECT_THAT(After("OUT \"x"), ElementsAre("4:5 E111"));
  EXPECT_THAT(After("OUT 'x"), ElementsAre("4:5 E111"));
  EXPECT_THAT(After("@"), ElementsAre("4:1 E111"));
  EXPECT_THAT(After("REMARK \"x\nOUT %Q0"), ElementsAre("4:8 E111"));
  EXPECT_THAT(ErrorsOf("SLOW\nNETWORK \"x\nEND_SLOW"), ElementsAre("2:9 E111"));
  EXPECT_THAT(After("OUT %Q99999 @"), ElementsAre("4:5 E104")) << "one error for each instruction, the first one";
}

TEST(Host50Errors, Pins) {
  EXPECT_THAT(After("CNUD %C1, 8, I=1"), ElementsAre("4:14 E209"));
  EXPECT_THAT(After("TONS %TM1, 8, P=1"), ElementsAre("4:15 E209"));
  EXPECT_THAT(After("CNUD %C1, 8, P=1, p=0"), ElementsAre("4:19 E209"));
}

TEST(Host50Errors, Fast) {
  EXPECT_THAT(ErrorsOf("FAST\nNETWORK\nLD 1\nCALL SR1\nLBL J0\nEND_FAST\nSUB SR1\nEND_SUB"),
              ElementsAre("4:1 E301", "5:1 E301"));
  std::string text = "FAST\n";
  for (int i = 0; i < 12; ++i) text += "NETWORK\n";
  EXPECT_THAT(ErrorsOf(text + "END_FAST"), ElementsAre("12:1 E302"));
}

TEST(Host50Errors, Duplicates) {
  EXPECT_THAT(ErrorsOf("FAST\nEND_FAST\nfast\nEND_FAST\nSUB SR1\nEND_SUB\nSUB sr01\nEND_SUB"),
              ElementsAre("3:1 E303", "7:1 E303"));
  EXPECT_THAT(ErrorsOf("SLOW\nNETWORK L1\nNETWORK\nNETWORK L0001\nEND_SLOW"), ElementsAre("3:1 E304", "4:1 E304"));
}

TEST(Host50Errors, Targets) {
  EXPECT_THAT(After("LBL J7"), ElementsAre("4:5 E305"));
  EXPECT_THAT(After("LBL J0"), IsEmpty());
  EXPECT_THAT(After("CALL SR7"), ElementsAre("4:6 E306"));
}

TEST(Host50Errors, Recursion) {
  EXPECT_THAT(ErrorsOf("SUB SR1\nNETWORK\nLD 1\nCALL SR1\nEND_SUB"), ElementsAre("4:1 E307"));
  // From SLOW the cycle is entered at SR2.
  EXPECT_THAT(ErrorsOf("SUB SR1\nNETWORK\nLD 1\nCALL SR2\nEND_SUB\nSUB SR2\nNETWORK\nLD 1\nCALL SR1\nEND_SUB\n" +
                       InNetwork("LD 1\nCALL SR2")),
              ElementsAre("4:1 E307"));
  EXPECT_THAT(ErrorsOf("SUB SR2\nNETWORK\nLD 1\nCALL SR1\nEND_SUB\nSUB SR1\nNETWORK\nLD 1\nCALL SR2\nEND_SUB\n"),
              ElementsAre("4:1 E307"))
      << "without SLOW from the least number";
}

/// SR1 calls SR2 calls ... SR<count>.
std::string Chain(uint32_t count) {
  std::string text;
  for (uint32_t i = 1; i <= count; ++i) {
    text += "SUB SR" + std::to_string(i) + "\nNETWORK\nLD 1\n";
    text += i < count ? "CALL SR" + std::to_string(i + 1) : "SET %Q0";
    text += "\nEND_SUB\n";
  }
  return text;
}

TEST(Host50Errors, CallDepth) {
  EXPECT_THAT(ErrorsOf(Chain(25) + InNetwork("LD 1\nCALL SR1")), IsEmpty());
  EXPECT_THAT(ErrorsOf(Chain(26) + InNetwork("LD 1\nCALL SR1")), ElementsAre("124:1 E308"));
  EXPECT_THAT(ErrorsOf(Chain(26)), IsEmpty()) << "nothing calls SR1: its CALL is the first one";
  EXPECT_THAT(ErrorsOf(Chain(27)), ElementsAre("129:1 E308"));
  EXPECT_THAT(ErrorsOf(Chain(30) + InNetwork("LD 1\nCALL SR1")), ElementsAre("124:1 E308")) << "the first one only";
}

TEST(Host50Errors, TooMany) {
  std::string subs, networks = "SLOW\n";
  for (int i = 0; i < 102; ++i) subs += "SUB SR" + std::to_string(i) + "\nEND_SUB\n";
  for (int i = 0; i < 502; ++i) networks += "NETWORK\n";
  EXPECT_THAT(ErrorsOf(subs), ElementsAre("201:1 E309"));
  EXPECT_THAT(ErrorsOf(networks + "END_SLOW"), ElementsAre("502:1 E309"));
}

TEST(Host50Errors, OutsideOfParts) {
  EXPECT_THAT(ErrorsOf("LD %I0\nOUT %Q0\nOUT %Q99999"), ElementsAre("1:1 E310", "3:5 E104"));
  EXPECT_THAT(ErrorsOf("SLOW\nLD %I0\nOUT %Q0\nNETWORK\nEND_SLOW"), ElementsAre("2:1 E310"));
  EXPECT_THAT(ErrorsOf("NETWORK\nLD %I0\nOUT %Q0\nNETWORK\nEND_SLOW"), ElementsAre("1:1 E310"))
      << "SLOW is missing: its END closes what was reported";
  EXPECT_THAT(ErrorsOf("FOO"), ElementsAre("1:1 E101"));
}

TEST(Host50Errors, Ends) {
  EXPECT_THAT(ErrorsOf("SLOW\nNETWORK"), ElementsAre("1:1 E311"));
  EXPECT_THAT(ErrorsOf("SYMBOLS\n%I0 A\nSLOW\nNETWORK\nLD A\nOUT %Q0\nEND_SLOW"), ElementsAre("1:1 E311"));
  EXPECT_THAT(ErrorsOf("END_SLOW\nEND_LADDER"), ElementsAre("1:1 E312", "2:1 E312"));
  EXPECT_THAT(ErrorsOf("SLOW\nNETWORK\nLD 1\nEND_FAST\nOUT %Q0\nEND_SLOW"), ElementsAre("4:1 E312"));
  EXPECT_THAT(ErrorsOf("SLOW\nNETWORK\nLD 1\nOUT %Q0\nEND_FAST\nSUB SR1\nEND_SUB"), ElementsAre("5:1 E312"))
      << "a wrong END where the right one is missing";
  EXPECT_THAT(ErrorsOf("TITLE\nEND_SYMBOLS\nEND_TITLE"), ElementsAre("2:1 E312"));
}

TEST(Host50Errors, APartEndsInItsFile) {
  Parsed parsed;
  ParseInto(parsed, {"SLOW\nNETWORK\nLD 1\nOUT %Q0\n", "END_SLOW\n"});
  EXPECT_THAT(parsed.Errors(), ElementsAre("1:1 E311", "file2:1:1 E312"));
}

TEST(Host50Errors, Expressions) {
  EXPECT_THAT(After("COMP %W0 + > 3\nOUT %Q0"), ElementsAre("4:12 E401"));
  EXPECT_THAT(After("COMP (%W0 > 3\nOUT %Q0"), ElementsAre("4:11 E402"));
  EXPECT_THAT(After("COMP (%W0 + 1 = 3\nOUT %Q0"), ElementsAre("4:15 E402"));
  EXPECT_THAT(After("COMP %W0 %W1 = 3\nOUT %Q0"), ElementsAre("4:10 E401"));
  EXPECT_THAT(After("COMP %W0 = --3\nOUT %Q0"), ElementsAre("4:13 E401"));
  EXPECT_THAT(After("COMP %W0 = 3)\nOUT %Q0"), ElementsAre("4:13 E401"));
  EXPECT_THAT(After("COMP %W0\nOUT %Q0"), ElementsAre("4:6 E402"));
  EXPECT_THAT(After("COMP 1 < %W0 < 3\nOUT %Q0"), ElementsAre("4:14 E402"));
  EXPECT_THAT(After("COMP\nOUT %Q0"), ElementsAre("4:5 E402"));
  EXPECT_THAT(After("OPRT %W0"), ElementsAre("4:6 E403"));
  EXPECT_THAT(After("OPRT %W0 >= 3"), ElementsAre("4:6 E403"));
  EXPECT_THAT(After("OPRT %W0 = 3 < 5"), ElementsAre("4:14 E403"));
  EXPECT_THAT(After("OPRT %W0 = (3 < 5)"), ElementsAre("4:15 E403"));
  EXPECT_THAT(After("OPRT = 3"), ElementsAre("4:6 E401"));
  EXPECT_THAT(After("OPRT %W0 = "), ElementsAre("4:11 E401"));
  EXPECT_THAT(After("OPRT %W0 = %F0 & 1"), ElementsAre("4:16 E404"));
  EXPECT_THAT(After("OPRT %W0 = 2147483648"), ElementsAre("4:12 E109"));
  EXPECT_THAT(After("OPRT %W0 = 2147483648 - %F0"), ElementsAre("4:12 E109")) << "whatever stands beside it";
  EXPECT_THAT(After("OPRT %W0 = -2147483648"), IsEmpty());
  EXPECT_THAT(After("OPRT \"%W0 = 1"), ElementsAre("4:6 E111"));
  EXPECT_THAT(After("OPRT %W0 = 1 @"), ElementsAre("4:14 E111"));
  EXPECT_THAT(After("OPRT %W0 = 5 % 3"), ElementsAre("4:14 E401"));
}

TEST(Host50Errors, LargeExpressions) {
  const auto chain = [](int operands) {
    std::string text = "OPRT %W0 = 1";
    for (int i = 1; i < operands; ++i) text += "+1";
    return text;
  };
  EXPECT_THAT(After(chain(1024)), IsEmpty());
  EXPECT_THAT(After(chain(1025)).size(), 1u);
  EXPECT_THAT(After("OPRT %W0 = " + std::string(64, '(') + "1" + std::string(64, ')')), IsEmpty());
  EXPECT_THAT(After("OPRT %W0 = " + std::string(30000, '(')).size(), 1u);
}

TEST(Host50Errors, TimersOfTwoKinds) {
  EXPECT_THAT(After("TONS %TM1, 5\nRUNG\nLD %I1\nTOFS %TM1, 5\nRUNG\nLD %I2\nTONM %TM1, 5"),
              ElementsAre("7:6 E501", "10:6 E501"));
  EXPECT_THAT(After("TONS %TM1, 5\nRUNG\nLD %I1\nTON %TM1, SEC, 9"), IsEmpty());
}

TEST(Host50Errors, Tables) {
  EXPECT_THAT(ErrorsOf("SYMBOLS\n%I0 A\n%I0 B\n%I1 A\n%I2001 C\nFOO\n%TM1.Q D\nEND_SYMBOLS"),
              ElementsAre("3:1 E502", "4:5 E502", "5:1 E104", "6:1 E103", "7:1 E103"));
  EXPECT_THAT(
      ErrorsOf("ALARMS\n%Q399 \"x\"\n%B400 \"x\"\n%Q400 LOUD \"x\"\n%Q9999 \"x\"\n%Q499 \"\"\n%Q0499 \"y\"\n%X \"\"\n"
               "%Q401\nEND_ALARMS"),
      ElementsAre("2:1 E503", "3:1 E503", "4:7 E102", "5:1 E503", "7:1 E504", "8:1 E103", "9:6 E102"));
  EXPECT_THAT(ErrorsOf("MCODES\n8 \"a\"\n008 \"b\"\nM9 \"c\"\n$9 \"d\"\nEND_MCODES"),
              ElementsAre("3:1 E504", "4:1 E102", "5:1 E102"));
  EXPECT_THAT(ErrorsOf("TITLE\nAUTHOR \"a\"\nauthor \"b\"\nFOO \"c\"\nNOTE x\nEND_TITLE"),
              ElementsAre("3:1 E505", "4:1 E101", "5:6 E102"));
}

TEST(Host50Errors, ASymbolWithAFaultIsReportedOnce) {
  EXPECT_THAT(ErrorsOf("SYMBOLS\n%I9999 A\nEND_SYMBOLS\n" + InNetwork("LD A\nOUT %Q0")), ElementsAre("2:1 E104"));
}

TEST(Host50Errors, Directives) {
  EXPECT_THAT(ErrorsOf("SLOWDIV 0\nSLOWDIV 1001\nSLOWDIV x\nSLOWDIV\nSLOWDIV $8"),
              ElementsAre("1:9 E505", "2:1 E505", "3:1 E505", "4:1 E505", "5:1 E505"));
  EXPECT_THAT(ErrorsOf("CHANNELS 9"), ElementsAre("1:10 E505"));
  EXPECT_THAT(ErrorsOf("SLOWDIV 8 9"), ElementsAre("1:11 E102"));
  EXPECT_THAT(ErrorsOf("OPTION FOO=1\nOPTION TP=FOO\nOPTION TP\nOPTION TP=IEC\nOPTION tp=manual\nOPTION"),
              ElementsAre("1:8 E505", "2:11 E505", "3:10 E505", "5:8 E505", "6:7 E505"));
  EXPECT_THAT(ErrorsOf("SLOW\nSLOWDIV 5\nNETWORK\nOPTION TP=IEC\nLD 1\nOUT %Q0\nEND_SLOW"),
              ElementsAre("2:1 E505", "4:1 E505"));
}

TEST(Host50Errors, AreInTheFirstLineOfAContinuedStatement) {
  EXPECT_THAT(After("MOV 1, \\\n \\\n %W301"), ElementsAre("4:1 E104"));
}

}  // namespace
}  // namespace plcxx::host50
