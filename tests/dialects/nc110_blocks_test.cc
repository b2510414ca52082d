// Blocks: matching, names, chains, files, and their errors.
#include "tests/dialects/nc110_parsing.h"

namespace plcxx::nc110 {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

void ExpectBlockErrors(const std::vector<Wrong>& table) {
  for (const Wrong& wrong : table) {
    ExpectWrong(wrong);
  }
}

// covers: NC110-183 NC110-184 NC110-186 NC110-187 NC110-188 NC110-190 NC110-194 NC110-201 NC110-250
TEST(Nc110Blocks, Chains) {
  EXPECT_THAT(
      ItemsOf("DOF 0: I0A0\n DOF B11: I0A1 END F\n DOE P1: I0A2 END E P1\nENDF 0\n; comment\nDOE: I0A3\nENDE DOE: "
              "U1K0=I0A1 ENDE"),
      ElementsAre("DOF '0' level 1: I0A0", "DOF 'B11' level 2: I0A1", "ENDF of #1", "DOE 'P1' level 2 after #1: I0A2",
                  "ENDE 'P1' of #2", "ENDF '0' of #0", "DOE level 1 after #0: I0A3", "ENDE of #3",
                  "DOE level 1 after #3: always", "assign U1K0 I0A1", "ENDE of #4"));
  EXPECT_THAT(ItemsOf("DOF: I0A0 ENDF U4A3 = I0A1"),
              ElementsAre("DOF level 1: I0A0", "ENDF of #0", "assign U4A3 I0A1"));
  EXPECT_THAT(ItemsOf("DOF: I0A0 ENDF T3I(5) = I0A1"),
              ElementsAre("DOF level 1: I0A0", "ENDF of #0", "assign T3I [5] I0A1"));
  EXPECT_THAT(ItemsOf("DOF: I0A0 ENDF\nU4A3 = I0A1").size(), 3u);
}

// covers: NC110-189
TEST(Nc110Blocks, AbsentConditionOfDoe) {
  for (const char* head : {"DOE:\n", "DOE: ; comment\n", "DOE:   \n"}) {
    EXPECT_THAT(ItemsOf("DOF:I0A0 ENDF " + std::string(head) + "U1K0=I0A1 ENDE"),
                ElementsAre("DOF level 1: I0A0", "ENDF of #0", "DOE level 1 after #0: always", "assign U1K0 I0A1",
                            "ENDE of #1"))
        << head;
  }
  for (const char* body : {"U1K0 = I0A1", "/U1K0=I0A1", "T5I (3)=I0A1", "MSG 5 x\n", "DOF:I0A1 ENDF", ""}) {
    const std::vector<std::string> items = ItemsOf("DOF:I0A0 ENDF DOE: " + std::string(body) + " ENDE");
    EXPECT_EQ(items[2], "DOE level 1 after #0: always") << body;
  }
  EXPECT_EQ(ItemsOf("DOF:I0A0 ENDF DOE: /I0A1 U1K0=I0A2 ENDE")[2], "DOE level 1 after #0: (not I0A1)");
  EXPECT_EQ(ItemsOf("DOF:I0A0 ENDF DOE: /(I0A1) U1K0=I0A2 ENDE")[2], "DOE level 1 after #0: (not I0A1)");
}

// covers: NC110-191 NC110-192 NC110-195 NC110-196 NC110-197 NC110-198 NC110-199 NC110-251
TEST(Nc110Blocks, Errors) {
  ExpectBlockErrors({
      {"DOF A: I0A0\nENDF B", "2:6 nc110-41", {"block name"}},
      {"DOF: I0A0\nENDF B", "2:6 nc110-41", {"block name"}},
      {"DOF a: I0A0\nENDF A", "2:6 nc110-41", {"block name"}},
      {"DOF A: I0A0\nDOF B: I0A0\nENDF A", "3:6 nc110-41", {"block name"}},
      {"DOF: I0A0\nENDE", "2:1 nc110-42", {"ENDE", "mismatch"}},
      {"DOF: I0A0 ENDF\nDOE: I0A1\nENDF", "3:1 nc110-42", {"ENDF", "mismatch"}},
      {"U4A0=I0A0\nDOF: I0A0\nU4A1=I0A0", "2:1 nc110-43", {"ENDF", "missing"}},
      {"DOF: I0A0 ENDF\nDOE: I0A1", "2:1 nc110-43", {"ENDE", "missing"}},
      {"DOF: I0A0\n$\nENDF", "1:1 nc110-43", {"ENDF", "missing"}},
      {"U4A0=I0A0\nENDF", "2:1 nc110-44", {"without"}},
      {"DOE: I0A0\nENDE", "1:1 nc110-45", {"DOE", "DOF"}},
      {"DOF: I0A0\nENDF\nU4A0=I0A0\nDOE: I0A1 ENDE", "4:1 nc110-45", {"DOE", "DOF"}},
      {"DOF: I0A0\nENDF\n$\nDOE: I0A1 ENDE", "4:1 nc110-45", {"DOE", "DOF"}},
      {"DOF: I0A0\nDOE: I0A1 ENDE\nENDF", "2:1 nc110-45", {"DOE", "DOF"}},
      {"DOF: I0A0\nENDF\nMSG 5 x\nDOE: I0A1 ENDE", "4:1 nc110-45", {"DOE", "DOF"}},
  });
}

std::vector<std::string> ErrorsIn(const std::string& text) {
  Parsed parsed;
  ParseInto(parsed, {text});
  return parsed.Errors();
}

/// One head or end that is missing or misspelt is one error.
TEST(Nc110Blocks, OneErrorForOneCause) {
  EXPECT_THAT(ErrorsIn("DOF A:I0A0\nU4A0=I0A1\nDOE:\nU4A1=I0A1\nENDE\n"), ElementsAre("1:1 nc110-43"));
  EXPECT_THAT(ErrorsIn("DOF A:I0A0\nU4A0=I0A1\nFNDF A\nDOE:\nU4A1=I0A1\nENDE\n"), ElementsAre("1:1 nc110-43"));
  EXPECT_THAT(ErrorsIn("DOF A:I0A0\nDOE:\nU4A1=I0A1\nENDE\nENDF\n"), ElementsAre("2:1 nc110-45"));
  EXPECT_THAT(ErrorsIn("DOF A:I0A0\nFNDF\nU4A1=I0A1\nENDF\n"), ElementsAre("2:1 nc110-1"));
  EXPECT_THAT(ErrorsIn("D0F A: I0A0\nU4A0=I0A1\nENDF A\nDOE:\nU4A1=I0A1\nENDE\n"), ElementsAre("1:1 nc110-1"));
  EXPECT_THAT(ErrorsIn("DOF A:I0A0\nENDF\nELSE:\nU4A1=I0A1\nENDE\n"), ElementsAre("3:1 nc110-1"));
  EXPECT_THAT(ErrorsIn("IF I0A0:\nU4A0=I0A1\nENDF\n"), ElementsAre("1:1 nc110-1"));
}

// covers: NC110-193
TEST(Nc110Blocks, Nesting) {
  const auto nested = [](int levels) {
    std::string text;
    for (int i = 0; i < levels; ++i) {
      text += "DOF: I0A0\n";
    }
    for (int i = 0; i < levels; ++i) {
      text += "ENDF\n";
    }
    return text;
  };
  EXPECT_EQ(ItemsOf(nested(9)).size(), 18u);
  ExpectWrong({nested(10), "10:1 nc110-40", {"nesting"}});
  ExpectWrong({nested(300), "10:1 nc110-40", {"nesting"}});
}

// covers: NC110-202
TEST(Nc110Blocks, Warnings) {
  EXPECT_THAT(WarningsOf("$\nDOF:I0A0 ENDF DOE:\nENDE\nDOE: I0A1\nENDE"), ElementsAre("4:1 nc110-W340"));
  EXPECT_THAT(WarningsOf("$\nDOF CLAMP01: I0A0\nENDF CLAMP02"), ElementsAre("3:6 nc110-W341"));
  EXPECT_THAT(WarningsOf("$\nDOF CLAMP1: I0A0\nENDF CLAMP1"), IsEmpty());
}

// covers: NC110-203
TEST(Nc110Blocks, Dow) {
  ExpectWrong({"DOW: I0A0\nU4A0=I0A0\nENDW", "1:1 nc110-NC104", {"DOW"}});
  ExpectWrong({"U4A0=I0A0\nENDW", "2:1 nc110-NC104", {"DOW"}});
  ParseOptions options;
  options.enable_dow = true;
  EXPECT_THAT(ItemsOf("DOW L: I0A0 U4A0=I0A0 END W L", options),
              ElementsAre("DOW 'L' level 1: I0A0", "assign U4A0 I0A0", "ENDW 'L' of #0"));
  ExpectWrong({"DOW:\nENDW", "1:4 nc110-2", {"condition expected"}}, options);
  ExpectWrong({"DOW: I0A0 ENDW\nDOE: I0A1 ENDE", "2:1 nc110-45", {"DOE"}}, options);
  ExpectWrong({"DOW: I0A0\nENDF", "2:1 nc110-42", {"mismatch"}}, options);
}

TEST(Nc110Blocks, ContinueInTheNextFile) {
  Parsed parsed;
  ParseInto(parsed, {"$\nDOF: I0A0\nU4A0=I0A0", "U4A1=I0A0\nENDF", "DOE: I0A1\nENDE"});
  EXPECT_THAT(parsed.Errors(), IsEmpty());
  EXPECT_THAT(parsed.Warnings(), ElementsAre("2:1 nc110-W304"));
  EXPECT_EQ(parsed.program.blocks[BlockId(0)].next, BlockId(1));
  EXPECT_EQ(parsed.program.blocks[BlockId(0)].end, ItemId(4));
}

TEST(Nc110Blocks, NamesOf128Characters) {
  const std::string name(128, 'A');
  EXPECT_EQ(ItemsOf("DOF " + name + ": I0A0 ENDF " + name).size(), 2u);
  ExpectWrong({"DOF " + name + "A: I0A0\nENDF " + name, "1:5 nc110-2", {"block name"}});
}

}  // namespace
}  // namespace plcxx::nc110
