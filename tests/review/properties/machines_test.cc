// plcxx prove on a machine of each language, written for this: what holds is proved, what does not is shown by a run.
//
// tests/review/properties/machines and samples/classics: the properties of NAME.yaml hold, those of NAME.wrong do not;
// both are worked out by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/driver/run_plcxx.h"
#include "tests/volume.h"

namespace plcxx::driver {
namespace {

using ::testing::HasSubstr;

class ProveMachines : public ::testing::TestWithParam<std::string> {
 protected:
  // The presses are the longest proofs by far. Of prostep there is the drum; of hnc what holds is proved.
  void SetUp() override {
    const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    const bool dear = GetParam() == "prostep_press.plc" ||
                      (GetParam() == "hnc_press.cld" && test.starts_with("WhatDoesNotHoldIsShown"));
    if (dear && !testing_support::IsWholeVolume()) GTEST_SKIP() << "long proof: dev/test --all";
  }

  static std::string Source() {
    const bool is_sample = GetParam().find('/') != std::string::npos;
    return PLCXX_ROOT + std::string(is_sample ? "/samples/" : "/tests/review/properties/machines/") + GetParam();
  }
  static std::string Path(const std::string& ending) { return Source().substr(0, Source().rfind('.')) + ending; }
};

TEST_P(ProveMachines, WhatHoldsIsProved) {
  const Ran ran = Workplace().Run("prove " + Path(".yaml") + " --time 40s");
  EXPECT_EQ(ran.code, 0) << ran;
}

TEST_P(ProveMachines, WhatDoesNotHoldIsShown) {
  const Workplace work;
  const Ran ran = work.Run("prove " + Source() + " --property " + Path(".wrong") +
                           " --time 40s --format json --counterexamples found");
  EXPECT_EQ(ran.code, 1) << ran;
  size_t number = 0;
  const auto report = nlohmann::json::parse(ran.out);
  for (const auto& property : report["properties"]) {
    const std::string text = property["property"];
    SCOPED_TRACE(text);
    ++number;
    EXPECT_EQ(property["verdict"], "violated") << ran;
    const Ran again = work.Run("test --engine sim --allow-outside found/property-" + std::to_string(number) + ".yaml");
    // That an output is stuck cannot be seen in one run: the scenario shows the state from which it is.
    const bool stuck = text.find("never stuck") != std::string::npos;
    EXPECT_EQ(again.code, stuck ? 0 : 1) << again;
    if (!stuck) {
      EXPECT_THAT(again.out, HasSubstr("does not hold"));
    }
  }
  EXPECT_GE(number, 4U);
}

INSTANTIATE_TEST_SUITE_P(EachLanguage, ProveMachines,
                         ::testing::Values("classicladder_page.clp", "hnc_press.cld", "host50_feed.il",
                                           "nc110_clamp.plc", "nc110_gears.plc", "nc110_timers.plc", "prostep_drum.plc",
                                           "prostep_press.plc", "technol_arm.plc", "technol_functions.plc"),
                         [](const auto& machine) { return machine.param.substr(0, machine.param.find('.')); });

/// Each is decided in a moment.
INSTANTIATE_TEST_SUITE_P(Classics, ProveMachines,
                         ::testing::Values("classics/motor_interlock.plc", "classics/conveyor.il",
                                           "classics/emergency_shutdown.plc", "classics/water.plc",
                                           "classics/stairs.cld", "classics/pick_and_place_0.plc",
                                           "classics/pick_and_place_1.plc", "classics/pick_and_place_2.plc"),
                         [](const auto& machine) {
                           const size_t begin = machine.param.find('/') + 1;
                           return machine.param.substr(begin, machine.param.find('.') - begin);
                         });

}  // namespace
}  // namespace plcxx::driver
