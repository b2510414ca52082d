// What a machine of a fleet promises is kept by the simulator.
#include "transpiler/soak/wide_runs.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "transpiler/engines/platform.h"
#include "transpiler/scenarios/property_machine.h"
#include "transpiler/soak/simulated_machines.h"
#include "transpiler/soak/soak.h"
#include "transpiler/soak/trial.h"

namespace plcxx::soak {
namespace {

struct Program {
  const char* name;
  const char* text;
  bool takes_runs;  // one run does not reach everything
};

/// Counters, timers, edges, memory that is kept, a choice of cases: each takes several steps to get through.
constexpr Program kPrograms[] = {{"machine.plc", R"(
T1I(3) = I0A0
$
C1I(3) = I0A1
C1A = I0A2
P1 = C1R
T2I(20) = I0A3*T1U
U4A0 = U4A0*/I0A4 + P1
U4A1 = T2U*U4A0
W5A0 = W1A0
U4A2 = [W1A0=77]*U4A1
U50K0 = U50K0 + U4A2
U4A3 = U50K0*/I0A5
)",
                                  true},
                                 {"machine.il", R"(SLOWDIV 10
SLOW
NETWORK
LD %I0
TONMS %TM1, %IW0
RUNG
LD %TM1.Q
AND %I1
SET %Q0
LD %Q0
ANI %I2
OUT %Q1
LD %Q1
AND %I3
RST %Q0
END_SLOW
)",
                                  false}};

class WideRunsTest : public testing::TestWithParam<Program> {};

TEST_P(WideRunsTest, PromisesAreKept) {
  compilation::CompilationRequest request;
  request.sources = {GetParam().name};
  request.texts[GetParam().name] = GetParam().text;
  scenarios::ProveMachine machine;
  scenarios::MakeProveMachine(request, machine);
  ASSERT_TRUE(machine.compilation.ok());
  const Goals goals(machine.compilation.program);
  const WatchPlan plan(machine, {});
  const Inputs inputs(machine);
  std::vector<std::shared_ptr<const WideProgram>> widths;
  for (const unsigned lanes : {64U, 256U, 512U}) {
    if (lanes > fleet::WidestFleet()) continue;
    auto compiled = CompileWide(machine.compilation, nullptr, goals, plan,
                                {.compiler = engines::FindCompiler(), .level = "1", .lanes = lanes, .cache = {}});
    ASSERT_TRUE(std::holds_alternative<std::shared_ptr<const WideProgram>>(compiled))
        << std::get<std::string>(compiled);
    widths.push_back(std::get<std::shared_ptr<const WideProgram>>(compiled));
  }
  const auto wide = widths.front();
  WideMachines machines(wide), of_this_processor(widths.back());
  const std::unique_ptr<Machines> simulated = SimulatedMachines(machine.compilation, nullptr)(1);
  Words words(machine.compilation);
  Known known{.inputs = inputs,
              .plan = plan,
              .scenarios = {},
              .entries = {},
              .given = std::vector<uint8_t>(plan.program().insts.size()),
              .open = {},
              .standing = {},
              .gone = {},
              .causes = {}};
  size_t promises = 0, from_moments = 0;
  std::vector<uint8_t> given = known.given;
  for (uint64_t run = 1; run <= 12; ++run) {
    const WideRequest wanted{.run = run,
                             .of_machine = [run](uint32_t number) { return 1000 * run + number; },
                             .most_ms = 150,
                             .is_late = {}};
    const WideResult result = machines.Run(known, words, wanted), other = of_this_processor.Run(known, words, wanted);
    EXPECT_GT(result.parts, 0U);
    // What the processor has makes no difference.
    EXPECT_EQ(result.parts, other.parts);
    EXPECT_EQ(result.outputs.ones, other.outputs.ones);
    EXPECT_EQ(result.outputs.zeros, other.outputs.zeros);
    ASSERT_EQ(result.promises.size(), other.promises.size());
    for (size_t i = 0; i < other.promises.size(); ++i) {
      EXPECT_EQ(result.promises[i].mark, other.promises[i].mark);
      ASSERT_EQ(result.promises[i].stimuli.size(), other.promises[i].stimuli.size());
      for (size_t k = 0; k < other.promises[i].stimuli.size(); ++k)
        EXPECT_EQ(result.promises[i].stimuli[k].words, other.promises[i].stimuli[k].words);
    }
    for (const Promise& promise : result.promises) {
      ASSERT_TRUE(promise.mark);
      const Mark& mark = wide->noted.marks[*promise.mark];
      Trial trial(known, words, promise.from, promise.stimuli);
      Trial* const one = &trial;
      RunTrials(*simulated, {&one, 1});
      TrialResult kept = trial.Take();
      EXPECT_NE(kept.given[mark.inst.index] & mark.given, 0)
          << "run " << run << ", mark " << *promise.mark << ", instruction " << mark.inst.index;
      ++promises;
      from_moments += promise.from ? 1 : 0;
      for (size_t i = 0; i < given.size(); ++i) given[i] |= kept.given[i];
      for (Entry& entry : kept.entries) known.entries.push_back(std::make_shared<Entry>(std::move(entry)));
    }
    known.given = given;
  }
  EXPECT_GT(promises, 3U);
  EXPECT_EQ(from_moments > 0, GetParam().takes_runs);
  // The last of what takes several steps was reached.
  EXPECT_GE(goals.Reached(given).Count() * 10, goals.all().size() * 9);
}

/// A soak whose time is over, or whose hours are, in its first generation.
Soaked SoakOnce(SoakRequest& request, const scenarios::ProveMachine& machine) {
  const Goals goals(machine.compilation.program);
  const WatchPlan plan(machine, {});
  const Inputs inputs(machine);
  auto compiled = CompileWide(machine.compilation, nullptr, goals, plan,
                              {.compiler = engines::FindCompiler(), .level = "1", .lanes = 64, .cache = {}});
  EXPECT_TRUE(std::holds_alternative<std::shared_ptr<const WideProgram>>(compiled));
  request.wide = std::get<std::shared_ptr<const WideProgram>>(compiled);
  return Soak(request, goals, inputs, plan);
}

TEST(WideSoak, WhatWasSeenBeforeTheEndIsLookedAt) {
  compilation::CompilationRequest request;
  request.sources = {kPrograms[0].name};
  request.texts[kPrograms[0].name] = kPrograms[0].text;
  scenarios::ProveMachine machine;
  scenarios::MakeProveMachine(request, machine);
  ASSERT_TRUE(machine.compilation.ok());
  SoakRequest wanted{.machine = machine,
                     .request = request,
                     .scenarios = {},
                     .corpus = {},
                     .make = SimulatedMachines(machine.compilation, nullptr),
                     .wide = {},
                     .plant = {},
                     .machines = kWideMachines,
                     .machine_ms = uint64_t{kWideMachines} * 1'000,
                     .end = {},
                     .is_asked_to_end = {},
                     .until = {},
                     .directory = {},
                     .is_taken = {},
                     .progress = {}};
  const Soaked whole = SoakOnce(wanted, machine);
  // And what is repeated.
  EXPECT_LT(whole.machine_ms / kWideMachines, 1'100U) << "a wait goes further than the hours";
  EXPECT_GT(whole.reached.Count(), 0U);

  // Asked for the first time before the generation begins, then after some of its scans.
  int times = 0;
  wanted.is_asked_to_end = [&times] { return ++times > 3; };
  wanted.machine_ms *= 1'000;
  const Soaked ended = SoakOnce(wanted, machine);
  EXPECT_TRUE(ended.was_asked_to_end);
  EXPECT_GT(ended.wide_parts, 0U);
  EXPECT_GT(ended.reached.Count(), 0U) << "the scans count, and what they came to is lost";
}

INSTANTIATE_TEST_SUITE_P(Languages, WideRunsTest, testing::ValuesIn(kPrograms), [](const auto& test) {
  const std::string_view name = test.param.name;
  return std::string(name.substr(name.find('.') + 1));
});

}  // namespace
}  // namespace plcxx::soak
