// What is kept of a run is read back as that run; what another program has is left out.
#include "transpiler/soak/kept_runs.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/property_machine.h"
#include "transpiler/soak/findings.h"

namespace plcxx::soak {
namespace {

using Assignments = std::vector<std::pair<std::string, std::string>>;

class KeptRuns : public testing::Test {
 protected:
  KeptRuns() {
    request_.sources = {"machine.plc"};
    request_.texts["machine.plc"] = "$\nU4A0 = I0A0*[W1A0=7]\n";
    scenarios::MakeProveMachine(request_, machine_);
  }

  std::string Written(const Stimuli& stimuli) const {
    return ScenarioOf(machine_, request_, nullptr, "", "Kept.", stimuli);
  }
  std::string WhyNot(const std::string& text, const Stimuli& stimuli) const {
    return WhyNotReadBack(machine_, "run.yaml", text, stimuli);
  }

  compilation::CompilationRequest request_;
  scenarios::ProveMachine machine_;
};

TEST_F(KeptRuns, AreReadBackAsTheyAre) {
  ASSERT_TRUE(machine_.compilation.ok());
  const Stimuli runs[] = {
      {{.inputs = {}, .words = {{"I0A0", "1"}, {"W1A0", "7"}, {"I0A0", "0"}, {"I0A0", "1"}}, .slow = 1}},
      {{.inputs = {}, .words = {}, .ms = 30}, {.inputs = {}, .words = {}, .power_cycle = true}},
      {{.inputs = {}, .words = {{"I0A0", "1"}}, .power_cycle = true},
       {.inputs = {}, .words = {{"I0A0", "0"}}, .fast = 2, .power_cycle = true}},
      {{.inputs = {}, .words = {}, .slow = 1}, {.inputs = {}, .words = {{"I0A0", "1"}}}}};
  for (const Stimuli& run : runs) EXPECT_EQ(WhyNot(Written(run), run), "") << Written(run);
}

TEST_F(KeptRuns, AreRefusedWhenTheyAreReadAsAnotherOne) {
  const Stimuli run = {{.inputs = {}, .words = {{"I0A0", "1"}}, .slow = 1}};
  const Stimuli other = {{.inputs = {}, .words = {{"I0A0", "1"}}, .slow = 2}};
  EXPECT_EQ(WhyNot(Written(run), other), "it is read as another run");
  EXPECT_NE(WhyNot("garbage: [", run), "");
  const Stimuli renamed = {{.inputs = {}, .words = {{"KOPEN", "1"}}, .slow = 1}};
  EXPECT_NE(WhyNot(Written(renamed), renamed).find("'KOPEN' is no location"), std::string::npos);
}

TEST_F(KeptRuns, OfAnotherProgramSayWhatThisOneHas) {
  std::vector<Stimuli> runs = {
      {{.inputs = {}, .words = {{"KOPEN", "1"}, {"I0A0", "1"}, {"W1A0", "300"}, {"W1A0", "7"}}, .slow = 1}}};
  EXPECT_EQ(FitTo(machine_.compilation, runs), (std::set<std::string>{"KOPEN", "W1A0"}));
  EXPECT_EQ(runs.front().front().words, (Assignments{{"I0A0", "1"}, {"W1A0", "7"}}));
  EXPECT_EQ(WhyNot(Written(runs.front()), runs.front()), "");
}

TEST_F(KeptRuns, HaveWholePeriodsWhereTheControlTakesNoOthers) {
  dialects::Dialect dialect = *machine_.compilation.dialect;
  dialect.whole_periods = true;
  machine_.compilation.dialect = &dialect;
  const uint32_t period = machine_.compilation.program.schedule.period_ms;
  ASSERT_GT(period, 1U);
  std::vector<Stimuli> runs = {
      {{.inputs = {}, .words = {}, .ms = period + 1}, {.inputs = {}, .words = {}, .ms = period}}};
  FitTo(machine_.compilation, runs);
  EXPECT_EQ(runs.front()[0].ms, 2 * period);
  EXPECT_EQ(runs.front()[1].ms, period);
}

}  // namespace
}  // namespace plcxx::soak
