#include "tests/dialects/nc110_lowered.h"
#include "transpiler/dialects/nc110/control/locate.h"

namespace plcxx::nc110 {
namespace {

using dialects::Location;

TEST(Nc110Locate, OperandsSymbolsAndTheKeyboard) {
  LoweredProgram lowered;
  LowerInto(lowered,
            {"*\nPUMP=U4A8\nLONGNAME.10IGNORED=W1T0\nNEVER=T9U\n", "!PUMP=T5U*C5R*\"GO\"\nT5I(3)=1\nC5I(3)=1"});
  const auto at = [&](std::string_view text) { return Locate(ir::NameIndex(lowered.program()), text); };
  const auto pump = at("!PUMP"), same = at("PUMP"), bit = at("i04A08"), word = at("W3K0");
  ASSERT_TRUE(pump && same && bit && word);
  EXPECT_EQ(pump->place.offset, 17u);
  EXPECT_EQ(pump->place.bit, 0);
  EXPECT_EQ(same->place.offset, pump->place.offset);
  EXPECT_EQ(bit->place.offset, pump->place.offset);
  EXPECT_EQ(word->place.type, ir::Type::kI8);
  EXPECT_EQ(lowered.program().spaces[word->place.space].name, "K");

  ASSERT_TRUE(at("!LONGNAME.1"));  // 10 characters count
  EXPECT_EQ(at("LONGNAME.1?")->place.offset, 4u);

  const auto elapsed = at("T5U"), count = at("C5W"), absent = at("T6U"), unused = at("NEVER"), shot = at("P6");
  ASSERT_TRUE(elapsed && count && absent && unused && shot);
  EXPECT_TRUE(elapsed->place.is_field());
  EXPECT_FALSE(elapsed->absent);
  EXPECT_EQ(count->place.type, ir::Type::kI8);
  EXPECT_TRUE(absent->absent);
  EXPECT_TRUE(unused->absent);
  EXPECT_TRUE(shot->absent);
  EXPECT_EQ(shot->place.type, ir::Type::kBit);

  ASSERT_TRUE(at("OPERATOR_TEXT"));
  EXPECT_TRUE(at("OPERATOR_TEXT")->text_input);
  for (const char* nothing : {"", "!", "I0A32", "W3K", "!U4A8", "UNKNOWN", "T255U"})
    EXPECT_FALSE(at(nothing)) << nothing;
}

TEST(Nc110Locate, ValuesInTheLanguagesSpelling) {
  EXPECT_EQ(ParseValue("33H"), 0x33u);
  EXPECT_EQ(ParseValue(" 377O "), 255u);
  EXPECT_EQ(ParseValue("022D"), 22u);
  EXPECT_EQ(ParseValue("1"), 1u);
  EXPECT_FALSE(ParseValue("0FF"));
  EXPECT_EQ(ParseValue("FFH"), 255u);
  EXPECT_FALSE(ParseValue(""));
}

TEST(Nc110Locate, TheLookOfTheLanguage) {
  for (const char* text : {"* symbols\n", "; comment\r\nU4A8 = I0A1\r\n", "/U4A8=I0A1", "T5I(30)=I0A1", " P6=I0A1",
                           "DOF A: I0A1", "C5W=3"}) {
    EXPECT_TRUE(Recognize(text)) << text;
  }
  for (const char* text :
       {"", "; U4A8=1\n", "LD %I0\nOUT %Q0\n", ":A I 10.1\n", "int plc1(void) { return 0; }\n", "x = 1;"}) {
    EXPECT_FALSE(Recognize(text)) << text;
  }
}

TEST(Nc110Dialect, LoadErrorsAndBudgetsHaveTheirCodes) {
  diag::Engine diagnostics;
  kNc110.report_load_error("a", {source::LoadProblem::kMissing, "no such file"}, diagnostics);
  kNc110.report_load_error("a", {source::LoadProblem::kTooLarge, "65 MB"}, diagnostics);
  source::SourceManager sources;
  sources.AddText("x", "another\n");
  const source::FileId first = sources.AddText("a", "; first\nU4A0=1\n");
  kNc110.report_over_budget(dialects::Budget::kFastUs, 7, 5, first, sources, diagnostics);
  kNc110.report_over_budget(dialects::Budget::kSlowMs, 7, 5, first, sources, diagnostics);
  kNc110.report_over_budget(dialects::Budget::kCodeKb, 7, 5, first, sources, diagnostics);
  std::vector<std::string> codes;
  for (const diag::Diagnostic& diagnostic : diagnostics.all()) codes.emplace_back(diagnostic.row->code);
  // covers: NC110-216 NC110-254
  EXPECT_THAT(codes, testing::ElementsAre("nc110-62", "nc110-51", "nc110-38", "nc110-39", "nc110-NC105"));
  EXPECT_EQ(sources.Locate(diagnostics.all()[2].range.begin).line, 1u);
  EXPECT_EQ(sources.Locate(diagnostics.all()[2].range.begin).file, first);
}

}  // namespace
}  // namespace plcxx::nc110
