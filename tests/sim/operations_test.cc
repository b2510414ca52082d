// Every operation once through the simulator. What the functions compute is tested in tests/runtime_support; here, that
// the simulator calls the right one with the right operands.
#include <string>
#include <vector>

#include "tests/sim/test_program.h"

namespace plcxx::sim {
namespace {

struct PureCase {
  std::string_view op;
  std::vector<uint64_t> operands;
  uint64_t result;
};

const PureCase kPureCases[] = {
    {"and.bit", {1, 0}, 0},
    {"and.bit", {1, 1}, 1},
    {"or.bit", {1, 0}, 1},
    {"or.bit", {0, 0}, 0},
    {"xor.bit", {1, 1}, 0},
    {"xor.bit", {1, 0}, 1},
    {"not.bit", {1}, 0},
    {"not.bit", {0}, 1},
    {"and.i8", {0x3C, 0x66}, 0x24},
    {"or.i8", {0x3C, 0x66}, 0x7E},
    {"xor.i8", {0x3C, 0x66}, 0x5A},
    {"not.i8", {0x3C}, 0xC3},
    {"highest_bit.i8", {0x28}, 6},
    {"one_hot.i8", {3}, 4},
    {"high_nibble.i8", {0xA5}, 0xA},
    {"low_nibble.i8", {0xA5}, 0x5},
    {"swap_nibbles.i8", {0xA5}, 0x5A},
    {"pair.i16", {0x34, 0x12}, 0x1234},
    {"add.i8", {200, 100}, 44},
    {"sub.i8", {1, 2}, 255},
    {"abs.i8", {0xFE}, 2},
    {"sign_bit.i8", {0x80}, 1},
    {"to_bcd.i8", {42}, 0x42},
    {"from_bcd.i8", {0x42}, 42},
    {"add.i32", {0xFFFFFFFF, 2}, 1},
    {"mul.i32", {0x10000, 0x10001}, 0x10000},
    {"eq.i8", {7, 7}, 1},
    {"ult.i8", {0x7F, 0x80}, 1},
    {"ugt.i8", {0x7F, 0x80}, 0},
    {"eq.i32", {0x12345678, 0x12345678}, 1},
    {"zext.i16.i32", {0xFFFF}, 0xFFFF},
    {"zext.i8.i32", {0xFF}, 0xFF},
};

uint64_t Compute(const PureCase& pure) {
  const ir::OpInfo& info = ir::Info(*ir::OpByText(pure.op));
  std::string text = "space M 8 volatile little\nplace RESULT " + std::string(Name(info.result)) + " M[0]";
  if (info.result == ir::Type::kBit) text += ".0";
  text += "\nroutine period schedule {\n";
  std::string call = "%r = " + std::string(pure.op);
  for (size_t i = 0; i < pure.operands.size(); ++i) {
    const std::string name = "%v" + std::to_string(i);
    text += name + " = const " + std::string(Name(info.operands[i])) + " " + std::to_string(pure.operands[i]) + "\n";
    call += " " + name;
  }
  text += call + "\nstore RESULT %r\n}\nschedule period period\n";
  Machine machine(text);
  machine.Run();
  return machine.Get("RESULT");
}

TEST(Operations, PureOnes) {
  for (const PureCase& pure : kPureCases) EXPECT_EQ(Compute(pure), pure.result) << pure.op;
}

TEST(Operations, PureOnesGiveValuesOfTheirTypeForAnyOperands) {
  for (uint32_t i = 0; i < ir::OpCount(); ++i) {
    const ir::OpInfo& info = ir::Info(static_cast<ir::OpKind>(i));
    if (info.shape != ir::Shape::kPure) continue;
    const uint64_t limit = info.result == ir::Type::kBit ? 1 : ~uint64_t{0} >> (64 - 8 * Bytes(info.result));
    for (const uint64_t seed : {uint64_t{0}, ~uint64_t{0}, uint64_t{0x8182838485868788}}) {
      PureCase pure{info.text, {}, 0};
      for (uint8_t k = 0; k < info.operand_count; ++k) {
        const ir::Type type = info.operands[k];
        pure.operands.push_back(type == ir::Type::kBit ? seed & 1 : seed >> (64 - 8 * Bytes(type)));
      }
      EXPECT_LE(Compute(pure), limit) << info.text;
    }
  }
}

TEST(Operations, OnDelay) {
  Machine machine(R"(
    space M 1 volatile little
    state T5 on_delay_timer
    place IN bit M[0].0
    place T5U bit field T5 done
    place T5D bit field T5 timing
    host now () -> i32 routine_exchange
    routine period schedule {
      %0 = load IN
      %1 = const i32 20
      %2 = host now ()
      step.on_delay T5 %0 %1 %2
    }
    schedule period period
    schedule now now
  )");
  machine.Set("IN", 1);
  machine.Run(0);
  EXPECT_EQ(machine.Get("T5D"), 1u);
  machine.Run(10);
  EXPECT_EQ(machine.Get("T5U"), 0u);
  machine.Run(20);
  EXPECT_EQ(machine.Get("T5U"), 1u);
  EXPECT_EQ(machine.Get("T5D"), 0u);
  EXPECT_TRUE(machine.simulator.TakeEvents().empty());
}

/// The carry of a counter modulo 2 after each of six inputs, when it is counted and expired by the given operations.
std::string Carries(std::string_view count, std::string_view time, std::string_view expire) {
  Machine machine(
      "space M 12 volatile little\nstate C5 ring_counter\nplace IN bit M[0].0\nplace TIME i32 M[4]\n"
      "place SKIP bit M[0].1\nplace C5R bit field C5 carry\nplace COUNTED bit M[0].2\n"
      "routine period schedule {\n%t = load TIME\n%one = const i32 1\n%n = add.i32 %t %one\nstore TIME %n\n"
      "%s = load SKIP\nif %s {\n} else {\n%0 = load IN\n%1 = const i16 2\n%2 = " +
      std::string(count) + " C5 %0 %1 " + std::string(time) + "\nstore COUNTED %2\n}\n" + std::string(expire) +
      "}\nschedule period period\n");
  std::string carries;
  for (const bool input : {true, false, true, true, false, true}) {
    machine.Set("IN", input);
    machine.Run();
    EXPECT_EQ(machine.Get("COUNTED"), 1u);
    carries += machine.Get("C5R") != 0 ? '1' : '0';
  }
  machine.Set("IN", 0);
  machine.Run();
  machine.Set("IN", 1);
  machine.Run();  // wraps
  machine.Set("SKIP", 1);
  machine.Run();
  carries += machine.Get("C5R") != 0 ? '1' : '0';
  return carries;
}

TEST(Operations, Counters) {
  EXPECT_EQ(Carries("step.count_slow", "%n", "step.expire_counter_slow C5 %n\n"), "0010000");
  EXPECT_EQ(Carries("step.count_fast", "%n", "step.expire_counter_fast C5 %n\n"), "0010000");
  EXPECT_EQ(Carries("step.count_slow", "%n", "step.expire_counter_fast C5 %n\n"), "0010001");
  EXPECT_EQ(Carries("step.count_carry_while_input", "", ""), "0011001");
  EXPECT_EQ(Carries("step.count_carry_until_next", "", ""), "0011101");
}

TEST(Operations, CounterRefusesItsModulusAndIsReset) {
  Machine machine(R"(
    space M 4 volatile little
    state C5 ring_counter
    place IN bit M[0].0
    place Z bit M[0].1
    place COUNTED bit M[0].2
    place MODULUS i16 M[2]
    place C5W i8 field C5 count
    routine period schedule {
      %0 = load IN
      %1 = load MODULUS
      %2 = step.count_carry_while_input C5 %0 %1
      store COUNTED %2
      %3 = load Z
      step.reset_counter C5 %3
    }
    schedule period period
  )");
  machine.Set("IN", 1);
  machine.Set("MODULUS", 256);
  machine.Run();
  EXPECT_EQ(machine.Get("COUNTED"), 0u);
  EXPECT_EQ(machine.Get("C5W"), 0u);
  machine.Set("C5W", 77);
  machine.Run();
  EXPECT_EQ(machine.Get("COUNTED"), 1u);
  EXPECT_EQ(machine.Get("C5W"), 77u);
  machine.Set("Z", 1);
  machine.Run();
  EXPECT_EQ(machine.Get("C5W"), 0u);
}

TEST(Operations, OneShots) {
  Machine machine(R"(
    space M 12 volatile little
    state P6 one_shot
    state P7 one_shot
    place IN bit M[0].0
    place SKIP bit M[0].1
    place CYCLE i32 M[4]
    place DONE i32 M[8]
    place SLICE i8 M[1]
    place P6 bit field P6 pulse
    place P7 bit field P7 pulse
    routine period schedule {
      %skip = load SKIP
      %cycle = load CYCLE
      %done = load DONE
      if %skip {
      } else {
        %0 = load IN
        %1 = load SLICE
        step.pulse_slow P6 %0 %cycle
        step.pulse_fast P7 %0 %done %1
      }
      step.expire_pulse_slow P6 %cycle
      step.expire_pulse_fast P7 %done
    }
    schedule period period
  )");
  machine.Set("CYCLE", 1);
  machine.Set("SLICE", 1);  // a slow cycle is half done: the pulse lasts until the second one from here ends
  machine.Set("IN", 1);
  machine.Run();
  EXPECT_EQ(machine.Get("P6"), 1u);
  EXPECT_EQ(machine.Get("P7"), 1u);
  machine.Set("CYCLE", 2);
  machine.Set("DONE", 1);
  machine.Set("SKIP", 1);
  machine.Run();
  EXPECT_EQ(machine.Get("P6"), 0u);
  EXPECT_EQ(machine.Get("P7"), 1u);
  machine.Set("DONE", 2);
  machine.Run();
  EXPECT_EQ(machine.Get("P7"), 0u);
}

TEST(Operations, OperatorTexts) {
  Machine machine(R"(
    state START text_flag
    state STOP text_flag
    state INBOX text_inbox
    place START bit field START flag
    place STOP bit field STOP flag
    routine period schedule {
      text.update START INBOX "START"
      text.update STOP INBOX "STOP"
      step.clear_text INBOX
    }
    schedule period period
    text_inbox INBOX
  )");
  machine.simulator.SendText("STOP");
  machine.simulator.SendText("START");
  std::string flags;
  for (int i = 0; i < 3; ++i) {
    machine.Run();
    flags += machine.Get("START") != 0 ? '1' : '0';
    EXPECT_EQ(machine.Get("STOP"), 0u);
  }
  EXPECT_EQ(flags, "110");
}

TEST(Operations, ATextForAProgramThatReadsNoneIsDropped) {
  Machine machine("space M 1 volatile little host_visible\n");
  machine.simulator.SendText("START");
  EXPECT_EQ(machine.simulator.Snapshot(), std::vector<uint8_t>{0});
}

}  // namespace
}  // namespace plcxx::sim
