#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/diagnostics/reporting.h"
#include "transpiler/diagnostics/terminal_text.h"

namespace plcxx::diag {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(RenderText, NothingWithoutDiagnostics) { EXPECT_EQ(Reporting("x").Text(), ""); }

TEST(RenderText, PlaceLineCaretAndHelp) {
  Reporting report("$\nU4A0=IOA7\n");
  report.engine.Report(report.Find("IOA7"), kBroken, "IOA7");
  EXPECT_EQ(report.Text(),
            "a.plc:2:6: error: 'IOA7' is broken [test-1]\n"
            "    2 | U4A0=IOA7\n"
            "      |      ^~~~\n"
            "      help: mend it\n"
            "1 error\n");
}

TEST(RenderText, WithoutPlace) {
  Reporting report("x");
  report.engine.Report({}, kBroken, "it");
  EXPECT_EQ(report.Text(), "error: 'it' is broken [test-1]\n      help: mend it\n1 error\n");
}

TEST(RenderText, Counts) {
  Reporting report("xyz");
  report.engine.Report(report.At(0, 1), kOdd);
  EXPECT_THAT(report.Text(), testing::EndsWith("\n1 warning\n"));
  report.engine.Report(report.At(1, 2), kBroken, "a");
  report.engine.Report(report.At(2, 3), kBroken, "b");
  EXPECT_THAT(report.Text(), testing::EndsWith("\n2 errors, 1 warning\n"));
}

TEST(RenderText, NotesHaveTheirOwnPlace) {
  Reporting report("(a\nb\n");
  Diagnostic& diagnostic = report.engine.Report(report.Find("b"), kOdd);
  diagnostic.notes.push_back({report.Find("("), "to match this '('"});
  diagnostic.notes.push_back({{}, "and that is all"});
  EXPECT_EQ(report.Text(),
            "a.plc:2:1: warning: this is odd [test-W7]\n"
            "    2 | b\n"
            "      | ^\n"
            "a.plc:1:1: note: to match this '('\n"
            "    1 | (a\n"
            "      | ^\n"
            "note: and that is all\n"
            "1 warning\n");
}

TEST(RenderText, FixIts) {
  Reporting report("АВ;\n");
  Diagnostic& diagnostic = report.engine.Report(report.At(0, 4), kOdd);
  diagnostic.fixits.push_back({report.At(0, 2), "A"});
  diagnostic.fixits.push_back({report.At(2, 4), "B"});
  diagnostic.fixits.push_back({report.At(4, 5), ""});
  diagnostic.fixits.push_back({report.At(4, 4), ")"});
  EXPECT_THAT(report.Text(), HasSubstr("      fix: replace 'А' by 'A'\n"
                                       "      fix: replace 'В' by 'B' at 1:2\n"
                                       "      fix: delete ';' at 1:3\n"
                                       "      fix: insert ')' at 1:3\n"));
}

TEST(RenderText, ATabBecomesBlanks) {
  Reporting report("\tab\tc");
  report.engine.Report(report.Find("c"), kOdd);
  EXPECT_THAT(report.Text(), HasSubstr("a.plc:1:5: "));
  EXPECT_THAT(report.Text(), HasSubstr("    1 |         ab      c\n"
                                       "      |                 ^\n"));
}

TEST(RenderText, WideAndCombiningCharacters) {
  Reporting wide(";刀具 x");
  wide.engine.Report(wide.Find("x"), kOdd);
  EXPECT_THAT(wide.Text(), HasSubstr("    1 | ;刀具 x\n      |       ^\n"));

  Reporting marked("刀具");
  marked.engine.Report(marked.Find("刀具"), kOdd);
  EXPECT_THAT(marked.Text(), HasSubstr("      | ^~~~\n"));

  Reporting combining(";и\u0306 x");
  combining.engine.Report(combining.Find("x"), kOdd);
  EXPECT_THAT(combining.Text(), HasSubstr("      |    ^\n"));
  EXPECT_THAT(combining.Text(), HasSubstr("a.plc:1:5: "));
}

TEST(RenderText, EndOfLineAndEndOfFile) {
  Reporting line("ab\r\ncd");
  line.engine.Report(line.At(2, 4), kOdd);
  EXPECT_THAT(line.Text(), HasSubstr("    1 | ab\n      |   ^\n"));

  Reporting file("ab\n");
  file.engine.Report(file.At(3, 3), kOdd);
  EXPECT_THAT(file.Text(), HasSubstr("a.plc:2:1: warning"));
  EXPECT_THAT(file.Text(), HasSubstr("    2 |\n      | ^\n"));

  Reporting empty("");
  empty.engine.Report(empty.At(0, 0), kOdd);
  EXPECT_THAT(empty.Text(), HasSubstr("    1 |\n      | ^\n"));
}

TEST(RenderText, ARangeOfSeveralLinesIsMarkedInItsFirst) {
  Reporting report("x abc\ndef");
  report.engine.Report(report.At(2, 9), kOdd);
  EXPECT_THAT(report.Text(), HasSubstr("    1 | x abc\n      |   ^~~\n"));
}

TEST(RenderText, LargeLineNumbersWidenTheGutter) {
  Reporting report(std::string(123455, '\n') + "x");
  report.engine.Report(report.Find("x"), kOdd);
  EXPECT_THAT(report.Text(), HasSubstr("\n123456 | x\n       | ^\n"));
}

TEST(RenderText, ControlsAreShownNotSent) {
  Reporting report("a\x1b[31mb\x07 \u202Ec\u200B", "evil\x1b.plc");
  report.engine.Report(report.Find("b"), kBroken, "\x1b[2J");
  const std::string text = report.Text();
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
  EXPECT_THAT(text, HasSubstr("evil<U+001B>.plc:1:7: error: '<U+001B>[2J' is broken"));
  EXPECT_THAT(text, HasSubstr("| a<U+001B>[31mb<U+0007> <U+202E>c<U+200B>\n      |              ^\n"));
}

TEST(RenderText, BytesThatAreNoUtf8) {
  Reporting report(
      "a\xFF"
      "z");
  report.engine.Report(report.Find("z"), kOdd);
  EXPECT_THAT(report.Text(), HasSubstr("| a<FF>z\n      |      ^\n"));
}

std::string LongestLine(const std::string& text) {
  std::string longest, line;
  for (const char c : text) {
    if (c == '\n') {
      if (CellsOf(line).size() > CellsOf(longest).size()) longest = line;
      line.clear();
    } else {
      line += c;
    }
  }
  return longest;
}

TEST(RenderText, LongLinesAreCroppedAroundTheCaret) {
  for (const size_t before : {size_t{0}, size_t{10}, size_t{50}, size_t{100}, size_t{30000}, size_t{60000}}) {
    const std::string text = std::string(before, 'a') + "HERE" + std::string(60000 - before, 'b');
    Reporting report(text);
    report.engine.Report(report.Find("HERE"), kOdd);
    const std::string shown = report.Text({.width = 80});
    EXPECT_LE(CellsOf(LongestLine(shown)).size(), 80u) << before;
    EXPECT_LT(shown.size(), 400u);
    // The caret stands below the word: same column in the two lines.
    const size_t line = shown.find(" | ") + 3;
    const size_t marker = shown.find(" | ", line) + 3;
    EXPECT_EQ(shown.find("HERE", line) - line, shown.find("^~~~\n", marker) - marker) << before;
    EXPECT_EQ(shown.substr(line, 3) == "...", before >= 50) << before;
  }
}

TEST(RenderText, ALongRangeIsCroppedToo) {
  Reporting report(std::string(60000, 'x'));
  report.engine.Report(report.At(0, 60000), kOdd);
  EXPECT_LE(LongestLine(report.Text({.width = 80})).size(), 80u);
}

TEST(RenderText, LongLinesOfWideAndInvalidCharacters) {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += "刀\xFF\t";
  Reporting report(text + "HERE" + text);
  report.engine.Report(report.Find("HERE"), kOdd);
  EXPECT_THAT(report.Text({.width = 60}), HasSubstr("HERE"));
  EXPECT_LT(report.Text({.width = 60}).size(), 600u);
}

TEST(RenderText, AVeryNarrowTerminal) {
  Reporting report(std::string(200, 'a') + "HERE" + std::string(200, 'b'));
  report.engine.Report(report.Find("HERE"), kOdd);
  EXPECT_THAT(report.Text({.width = 0}), HasSubstr("HERE"));
}

TEST(RenderText, NotesOfTheirOwn) {
  constexpr Message<> kNote{{"Note", "test-N1", Severity::kNote, "this was chosen", ""}};
  Reporting report("x");
  report.engine.Report(report.Find("x"), kNote);
  EXPECT_EQ(report.Text(), "a.plc:1:1: note: this was chosen [test-N1]\n    1 | x\n      | ^\n1 note\n");
}

TEST(RenderText, Colours) {
  Reporting report("x");
  report.engine.Report(report.Find("x"), kBroken, "x");
  const std::string text = report.Text({.colour = Colour::kOn});
  EXPECT_THAT(text, HasSubstr("\x1b[1;31merror:\x1b[0m "));
  EXPECT_THAT(text, HasSubstr("\x1b[1;32m^\x1b[0m\n"));
  EXPECT_THAT(report.Text(), Not(HasSubstr("\x1b")));
}

TEST(RenderText, PlacesInCyrillicTextOfAnyEncoding) {
  source::SourceManager sources;
  const auto loaded = sources.AddBytes("a.plc", ";\x91\xAC\xA0\xA7\xAA\xA0 x", {.encoding = source::Encoding::kCp866});
  const source::File& file = sources.Get(std::get<source::FileId>(loaded));
  Engine engine;
  const auto at = file.base + static_cast<source::Offset>(file.text.find('x'));
  engine.Report({at, at + 1}, kOdd);
  EXPECT_THAT(RenderText(sources, engine.all(), {}), HasSubstr("a.plc:1:9: warning"));
  EXPECT_THAT(RenderText(sources, engine.all(), {}), HasSubstr("    1 | ;Смазка x\n      |         ^\n"));
  EXPECT_THAT(RenderJson(sources, engine.all()), HasSubstr("\"byteOffset\": 8,"));
}

}  // namespace
}  // namespace plcxx::diag
