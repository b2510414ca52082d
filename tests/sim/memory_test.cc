// Memory: widths, byte orders, indexed places, forces, power-on, retentive spaces, the host's side.
#include <gmock/gmock.h>

#include "tests/sim/test_program.h"

namespace plcxx::sim {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::IsEmpty;

/// Two spaces of different byte order; the period copies a double word from one to the other.
constexpr std::string_view kTwoOrders = R"(
  space L 16 volatile little host_visible
  space B 16 volatile big host_visible
  place L16 i16 L[4]
  place B16 i16 B[4]
  place L32 i32 L[4]
  place B32 i32 B[4]
  place L64 i64 L[4]
  place B64 i64 B[4]
  place L4 i8 L[4]
  place B4 i8 B[4]
  place L4.3 bit L[4].3
  place BEYOND i32 L[14]
  place OUTSIDE bit L[16].0
  routine period schedule {
    %0 = load L32
    store B32 %0
  }
  schedule period period
)";

TEST(Memory, ByteOrderOfTheSpace) {
  Machine machine(kTwoOrders);
  machine.Set("L16", 0x1234);
  EXPECT_EQ(machine.Get("L4"), 0x34u);
  machine.Set("B16", 0x1234);
  EXPECT_EQ(machine.Get("B4"), 0x12u);
  machine.Set("L64", 0x1122334455667788);
  EXPECT_EQ(machine.Get("L64"), 0x1122334455667788u);
  EXPECT_EQ(machine.Get("L32"), 0x55667788u);
  machine.Set("B64", 0x1122334455667788);
  EXPECT_EQ(machine.Get("B64"), 0x1122334455667788u);
  EXPECT_EQ(machine.Get("B32"), 0x11223344u);
  machine.Run();
  EXPECT_EQ(machine.Get("B32"), 0x55667788u);
  EXPECT_EQ(machine.Get("L4.3"), 1u);
  machine.Set("L4.3", 0);
  EXPECT_EQ(machine.Get("L4"), 0x80u);
}

TEST(Memory, OutsideReadsZeroAndWritesNothing) {
  Machine machine(kTwoOrders);
  const std::vector<uint8_t> before = machine.simulator.Snapshot();
  for (const std::string_view name : {"BEYOND", "OUTSIDE"}) {
    machine.Set(name, ~uint64_t{0});
    machine.Force(name, ~uint64_t{0});
    machine.Release(name);
    EXPECT_EQ(machine.Get(name), 0u);
  }
  EXPECT_EQ(machine.simulator.Snapshot(), before);
}

TEST(Memory, IndexedPlacesStayInTheirBounds) {
  Machine machine(R"(
    space M 32 volatile little host_visible
    place INDEX i32 M[0]
    place VALUE i16 M[4]
    place READ i16 M[6]
    place ROW i16 M[12] stride 4 low 8 high 22 indexed
    place BIT bit M[12].7 stride 1 low 8 high 22 indexed
    place SEEN bit M[24].0
    routine period schedule {
      %i = load INDEX
      %v = load VALUE
      store ROW[%i] %v
      %r = load ROW[%i]
      store READ %r
      %b = load BIT[%i]
      store SEEN %b
    }
    schedule period period
  )");
  const auto access = [&](int32_t index) {
    machine.Set("INDEX", static_cast<uint32_t>(index));
    machine.Set("VALUE", 0x8001);
    machine.Run();
    return machine.Get("READ");
  };
  EXPECT_EQ(access(0), 0x8001u);
  EXPECT_EQ(access(-1), 0x8001u);  // 8 and 9
  EXPECT_EQ(access(2), 0x8001u);   // 20 and 21
  EXPECT_EQ(access(-2), 0u);
  EXPECT_EQ(access(3), 0u);
  EXPECT_EQ(access(0x7FFFFFFF), 0u);
  EXPECT_EQ(access(-0x7FFFFFFF - 1), 0u);
  std::vector<uint8_t> row(32);
  for (const size_t at : {8u, 12u, 20u}) {
    row[at] = 0x01;
    row[at + 1] = 0x80;
  }
  machine.Set("INDEX", 0);
  machine.Set("VALUE", 0);
  machine.Set("READ", 0);
  EXPECT_EQ(machine.simulator.Snapshot(), row);
  machine.Set("VALUE", 0x8080);
  machine.Run();
  EXPECT_EQ(machine.Get("SEEN"), 1u);
}

constexpr std::string_view kRetentive = R"(
  space A 4 volatile little host_visible
  space T 3 retentive little host_visible
  initial A 1 0x0f
  initial T 2 0x33
  state C5 ring_counter
  place A0 i8 A[0]
  place A1 i8 A[1]
  place A2 i8 A[2]
  place T0 i8 T[0]
  place T2 i8 T[2]
  place STORE bit A[3].0
  place C5W i8 field C5 count
  host load_all () writes_retentive routine_exchange
  host store_all () reads_retentive
  host exchange () writes_state routine_exchange
  routine init init {
    host load_all ()
    %0 = load A1
    store A2 %0
  }
  routine period schedule {
    host exchange ()
    %0 = load STORE
    if %0 {
      host store_all ()
    }
  }
  schedule init init
  schedule period period
  schedule retentive_load load_all
  schedule retentive_store store_all
)";

TEST(Memory, PowerOnClearsAndAppliesInitialBytesBeforeInit) {
  Machine machine(kRetentive);
  for (const std::string_view name : {"A0", "A1", "A2", "T0", "T2", "C5W"}) machine.Set(name, 0xEE);
  machine.simulator.PowerOn();
  EXPECT_THAT(machine.simulator.Snapshot(), ElementsAreArray({0, 0x0F, 0x0F, 0, 0, 0, 0x33,     // A, T
                                                              0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));  // C5: 4 + 1 + 5 bytes
}

TEST(Memory, RetentiveSpacesComeBackAsTheyWereStored) {
  Machine machine(kRetentive);
  machine.Set("T0", 7);
  machine.Set("T2", 8);
  machine.Set("STORE", 1);
  machine.Run();
  EXPECT_THAT(machine.simulator.TakeEvents(), ElementsAre(HostEvent{ir::HostFunctionId(1), {}}));
  machine.Set("T0", 9);  // after the last store
  machine.simulator.PowerOn();
  EXPECT_EQ(machine.Get("T0"), 7u);
  EXPECT_EQ(machine.Get("T2"), 8u);
  EXPECT_THAT(machine.simulator.TakeEvents(), IsEmpty());
  machine.Set("T0", 10);
  machine.simulator.StoreRetentive();
  machine.simulator.PowerOn();
  EXPECT_EQ(machine.Get("T0"), 10u);
}

constexpr std::string_view kForces = R"(
  space A 8 volatile big host_visible
  space T 1 retentive little
  initial A 0 0xff
  state T5 on_delay_timer
  state INBOX text_inbox
  state START text_flag
  place W i8 A[0]
  place W.0 bit A[0].0
  place W.7 bit A[0].7
  place WIDE i32 A[4]
  place W4 i8 A[4]
  place W7 i8 A[7]
  place T0 i8 T[0]
  place T5U bit field T5 done
  place T5I bit field T5 input
  place T5A bit field T5 hold
  place START bit field START flag
  host load_all () writes_retentive routine_exchange
  host store_all () reads_retentive
  routine init init {
    host load_all ()
  }
  routine period schedule {
    %0 = load T5U
    store W.0 %0
    %1 = const bit 1
    %2 = const i32 0
    step.on_delay T5 %1 %2 %2
    store W.7 %1
    store T5A %1
    text.update START INBOX "START"
    step.clear_text INBOX
  }
  schedule init init
  schedule period period
  schedule retentive_load load_all
  schedule retentive_store store_all
  text_inbox INBOX
)";

TEST(Forces, HoldAgainstTheProgramTheHostAndPowerOn) {
  Machine machine(kForces);
  machine.Force("W.7", 0);
  EXPECT_EQ(machine.Get("W"), 0x7Fu);  // at once
  machine.Run();
  EXPECT_EQ(machine.Get("W"), 0x7Eu);  // bit 0 is still the program's
  machine.Set("W", 0xFF);
  EXPECT_EQ(machine.Get("W"), 0x7Fu);
  machine.simulator.PowerOn();
  EXPECT_EQ(machine.Get("W"), 0x7Fu);
  machine.Release("W.7");
  EXPECT_EQ(machine.Get("W"), 0x7Fu);  // until something writes it
  machine.Run();
  EXPECT_EQ(machine.Get("W.7"), 1u);
}

TEST(Forces, AForcedWordLeavesNothingFree) {
  Machine machine(kForces);
  machine.Force("W", 0x18);
  machine.Run();
  machine.Set("W.0", 1);
  EXPECT_EQ(machine.Get("W"), 0x18u);
  machine.Force("W", 0x81);  // a new value for what is forced already
  EXPECT_EQ(machine.Get("W"), 0x81u);
  machine.Release("W.0");
  machine.Set("W", 0);
  EXPECT_EQ(machine.Get("W"), 0x80u);
}

TEST(Forces, WidePlacesInTheOrderOfTheSpace) {
  Machine machine(kForces);
  machine.Force("WIDE", 0x11223344);
  machine.Set("WIDE", 0);
  EXPECT_EQ(machine.Get("WIDE"), 0x11223344u);
  EXPECT_EQ(machine.Get("W4"), 0x11u);
  machine.Release("W4");
  machine.Set("WIDE", 0);
  EXPECT_EQ(machine.Get("WIDE"), 0x00223344u);
}

TEST(Forces, AForcedFieldIsPutBackAfterEveryStep) {
  Machine machine(kForces);
  machine.Force("T5U", 0);
  machine.Force("T5A", 0);
  machine.Run();
  EXPECT_EQ(machine.Get("T5I"), 1u);
  EXPECT_EQ(machine.Get("T5U"), 0u);
  EXPECT_EQ(machine.Get("T5A"), 0u);
  machine.Set("T5U", 1);
  EXPECT_EQ(machine.Get("T5U"), 0u);
  machine.Force("T5U", 0xFF);  // a bit holds 0 or 1
  EXPECT_EQ(machine.Get("T5U"), 1u);
  machine.simulator.PowerOn();
  EXPECT_EQ(machine.Get("T5U"), 1u);
  machine.Release("T5U");
  machine.Release("T5A");
  machine.simulator.PowerOn();
  EXPECT_EQ(machine.Get("T5U"), 0u);
  machine.Run();
  EXPECT_EQ(machine.Get("T5U"), 1u);
  EXPECT_EQ(machine.Get("T5A"), 1u);
}

TEST(Forces, HoldAgainstTextsAndRetentiveLoading) {
  Machine machine(kForces);
  machine.simulator.SendText("START");
  machine.Force("START", 0);
  machine.Run();
  EXPECT_EQ(machine.Get("START"), 0u);
  machine.Set("T0", 5);
  machine.simulator.StoreRetentive();
  machine.Force("T0", 6);
  machine.simulator.PowerOn();
  EXPECT_EQ(machine.Get("T0"), 6u);
}

TEST(LastWrites, TellWhoWroteABit) {
  Machine machine(R"(
    statement s1
    statement s2
    space A 1 volatile little host_visible
    state T5 on_delay_timer
    place W i8 A[0]
    place W.0 bit A[0].0
    place W.1 bit A[0].1
    place IN bit A[0].7
    place T5U bit field T5 done
    routine period schedule {
      stmt s1
      %0 = load IN
      store W.0 %0
      stmt s2
      %0 = load IN
      %1 = not.bit %0
      store W.1 %1
      %2 = const i32 0
      step.on_delay T5 %0 %2 %2
    }
    schedule period period
  )");
  EXPECT_EQ(machine.simulator.last_writes(), nullptr);
  machine.simulator.RecordLastWrites();
  const auto of = [&](std::string_view name) {
    return machine.simulator.last_writes()->Of(PlaceNamed(machine.program, name));
  };
  EXPECT_THAT(of("W.0"), IsEmpty());
  for (const uint32_t now : {0u, 10u, 20u}) machine.Run(now);
  const LastWrite zero{Writer::kProgram, ir::StatementId(0), 0, 20, 0};
  EXPECT_THAT(of("W.0"), ElementsAre(zero));
  machine.Set("W", 0x81);
  const LastWrite host{Writer::kHost, ir::StatementId(), 20, 20, 1};
  EXPECT_THAT(of("W.0"), ElementsAre(host, zero));
  machine.Run(30);
  const LastWrite one{Writer::kProgram, ir::StatementId(0), 30, 30, 1};
  EXPECT_THAT(of("W.0"), ElementsAre(one, host, zero));
  EXPECT_THAT(of("T5U"), ElementsAre(LastWrite{Writer::kProgram, ir::StatementId(1), 30, 30, 1},
                                     LastWrite{Writer::kProgram, ir::StatementId(1), 0, 20, 0}));
  machine.Force("W.0", 0);
  machine.Run(40);
  EXPECT_THAT(of("W.0"), ElementsAre(LastWrite{Writer::kProgram, ir::StatementId(0), 40, 40, 0},
                                     LastWrite{Writer::kForce, ir::StatementId(), 30, 30, 0}, one));
  EXPECT_EQ(of("W").front(), (LastWrite{Writer::kProgram, ir::StatementId(1), 40, 40, 0x80}));
  machine.simulator.PowerOn();
  EXPECT_THAT(of("W.0"), IsEmpty());
}

TEST(LastWrites, TimesGoOnWhereTheClockOfTheControlWraps) {
  Machine machine(R"(
    statement s1
    space A 1 volatile little host_visible
    place OUT bit A[0].0
    place IN bit A[0].7
    routine period schedule {
      stmt s1
      %0 = load IN
      store OUT %0
    }
    schedule period period
  )");
  machine.simulator.RecordLastWrites();
  for (const uint32_t now : {0u, 0xFFFFFFF0u, 0x10u}) machine.Run(now);
  const LastWrite write{Writer::kProgram, ir::StatementId(0), 0, 0x100000010u, 0};
  EXPECT_THAT(machine.simulator.last_writes()->Of(PlaceNamed(machine.program, "OUT")), ElementsAre(write));
}

TEST(Memory, LastWritesOfAWordHaveItsValue) {
  Machine machine(R"(
    space M 8 volatile little
    place WIDE i32 M[0]
    place LOW i8 M[0]
    routine period schedule {
      %0 = const i32 4294967289
      store WIDE %0
    }
    schedule period period
  )");
  machine.simulator.RecordLastWrites();
  const auto newest = [&](std::string_view name) {
    return machine.simulator.last_writes()->Of(PlaceNamed(machine.program, name)).front().value;
  };
  machine.Run();
  EXPECT_EQ(newest("WIDE"), 0xFFFFFFF9u);
  EXPECT_EQ(newest("LOW"), 0xF9u);
  machine.Set("LOW", 5);
  EXPECT_EQ(newest("WIDE"), 5u);  // only its first byte was written
}

}  // namespace
}  // namespace plcxx::sim
