// A rung does what its instructions do one by one: random logic, executed in rungs and, because somebody is asked at
// each statement, without.
#include "transpiler/sim/rungs.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "plcxx/logic.h"
#include "tests/sim/test_program.h"

namespace plcxx::sim {
namespace {

constexpr int kBits = 24, kRungs = 60;

/// Statements, each of contacts (bits of memory and of a timer), what joins them, and one coil or two; some of a few
/// instructions only, some under a condition, some with a number between.
std::string RandomProgram(std::mt19937& random) {
  const auto below = [&random](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
  std::string text = "space M 16 volatile little host_visible\nstate T5 on_delay_timer\nplace T5U bit field T5 done\n";
  text += "place N i8 M[12]\nplace TIME i32 M[8]\n";
  for (int bit = 0; bit < kBits; ++bit) {
    text +=
        "place B" + std::to_string(bit) + " bit M[" + std::to_string(bit / 8) + "]." + std::to_string(bit % 8) + "\n";
  }
  for (int rung = 0; rung < kRungs; ++rung) text += "statement s" + std::to_string(rung) + "\n";
  text += "routine period schedule {\n";
  int value = 0;
  const auto give = [&](const std::string& what) {
    text += "  %v" + std::to_string(value) + " = " + what + "\n";
    return "%v" + std::to_string(value++);
  };
  for (int rung = 0; rung < kRungs; ++rung) {
    text += "  stmt s" + std::to_string(rung) + "\n";
    std::vector<std::string> values;
    const auto any = [&] { return values[static_cast<size_t>(below(static_cast<int>(values.size())))]; };
    for (int i = 1 + below(4); i > 0; --i)
      values.push_back(give(below(6) == 0 ? "load T5U" : "load B" + std::to_string(below(kBits))));
    for (int i = below(5); i > 0; --i) {
      switch (below(5)) {
        case 0:
          values.push_back(give("not.bit " + any()));
          break;
        case 1:
          values.push_back(give("xor.bit " + any() + " " + any()));
          break;
        case 2:
          values.push_back(give("or.bit " + any() + " " + any()));
          break;
        case 3:
          values.push_back(give("and.bit " + any() + " " + any()));
          break;
        default: {
          const std::string number = give("load N"), one = give("const i8 1");
          text += "  store N " + give("add.i8 " + number + " " + one) + "\n";
          values.push_back(give("const bit 1"));
        }
      }
    }
    const bool is_conditional = below(8) == 0;
    if (is_conditional) text += "  if " + any() + " {\n";
    for (int i = below(3); i >= 0; --i) text += "  store B" + std::to_string(below(kBits)) + " " + any() + "\n";
    if (is_conditional) text += "  }\n";
    if (below(10) == 0) {
      const std::string preset = give("const i32 2"), time = give("load TIME"), one = give("const i32 1");
      text += "  store TIME " + give("add.i32 " + time + " " + one) + "\n";
      text += "  step.on_delay T5 " + any() + " " + preset + " " + time + "\n";
    }
  }
  return text + "}\nschedule period period\n";
}

TEST(Rungs, AreTheirInstructions) {
  std::mt19937 random(20);
  for (int round = 0; round < 40; ++round) {
    const std::string text = RandomProgram(random);
    SCOPED_TRACE(text);
    Machine rungs{text}, alone{text};
    alone.simulator.AtStatements([](ir::StatementId) { return false; });
    std::vector<uint8_t> given(rungs.program.insts.size()), given_alone(given.size());
    if (round % 2 == 0) {
      rungs.simulator.NoteGiven(given);
      alone.simulator.NoteGiven(given_alone);
    }
    for (uint32_t period = 0; period < 30; ++period) {
      for (int i = static_cast<int>(random() % 4); i > 0; --i) {
        const std::string bit = "B" + std::to_string(random() % kBits);
        const uint64_t one = random() % 2;
        const unsigned what = random() % 8;
        for (Machine* const machine : {&rungs, &alone}) {
          if (what == 0) {
            machine->Force(bit, one);
          } else if (what == 1) {
            machine->Release(bit);
          } else {
            machine->Set(bit, one);
          }
        }
      }
      if (period % 10 == 9) rungs.simulator.Restore(rungs.simulator.Save());
      rungs.Run(10 * period);
      alone.Run(10 * period);
      ASSERT_EQ(rungs.simulator.Snapshot(), alone.simulator.Snapshot()) << "period " << period;
      for (uint32_t id = 0; id < rungs.program.insts.size(); ++id)
        ASSERT_EQ(rungs.simulator.ValueOf(ir::ValueId(id)), alone.simulator.ValueOf(ir::ValueId(id))) << id;
    }
    EXPECT_EQ(given, given_alone);
    EXPECT_EQ(rungs.simulator.executed(), alone.simulator.executed());
  }
}

TEST(Rungs, TablesAreOfTheFunctions) {
  EXPECT_EQ(TruthOf(plcxx::BitAnd), 0b1000);
  EXPECT_EQ(TruthOf(plcxx::BitOr), 0b1110);
  EXPECT_EQ(TruthOf(plcxx::BitXor), 0b0110);
  EXPECT_EQ(TruthOf([](bool a, bool) { return plcxx::BitNot(a); }), 0b0101);
}

/// What a program does when power comes may be a rung, too.
TEST(Rungs, AtPowerOn) {
  Machine machine{R"(
    space M 8 volatile little host_visible
    place A bit M[0].0
    place B bit M[0].1
    routine init init {
      %a = load A
      %not = not.bit %a
      store B %not
    }
    routine period schedule {
    }
    schedule init init
    schedule period period
  )"};
  EXPECT_EQ(machine.Get("B"), 1U);
}

}  // namespace
}  // namespace plcxx::sim
