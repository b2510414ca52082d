// The period of a pass does what the periods of its slices do, whatever others set in front of each of them.
#include "transpiler/scenarios/pass_machine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "transpiler/sim/simulator.h"

namespace plcxx::scenarios {
namespace {

constexpr const char* kProgram = R"(U5A0 = I0A0
T50I(30) = I0A0
U4A0 = T50U + U100K7
$
U100K0 = I0A0
T1I(2) = I0A1
U4A1 = T1U
C3I(3) = I0A2*I0A1
U4A2 = C3R + I1A3
U100K1 = I0A0&U100K0
U100K7 = U100K1 + I0A4
P2 = I0A5
U4A3 = P2*I0A0
W131K0 = [W131K0+1]
U4A4 = [W131K0=3]*I0A0
)";

struct SlicedProgram {
  uint32_t slices;
  const char* latches;
};

class PassMachineTest : public testing::TestWithParam<SlicedProgram> {};

TEST_P(PassMachineTest, DoesWhatItsSlicesDo) {
  compilation::CompilationRequest request;
  request.sources = {"m.plc"};
  request.texts["m.plc"] = kProgram;
  request.options = {{"slices", std::to_string(GetParam().slices)}, {"latch-slow-inputs", GetParam().latches}};
  PassMachine pass;
  MakePassMachine(request, pass);
  ASSERT_EQ(pass.refusal, "");
  ASSERT_EQ(pass.pass.slices, GetParam().slices);
  ASSERT_FALSE(pass.bytes.empty());
  const compilation::Compilation whole = compilation::Compile(request);
  sim::Simulator by_slices(whole.program), by_pass(pass.compilation.program);
  by_slices.PowerOn();
  by_pass.PowerOn();
  std::mt19937 random(23);
  std::set<std::vector<uint8_t>> states;
  constexpr uint32_t kPasses = 400;
  uint32_t time = 0;
  for (uint32_t count = 0; count < kPasses; ++count) {
    const uint32_t begin = time;
    for (uint32_t slice = 0; slice < pass.pass.slices; ++slice) {
      for (uint32_t i = 0; i < pass.bytes.size(); ++i) {
        const passes::ByteBetweenSlices& byte = pass.bytes[i];
        const uint64_t value = random() & random();
        for (uint8_t bit = 0; bit < 8; ++bit) {
          if ((byte.set >> bit & 1) == 0) continue;
          by_slices.Write({.space = byte.space, .offset = byte.offset, .bit = bit}, value >> bit & 1);
          by_pass.Write({.space = pass.pass.inputs[slice], .offset = i, .bit = bit}, value >> bit & 1);
        }
      }
      by_slices.RunPeriod(time);
      time += whole.program.schedule.period_ms;
    }
    by_pass.RunPeriod(begin);
    for (uint32_t s = 0; s < whole.program.spaces.size(); ++s) {
      if (whole.program.spaces[ir::SpaceId(s)].lifetime == ir::Lifetime::kRoutine) continue;
      const auto expected = by_slices.Memory(ir::SpaceId(s)), found = by_pass.Memory(ir::SpaceId(s));
      ASSERT_TRUE(std::ranges::equal(expected, found))
          << whole.program.spaces[ir::SpaceId(s)].name << " behind pass " << count;
      if (whole.program.spaces[ir::SpaceId(s)].name == "A") states.emplace(expected.begin(), expected.end());
    }
  }
  EXPECT_GT(states.size(), 8U);
}

INSTANTIATE_TEST_SUITE_P(All, PassMachineTest,
                         testing::Values(SlicedProgram{2, "off"}, SlicedProgram{3, "off"}, SlicedProgram{3, "on"},
                                         SlicedProgram{7, "off"}),
                         [](const auto& info) { return info.param.latches + std::to_string(info.param.slices); });

}  // namespace
}  // namespace plcxx::scenarios
