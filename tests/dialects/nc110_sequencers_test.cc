// W354: which counters can stop between two steps.
#include "tests/dialects/nc110_parsing.h"
#include "transpiler/dialects/nc110/analysis/warnings.h"

namespace plcxx::nc110 {
namespace {

bool CanStall(const std::string& text) {
  source::SourceManager sources;
  diag::Engine diagnostics;
  const std::vector<source::FileId> files = {sources.AddText("logic", "$\n" + text)};
  const Program program = Parse(sources, files, {}, diagnostics);
  EXPECT_FALSE(diagnostics.HasErrors()) << text;
  CheckSequencers({program, {}, sources, {}, {}}, diagnostics);
  for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.row->code == "nc110-W354") return true;
  }
  return false;
}

// covers: NC110-171 NC110-232
TEST(Nc110Sequencers, StallWhereTwoStepsHoldTheInput) {
  EXPECT_TRUE(CanStall("C5I(4)=[C5W=0]*I0A0+[C5W=1]*I0A1+[C5W=2]*I0A2+[C5W=3]*I0A3"));
  EXPECT_TRUE(CanStall("C5I(4)=I0A9*[0=C5W]+I0A1*/I0A2*[C5W=1]")) << "in any order";
  EXPECT_TRUE(CanStall("C5I(4)=[C5W=0]*I0A0+[C5W=1]*/P6")) << "the complement of a pulse is nearly always 1";
}

TEST(Nc110Sequencers, GoOnWhereTheInputFalls) {
  EXPECT_FALSE(CanStall("C5I(2)=[C5W=0]*I0A0+[C5W=1]*/U0A0")) << "I and U are one bit";
  EXPECT_FALSE(CanStall("P6=I0A1\nC5I(4)=[C5W=0]*I0A0+[C5W=1]*P6")) << "a pulse";
  EXPECT_FALSE(CanStall("C5I(4)=[C5W=0]*I0A0+[C5W=2]*I0A1")) << "not successive";
  EXPECT_FALSE(CanStall("C5I(4)=[C6W=0]*I0A0+[C6W=1]*I0A1")) << "another count";
  EXPECT_FALSE(CanStall("C5I(4)=I0A0+I0A1"));
}

}  // namespace
}  // namespace plcxx::nc110
