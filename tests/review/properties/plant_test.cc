// plcxx prove --plant: runs with the machine moving come first, what they do not show is found as before, and nothing
// is proved by a plant.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The gate's switches follow from its contactor; both at once is what no machine does.
constexpr std::string_view kGate = "$\nU4A0=I0A0*/I0A6\nU4A1=I0A6*I0A7\nU4A2=I0A6\n";
constexpr std::string_view kPlant =
    "elements:\n- cylinder: {name: gate, extend: U4A0, extend-time: 200 ms, retract-time: 100 ms, extended: I0A6, "
    "retracted: I0A7}\n";

struct Planted {
  explicit Planted(std::string_view source = kGate, std::string_view plant = kPlant) {
    work.Write("m.plc", source);
    work.Write("m.plant.yaml", plant);
  }
  Ran Prove(std::string_view properties, const std::string& options = "--plant m.plant.yaml") const {
    work.Write("m.prop", properties);
    return work.Run("prove m.plc --property m.prop --counterexamples found --time 60s " + options);
  }
  /// The scenario of the first property fails in the simulator.
  void ExpectShown() const {
    const Ran again = work.Run("test --engine sim found/property-1.yaml");
    EXPECT_EQ(again.code, 1) << again;
    EXPECT_THAT(again.out, HasSubstr("does not hold"));
  }
  Workplace work;
};

TEST(ProvePlant, AViolationThatTheMachineShowsIsShownByIt) {
  const Planted planted;
  const Ran ran = planted.Prove("never U4A2\n");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("after 21 periods: I0A0=1, 210 ms\n             the plant (m.plant.yaml) moves in "
                                 "this run\n"));
  const std::string scenario = planted.work.Read("found/property-1.yaml");
  EXPECT_THAT(scenario, HasSubstr("plant: ../m.plant.yaml\n"));
  EXPECT_THAT(scenario, Not(HasSubstr("I0A6")));
  planted.ExpectShown();
  // The switch is what violates it: without one it passes.
  planted.work.Write("m.plc", "$\nU4A0=I0A0*/I0A6\nU4A1=I0A6*I0A7\nU4A2=I0A6*/I0A6\n");
  EXPECT_EQ(planted.work.Run("test --engine sim found/property-1.yaml").code, 0);
}

// Air pressure, or a door: the program need not read what lets the machine move.
TEST(ProvePlant, InputsThatThePlantAloneReadsAreSet) {
  const Planted planted;
  planted.work.Write("m.plant.yaml",
                     "elements:\n- cylinder: {name: c, extend: U4A0 and I2A0, extend-time: 200 ms, extended: I0A6}\n");
  const Ran ran = planted.Prove("never U4A2\n");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("the plant (m.plant.yaml) moves in this run"));
  EXPECT_THAT(planted.work.Read("found/property-1.yaml"), HasSubstr("I2A0: 1"));
  planted.ExpectShown();
}

TEST(ProvePlant, WhatOnlyInputsShowIsFoundWithoutThePlantAndSaidSo) {
  const Planted planted;
  const Ran ran = planted.Prove("never U4A1\n");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("the plant does not move in this run; with it no run was found"));
  EXPECT_THAT(planted.work.Read("found/property-1.yaml"), Not(HasSubstr("plant:")));
  planted.ExpectShown();
}

TEST(ProvePlant, AProofIsTheSameWithAPlant) {
  constexpr std::string_view kProperties =
      "never U4A0 and I0A6\nU4A1 implies U4A2\nU4A2 is never stuck within 1 slow\n";
  const Planted planted;
  const Ran without = planted.Prove(kProperties, "");
  const Ran with = planted.Prove(kProperties);
  EXPECT_EQ(with.code, 0) << with;
  EXPECT_THAT(with.out, HasSubstr("\nProofs hold for every input, whatever the plant (m.plant.yaml) does; "));
  EXPECT_EQ(with.out.substr(0, without.out.size()), without.out);
}

// The solver finds the two codes, and sets the switch with them; no search guesses them, but it may take them over.
TEST(ProvePlant, ARunOfTheSolverIsRepeatedWithThePlant) {
  const Planted planted("$\nU4A0=[W3K0=5AH]*[W5K0=3CH]*[W7K0=0A5H]\nU4A2=U4A0*I0A6\n");
  const Ran ran = planted.Prove("never U4A2\n");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("the plant (m.plant.yaml) moves in this run"));
  EXPECT_THAT(planted.work.Read("found/property-1.yaml"), Not(HasSubstr("I0A6")));
  planted.ExpectShown();
}

// Scenarios beside the program press buttons only, for their plant does the rest.
TEST(ProvePlant, ScenariosBesideTheProgramLeadTheMachineThere) {
  const Planted planted("$\nU4A0=[W3K0=5AH]*[W5K0=3CH]\nU4A3=(U4A3+U4A0*I0A6)*/[W7K0=1]\nU4A2=U4A3*[W7K0=0A5H]*I0A7\n");
  planted.work.Write(
      "open.yaml",
      "sources: [m.plc]\nplant: m.plant.yaml\nsteps:\n- set: {W3K0: 0x5A, W5K0: 0x3C}\n- run: {ms: 500}\n"
      "- set: {W3K0: 0, W7K0: 0xA5}\n- run: {ms: 500}\n");
  const Ran ran = planted.Prove("never U4A2\n", "--plant m.plant.yaml --format json");
  const auto report = nlohmann::json::parse(ran.out);
  EXPECT_EQ(report["plant"], "m.plant.yaml");
  EXPECT_EQ(report["properties"][0]["verdict"], "violated") << ran;
  EXPECT_EQ(report["properties"][0]["plantMoves"], true) << ran;
  planted.ExpectShown();
}

TEST(ProvePlant, WhatThePlantWritesBesideInputsIsNoPartOfAProof) {
  const Planted planted("$\nU4A6=U4A5\nU4A5=I0A0*/I0A0\nU4A7=U4A5*/U4A5\nU4A8=I0A1\n",
                        "elements:\n- switch: {input: U4A5, follows: I0A1}\n");
  const Ran proved = planted.Prove("never U4A7\n");
  EXPECT_EQ(proved.code, 0) << proved;
  EXPECT_THAT(proved.out,
              HasSubstr("note: the plant drives 'U4A5', which is no input: of what it does there nothing is proved"));
  EXPECT_EQ(planted.Prove("never U4A6\n", "").code, 0);
  const Ran violated = planted.Prove("never U4A6\n");
  EXPECT_EQ(violated.code, 1) << violated;
  EXPECT_THAT(violated.out, HasSubstr("the plant (m.plant.yaml) moves in this run"));
  planted.ExpectShown();
}

TEST(ProvePlant, WhatIsStuckIsAskedOfEveryInput) {
  const Planted planted("$\nU4A0=I0A0\nU4A2=U4A2+I0A6\n");
  const Ran ran = planted.Prove("U4A2 is never stuck within 3 slow\n");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("the plant does not move in this run: what is stuck is asked of every input"));
}

TEST(ProvePlant, OfASlicedProgramTheMachineIsReplayedWithItsSlices) {
  std::string between;
  for (int i = 0; i < 12; ++i)
    between += "U" + std::to_string(110 + i) + "K0=I1A" + std::to_string(i) + "*I2A" + std::to_string(i) + "\n";
  // Of the second slice: the plant moves later than with the pass in one piece.
  const Planted planted("$\nU4A2=I0A6\n" + between + "U4A0=I0A0\n");
  const Ran ran = planted.Prove("never U4A2\n", "--plant m.plant.yaml --set slices=2");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("the plant (m.plant.yaml) moves in this run"));
  planted.ExpectShown();
}

TEST(ProvePlant, ThePlantOfTheProjectAndOneThatIsWrong) {
  const Planted planted;
  planted.work.Write("plcxx.yaml",
                     "name: gate\ndialect: nc110\nsources: m.plc\nproperties: m.prop\nplant: m.plant.yaml\n");
  planted.work.Write("m.prop", "never U4A2\n");
  const Ran project = planted.work.Run("prove --plant project");
  EXPECT_THAT(project.out, HasSubstr("the plant (m.plant.yaml) moves in this run")) << project;
  const Ran without = planted.work.Run("prove");
  EXPECT_THAT(without.out, Not(HasSubstr("plant"))) << without;
  const Ran none = planted.Prove("never U4A2\n", "--plant none.yaml");
  EXPECT_EQ(none.code, 2) << none;
  EXPECT_THAT(none.errors, HasSubstr("none.yaml"));
  planted.work.Write("m.plant.yaml", "elements:\n- switch: {input: U4B5, follows: I0A1}\n");
  const Ran wrong = planted.Prove("never U4A2\n");
  EXPECT_EQ(wrong.code, 2) << wrong;
  EXPECT_THAT(wrong.errors, HasSubstr("m.plant.yaml:2:19: "));
  const Ran unnamed = Planted().Prove("never U4A2\n", "--plant project");
  EXPECT_EQ(unnamed.code, 2) << unnamed;
  EXPECT_THAT(unnamed.errors, HasSubstr("names no plant"));
}

}  // namespace
}  // namespace plcxx::driver
