// The State of a machine in another simulator: the same values, the same timers, the same power flow.
#include "transpiler/live/mirror.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/live/live_fixture.h"
#include "transpiler/emit/layout/layout.h"
#include "transpiler/explanation/instance_text.h"
#include "transpiler/live/linked_cells.h"
#include "transpiler/live/locations.h"

namespace plcxx::live {
namespace {

constexpr const char* kTimed = R"(W3K0=[W3K0+1]
$
T0I(3)=I0A3
U4A8=I0A3*/I0A4+U4A8*/I0A4
U4A9=U4A8*T0U
U4A10=T0D
W2K2=[W3K0]
)";

/// The State that generated code would have with the memory of this simulator.
std::vector<uint8_t> StateOf(const ir::Program& program, const emit::layout::Layout& layout,
                             sim::Simulator& simulator) {
  std::vector<uint8_t> state(layout.size);
  const sim::Simulator::Saved saved = simulator.Save();
  for (uint32_t space = 0; space < layout.bytes.size(); ++space) {
    for (uint32_t at = 0; at < layout.bytes[space].size(); ++at) {
      const emit::layout::ByteStorage& stored = layout.bytes[space][at];
      if (stored.whole.storage != emit::layout::Storage::kNone) state[stored.whole.offset] = saved.spaces[space][at];
      for (int bit = 0; bit < 8; ++bit) {
        if (stored.bits[bit].storage == emit::layout::Storage::kNone) continue;
        state[stored.bits[bit].offset] = saved.spaces[space][at] >> bit & 1;
      }
    }
  }
  for (uint32_t i = 0; i < program.states.size(); ++i) {
    const ir::StateKind kind = program.states[ir::StateId(i)].kind;
    const auto fields = ir::Info(kind).fields;
    for (uint8_t field = 0; field < fields.size(); ++field) {
      if (fields[field].count != 1) continue;
      const uint64_t value = saved.instances.Read(i, field);
      for (uint32_t j = 0; j < ir::Bytes(fields[field].type); ++j) {
        state[layout.states[i].offset + emit::layout::FieldOffset(kind, field) + j] =
            static_cast<uint8_t>(value >> (8 * j));
      }
    }
  }
  return state;
}

/// Two sessions of one program: one that runs, one that mirrors it.
struct MirrorBench {
  explicit MirrorBench(const std::string& text) : runs(text), shows(text) {
    layout = emit::layout::MakeLayout(shows.compilation.program);
    mirror = std::make_unique<Mirror>(shows.compilation.program, layout, shown());
  }
  Machine& machine() { return runs.session->timeline().machine(); }
  Machine& shown() { return shows.session->timeline().machine(); }
  void Take() { mirror->Take(0, StateOf(runs.compilation.program, layout, machine().simulator())); }
  void ExpectSameValues(uint64_t period) {
    for (const LiveSignal& signal : runs.session->signals().signals) {
      if (signal.state.valid()) {
        const auto text = [&](Machine& one) {
          return explanation::InstanceText(runs.compilation.program, signal.state, one.simulator().instances());
        };
        EXPECT_EQ(text(shown()), text(machine())) << signal.name << ", period " << period;
        continue;
      }
      if (CellsOf(runs.compilation.program, layout, *signal.location).empty()) continue;
      EXPECT_EQ(shown().Read(*signal.location), machine().Read(*signal.location)) << signal.name << ", " << period;
    }
  }

  LiveBench runs, shows;
  emit::layout::Layout layout;
  std::unique_ptr<Mirror> mirror;
};

TEST(Mirror, ShowsWhatTheMachineHas) {
  MirrorBench bench(kTimed);
  std::mt19937 random(7);
  for (uint64_t period = 0; period < 200; ++period) {
    if (random() % 20 == 0) Toggle(*bench.runs.session, "I0A3");
    if (random() % 50 == 0) Toggle(*bench.runs.session, "I0A4");
    bench.runs.Periods(1);
    bench.Take();
    bench.mirror->Show();
    bench.ExpectSameValues(period);
  }
}

TEST(Mirror, ComputesThePowerFlowOfTheScanAndKeepsTheValues) {
  MirrorBench bench(kTimed);
  std::mt19937 random(8);
  const ir::Program& program = bench.runs.compilation.program;
  for (uint64_t period = 0; period < 200; ++period) {
    if (random() % 30 == 0) Toggle(*bench.runs.session, "I0A3");
    bench.runs.Periods(2);  // what was set has arrived, and nothing is on its way
    bench.Take();
    EXPECT_TRUE(bench.mirror->ComputeAgain().empty());
    bench.ExpectSameValues(period);
    for (uint32_t i = 0; i < program.insts.size(); ++i) {
      if (program.insts[ir::InstId(i)].type != ir::Type::kBit) continue;
      const auto value = ir::ValueId(i);
      EXPECT_EQ(bench.shown().simulator().ValueOf(value) & 1, bench.machine().simulator().ValueOf(value) & 1)
          << i << ", period " << period;
    }
    for (uint32_t i = 0; i < program.statements.size(); ++i) {
      EXPECT_EQ(bench.shown().executed()[i] == bench.shown().stretch(),
                bench.machine().executed()[i] == bench.machine().stretch());
    }
  }
}

TEST(Mirror, AByteThatIsNoTruthIsItsLowestBit) {
  MirrorBench bench(kTimed);
  std::vector<uint8_t> state(bench.layout.size, 0xFE);
  bench.mirror->Take(0, state);
  bench.mirror->ComputeAgain();
  EXPECT_EQ(bench.shows.Value("I0A3"), 0u);
  bench.mirror->Take(bench.layout.size - 1, std::vector<uint8_t>(100, 0xFF));  // what is after the end is left out
  bench.mirror->Take(0, std::vector<uint8_t>(bench.layout.size, 0xFF));
  bench.mirror->Show();
  EXPECT_EQ(bench.shows.Value("I0A3"), 1u);
}

}  // namespace
}  // namespace plcxx::live
