// What scenarios expect of the compiler.
#include "transpiler/scenarios/expected_diagnostics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "transpiler/scenarios/scenario.h"

namespace plcxx::scenarios {
namespace {

constexpr diag::Message<> kLabel{{"Label", "test-41", diag::Severity::kError, "no such Label", "define it"}};
constexpr diag::Message<> kUnused{{"Unused", "test-W356", diag::Severity::kWarning, "never read", "remove it"}};
constexpr diag::Message<> kOther{{"Other", "test-W302", diag::Severity::kWarning, "twice", "remove it"}};

Scenario ParsedRight(const std::string& text) { return std::get<Scenario>(ParseScenario("s.yaml", text)); }

/// Two files of four lines; diagnostics are given by their file and line.
struct Compiled {
  source::SourceManager sources;
  diag::Engine diagnostics;
  source::FileId files[2];

  Compiled() {
    files[0] = sources.AddText("dir/a.plc", "one\ntwo\nthree\nfour\n");
    files[1] = sources.AddText("dir/b.plc", "one\ntwo\nthree\nfour\n");
  }
  source::Range Line(int file, uint32_t line) const {
    const source::File& text = sources.Get(files[file]);
    const source::Offset begin = text.base + text.line_starts[line - 1];
    return {begin, begin + 3};
  }
  std::string Error(const std::string& yaml) {
    diagnostics.SortBySource();
    return CheckExpectedError(ParsedRight("expect_error: " + yaml), diagnostics, sources).value_or("as expected");
  }
  std::string Warnings(const std::string& yaml) {
    diagnostics.SortBySource();
    return CheckExpectedWarnings(ParsedRight("warnings: " + yaml), diagnostics, sources).value_or("as expected");
  }
};

TEST(ExpectedError, IsTheFirstOneOfTheSource) {
  Compiled compiled;
  compiled.diagnostics.Report(compiled.Line(1, 1), kLabel);
  compiled.diagnostics.Report(compiled.Line(0, 3), kLabel);
  compiled.diagnostics.Report(compiled.Line(0, 1), kUnused);
  EXPECT_EQ(compiled.Error("{line: 3, contains: LABEL}"), "as expected");
  EXPECT_EQ(compiled.Error("{contains: [such, label]}"), "as expected");
  EXPECT_EQ(compiled.Error("{line: 3, contains: test-41, file: a.plc}"), "as expected");
  EXPECT_EQ(compiled.Error("{line: 3, file: dir/a.plc}"), "as expected");
  EXPECT_EQ(compiled.Error("{line: 1, contains: label}"),
            "s.yaml:1:15: expected an error at line 1 that contains 'label', found first at line 3 of dir/a.plc: "
            "test-41 no such Label");
  EXPECT_EQ(
      compiled.Error("{line: 3, file: b.plc}"),
      "s.yaml:1:15: expected an error at line 3 of b.plc, found first at line 3 of dir/a.plc: test-41 no such Label");
  EXPECT_EQ(compiled.Error("{contains: [such, define]}"), "as expected");  // a word of the remedy
  EXPECT_EQ(compiled.Error("{contains: [such, nowhere]}"),
            "s.yaml:1:15: expected an error that contains 'such' and 'nowhere', found first at line 3 of dir/a.plc: "
            "test-41 no such Label");
}

TEST(ExpectedError, NoneIsAFailure) {
  Compiled compiled;
  compiled.diagnostics.Report(compiled.Line(0, 1), kUnused);
  EXPECT_EQ(compiled.Error("{line: 1}"), "s.yaml:1:15: expected an error at line 1, found no error");
}

TEST(ExpectedError, MayHaveNoPlace) {
  Compiled compiled;
  compiled.diagnostics.Report({}, kLabel);
  EXPECT_EQ(compiled.Error("{contains: label}"), "as expected");
  EXPECT_EQ(compiled.Error("{line: 1}"),
            "s.yaml:1:15: expected an error at line 1, found first: test-41 no such Label");
}

TEST(ExpectedWarnings, AreThereAndNowhereElse) {
  Compiled compiled;
  compiled.diagnostics.Report(compiled.Line(0, 2), kUnused);
  compiled.diagnostics.Report(compiled.Line(1, 3), kUnused);
  compiled.diagnostics.Report(compiled.Line(0, 4), kOther);
  EXPECT_EQ(compiled.Warnings("[{line: 2, code: W356}, {line: 3, code: test-w356, file: b.plc}]"), "as expected");
  EXPECT_EQ(compiled.Warnings("[{code: W356}]"), "as expected");
  EXPECT_EQ(compiled.Warnings("[{line: 4, code: W302}]"), "as expected");
  EXPECT_EQ(compiled.Warnings("[{line: 2, code: W356}]"),
            "s.yaml:1:12: warning W356 is also at line 3 of dir/b.plc, where it is not expected");
  EXPECT_EQ(compiled.Warnings("[{line: 3, code: W302}]"),
            "s.yaml:1:12: expected warning W302 at line 3, found none\n"
            "s.yaml:1:12: warning W302 is also at line 4 of dir/a.plc, where it is not expected");
  EXPECT_EQ(compiled.Warnings("[{code: 356}]"), "s.yaml:1:12: expected warning 356, found none");
  EXPECT_EQ(compiled.Warnings("[]"), "s.yaml: expected no warnings, found 3 warnings");
  EXPECT_EQ(Compiled().Warnings("[]"), "as expected");
}

}  // namespace
}  // namespace plcxx::scenarios
