// Symbol files and symbols in programs.
#include "tests/dialects/nc110_parsing.h"

namespace plcxx::nc110 {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A symbol file and a program.
std::vector<std::string> ItemsWith(const std::string& symbols, const std::string& text) {
  Parsed parsed;
  ParseInto(parsed, {"* names\n" + symbols, "$\n" + text});
  EXPECT_THAT(parsed.Errors(), IsEmpty()) << parsed.TextOfFirstError();
  std::vector<std::string> items = parsed.Items();
  return {items.begin() + parsed.program.symbols.size(), items.end()};
}

void ExpectSymbolFileWrong(const Wrong& wrong) {
  Parsed parsed;
  ParseInto(parsed, {"*\n" + wrong.program});
  EXPECT_THAT(parsed.Errors(), ElementsAre(wrong.error)) << wrong.program;
  for (const std::string& word : wrong.words) {
    EXPECT_THAT(Lower(parsed.TextOfFirstError()), testing::HasSubstr(Lower(word))) << wrong.program;
  }
}

// covers: NC110-002 NC110-029 NC110-030 NC110-031 NC110-032 NC110-033 NC110-034 NC110-035 NC110-037 NC110-042
TEST(Nc110Symbols, StandForOperands) {
  EXPECT_THAT(ItemsWith("LAMP = U04A03 ; red\n\n; comment\nDELAY=T5I\n", "!LAMP=!DELAY !DELAY(30)=!LAMP"),
              ElementsAre("cycle-mark", "assign U4A3:!LAMP T5I:!DELAY", "assign T5I:!DELAY [30] U4A3:!LAMP"));
  EXPECT_THAT(ItemsWith("1.@#'?=W1K0\nCOUNT=C5W\nPULSE=P6\ncOUNT=W2K0", "!1.@#'?=[!COUNT+!cOUNT] U4A0=!PULSE"),
              ElementsAre("cycle-mark", "assign W1K0:!1.@#'? (add C5W:!COUNT W2K0:!cOUNT)", "assign U4A0 P6:!PULSE"));
  const std::string longest(127, 'A');
  EXPECT_THAT(ItemsWith(longest + "=I0A0\n", "U4A0=!" + longest).size(), 2u);
}

TEST(Nc110Symbols, TenCharactersAreSignificant) {
  EXPECT_THAT(ItemsWith("ABCDEFGHIJKLM=I0A0\nB=I0A0\n", "U4A0=!ABCDEFGHIJ*!ABCDEFGHIJXYZ*!B"),
              ElementsAre("cycle-mark", "assign U4A0 (and (and I0A0:!ABCDEFGHIJKLM I0A0:!ABCDEFGHIJKLM) I0A0:!B)"));
}

// A symbol counts as its operand in the look-ahead rules too.
TEST(Nc110Symbols, InLookAhead) {
  EXPECT_THAT(ItemsWith("A=U1K0\n", "DOF:I0A0 ENDF DOE: !A=I0A1 ENDE !A=I0A2"),
              ElementsAre("cycle-mark", "DOF level 1: I0A0", "ENDF of #0", "DOE level 1 after #0: always",
                          "assign U1K0:!A I0A1", "ENDE of #1", "assign U1K0:!A I0A2"));
}

// covers: NC110-034 NC110-040
TEST(Nc110Symbols, DefinitionErrors) {
  for (const Wrong& wrong : std::vector<Wrong>{
           {"LAMP U4A3", "2:6 nc110-46", {"symbol"}},
           {"LAMP", "2:5 nc110-46", {"symbol"}},
           {"=U4A3", "2:1 nc110-46", {"symbol"}},
           {"!LAMP=U4A3", "2:1 nc110-46", {"symbol"}},
           {"LAMP=", "2:6 nc110-46", {"symbol"}},
           {"LAMP=U4A3 U4A4", "2:11 nc110-46", {"symbol"}},
           {"LAMP=!OTHER", "2:6 nc110-46", {"symbol"}},
           {"LA-MP=U4A3", "2:3 nc110-46", {"symbol"}},
           {std::string(128, 'A') + "=U4A3", "2:1 nc110-46", {"symbol"}},
           {"LAMP=5", "2:6 nc110-1", {"operand"}},
           {"LAMP=U4A", "2:6 nc110-1", {"operand", "bit"}},
           {"LAMP=U32A0", "2:6 nc110-1", {"operand", "connector"}},
           {"LAMP=IOA7", "2:6 nc110-1", {"operand", "I0A7"}},
           {"LAMP=T255I", "2:6 nc110-50", {"timer number"}},
           {"LAMP=U4\u0410"
            "3",
            "2:8 nc110-NC103",
            {"Cyrillic"}},
           {"LAMP=U4A3\nX=U4A4\nLAMP=U4A5", "4:1 nc110-47", {"symbol", "twice"}},
           {"ABCDEFGHIJK=U4A3\nABCDEFGHIJX=U4A4", "3:1 nc110-47", {"symbol", "twice"}},
       }) {
    ExpectSymbolFileWrong(wrong);
  }
}

// covers: NC110-038
TEST(Nc110Symbols, TwiceAcrossFiles) {
  Parsed parsed;
  ParseInto(parsed, {"*\nLAMP=U4A3", "*\n\nLAMP=U4A3", "$\nU4A0=!LAMP"});
  EXPECT_THAT(parsed.Errors(), ElementsAre("3:1 nc110-47"));
}

// covers: NC110-039 NC110-043
TEST(Nc110Symbols, UseErrors) {
  ExpectWrong({"U4A0=!RESE", "1:6 nc110-49", {"symbol", "not defined"}});
  ExpectWrong({"!LAMP=I0A0\n!LAMP=I0A1", "1:1 nc110-49", {"symbol", "not defined"}});
  ExpectWrong({"!LAMP(30)=[W1K0=3]\nU4A0=I0A1", "1:1 nc110-49", {"symbol", "not defined"}});
  ExpectWrong({"U4A0=! X", "1:6 nc110-46", {"symbol"}});
  ExpectWrong({"U4A0=!" + std::string(128, 'A'), "1:6 nc110-46", {"symbol"}});
  Parsed late;
  ParseInto(late, {"$\nU4A0=!LAMP", "*\nLAMP=U4A3", "U4A1=!LAMP"});
  EXPECT_THAT(late.Errors(), ElementsAre("2:6 nc110-49"));
}

// covers: NC110-036
TEST(Nc110Symbols, KeepTheRightsOfTheirOperand) {
  Parsed parsed;
  ParseInto(parsed,
            {"*\nIN=I0A0\nDONE=T5U\nT=T5I\nW=W1K0", "$\n!IN=I0A1\n!DONE=I0A1\n!T=I0A1\nU4A0=!W\nT5I(!IN)=I0A0"});
  EXPECT_THAT(parsed.Errors(), ElementsAre("2:1 nc110-3", "3:1 nc110-3", "4:3 nc110-2", "5:6 nc110-3", "6:5 nc110-3"));
}

// covers: NC110-041
TEST(Nc110Symbols, TableSize) {
  ParseOptions options;
  options.max_symbols = 2;
  Parsed parsed;
  ParseInto(parsed, {"*\nA=I0A0\nB=I0A1\nC=I0A2\nD=I0A3", "$\nU4A0=!D"}, options);
  EXPECT_THAT(parsed.Errors(), ElementsAre("4:1 nc110-48"));
  EXPECT_THAT(parsed.TextOfFirstError(), testing::HasSubstr("table"));
}

// covers: NC110-045
TEST(Nc110Symbols, FileBehindLogic) {
  Parsed parsed;
  ParseInto(parsed, {"$\nU4A0=I0A0", "*\nLAMP=U4A3", "U4A1=!LAMP"});
  EXPECT_THAT(parsed.Errors(), IsEmpty());
  EXPECT_THAT(parsed.Warnings(), ElementsAre("1:1 nc110-W360"));
}

TEST(Nc110Symbols, KeepTheirComment) {
  Parsed parsed;
  ParseInto(parsed, {"*\nLAMP = U4A3 ; red lamp\n", "$\nU4A0=!LAMP"});
  EXPECT_EQ(parsed.sources.Text(parsed.program.symbols[SymbolId(0)].comment), "; red lamp");
}

}  // namespace
}  // namespace plcxx::nc110
