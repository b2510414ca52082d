// A plant and a panel in the session: what moves, what is operated, the way back, and the scenario of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/live/live_fixture.h"
#include "transpiler/live/recording.h"
#include "transpiler/scenarios/scenario.h"

namespace plcxx::live {
namespace {

using testing::HasSubstr;

/// U4A8 drives a cylinder out, whose switch is I0A6; U4A9 needs it.
constexpr const char* kCylinder = "$\nU4A8=I0A3*I0A4\nU4A9=I0A6*U4A8\n";
constexpr const char* kPlant =
    "elements:\n- cylinder: {name: door, extend: U4A8, extend-time: 200 ms, retract-time: 100 ms, extended: I0A6, "
    "retracted: I0A7}\n";
constexpr const char* kPanel =
    "groups:\n- controls:\n  - button: {text: GO, input: I0A3, lamp: U4A9}\n  - stop: {text: E, input: I0A4}\n"
    "  - knob: {text: K, location: W2K0, positions: [a, b, c], values: [5, 6, 7]}\n  - display: {text: D, of: W2K0}\n";
enum : uint8_t { kGo, kStop, kKnob, kShown };

struct PlantBench : LiveBench {
  PlantBench() : LiveBench(kCylinder) {
    auto read = plant::ParsePlant("plant.yaml", kPlant);
    auto bound = scenarios::BindPlant(std::get<std::shared_ptr<const plant::Model>>(read), *compilation.dialect,
                                      compilation.program);
    plant = std::get<std::shared_ptr<const scenarios::BoundPlant>>(bound);
    auto panel = BindPanel(std::get<plant::Panel>(plant::ParsePanel("panel.yaml", kPanel)), compilation, plant.get());
    session->Equip(plant, std::get<std::shared_ptr<const BoundPanel>>(panel));
    session->BeginAnew();
  }
  std::shared_ptr<const scenarios::BoundPlant> plant;
};

TEST(LivePlant, MovesAndGoesBackTheSameWay) {
  PlantBench bench;
  EXPECT_EQ(bench.Value("I0A7"), 1u);
  EXPECT_EQ(bench.Value("I0A4"), 1u);  // nobody presses the emergency stop
  EXPECT_EQ(Set(*bench.session, "I0A3", "1"), "");
  bench.Periods(20);  // the first one switches on at 0 ms; the one at 190 ms is before the end
  EXPECT_EQ(bench.Value("I0A6"), 0u);
  bench.Periods(1);
  EXPECT_EQ(bench.Value("I0A6"), 1u);
  EXPECT_EQ(bench.Value("U4A9"), 1u);
  for (int i = 0; i < 2; ++i) {
    bench.session->Back(7);
    EXPECT_EQ(bench.Value("I0A6"), 0u);
    bench.Periods(6);
    EXPECT_EQ(bench.Value("I0A6"), 0u);
    bench.Periods(1);
    EXPECT_EQ(bench.Value("I0A6"), 1u);
  }
}

TEST(LivePlant, WhatItDrivesIsNotTheOperators) {
  PlantBench bench;
  EXPECT_THAT(Set(*bench.session, "I0A6", "1"),
              HasSubstr("driven by the plant, cylinder 'door' (plant.yaml:2): force it"));
  EXPECT_THAT(Toggle(*bench.session, "I0A7"), HasSubstr("driven by the plant"));
  EXPECT_THAT(Set(*bench.session, "W0A0", "1"), HasSubstr("driven by the plant"));  // the byte that I0A6 is in
  EXPECT_EQ(Force(*bench.session, "I0A6", "1"), "");
  bench.Periods(3);
  EXPECT_EQ(bench.Value("I0A6"), 1u);
  EXPECT_EQ(Release(*bench.session, "I0A6"), "");
  bench.Periods(2);
  EXPECT_EQ(bench.Value("I0A6"), 0u);
}

TEST(LivePanel, AButtonIsHeldForATenthOfASecond) {
  PlantBench bench;
  EXPECT_EQ(bench.session->hands().Press(kGo), "");
  EXPECT_EQ(bench.session->hands().Release(kGo), "");
  bench.Periods(9);
  EXPECT_EQ(bench.Value("I0A3"), 1u);
  EXPECT_EQ(bench.session->hands().States()[kGo].position, 1);
  bench.Periods(1);
  EXPECT_EQ(bench.Value("I0A3"), 0u);
  EXPECT_EQ(bench.session->hands().States()[kGo].position, 0);
}

TEST(LivePanel, SwitchesStayAlsoThroughAPowerCycle) {
  PlantBench bench;
  EXPECT_EQ(bench.session->hands().Turn(kKnob, 2), "");
  EXPECT_EQ(bench.session->hands().Turn(kStop, 1), "");
  bench.Periods(5);
  EXPECT_EQ(bench.Value("I0A4"), 0u);
  std::vector<ControlState> states = bench.session->hands().States();
  EXPECT_EQ(states[kKnob].position, 2);
  EXPECT_EQ(states[kShown].value, 7u);
  EXPECT_EQ(states[kStop].position, 1);
  bench.session->hands().Turn(kStop, 0);
  bench.Periods(5);
  bench.session->PowerOff();
  bench.session->PowerOn();
  bench.Periods(5);
  EXPECT_EQ(bench.Value("I0A4"), 1u);
  EXPECT_EQ(bench.Value("W2K0"), 7u);
  EXPECT_NE(bench.session->hands().Turn(kKnob, 3), "");
  EXPECT_NE(bench.session->hands().Turn(kGo, 1), "");
  EXPECT_NE(bench.session->hands().Press(kKnob), "");
  EXPECT_NE(bench.session->hands().Press(99), "");
}

TEST(LivePanel, WhatWasOperatedIsAScenario) {
  PlantBench bench;
  bench.Periods(1);
  bench.session->hands().Press(kGo);
  bench.Periods(25);
  bench.session->hands().Release(kGo);
  bench.Periods(5);
  Expect(*bench.session, {"I0A6"});
  const Recording recording = WriteRecording(bench.compilation, bench.request, bench.session->timeline(), "");
  EXPECT_EQ(recording.refusal, "");
  EXPECT_THAT(recording.yaml, HasSubstr("plant: plant.yaml\nsteps:\n"
                                        "- set: {I0A4: 1, W2K0: 5}\n"
                                        "- run: {ms: 10}\n"
                                        "- set: {I0A3: 1}\n"
                                        "- run: {ms: 250}\n"
                                        "- set: {I0A3: 0}\n"
                                        "- run: {ms: 50}\n"
                                        "- expect: {I0A6: 0}\n"));
}

TEST(LivePanel, WhatIsWrongWithItsNamesHasPlaceAndRemedy) {
  PlantBench bench;
  const auto errors_of = [&](const std::string& text) {
    auto bound =
        BindPanel(std::get<plant::Panel>(plant::ParsePanel("panel.yaml", text)), bench.compilation, bench.plant.get());
    std::string all;
    if (const auto* errors = std::get_if<std::vector<yaml::Error>>(&bound)) {
      for (const yaml::Error& error : *errors) all += ToText(error) + "\n";
    }
    return all;
  };
  EXPECT_THAT(errors_of("groups:\n- controls:\n  - button: {text: A, input: NOTHING}\n"),
              testing::AllOf(HasSubstr("panel.yaml:3:30: 'NOTHING' is no location of nc110"), HasSubstr("help:")));
  EXPECT_THAT(errors_of("groups:\n- controls:\n  - button: {text: A, input: I0A6}\n"),
              HasSubstr("'I0A6' is driven by the plant, and not the operator's: cylinder 'door' (plant.yaml:2)"));
}

std::string ScenarioErrors(const std::string& text) {
  const scenarios::ScenarioOrErrors read = scenarios::ParseScenario("a.yaml", text);
  std::string all;
  if (const auto* errors = std::get_if<std::vector<yaml::Error>>(&read)) {
    for (const yaml::Error& error : *errors) all += ToText(error) + "\n";
  }
  return all;
}

TEST(ScenarioPlant, WhatItsKeyNamesMustBeThere) {
  const std::string rest = "\nsources: {a.plc: x}\nsteps: []\n";
  EXPECT_THAT(ScenarioErrors("plant: nothing.yaml" + rest),
              HasSubstr("a.yaml:1:8: plant 'nothing.yaml': there is no such file"));
  EXPECT_THAT(ScenarioErrors("plant: project" + rest),
              testing::AllOf(HasSubstr("a.yaml:1:8: 'plant: project' is the plant of plcxx.yaml"),
                             HasSubstr("help: name the file")));
}

TEST(ScenarioPlant, NamesThatAreNoneAndMemoryThatIsDrivenTwiceAreToldAtTheirPlaces) {
  const LiveBench bench(kCylinder);
  const auto errors_of = [&](const std::string& text) {
    auto model = std::get<std::shared_ptr<const plant::Model>>(plant::ParsePlant("plant.yaml", text));
    auto bound = scenarios::BindPlant(std::move(model), *bench.compilation.dialect, bench.compilation.program);
    std::string all;
    if (const auto* errors = std::get_if<std::vector<yaml::Error>>(&bound)) {
      for (const yaml::Error& error : *errors) all += ToText(error) + "\n";
    }
    return all;
  };
  EXPECT_THAT(errors_of("elements:\n- switch: {input: I0A6, follows: PUMP}\n"),
              testing::AllOf(HasSubstr("plant.yaml:2:34: 'PUMP' is no location of nc110"), HasSubstr("help:")));
  EXPECT_THAT(errors_of("elements:\n- fixed: {input: I0A6}\n- fixed: {values: {W0A0: 3}}\n"),
              HasSubstr("plant.yaml:3:20: 'W0A0' and 'I0A6' of line 2 are the same memory"));
}

}  // namespace
}  // namespace plcxx::live
