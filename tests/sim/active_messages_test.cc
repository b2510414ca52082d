#include "transpiler/sim/active_messages.h"

#include <gmock/gmock.h>

#include "tests/sim/test_program.h"

namespace plcxx::sim {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::string_view kMessages = R"(
  space K 8 volatile little host_visible
  place K0 i8 K[0]
  place K1 i8 K[1]
  place K2 i8 K[2]
  place W17K3 i8 K[7]
  message_bits K 0 first 1 count 12
  message_bits K 2 first 33 count 8
  message_word W17K3
)";

TEST(ActiveMessages, BitsAndWord) {
  Machine machine(kMessages);
  const auto active = [&] { return ActiveMessages(machine.program, machine.simulator); };
  EXPECT_THAT(active(), IsEmpty());
  machine.Set("K0", 0x81);
  machine.Set("K1", 0xF1);  // the stretch ends at its fourth bit
  machine.Set("K2", 0x08);
  machine.Set("W17K3", 20);
  EXPECT_THAT(active(), ElementsAre(1, 8, 9, 20, 36));
  machine.Set("W17K3", 36);  // shown twice is shown once
  EXPECT_THAT(active(), ElementsAre(1, 8, 9, 36));
}

TEST(MessageTracker, TellsWhatEntered) {
  Machine machine(kMessages);
  MessageTracker tracker(machine.program);
  const auto period = [&](uint64_t k0, uint64_t word) {
    machine.Set("K0", k0);
    machine.Set("W17K3", word);
    tracker.Observe(machine.simulator);
  };
  period(0x02, 200);
  EXPECT_THAT(tracker.TakeEntered(), ElementsAre(2, 200));
  period(0x02, 200);
  EXPECT_THAT(tracker.TakeEntered(), IsEmpty());
  period(0x04, 5);
  period(0x05, 4);
  period(0x00, 5);
  EXPECT_THAT(tracker.TakeEntered(), ElementsAre(3, 5, 1, 4, 5));
  EXPECT_THAT(tracker.active(), ElementsAre(5));
  tracker.PowerOn();
  period(0x00, 5);
  EXPECT_THAT(tracker.TakeEntered(), ElementsAre(5));
}

}  // namespace
}  // namespace plcxx::sim
