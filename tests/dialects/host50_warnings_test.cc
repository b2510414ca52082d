// Warnings W01 to W21 and notes N01 to N05, each with a program close to it that is not warned of.
// covers: HOST50-360..382 HOST50-384 HOST50-385
#include "tests/dialects/host50_parsing.h"

namespace plcxx::host50 {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> WarnedAfter(const std::string& instructions) {
  return WarningsOf(InNetwork("LD %I0\n" + instructions));
}

std::vector<std::string> NotesOf(const std::string& text, const diag::WarningOptions& enabled = {}) {
  Parsed parsed;
  parsed.diagnostics = diag::Engine(enabled);
  ParseInto(parsed, {text});
  return parsed.Notes();
}

TEST(Host50Warnings, Coils) {
  EXPECT_THAT(WarnedAfter("OUT %Q0\nOUTI %Q0\nOUT %Q0"), ElementsAre("5:6 W01", "6:5 W01"));
  EXPECT_THAT(WarnedAfter("SET %Q0\nRST %Q0\nOUT %Q1"), IsEmpty());
  EXPECT_THAT(WarnedAfter("SET %Q0\nOUT %Q0\nRST %Q0"), ElementsAre("5:5 W02"));
  EXPECT_THAT(WarnedAfter("OUT %Q0\nRST %Q0\nSET %Q0"), ElementsAre("5:5 W02"));
}

TEST(Host50Warnings, Sections) {
  const auto program = [](const std::string& fast, const std::string& slow) {
    return "FAST\nNETWORK\nLD 1\n" + fast + "\nEND_FAST\nSLOW\nNETWORK\nLD 1\n" + slow + "\nEND_SLOW\n";
  };
  EXPECT_THAT(WarningsOf(program("SET %Q0", "SET %Q0\nRST %Q0")), ElementsAre("9:5 W03"));
  EXPECT_THAT(WarningsOf(program("WTOB 5, %Q0, 8", "SET %Q7")), ElementsAre("9:5 W03"));
  EXPECT_THAT(WarningsOf(program("SET %Q0", "SET %Q1")), IsEmpty());
  EXPECT_THAT(WarningsOf(program("MOV 1, %W0", "MOV 1, %W0")), IsEmpty()) << "bits only";
  EXPECT_THAT(WarningsOf("SUB SR1\nEND_SUB\n"), ElementsAre("1:1 W05", "1:1 W19"));
  EXPECT_THAT(WarningsOf("FAST\nEND_FAST\nSLOW\nNETWORK\nREMARK x\nEND_SLOW"), ElementsAre("3:1 W19"));
  EXPECT_THAT(WarningsOf("SYMBOLS\nEND_SYMBOLS\nALARMS\n%Q400 \"x\"\nEND_ALARMS"), IsEmpty()) << "tables only";
}

TEST(Host50Warnings, Instances) {
  EXPECT_THAT(WarnedAfter("TONS %TM1, 5\nRUNG\nLD 1\nTONS %TM1, 6\nRUNG\nLD %TM1\nOUT %Q0"), ElementsAre("7:1 W04"));
  EXPECT_THAT(WarnedAfter("TONS %TM1, 5\nRUNG\nLD 1\nTONS %TM2, 6"), IsEmpty());
}

TEST(Host50Warnings, Jumps) {
  const auto program = [](const std::string& first) {
    return "SLOW\nNETWORK\n" + first + "\nLBL J3\nREMARK x\nNETWORK\nNETWORK\nNETWORK L3\nNETWORK\nEND_SLOW\n";
  };
  EXPECT_THAT(WarningsOf(program("LD 1")), ElementsAre("6:1 W06", "7:1 W06"));
  EXPECT_THAT(WarningsOf(program("LD %I0")), IsEmpty());
  EXPECT_THAT(WarningsOf(program("LD 1\nOUT %Q0")), IsEmpty()) << "not alone";
  EXPECT_THAT(WarningsOf("SLOW\nNETWORK\nLADDER\n|--{LBL J2}\nEND_LADDER\nNETWORK\nNETWORK\nEND_SLOW"),
              ElementsAre("6:1 W06"));
  EXPECT_THAT(WarnedAfter("LBL J0"), ElementsAre("4:1 W09"));
}

TEST(Host50Warnings, Calls) {
  const auto program = [](const std::string& body) {
    return InNetwork("LD 1\nCALL SR1\nCALL SR1\nCALL SR1") + "SUB SR1\nNETWORK\n" + body + "\nEND_SUB\n";
  };
  EXPECT_THAT(WarningsOf(program("LDP %I0\nSET %Q0")), ElementsAre("5:1 W16", "6:1 W16"));
  EXPECT_THAT(WarningsOf(program("LD %I0\nSET %Q0")), IsEmpty());
}

TEST(Host50Warnings, Memory) {
  EXPECT_THAT(WarnedAfter("AND %B501\nAND %B501\nOUT %Q0"), ElementsAre("4:5 W07"));
  EXPECT_THAT(WarnedAfter("AND %B500\nOUT %Q0"), IsEmpty()) << "retentive";
  EXPECT_THAT(WarnedAfter("AND %B501\nOUT %B501"), IsEmpty());
  EXPECT_THAT(WarnedAfter("BTOW %B600, %W0, 4\nWTOB 1, %B600, 3"), ElementsAre("4:6 W07"));
  EXPECT_THAT(WarnedAfter("MOV %W101, %W0\nOPRT %F0 = %F101"), ElementsAre("4:5 W07", "5:12 W07"));
  EXPECT_THAT(WarnedAfter("MOV 1, %IW0\nMOV 1, %IF0"), ElementsAre("4:8 W08", "5:8 W08"));
}

TEST(Host50Warnings, Division) {
  EXPECT_THAT(WarnedAfter("DIVW 5, 0, %W0\nDIVF 5, -0.0, %F0\nDIVF 1, 0, %F0\nOPRT %W1 = 3 / 0"),
              ElementsAre("4:9 W10", "5:9 W10", "6:9 W10", "7:16 W10"));
  EXPECT_THAT(WarnedAfter("DIVW 0, 5, %W0"), IsEmpty());
}

TEST(Host50Warnings, Signals) {
  EXPECT_THAT(WarnedAfter("AND %I504\nAND %I504\nAND %I500\nOUT %Q599\nAND %Q999\nOUT %B0"),
              ElementsAre("4:5 W11", "7:5 W11"));
  EXPECT_THAT(WarningsOf("CHANNELS 2\n" + InNetwork("LD %I2500\nAND %I2504\nOUT %Q0")), ElementsAre("5:5 W11"));
}

TEST(Host50Warnings, Alarms) {
  const std::string alarms = "ALARMS\n%Q400 \"a\"\n%Q401 \"\"\n%Q402 \"b\"\nEND_ALARMS\n";
  Parsed parsed;
  ParseInto(parsed, {alarms + InNetwork("LD %I0\nOUT %Q400\nSET %Q401\nRST %Q401\nSET %Q499")});
  EXPECT_THAT(parsed.Warnings(), ElementsAre("10:5 W12", "12:5 W12"));
  EXPECT_THAT(parsed.Notes(), ElementsAre("4:1 N04"));
}

TEST(Host50Warnings, Texts) {
  const std::string long_text(31, 'x');
  EXPECT_THAT(WarningsOf("TITLE\nAUTHOR \"" + long_text + "\"\nNOTE \"" + long_text + "\"\nEND_TITLE"),
              ElementsAre("2:1 W13"));
  EXPECT_THAT(WarningsOf("SYMBOLS\n%I0 " + long_text + " \"" + long_text + "\"\nEND_SYMBOLS"),
              ElementsAre("2:5 W13", "2:37 W13"));
  EXPECT_THAT(WarningsOf(InNetwork("LD 1 ; " + std::string(51, 'x') + "\n; " + std::string(99, 'x') + "\nOUT %Q0 ; " +
                                   std::string(50, 'x'))),
              ElementsAre("3:6 W13"));
  EXPECT_THAT(WarningsOf(InNetwork("LD 1\nCALL SR1") + "SUB SR1 \"" + std::string(21, 'x') + "\"\nEND_SUB"),
              ElementsAre("6:9 W13"));
  std::string wide;
  for (int i = 0; i < 30; ++i) wide += "泵";
  EXPECT_THAT(WarningsOf("SYMBOLS\n%I0 " + wide + "\nEND_SYMBOLS"), IsEmpty()) << "characters, not bytes";
  EXPECT_THAT(WarningsOf("MCODES\n99 \"x\"\n100 \"y\"\nEND_MCODES"), ElementsAre("3:1 W18"));
}

TEST(Host50Warnings, Layout) {
  std::string wide = "LD %I0", high = "LD %I0";
  for (int i = 0; i < 7; ++i) wide += "\nAND %I1";
  for (int i = 0; i < 50; ++i) high += "\nOR %I1";
  EXPECT_THAT(WarningsOf(InNetwork(wide + "\nOUT %Q0")), IsEmpty()) << "9 cells with the coil";
  EXPECT_THAT(WarningsOf(InNetwork(wide + "\nAND %I2\nOUT %Q0")), ElementsAre("2:1 W14"));
  EXPECT_THAT(WarningsOf(InNetwork(high + "\nOUT %Q0")), ElementsAre("2:1 W14"));
}

TEST(Host50Warnings, Resources) {
  std::string text = "LD 1\n";
  for (int i = 0; i <= 200; ++i) text += "NEG %QF" + std::to_string(i) + "\n";
  for (int i = 0; i <= 100; ++i) text += "TONS %TM" + std::to_string(i) + ", 1\n";
  EXPECT_THAT(WarningsOf(InNetwork(text)), ElementsAre("2:1 W14", "104:1 W15", "204:5 W15", "305:6 W15"));
}

TEST(Host50Warnings, Axes) {
  EXPECT_THAT(WarnedAfter("HOME 1, 3, 5.0\nHOME 2, 35, 5\nHOME 3, %W0, 5"), ElementsAre("4:9 W17"));
  EXPECT_THAT(WarnedAfter("VELP 2, 5\nSET %Q1001\nSET %Q1011\nMOV 1, %QW1\nMOV 1.5, %QF1"),
              ElementsAre("5:5 W21", "8:10 W21"));
  EXPECT_THAT(WarningsOf("OPTION AXISBASE=0\n" + InNetwork("LD 1\nVELP 2, 5\nSET %Q1002")), ElementsAre("6:5 W21"));
}

TEST(Host50Warnings, FloatEquality) {
  EXPECT_THAT(WarnedAfter("EQ %F0, 1\nNE %W0, 1\nCOMP %F0 = 1\nCOMP %F0 > 1\nCOMP 1.5 <> 2\nOUT %Q0"),
              ElementsAre("4:1 W20", "6:6 W20", "8:6 W20"));
}

TEST(Host50Warnings, Notes) {
  EXPECT_THAT(NotesOf(InNetwork("LD 1\nTPS %TM1, 5\nOUT %Q0")), ElementsAre("4:1 N01"));
  const std::string rot = "LD 1\nROT 8, %W0, 2, %W1, M=0\n";
  EXPECT_THAT(NotesOf(InNetwork(rot + "OUT %Q0")), ElementsAre("4:1 N02"));
  EXPECT_THAT(NotesOf(InNetwork(rot)), IsEmpty());
  EXPECT_THAT(NotesOf(InNetwork(rot + "RUNG\nLD 1\nOUT %Q0")), IsEmpty());
  EXPECT_THAT(NotesOf(InNetwork("LD 1\nMPS\nROT 8, %W0, 2, %W1, M=0\nMPP\nOUT %Q0")), IsEmpty());
  EXPECT_THAT(
      NotesOf("SLOW\nNETWORK\nLADDER\n|-{ROT 8, 1, 2, %W1, M=0}\n|-{ROT 8, 1, 2, %W1, M=0}-( %Q0 )\nEND_LADDER\n"
              "END_SLOW"),
      ElementsAre("5:3 N02"));
  const std::string labels = "SLOW\nNETWORK L1\nLD %I0\nLBL J2\nNETWORK L2\nEND_SLOW";
  EXPECT_THAT(NotesOf(labels), IsEmpty());
  EXPECT_THAT(NotesOf(labels, {.enabled = {"N05"}}), ElementsAre("2:1 N05"));
}

TEST(Host50Warnings, Encodings) {
  const source::Encoding encodings[] = {source::Encoding::kUtf8, source::Encoding::kGb18030};
  const source::LoadOptions options = {.encodings = encodings,
                                       .detection = source::Detection::kFallback,
                                       .fallback = source::Encoding::kGb18030,
                                       .undecodable = source::Undecodable::kByTheDialect};
  Parsed parsed;
  const auto loaded =
      parsed.sources.AddBytes("a.il", "; \xB1\xC3\nSLOW\nNETWORK\nLD 1 ; \xFF\nOUT \xFF\nEND_SLOW\n", options);
  const source::FileId file = std::get<source::FileId>(loaded);
  parsed.program = Parse(parsed.sources, std::vector{file}, {}, parsed.diagnostics);
  CheckProgram(parsed.program, parsed.sources, parsed.diagnostics);
  parsed.diagnostics.SortBySource();
  EXPECT_THAT(parsed.Notes(), ElementsAre("1:1 N06"));
  EXPECT_THAT(parsed.Errors(), ElementsAre("4:8 E111", "5:5 E111"));
}

}  // namespace
}  // namespace plcxx::host50
