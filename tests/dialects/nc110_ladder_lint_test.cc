// W370: what the ladder editor cannot show; silent unless asked for.
#include "transpiler/dialects/nc110/analysis/ladder_lint.h"

#include "tests/dialects/nc110_parsing.h"

namespace plcxx::nc110 {
namespace {

std::vector<std::string> LadderWarnings(const std::string& text, diag::WarningOptions warnings) {
  source::SourceManager sources;
  diag::Engine diagnostics(std::move(warnings));
  const std::vector<source::FileId> files = {sources.AddText("symbols", "*\nLONGNAME=U4A5\nA23456789012345678=U4A6\n"),
                                             sources.AddText("logic", text)};
  const Program program = Parse(sources, files, {}, diagnostics);
  EXPECT_FALSE(diagnostics.HasErrors()) << text;
  LintLadder(sources, program, diagnostics);
  std::vector<std::string> result;
  for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.row->code == "nc110-W370") {
      result.push_back(diagnostic.text.substr(diagnostic.text.find(": ") + 2));
    }
  }
  return result;
}

// covers: NC110-228
TEST(Nc110LadderLint, OneReasonPerStatement) {
  diag::WarningOptions on;
  on.enabled.insert("W370");
  const std::string eight = "U4A0=I0A0*I0A1*I0A2*I0A3*I0A4*I0A5*[W1K0=3]";
  const std::vector<std::pair<std::string, std::string>> table = {
      {eight, ""},
      {eight + "*I0A7", "more than 8 input elements stand in series"},
      {"U4A0=" + std::string("I0A0+I0A0+I0A0+I0A0+I0A0+I0A0+I0A0+I0A0+I0A0+I0A0"), ""},
      {"DOF: I0A0*" + eight.substr(5) + " ENDF", "more than 8 input elements stand in series"},
      {"U4A0=!LONGNAME", "the name of an input element is longer than 7 characters"},
      {"!LONGNAME=I0A0", ""},
      {"!A23456789012345678=I0A0", "the name of an output is longer than 16 characters"},
      {"W1K0=[W1K0+W2K0]", ""},
      {"W1K0=[W1K0]", "arithmetic with other than two operands"},
      {"W1K0=[W1K0+1-W2K0]", "arithmetic with other than two operands"},
      {"W1K0=[ABS(W1K0)]", ""},
      {"U4A0=I0A0 ; " + std::string(70, 'x'), "a comment is longer than 60 characters"},
  };
  for (const auto& [text, reason] : table) {
    const std::vector<std::string> found = LadderWarnings("$\n" + text, on);
    EXPECT_EQ(found, reason.empty() ? std::vector<std::string>{} : std::vector<std::string>{reason}) << text;
    EXPECT_TRUE(LadderWarnings("$\n" + text, {}).empty()) << text;
  }
}

}  // namespace
}  // namespace plcxx::nc110
