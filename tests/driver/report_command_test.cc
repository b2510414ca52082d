// plcxx report: tables by name, by address, by statement.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

struct Table {
  Table() {
    work.Write("names.sym", "*\nZERO=U4A0\nDELAY=T5I\nADONE=T5U\nUNUSED=W27K0\n");
    work.Write("main.plc", "$\n!DELAY(30)=I0A0*/!ZERO\n!ZERO=!ADONE+I0A1*/!ADONE\n");
  }
  Workplace work;
};

// covers: NC110-044
TEST(Report, SymbolsByNameWithReadsAndWrites) {
  const Table table;
  const auto result = table.work.Run("report names.sym main.plc --print-symbols");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.out,
            "symbol            operand   reads  writes\n"
            "ADONE             T5U       2      0\n"
            "DELAY             T5I       0      1\n"
            "UNUSED            W27K0     0      0\n"
            "ZERO              U4A0      1      1\n");
}

// covers: NC110-227
TEST(Report, CrossReferenceNamesFilesAndLines) {
  const Table table;
  const auto result = table.work.Run("report names.sym main.plc --cross-reference");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out, HasSubstr("U4A0  ZERO"));
  EXPECT_THAT(result.out, HasSubstr("  written: main.plc:3\n  read:    main.plc:2\n"));
}

TEST(Report, CostsOfTheStatements) {
  const Table table;
  const auto result = table.work.Run("report names.sym main.plc --cost-listing");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out, HasSubstr("main.plc:2  !DELAY(30)=I0A0*/!ZERO\n"));
}

/// Two programs (FAST is one, SLOW is one), networks, distinct addresses, expressions, blocks that are counted.
constexpr std::string_view kLathe = R"(SYMBOLS
%B1 start "cycle start"
%W5 parts
END_SYMBOLS
FAST
NETWORK
LD %I3
OUT %Q4
END_FAST
SLOW
NETWORK
LD start
AND %I3
OUT %B2
NETWORK
LD %B2
TONS %TM1, 5
RUNG
LD %TM1.Q
OPRT parts = parts + %W6
END_SLOW
)";

// covers: HOST50-236
TEST(Report, ResourcesOfTheControlThatTheProgramUses) {
  Workplace work;
  work.Write("lathe.il", std::string(kLathe));
  const auto result = work.Run("report lathe.il --resources");
  EXPECT_EQ(result.code, 0) << result.errors;
  EXPECT_EQ(result.out,
            "resource          used    available\n"
            "programs          2       100\n"
            "networks          3       500\n"
            "bits              2       2000\n"
            "input bits        1       3000\n"
            "output bits       1       3000\n"
            "words             2       1200\n"
            "input words       0       300\n"
            "output words      0       300\n"
            "floats            0       200\n"
            "input floats      0       200\n"
            "output floats     0       200\n"
            "counters          0       50\n"
            "timers            1       100\n"
            "expressions       1       200\n"
            "symbols           2       3000\n"
            "function blocks   0       100\n");
  work.Write("turret.plc", "$\nU4A0=I0A1\n");
  EXPECT_EQ(work.Run("report turret.plc --resources").out,
            "Balt-System NC-110 ... NC-400 limits no resources of this kind\n");
}

// covers: HOST50-237
TEST(Report, AddressTableOfHost50) {
  Workplace work;
  work.Write("lathe.il", std::string(kLathe));
  const auto result = work.Run("report lathe.il --cross-reference");
  EXPECT_EQ(result.code, 0) << result.errors;
  EXPECT_THAT(result.out, HasSubstr("I3\n  written: -\n  read:    lathe.il:7 lathe.il:13\n"));
  EXPECT_THAT(result.out, HasSubstr("B2\n  written: lathe.il:14\n  read:    lathe.il:16\n"));
  EXPECT_THAT(result.out, HasSubstr("W5  parts\n  written: lathe.il:20\n  read:    lathe.il:20\n"));
}

/// A statement that works on a timer or counter writes it; what is latched for the slow part is still read there; a
/// choice of words is one write.
// covers: NC110-227 HOST50-237
TEST(Report, UsesOfInstancesCopiesAndChoices) {
  const Workplace work;
  work.Write("n.sym", "*\nRST=C5Z\nDOOR=I0A5\nOUT=W4A1\n");
  work.Write("n.plc",
             "$\n!RST=I0A1\nC5I(5)=I0A0\nU4A0=C5R*!DOOR\n!OUT=MUX(W0A1,W0A2,W0A3),(I0A0,I0A1,I0A2)\nC6I(3)=I0A0\n");
  const std::string latched = " --set slices=2 --set latch-slow-inputs=on";
  const Ran uses = work.Run("report n.sym n.plc --cross-reference" + latched);
  EXPECT_EQ(uses.code, 0) << uses;
  EXPECT_THAT(uses.out, HasSubstr("C5Z  RST\n  written: n.plc:2\n  read:    -\n"));
  EXPECT_THAT(uses.out, HasSubstr("C6I\n  written: n.plc:6\n  read:    -\n"));
  EXPECT_THAT(uses.out, HasSubstr("I0A5  DOOR\n  written: -\n  read:    n.plc:4\n"));
  const Ran symbols = work.Run("report n.sym n.plc --print-symbols" + latched);
  EXPECT_THAT(symbols.out, HasSubstr("DOOR              I0A5      1      0\n"));
  EXPECT_THAT(symbols.out, HasSubstr("OUT               W4A1      0      1\n"));
  EXPECT_THAT(symbols.out, HasSubstr("RST               C5Z       0      1\n"));

  work.Write("t.plc", ":MOD PM 9\n:A I 0.0\n:SE T 1\n: K 20D\n:A I 0.1\n:R T 1\n:L T 1\n:T OB 4\n:END PM 9\n");
  const Ran timers = work.Run("report --dialect prostep --cross-reference t.plc");
  EXPECT_EQ(timers.code, 0) << timers;
  EXPECT_THAT(timers.out, HasSubstr("T 1\n  written: t.plc:3 t.plc:6\n  read:    t.plc:7\n"));

  work.Write("t.il", "FAST\nNETWORK\nLD %I0\nTONS %TM1, 5\nOUT %Q0\nEND_FAST\n");
  const Ran elements = work.Run("report t.il --cross-reference");
  EXPECT_EQ(elements.code, 0) << elements;
  EXPECT_THAT(elements.out, HasSubstr("TM1\n  written: t.il:4\n"));
}

TEST(Report, APageWithoutATable) {
  const Table table;
  const auto result = table.work.Run("report names.sym main.plc -o out");
  EXPECT_EQ(result.code, 0) << result.errors;
  EXPECT_THAT(table.work.Files("out"), ElementsAre("main.html"));
  const std::string page = table.work.Read("out/main.html");
  EXPECT_THAT(page, HasSubstr("!DELAY(30)=I0A0*/!ZERO"));
  EXPECT_THAT(page, HasSubstr("OnDelay(m[T5], m[I0A0] &amp; !m[ZERO], 3000, m[now]);"));
  EXPECT_THAT(page, HasSubstr("<svg class=\"ladder\""));
  EXPECT_THAT(page, Not(HasSubstr(table.work.Path("main.plc"))));
  EXPECT_EQ(table.work.Run("report names.sym main.plc -o -").out, page) << "to standard output, the same";
}

TEST(Report, LadderPictures) {
  const Table table;
  EXPECT_EQ(table.work.Run("report names.sym main.plc --ladder -o out").code, 0);
  EXPECT_THAT(table.work.Files("out"), Contains("main.slow.svg"));
  EXPECT_THAT(table.work.Read("out/main.slow.svg"), HasSubstr(">ADONE</text>"));
  EXPECT_THAT(table.work.Run("report names.sym main.plc --ladder -o -").out, StartsWith("<svg xmlns="));
  EXPECT_EQ(table.work.Run("report names.sym main.plc --ladder --print-symbols").code, 2);
}

TEST(Report, NoPageOfAProgramWithErrors) {
  const Table table;
  table.work.Write("bad.plc", "$\nU4A0=(I0A0\n");
  EXPECT_EQ(table.work.Run("report bad.plc -o out").code, 1);
  EXPECT_FALSE(table.work.Has("out"));
  EXPECT_EQ(table.work.Run("report main.plc names.sym -o main.plc").code, 1)
      << "a file stands where the directory goes";
}

/// A direct output is a cell of the control, not a place in a memory: the tables of uses have to find it nevertheless.
TEST(Report, UsesOfDirectOutputs) {
  const Workplace work;
  work.Write("direct.plc", ":MOD PM 9\n:= P 7.6\n:END PM 9\n");
  const Ran symbols = work.Run("report --dialect prostep --print-symbols direct.plc");
  EXPECT_EQ(symbols.code, 0) << symbols;
  const Ran uses = work.Run("report --dialect prostep --cross-reference direct.plc");
  EXPECT_EQ(uses.code, 0) << uses;
  EXPECT_THAT(uses.out, HasSubstr("P 7.6\n  written: direct.plc:2\n"));
}

TEST(Report, UsesInAMachineWithDirectOutputs) {
  const Workplace work;
  const std::string machine = PLCXX_ROOT "/samples/prostep/mill_fnd32/";
  std::string sources;
  for (const char* const name : {"mill", "texts", "fast", "loop", "magazine"}) sources += " " + machine + name + ".plc";
  const Ran symbols = work.Run("report --print-symbols" + sources);
  EXPECT_EQ(symbols.code, 0) << symbols;
  EXPECT_THAT(symbols.out, StartsWith("symbol "));
  const Ran uses = work.Run("report --cross-reference" + sources);
  EXPECT_EQ(uses.code, 0) << uses;
  EXPECT_THAT(uses.out, HasSubstr("\nP 3.0"));
}

// -o means the same everywhere: it was passed over, and the table went to standard output.
TEST(ReportCommand, ATableIsWrittenWhereItIsAskedFor) {
  const Workplace work;
  work.Write("a.plc", "$\nU4A8=I0A3\n");
  for (const std::string table :
       {"--cross-reference", "--print-symbols", "--resources", "--cost-listing", "--ladder-text"}) {
    const std::string shown = work.Run("report a.plc " + table).out;
    const Ran written = work.Run("report a.plc " + table + " -o table.txt");
    EXPECT_EQ(written.code, 0) << table << written;
    EXPECT_EQ(written.out, "") << table;
    EXPECT_EQ(work.Read("table.txt"), shown) << table;
    EXPECT_EQ(work.Run("report a.plc " + table + " -o -").out, shown) << table;
  }
  const Ran folder = work.Run("report a.plc --cross-reference -o tables");
  EXPECT_EQ(folder.code, 2) << folder;
  EXPECT_THAT(folder.errors, HasSubstr("name a file with an extension, or leave -o out"));
}

// Spelled as in the source, and inside a box, where no picture has it as a name.
TEST(ReportCommand, ASignalAsTheSourceSpellsIt) {
  const Workplace work;
  work.Write("a.sym", "* names\nSTART = I0A3\nLEVEL = W1K0\n");
  work.Write("a.plc", "$\nU4A8=!START\nW130K0=[!LEVEL+1]\nU4A10=I0A4\n");
  for (const std::string word : {"'!START'", "START", "i0a3", "I0A3"}) {
    const Ran ran = work.Run("report a.sym a.plc --ladder-text --signal " + word);
    EXPECT_THAT(ran.out, testing::AllOf(HasSubstr("U4A8"), testing::Not(HasSubstr("U4A10")))) << word << ran;
  }
  for (const std::string word : {"'!LEVEL'", "W1K0"}) {
    const Ran ran = work.Run("report a.sym a.plc --ladder-text --signal " + word);
    EXPECT_THAT(ran.out, testing::AllOf(HasSubstr("W130K0"), testing::Not(HasSubstr("U4A8")))) << word << ran;
  }
}

// A name that is none gave an empty ladder and exit code 0, as if nothing drove the signal.
TEST(ReportCommand, ASignalThatIsNone) {
  const Workplace work;
  work.Write("a.plc", "$\nU4A8=I0A3\n");
  const Ran wrong = work.Run("report a.plc --ladder-text --signal U4AA8");
  EXPECT_EQ(wrong.code, 2) << wrong;
  EXPECT_THAT(wrong.errors, HasSubstr("'U4AA8' is no location of nc110, did you mean 'U4A8'"));
  const Ran unused = work.Run("report a.plc --ladder-text --signal U4A9");
  EXPECT_EQ(unused.code, 0) << unused;
  EXPECT_THAT(unused.errors, HasSubstr("note: no rung names 'U4A9'"));
  EXPECT_EQ(work.Run("report a.plc --cross-reference --signal U4A8").code, 2);
}

}  // namespace
}  // namespace plcxx::driver
