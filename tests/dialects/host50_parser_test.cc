// The tree of correct programs: sections, operands, expressions, tables, comments, options.
// covers: HOST50-005 HOST50-006 HOST50-008 HOST50-010 HOST50-015..018 HOST50-021..024 HOST50-145 HOST50-230..235
#include "tests/dialects/host50_parsing.h"
#include "transpiler/dialects/host50/analysis/resources.h"
#include "transpiler/dialects/host50/source/recognize.h"

namespace plcxx::host50 {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> LinesOf(const std::string& text) {
  Parsed parsed;
  ParseInto(parsed, {text});
  EXPECT_THAT(parsed.Errors(), IsEmpty()) << text << "\n" << parsed.TextOfFirstError();
  std::vector<std::string> lines = parsed.Lines();
  lines.erase(lines.begin());  // slowdiv and channels
  return lines;
}

/// One instruction behind LD 1.
std::string One(const std::string& instruction) {
  const std::vector<std::string> lines = InstructionsOf(InNetwork("LD 1\n" + instruction + "\nRUNG"));
  return lines.size() > 1 ? lines[1] : "";
}

TEST(Host50Parser, SectionsAndNetworks) {
  EXPECT_THAT(
      LinesOf("slow \"main\"\nNetwork l0007 \"pump\"\nNETWORK\nend_SLOW\nSUB sr0 \"\"\nEND_SUB\nFAST\nEND_FAST"),
      ElementsAre("slow \"main\"", "network 7 labelled \"pump\"", "network 1", "sub SR0", "fast"));
}

TEST(Host50Parser, LettersAndZeros) {
  EXPECT_THAT(InstructionsOf(InNetwork("ld %i007\nAni %tm01.q\nOr %t2\nout %b00010")),
              ElementsAre("#0 LD %I7", "#1 ANDI %TM1.Q <- #0", "#2 OR %TM2.Q <- #1", "#3 OUT %B10 <- #2"));
}

TEST(Host50Parser, SpellingVariants) {
  EXPECT_EQ(One("GL %W0, 1\nTONS %TM1, 1"), "#1 GT %W0, 1 <- #0");
  EXPECT_EQ(One("WIOB 5, %B0, 4"), "#1 WTOB 5, %B0, 4 <- #0");
  EXPECT_EQ(One("TON %TM1, s, 3"), "#1 TON 1000ms %TM1, 3 <- #0");
  EXPECT_EQ(One("TOF %TM1, min, 3"), "#1 TOF 60000ms %TM1, 3 <- #0");
  EXPECT_EQ(One("TPMS %T001, %W3"), "#1 TP 100ms %TM1, %W3 <- #0");
}

TEST(Host50Parser, Symbols) {
  const std::string symbols =
      "SYMBOLS\n%I0 START \"s\"\"t\"\n%Q0 'axis4-'\n%TM1 T_RUN\n%C2 T_RUN.V\n%B5 泵\n%W9 \"no name\"\nEND_SYMBOLS\n";
  const std::string network = InNetwork(
      "LD START\nAND T_RUN\nAND 'T_RUN'.q\nAND 泵\nOUT axis4-\nMOV T_RUN.P, %W0\nMOV 'T_RUN'.V, %W0\n"
      "MOV 'T_RUN.V'.V, %W0");
  EXPECT_THAT(InstructionsOf(network + symbols),
              ElementsAre("#0 LD %I0:START", "#1 AND %TM1.Q:T_RUN <- #0", "#2 AND %TM1.Q:T_RUN <- #1",
                          "#3 AND %B5:泵 <- #2", "#4 OUT %Q0:axis4- <- #3", "#5 MOV %TM1.P:T_RUN, %W0 <- #3",
                          "#6 MOV %TM1.V:T_RUN, %W0 <- #3", "#7 MOV %C2.V:T_RUN.V, %W0 <- #3"));
  EXPECT_THAT(ErrorsOf(InNetwork("LD 1\nMOV T_RUN.V, %W0") + symbols), ElementsAre("4:5 E107"))
      << "a word is a symbol before it is one with an attribute";
}

TEST(Host50Parser, ConstantsTakeTheTypeOfTheirPlace) {
  EXPECT_EQ(One("ADDF 1, $FFFFFFFF, %F0"), "#1 ADDF 1.0, -1.0, %F0 <- #0");
  EXPECT_EQ(One("MOV 3000000000, %F0"), "#1 MOV 3e+09, %F0 <- #0");
  EXPECT_EQ(One("MOV 1.5, %W0"), "#1 MOV 1.5, %W0 <- #0");
  EXPECT_EQ(One("MOV $FFFFFFFF, %W0"), "#1 MOV -1, %W0 <- #0");
  EXPECT_EQ(One("EQ 1, %F0\nTONS %TM1, 1"), "#1 EQ 1.0, %F0 <- #0");
  EXPECT_EQ(One("POSA 1, 5, 100"), "#1 POSA 1, 5.0, 100.0 <- #0");
  EXPECT_EQ(One("POSA 1, %W0, 100"), "#1 POSA 1, %W0, 100.0 <- #0");
}

TEST(Host50Parser, Expressions) {
  EXPECT_EQ(One("OPRT %W0 = 1 + 2 * 3 - -4"), "#1 OPRT %W0, (- (+ 1 (* 2 3)) -4) <- #0");
  EXPECT_EQ(One("OPRT %W0 := (1 + 2) * +%W1"), "#1 OPRT %W0, (* (+ 1 2) %W1) <- #0");
  EXPECT_EQ(One("OPRT %F0 = 7 / 2"), "#1 OPRT %F0, (/ 7 2) <- #0");
  EXPECT_EQ(One("OPRT %F0 = 7 / 2.0 - %I0"), "#1 OPRT %F0, (- (/ 7 2.0)f %I0)f <- #0");
  EXPECT_EQ(One("OPRT \"%C1.V = -(%TM1.V | 3 & 1)\""), "#1 OPRT %C1.V, (negate (| %TM1.V (& 3 1))) <- #0");
  EXPECT_EQ(One("COMP %W1 & $0F <> %TM3\nTONS %TM1, 1"), "#1 COMP (<> (& %W1 15) %TM3.Q) <- #0");
  EXPECT_EQ(One("COMP %F0>=-1.5e1\nTONS %TM1, 1"), "#1 COMP (>= %F0 -15.0) <- #0");
}

TEST(Host50Parser, Tables) {
  EXPECT_THAT(LinesOf("TITLE\nauthor \"A \"\"B\"\"\"\nEND_TITLE\n"
                      "ALARMS\n%Q400 \"plain\"\n%Q401 warning \"注意-kept\"\n%Q0402 \"注意-oil - low\"\n%Q403 \"x-y\"\n"
                      "%Q404 \"\"\nEND_ALARMS\nMCODES\n008 \"coolant\"\nEND_MCODES"),
              ElementsAre("title AUTHOR \"A \"B\"\"", "alarm 0 NOTICE \"plain\"", "alarm 1 WARNING \"注意-kept\"",
                          "alarm 2 CAUTION \"oil - low\"", "alarm 3 NOTICE \"x-y\"", "alarm 4 NOTICE \"\"",
                          "mcode 8 \"coolant\""));
}

TEST(Host50Parser, SeveralFiles) {
  Parsed parsed;
  ParseInto(parsed, {"SLOW\nNETWORK\nLD A\nOUT %Q0\nCALL SR1\nEND_SLOW\n", "SYMBOLS\n%I3 A\nEND_SYMBOLS\n",
                     "SUB SR1\nEND_SUB"});
  EXPECT_THAT(parsed.Errors(), IsEmpty());
  EXPECT_THAT(parsed.Instructions(), ElementsAre("#0 LD %I3:A", "#1 OUT %Q0 <- #0", "#2 CALL SR1 <- #0"));
}

TEST(Host50Parser, Comments) {
  Parsed parsed;
  ParseInto(parsed, {"; of slow\nSLOW ; main\n; of network\nNETWORK\n; one\n\n; two\nLD 1 ; row\nOUT %Q0\n; end\n"
                     "END_SLOW"});
  EXPECT_THAT(parsed.Errors(), IsEmpty());
  const auto texts = [&](const Span& span) {
    std::vector<std::string> result;
    for (uint32_t i = 0; i < span.count; ++i) {
      const Comment& comment = parsed.program.comments[span.first + i];
      const std::string text(parsed.sources.Text(comment.range));
      result.push_back(comment.place == CommentPlace::kRow ? "row " + text : text);
    }
    return result;
  };
  const Section& section = parsed.program.sections[SectionId(0)];
  EXPECT_THAT(texts(section.comments), ElementsAre("; of slow", "row ; main"));
  EXPECT_THAT(texts(section.end_comments), ElementsAre("; end"));
  EXPECT_THAT(texts(parsed.program.networks[NetworkId(0)].comments), ElementsAre("; of network"));
  const auto& instructions = parsed.program.instructions;
  EXPECT_THAT(texts(instructions[InstructionId(0)].comments), ElementsAre("; one", "; two", "row ; row"));
  EXPECT_THAT(texts(instructions[InstructionId(1)].comments), IsEmpty());
}

TEST(Host50Parser, Options) {
  Parsed parsed;
  ParseInto(parsed, {"SLOWDIV 20\noption tp = iec\nOPTION ROTBASE=0\nSLOW\nEND_SLOW\n"},
            {{"slowdiv", "5"}, {"Rotq", "reverse"}});
  const Settings& settings = parsed.program.settings;
  EXPECT_EQ(settings.slowdiv, 5u);
  EXPECT_EQ(settings.tp, TpOption::kIec);
  EXPECT_EQ(settings.rotbase, RotBaseOption::kZero);
  EXPECT_EQ(settings.rotq, RotQOption::kReverse);
  EXPECT_EQ(settings.cnud, CnudOption::kRing);
}

TEST(Host50Parser, OptionsOfTheCommandLine) {
  const auto codes = [](const OptionMap& options) {
    diag::Engine diagnostics;
    CheckOptions(options, diagnostics);
    std::vector<std::string> result;
    for (const diag::Diagnostic& diagnostic : diagnostics.all()) result.emplace_back(diagnostic.row->code);
    return result;
  };
  EXPECT_THAT(codes({{"TP", "iec"}, {"slowdiv", "1000"}, {"Channels", "8"}, {"predefined", "On"}}), IsEmpty());
  EXPECT_THAT(codes({{"foo", "1"}}), ElementsAre("plcxx-2"));
  EXPECT_THAT(codes({{"TP", "5"}, {"slowdiv", "0"}}), ElementsAre("plcxx-3", "plcxx-3"));
}

TEST(Host50Parser, PredefinedSymbols) {
  const std::string program = InNetwork("LD NC_READY\nOUT %Q0");
  EXPECT_THAT(ErrorsOf(program), ElementsAre("3:4 E105"));
  EXPECT_THAT(InstructionsOf("OPTION PREDEFINED=ON\n" + program),
              ElementsAre("#0 LD %I520:NC_READY", "#1 OUT %Q0 <- #0"));
  EXPECT_THAT(InstructionsOf("OPTION PREDEFINED=ON\nSYMBOLS\n%B600 NC_READY\nEND_SYMBOLS\n" + program),
              testing::Contains("#0 LD %B600:NC_READY"))
      << "the program's own names win";
}

TEST(Host50Parser, Resources) {
  Parsed parsed;
  ParseInto(parsed, {InNetwork("LD %I0\nAND %I0\nAND %I1\nTONS %TM1, %W0\nRUNG\nLD %TM1\nEQ %W0, %IW3\n"
                               "BTOW %B0, %W1, 8\nOUT %Q0")});
  const std::vector<ResourceUse> uses = ResourcesOf(parsed.program);
  const auto used = [&](Resource resource) { return uses[static_cast<size_t>(resource)].used; };
  EXPECT_EQ(used(Resource::kPrograms), 1u);
  EXPECT_EQ(used(Resource::kNetworks), 1u);
  EXPECT_EQ(used(Resource::kInputBits), 2u);
  EXPECT_EQ(used(Resource::kBits), 8u);
  EXPECT_EQ(used(Resource::kWords), 2u);
  EXPECT_EQ(used(Resource::kInputWords), 1u);
  EXPECT_EQ(used(Resource::kTimers), 1u);
  EXPECT_EQ(used(Resource::kFunctionBlocks), 2u);
  EXPECT_EQ(used(Resource::kExpressions), 0u);
}

TEST(Host50Parser, Recognized) {
  EXPECT_TRUE(Recognize("; x\n  network L1\n"));
  EXPECT_TRUE(Recognize("SYMBOLS\nend_symbols"));
  EXPECT_FALSE(Recognize("U4A0=I0A0\n"));
  EXPECT_FALSE(Recognize(""));
}

}  // namespace
}  // namespace plcxx::host50
