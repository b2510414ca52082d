// Macros and includes: what lines they make, and where their faults are reported.
#include "transpiler/dialects/technol/parser/macros.h"

#include "tests/dialects/technol_parsing.h"
#include "tests/temporary_directory.h"

namespace plcxx::technol {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string WithMacros(std::string_view macros, std::string_view code) {
  return std::string(macros) + InProgram(kCells, code);
}

TEST(TechnolMacros, Arguments) {
  EXPECT_THAT(SplitArguments(" a , (b,c) ,'d,e',[f,g],"), ElementsAre("a", "(b,c)", "'d,e'", "[f,g]", ""));
  EXPECT_THAT(SplitArguments("  "), IsEmpty());
  EXPECT_THAT(SplitArguments(","), ElementsAre("", ""));
}

TEST(TechnolMacros, Expansion) {
  Macro macro;
  macro.parameters = {"P", "Q"};
  macro.locals = {"L"};
  const auto fold = [](std::string_view word) {
    std::string upper(word);
    for (char& c : upper) c = static_cast<char>(std::toupper(c));
    return upper;
  };
  const auto expanded = [&](std::string_view line) { return Expand(line, macro, {"X+1", "5"}, 7, fold); };
  EXPECT_EQ(expanded("L: LOD p ; P"), "L??7: LOD X+1 ");
  EXPECT_EQ(expanded("N&Q&_A: LOD PP.Q"), "N5_A: LOD PP.5");
  EXPECT_EQ(expanded("DB 'P'"), "DB 'P'");
  EXPECT_EQ(expanded("A & B"), "A & B");
  EXPECT_EQ(WrittenName("L??7"), "L");
  EXPECT_EQ(WrittenName("L??x"), "L??x");
  EXPECT_EQ(WrittenName("??7"), "??7");
}

TEST(TechnolMacros, Calls) {
  Parsed parsed;
  ParseInto(
      parsed,
      {WithMacros("PUT MACRO TO,N\nLOCAL END\nLOD CNST.N\nJL1 END\nSTO TO\nEND: ENDIT\nENDM\nENDIT MACRO\nNOP\nENDM\n",
                  "LDR A\nPUT X,5\nHERE: PUT W\n")});
  EXPECT_THAT(parsed.Errors(), ElementsAre("21:12 TE001")) << "an empty argument";
  EXPECT_THAT(parsed.Instructions(), ElementsAre("LDR A", "LOD CNST.5", "JL1 END", "STO BYTE.X", "NOP", "LOD",
                                                 "JL1 END", "STO WORD.W", "NOP"));
}

TEST(TechnolMacros, FaultsAreReportedAtTheCall) {
  Parsed parsed;
  ParseInto(parsed, {WithMacros("INNER MACRO P\nLOD P\nENDM\nOUTER MACRO P\nINNER P\nENDM\n", "OUTER NIC\n")});
  ASSERT_THAT(parsed.Errors(), ElementsAre("15:1 TE010"));
  const diag::Diagnostic& error =
      *std::ranges::find(parsed.diagnostics.all(), diag::Severity::kError, &diag::Diagnostic::severity);
  ASSERT_EQ(error.notes.size(), 2u);
  EXPECT_EQ(parsed.sources.Locate(error.notes[0].range.begin).line, 2u);
  EXPECT_EQ(parsed.sources.Locate(error.notes[1].range.begin).line, 5u);
}

TEST(TechnolMacros, Errors) {
  EXPECT_THAT(ErrorsOf(WithMacros("M MACRO\nM\nENDM\n", "M\n")), ElementsAre("12:1 TE018"));
  EXPECT_THAT(ErrorsOf(WithMacros("M MACRO P\nLOD P\nENDM\n", "M X,W\n")), ElementsAre("12:1 TE017"));
  EXPECT_THAT(ErrorsOf(WithMacros("LOD MACRO\nNOP\nENDM\nENDM\n", "NOP\n")), ElementsAre("1:1 TE005", "4:1 TE001"));
  EXPECT_THAT(ErrorsOf(InProgram("", "NOP\n") + "M MACRO\n"), IsEmpty()) << "behind STOP";
  EXPECT_THAT(ErrorsOf("M MACRO\nNOP\n" + InProgram("", "NOP\n")), ElementsAre("3:1 TE001"));
  std::string growing = "M0 MACRO P\nLOD P\nENDM\n";
  for (int i = 1; i <= 15; ++i) {
    const std::string inner = "M" + std::to_string(i - 1);
    growing += "M" + std::to_string(i) + " MACRO P\n" + inner + " P\n" + inner + " P\n" + inner + " P\n" + inner +
               " P\nENDM\n";
  }
  EXPECT_THAT(ErrorsOf(WithMacros(growing, "M15 X\n")), testing::Contains(HasSubstr("TE018"))) << "and it ends";
}

TEST(TechnolIncludes, FilesAreFound) {
  const testing_support::TemporaryDirectory directory;
  directory.Write("const.inc", "MAX EQU 5\nS STRUC\nF DW ?\nS ENDS\nM MACRO\nNOP\nENDM\n");
  directory.Write("kod.inc", "LOD X\n");
  directory.Write("kruh.inc", "T_INCLUDE KRUH.INC\n");
  const auto errors = [&](const std::string& text, Parsed& parsed) {
    directory.Write("main.plc", text);
    const auto loaded = parsed.sources.Load((directory.path() / "main.plc").string(), SourceOptions());
    parsed.request.files.push_back(std::get<source::FileId>(loaded));
    parsed.program = Parse(parsed.request, {});
    return parsed.Errors();
  };
  Parsed right, quoted, missing, code, ring;
  const std::string program = InProgram("X: DS MAX\n", "M\nLOD WORD.X.F\nSTO WORD.X\n");
  EXPECT_THAT(errors("T_INCLUDE CONST.INC\nT_INCLUDE Const.Inc ;again\n" + program, right), IsEmpty());
  quoted.request.system_include_directories = {directory.path().string()};
  EXPECT_THAT(errors("T_INCLUDE 'Const.inc'\n" + program, quoted), IsEmpty());
  EXPECT_THAT(errors("T_INCLUDE 'const.inc'\n" + program, missing), testing::Contains("1:11 TE015"));
  EXPECT_THAT(errors("T_INCLUDE kod.inc\n" + InProgram("X: DS 1\n", "LOD X\n"), code), ElementsAre("1:1 TE036"));
  EXPECT_THAT(errors("T_INCLUDE kruh.inc\n" + InProgram("X: DS 1\n", "LOD X\n"), ring), ElementsAre("1:11 TE016"));
}

}  // namespace
}  // namespace plcxx::technol
