// Scenarios with a simulated control that answers host calls, keeps inputs and has ports of its own.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "tests/scenarios/scenario_fixture.h"

namespace plcxx::scenarios {
namespace {

using testing::HasSubstr;

/// IN is delivered at each read_inputs, the program spoils it; PORT is what port 3 holds; FLOAT goes to the NC.
constexpr std::string_view kControlled = R"(
  space M 20 volatile little host_visible
  zone M 0 1 input
  space T 4 retentive little host_visible
  place IN i8 M[0]
  place SEEN i8 M[1]
  place PORT i8 M[2]
  place MESSAGES i8 M[3]
  place FLOAT f32 M[4]
  place WORD i32 M[8]
  place MORE i8 M[12]
  place KEPT i32 T[0]
  host read_inputs () writes_state routine_exchange
  host look () reads_state routine_exchange
  host read_port (port : i8) -> i8
  host write_port (port : i8, value : i8)
  host axis (axis : i32, position : f32)
  host load_all () writes_retentive routine_exchange
  host store_all () reads_retentive routine_exchange
  routine init init {
    host load_all ()
    host read_inputs ()
    %in = load IN
    store SEEN %in
  }
  routine period schedule {
    host read_inputs ()
    stmt s1
    %in = load IN
    store SEEN %in
    %spoilt = const i8 99
    store IN %spoilt
    stmt s2
    %three = const i8 3
    %image = host read_port (%three) exchange
    %port = host read_port (%three)
    %sum = add.i8 %port %image
    store PORT %sum
    host write_port (%three, %sum)
    stmt s3
    %axis = const i32 4294967294
    %position = load FLOAT
    host axis (%axis, %position)
    host look ()
    stmt s4
    %more = load MORE
    store MESSAGES %more
  }
  message_bits M 3 first 1 count 8
  message 2 colour 0 "oil level"
  schedule init init
  schedule period period
  schedule fast_only period
  schedule retentive_load load_all
  schedule retentive_store store_all
  schedule retention 1
)";

/// Holds inputs and ports as a machine does.
class HeldMachine : public dialects::ControlStub {
 public:
  std::unique_ptr<dialects::ControlStub> Clone() const override { return std::make_unique<HeldMachine>(*this); }
  uint64_t Call(const ir::HostFunction& function, std::span<const uint64_t> arguments, dialects::ImagePort& image,
                std::optional<uint64_t>&) override {
    if (function.name == "read_inputs") image.Set(ir::SpaceId(0), 0, input_);
    if (function.name == "look") image.LookAtMessages();
    if (function.name == "read_port") return port_;
    if (function.name == "write_port") latch_ = arguments[1];
    return 0;
  }
  bool Written(const ir::Place& place, uint64_t value, dialects::ImagePort&) override {
    if (place.offset != 0 || place.space != ir::SpaceId(0)) return false;
    input_ = static_cast<uint8_t>(value);
    return true;
  }
  void PowerOff() override { latch_ = 0; }
  uint64_t ReadCell(uint32_t cell, const dialects::ImagePort&) override { return cell == 3 ? latch_ : 0; }
  void WriteCell(uint32_t, uint64_t value, dialects::ImagePort&) override { port_ = value; }

 private:
  uint8_t input_ = 0;
  uint64_t port_ = 0, latch_ = 0;
};

/// In lockstep with a second engine.
std::string RunScenario(const std::string& steps) {
  ScenarioBench bench(kControlled);
  bench.stub = std::make_unique<HeldMachine>();
  bench.other = ir::ReadOrDie(kControlled);
  return bench.Run(steps);
}

TEST(ScenarioControl, InputsAreDeliveredAgainAndAgain) {
  EXPECT_EQ(
      RunScenario("- set: {IN: 5}\n- expect: {IN: 5}\n- run: {slow: 1}\n- expect: {IN: 99, SEEN: 5}\n"
                  "- run: {slow: 1}\n- expect: {SEEN: 5}\n- set: {IN: 6}\n- run: {slow: 1}\n- expect: {SEEN: 6}\n"),
      "passed");
}

TEST(ScenarioControl, InputsOutliveAPowerCycleAndInitSeesThem) {
  EXPECT_EQ(RunScenario("- set: {IN: 5}\n- expect: {SEEN: 0}\n- power_cycle: {}\n- expect: {SEEN: 5, IN: 5}\n"),
            "passed");
}

TEST(ScenarioControl, PortsAreSetAsInputsAndExpectedAsOutputs) {
  EXPECT_EQ(RunScenario("- set: {P3: 20}\n- expect: {P3: 0}\n- run: {slow: 1}\n- expect: {P3: 40, PORT: 40}\n"
                        "- power_cycle: {}\n- expect: {P3: 0, PORT: 0}\n- run: {slow: 1}\n- expect: {P3: 40}\n"),
            "passed");
  EXPECT_EQ(RunScenario("- expect: {P3: 7}\n"),
            "s.yaml:2:12: step 1 (expect), at 0 ms: expected P3 = 7 (0x07), found 0 (0x00)");
  EXPECT_EQ(RunScenario("- force: {P3: 7}\n- release: P3\n"),
            "s.yaml:2:11: 'P3' can only be set and expected: it is no memory of the program\n"
            "s.yaml:3:12: 'P3' can only be set and expected: it is no memory of the program");
}

TEST(ScenarioControl, CallsOfTheExchangeAreNotListed) {
  EXPECT_EQ(
      RunScenario(
          "- set: {P3: 1, FLOAT: -3.25}\n- run: {slow: 1}\n"
          "- expect_calls: [{read_port: {port: 3}}, {write_port: {value: 2}}, {axis: {axis: -2, position: -3.25}}]\n"),
      "passed");
  EXPECT_EQ(
      RunScenario(
          "- set: {FLOAT: nan}\n- run: {slow: 1}\n- expect_calls: [read_port, write_port, {axis: {position: nan}}]\n"),
      "passed");
  EXPECT_THAT(RunScenario("- set: {FLOAT: 0.5}\n- run: {slow: 1}\n- expect_calls: []\n"),
              HasSubstr("found read_port(port: 3), write_port(port: 3, value: 0), axis(axis: -2, position: 0.5)"));
}

TEST(ScenarioControl, MessagesAreSeenInThePeriodAndAtItsEnd) {
  // Message 1 is gone at the period's end, but was there when the control looked.
  EXPECT_EQ(
      RunScenario("- set: {MESSAGES: 1, MORE: 6}\n- run: {slow: 1}\n- expect_messages: [message 1, oil level, 3]\n"
                  "- run: {slow: 1}\n- expect_messages: []\n"),
      "passed");
  EXPECT_EQ(RunScenario("- set: {MORE: 6}\n- run: {slow: 1}\n- expect_messages: [2]\n"),
            "s.yaml:4:3: step 3 (expect_messages), at 10 ms: expected messages [2], found ['oil level', 3]");
}

TEST(ScenarioControl, RetentiveMemorySetBeforeTheFirstRunIsKept) {
  EXPECT_EQ(RunScenario("- set: {KEPT: 70000, WORD: 5}\n- power_cycle: {}\n- expect: {KEPT: 70000, WORD: 0}\n"
                        "- run: {slow: 1}\n- power_cycle: {}\n- expect: {KEPT: 70000}\n"),
            "passed");
}

TEST(ScenarioControl, NumbersOfEveryKind) {
  EXPECT_EQ(RunScenario("- set: {FLOAT: 12.5, WORD: -7}\n- expect: {FLOAT: 12.5, WORD: 4294967289}\n"
                        "- set: {FLOAT: 0.1, WORD: 0x80000000}\n- expect: {FLOAT: 0.1, WORD: -2147483648}\n"
                        "- set: {FLOAT: 1e-50}\n- expect: {FLOAT: 0}\n- set: {FLOAT: -inf}\n- expect: {FLOAT: -inf}\n"
                        "- set: {FLOAT: .5}\n- expect: {FLOAT: +5.0e-1}\n- set: {FLOAT: nan}\n- expect: {FLOAT: nan}\n"
                        "- set: {FLOAT: 10H}\n- expect: {FLOAT: 16}\n"),
            "passed");
  EXPECT_EQ(RunScenario("- set: {FLOAT: 12.5}\n- expect: {FLOAT: 12.25}\n"),
            "s.yaml:3:12: step 2 (expect), at 0 ms: expected FLOAT = 12.25 (0x41440000), found 12.5 (0x41480000)\n"
            "  last writes to FLOAT, newest first:\n    value 12.5 at 0 ms: the scenario or the control");
  EXPECT_EQ(RunScenario("- set: {FLOAT: -0.0}\n- expect: {FLOAT: 0}\n"),
            "s.yaml:3:12: step 2 (expect), at 0 ms: expected FLOAT = 0 (0x00), found -0 (0x80000000)\n"
            "  last writes to FLOAT, newest first:\n    value -0 at 0 ms: the scenario or the control");
  EXPECT_EQ(RunScenario("- set: {FLOAT: 1e39, WORD: -2147483649, IN: 1.5}\n- set: {FLOAT: 1.5x}\n"),
            "s.yaml:2:16: '1e39' is no value: 'FLOAT' takes a number\n"
            "s.yaml:2:28: value -2147483649 does not fit: 'WORD' takes 0 to 4294967295\n"
            "s.yaml:2:45: '1.5' is no value: 'IN' takes 0 to 255\n"
            "s.yaml:3:16: '1.5x' is no value: 'FLOAT' takes a number");
}

}  // namespace
}  // namespace plcxx::scenarios
