#include "tests/dialects/nc110_lowered.h"

namespace plcxx::nc110 {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string Dots(size_t count) { return std::string(count, '.'); }

std::vector<std::string> OptionProblems(const OptionMap& options) {
  diag::Engine diagnostics;
  kNc110.check_options(options, diagnostics);
  std::vector<std::string> codes;
  for (const diag::Diagnostic& diagnostic : diagnostics.all()) codes.emplace_back(diagnostic.row->code);
  return codes;
}

// covers: NC110-253
TEST(Nc110Options, KeysAndValuesAreChecked) {
  EXPECT_THAT(OptionProblems({{"clo", "10,2"},
                              {"cycle_ms", "8"},
                              {"slice_ms", "1"},
                              {"slices", "auto"},
                              {"latch-slow-inputs", "true"},
                              {"tim", "2"},
                              {"t-init", "01=F4, 64=00"},
                              {"old", "off"},
                              {"spl", "5"},
                              {"processes", "5"},
                              {"extern", "I50K3, W60K1"},
                              {"carry", "input"},
                              {"xor-prec", "above-or"},
                              {"stub-ms", "0"},
                              {"iocfil", "IOCFIL"}}),
              IsEmpty());
  EXPECT_THAT(OptionProblems({{"nonsense", "1"}}), ElementsAre("plcxx-2"));
  for (const auto& [key, value] : {std::pair{"clo", "10"},
                                   {"clo", "0,2"},
                                   {"cycle_ms", "0"},
                                   {"slices", "65"},
                                   {"slices", "0"},
                                   {"tim", "x"},
                                   {"old", "1"},
                                   {"processes", "6"},
                                   {"extern", "I50K"},
                                   {"carry", "never"},
                                   {"xor-prec", ""},
                                   {"messages", ""},
                                   {"t-init", "01F4"}}) {
    EXPECT_THAT(OptionProblems({{key, value}}), ElementsAre("plcxx-3")) << key << "=" << value;
  }
  // covers: NC110-054
  EXPECT_THAT(OptionProblems({{"t-init", "65=00"}}), ElementsAre("nc110-NC123"));
  EXPECT_THAT(OptionProblems({{"t-init", "01=100"}}), ElementsAre("nc110-NC123"));
}

// covers: NC110-053 NC110-214
TEST(Nc110Records, CharacterisationFilesAreRead) {
  const OptionMap files = {{"I", "; comment\n*1\nCLO = 20 , 4 ; clock\nSPL=2\n*4\nT01=F4\nT05=0AH\nT64=ff\nCLO=1,1\n"},
                           {"X", "TIM=7\n*1\nTIM=4\n"},
                           {"P", "*2\nOLD\n"}};
  const OptionMap options = {{"iocfil", "I"}, {"axcfil", "X"}, {"pgcfil", "P"}};
  LoweredProgram lowered;
  LowerInto(lowered, {"T50I(W30K0)=1"}, options, files);
  EXPECT_EQ(lowered.program().schedule.period_ms, 20u);
  EXPECT_EQ(lowered.program().schedule.slot_ms, 4u);
  EXPECT_TRUE(lowered.program().schedule.retention);
  const std::string text = ir::Print(lowered.program());
  EXPECT_THAT(text, HasSubstr("initial T 0 0xf4\ninitial T 4 0xa\ninitial T 63 0xff\n"));
  EXPECT_THAT(text, HasSubstr("const i32 4\n"));

  OptionMap explicit_options = options;
  explicit_options.insert({{"cycle_ms", "5"}, {"t-init", "01=01"}, {"old", "off"}, {"tim", "3"}});
  LoweredProgram overridden;
  LowerInto(overridden, {"T50I(W30K0)=1"}, explicit_options, files);
  EXPECT_EQ(overridden.program().schedule.period_ms, 5u);
  EXPECT_EQ(overridden.program().schedule.slot_ms, 4u);
  EXPECT_FALSE(overridden.program().schedule.retention);
  EXPECT_THAT(ir::Print(overridden.program()), HasSubstr("initial T 0 0x1\n"));

  // covers: NC110-041
  LoweredProgram symbols;
  LowerInto(symbols, {"*\nA=I0A1\nB=I0A2\nC=I0A3\n"}, options, files);
  EXPECT_THAT(symbols.Reported(), testing::Contains("4 nc110-48"));
}

// covers: NC110-054
TEST(Nc110Records, InitialValuesOutOfRange) {
  LoweredProgram lowered;
  LowerInto(lowered, {"U4A0=I0A0 $"}, {{"iocfil", "I"}}, {{"I", "*4\nT65=00\nT00=00\nT03=100\nT04=XY\n*5\nT99=1\n"}});
  EXPECT_THAT(lowered.Reported(), ElementsAre("2 nc110-NC123", "3 nc110-NC123", "4 nc110-NC123", "5 nc110-NC123"));
}

TEST(Nc110Records, MalformedRecordsAreRefused) {
  for (const char* record : {"CLO=,", "CLO=10", "CLO=0,2", "SPL=", "SPL=many"}) {
    LoweredProgram lowered;
    LowerInto(lowered, {"U4A0=I0A0 $"}, {{"iocfil", "I"}}, {{"I", std::string("*1\n") + record}});
    EXPECT_THAT(lowered.Reported(), ElementsAre("2 plcxx-3")) << record;
  }
}

TEST(Nc110Records, AMissingFileIsAnError) {
  LoweredProgram lowered;
  LowerInto(lowered, {"U4A0=I0A0 $"}, {{"iocfil", "I"}});
  EXPECT_THAT(lowered.Reported(), ElementsAre("0 nc110-62"));
}

// covers: NC110-221
TEST(Nc110Messages, TheMessageFile) {
  LoweredProgram lowered;
  LowerInto(lowered, {"U4A0=I0A0 $"}, {{"messages", "M"}},
            {{"M", "1#one\n15#\n16#x\nx#y\n1 #y\n1# y\nplain\n2#" + Dots(43) + "\n3#" + Dots(44) + "\n\n4#Привет\n"}});
  EXPECT_THAT(lowered.Reported(), ElementsAre("3 nc110-NC121", "4 nc110-NC121", "5 nc110-NC121", "6 nc110-NC121",
                                              "7 nc110-W361", "8 nc110-W361", "9 nc110-NC122"));
  const auto& texts = lowered.program().messages;
  ASSERT_EQ(texts.size(), 5u);
  EXPECT_EQ(texts[0].text, "one");
  EXPECT_EQ(texts[1].text, "");
  EXPECT_EQ(texts[2].number, 7u);
  EXPECT_EQ(texts[2].colour, 15u);
  EXPECT_EQ(texts[4].number, 11u);
  EXPECT_EQ(texts[4].text, "Привет");
}

TEST(Nc110Messages, AtMost255Lines) {
  std::string lines;
  for (int i = 0; i < 256; ++i) lines += "1#x\n";
  LoweredProgram lowered;
  LowerInto(lowered, {"U4A0=I0A0 $"}, {{"messages", "M"}}, {{"M", lines}});
  EXPECT_THAT(lowered.Reported(), ElementsAre("256 nc110-NC120"));
}

// covers: NC110-224
TEST(Nc110Messages, TheMenuFile) {
  LoweredProgram lowered;
  LowerInto(lowered, {"U4A0=I0A0 $"}, {{"menu", "M"}}, {{"M", "1#" + Dots(16) + "\n1#" + Dots(17) + "\n"}});
  EXPECT_THAT(lowered.Reported(), ElementsAre("2 nc110-NC122"));
  EXPECT_EQ(lowered.program().menu_texts.size(), 1u);
}

// covers: NC110-223 NC110-226
TEST(Nc110Messages, SelectedMessagesNeedTexts) {
  LoweredProgram lowered;
  LowerInto(lowered,
            {"MSG 40 \"declared\"\n$\nU21K0=I0A1\nU21K8=I0A1\nU22K7=I0A1\nU22K3=I0A1\nW17K3=3\nW17K3=W30K0\nW30K0=9\n"
             "W21K1=2\nW17K3=MUX(1,99),(I0A1,I0A2)"},
            {{"messages", "M"}}, {{"M", "1#one\n"}});
  EXPECT_THAT(lowered.Reported(), ElementsAre("1 nc110-W364", "4 nc110-W362", "6 nc110-W362", "7 nc110-W362",
                                              "10 nc110-W362", "11 nc110-W362"));
  ASSERT_EQ(lowered.program().messages.size(), 2u);
  EXPECT_EQ(lowered.program().messages[1].number, 40u);

  LoweredProgram without;
  LowerInto(without, {"$\nU21K0=I0A1"});
  EXPECT_THAT(without.Reported(), IsEmpty());
}

// covers: NC110-225 NC110-227
TEST(Nc110Help, DescriptionsJoinTheDocumentation) {
  LoweredProgram lowered;
  LowerInto(lowered, {"*\nDOOR=I0A1 ; closed\nUNUSED=T7U\n", "U4A0=!DOOR*I27K0*/I50K3*T5U\n$\n"}, {{"help", "H"}},
            {{"H", "<\nI50K3 - PANEL\nfirst line\nsecond line\n#\n<I0A1-X\ntext\n#\n"}});
  EXPECT_THAT(lowered.Reported(), testing::Not(testing::Contains("2 nc110-W358")));
  std::vector<std::string> entries;
  for (const ir::Documentation& entry : lowered.program().documentation) {
    entries.push_back(entry.address + "|" + entry.symbols + "|" + entry.predefined + "|" + entry.help);
  }
  EXPECT_THAT(entries, ElementsAre("I0A1|DOOR|X|text", "U4A0|||", "I27K0|||", "I50K3||PANEL|first line\nsecond line",
                                   "T5U|||", "T7U|UNUSED||"));
  EXPECT_EQ(lowered.program().documentation[0].meaning, "closed");
}

TEST(Nc110Help, MalformedEntriesAreWarned) {
  const std::pair<std::string, uint32_t> wrong[] = {{"stray\n", 1},
                                                    {"<\nnothing\nx\n#\n", 1},
                                                    {"<\nI0A1-X\nx\n", 1},
                                                    {"<\nI0A1-X\na<b\n#\n", 1},
                                                    {"<\nI0A1-X\n" + Dots(55) + "\nx\n#\n", 1},
                                                    {"<\nI0A1-X\n" + Dots(919) + "\n#\n", 1},
                                                    {"<\n#\n", 1}};
  for (const auto& [text, line] : wrong) {
    LoweredProgram lowered;
    LowerInto(lowered, {"U4A0=I0A0 $"}, {{"help", "H"}}, {{"H", text}});
    EXPECT_THAT(lowered.Reported(), ElementsAre(std::to_string(line) + " nc110-W363")) << text;
  }
  LoweredProgram fine;
  LowerInto(fine, {"U4A0=I0A0 $"}, {{"help", "H"}}, {{"H", "<\nI0A1-X\n" + Dots(918) + "\n#\n"}});
  EXPECT_THAT(fine.Reported(), IsEmpty());
}

// covers: NC110-227
TEST(Nc110Signals, PredefinedNamesShiftWithTheProcess) {
  LoweredProgram lowered;
  LowerInto(lowered, {"U10K20=I0K1 U4A0=I26K1 U36K20=0 $"}, {{"processes", "2"}});
  std::vector<std::string> entries;
  for (const ir::Documentation& entry : lowered.program().documentation) {
    entries.push_back(entry.address + " " + entry.predefined);
  }
  EXPECT_THAT(entries, ElementsAre("U4A0 ", "I0K1 RESE", "U10K20 RSPEPN", "I26K1 RESE", "U36K20 "));
}

}  // namespace
}  // namespace plcxx::nc110
