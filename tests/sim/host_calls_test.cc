// Host calls with results: what is asked, what is listed, what the answer does.
#include <gmock/gmock.h>

#include "tests/sim/test_program.h"

namespace plcxx::sim {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;

/// Reads port 3 for the image and port 4 for the program, a system variable, and writes port 5.
constexpr std::string_view kPorts = R"(
  space M 16 volatile little host_visible
  space R 16 routine little
  place IMAGE i8 M[0]
  place DIRECT i8 M[1]
  place FOUND bit M[2].0
  place VARIABLE i32 M[4]
  place NOW i32 M[8]
  place value i32 R[0]
  host now () -> i32 routine_exchange
  host exchange () writes_state routine_exchange
  host read_port (port : i8) -> i8
  host write_port (port : i8, value : i8)
  host nc_read (width : i8, index : i16) -> bit out value : i32
  routine period schedule {
    %now = host now ()
    store NOW %now
    %three = const i8 3
    %image = host read_port (%three) exchange
    store IMAGE %image
    host exchange ()
    %four = const i8 4
    %direct = host read_port (%four)
    store DIRECT %direct
    %was = const i32 77
    store value %was
    %index = const i16 40
    %found = host nc_read (%four, %index) out value
    store FOUND %found
    %value = load value
    store VARIABLE %value
    %five = const i8 5
    %back = load IMAGE
    host write_port (%five, %back)
  }
  schedule period period
  schedule now now
)";

struct HostCalls : testing::Test {
  Machine machine{kPorts};

  std::string NameOf(ir::HostFunctionId function) const { return machine.program.host_functions[function].name; }
};

TEST_F(HostCalls, WithoutAnAnswerCallsGiveNothing) {
  machine.Run(30);
  EXPECT_EQ(machine.Get("DIRECT"), 0u);
  EXPECT_EQ(machine.Get("FOUND"), 0u);
  EXPECT_EQ(machine.Get("VARIABLE"), 77u);
  EXPECT_EQ(machine.Get("NOW"), 30u);
}

TEST_F(HostCalls, ResultsAndSecondResults) {
  machine.simulator.AnswerHostCalls([&](ir::HostFunctionId function, std::span<const uint64_t> arguments) {
    if (NameOf(function) == "read_port") return HostAnswer{.result = arguments[0] * 10, .out = {}};
    if (NameOf(function) == "nc_read") return HostAnswer{.result = 1, .out = arguments[1] + 100'000};
    return HostAnswer{};
  });
  machine.Run();
  EXPECT_EQ(machine.Get("IMAGE"), 30u);
  EXPECT_EQ(machine.Get("DIRECT"), 40u);
  EXPECT_EQ(machine.Get("FOUND"), 1u);
  EXPECT_EQ(machine.Get("VARIABLE"), 100'040u);
}

TEST_F(HostCalls, EachCallIsAskedInItsTurnAndMayChangeMemory) {
  std::vector<std::string> asked;
  machine.simulator.AnswerHostCalls([&](ir::HostFunctionId function, std::span<const uint64_t>) {
    asked.push_back(NameOf(function) + " " + std::to_string(machine.Get("IMAGE")));
    if (NameOf(function) == "exchange") machine.Set("IMAGE", 9);
    return HostAnswer{.result = 2, .out = {}};
  });
  machine.Run();
  EXPECT_THAT(asked, ElementsAre("read_port 0", "exchange 2", "read_port 9", "nc_read 9", "write_port 9"));
}

TEST_F(HostCalls, EventsSayWhichCallsAreOfTheExchange) {
  machine.Run();
  std::vector<std::string> events;
  for (const HostEvent& event : machine.simulator.TakeEvents()) {
    events.push_back(NameOf(event.function) + (event.exchange ? " exchange" : ""));
  }
  EXPECT_THAT(events, ElementsAre("read_port exchange", "read_port", "nc_read", "write_port"));
  EXPECT_THAT(machine.simulator.TakeEvents(), IsEmpty());
}

}  // namespace
}  // namespace plcxx::sim
