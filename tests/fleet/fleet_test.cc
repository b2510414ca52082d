// Each lane of a fleet is a machine of its own, beside a simulator with the same inputs.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <variant>

#include "tests/fleet/lanes_beside.h"
#include "tests/reference/random_program.h"
#include "tests/reference/reference_dialects.h"
#include "tests/temporary_directory.h"
#include "tests/volume.h"
#include "transpiler/compilation/compilation.h"
#include "transpiler/engines/platform.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/scenario.h"

namespace plcxx::fleet {
namespace {

using testing_support::Volume;

std::shared_ptr<const Library> Built(const ir::Program& program, unsigned lanes, bool forces = false) {
  LibraryOrFailure built = CompileFleet(
      program, {.compiler = engines::FindCompiler(), .level = "1", .lanes = lanes, .forces = forces, .cache = {}});
  if (const auto* failure = std::get_if<std::string>(&built)) {
    ADD_FAILURE() << *failure;
    return nullptr;
  }
  return std::get<std::shared_ptr<const Library>>(built);
}

compilation::Compilation Compiled(const std::string& name, const std::string& text) {
  compilation::CompilationRequest request;
  request.sources = {name};
  request.texts[name] = text;
  return compilation::Compile(request);
}

/// Coils, timers, counters, one-shots, bytes and comparisons.
constexpr const char* kProgram = R"($
U4A0=I0A0*/I0A1+U4A0*I0A2
T1I(3)=I0A3
T2I(1)=U4A0+I0A4
C1I(3)=I0A5*/T1U
C1A=I0A6
C1Z=I0A7*I0A8
P1=I0A9
U4A1=T1U+T2D
U4A2=C1R+P1
W5A0=W1A0
U4A3=[W1A1<5]*I0A10
U4A4=[W1A1=W1A2]+[W1A1>200]
)";

class WidthTest : public testing::TestWithParam<unsigned> {};

TEST_P(WidthTest, EachLaneIsAMachine) {
  const compilation::Compilation compiled = Compiled("machine.plc", kProgram);
  ASSERT_TRUE(compiled.ok());
  if (GetParam() > WidestFleet()) GTEST_SKIP() << "this processor has no such vectors";
  for (const bool forces : {false, true}) {
    const auto library = Built(compiled.program, GetParam(), forces);
    ASSERT_NE(library, nullptr);
    EXPECT_EQ(library->lanes, GetParam());
    EXPECT_EQ(CompareLanes(library, 1, 400), "");
  }
}

INSTANTIATE_TEST_SUITE_P(Fleet, WidthTest, testing::Values(64u, 256u, 512u));

/// Timers that all lanes step together: short and long ones, held, driven twice, in the fast part and in
/// the slow one, written by the control; with times that leap.
constexpr const char* kTimers = R"(
T1I(3)=I0A0
T2I(250)=I0A1+I0A2*/I0A3
$
T3I(1)=I0A3
T3A=I0A4*I0A5
T4I(7)=I0A6
T4I(2)=I0A7
T50I(1)=I0A8
T6I(40)=/T6U*/I0A9
T7I(9)=/I0A0+I0A1+/I0A2
T7A=I0A3
T8I(20)=I0A0+/I0A0
C1I(3)=T6U
U4A0=T1U+T2D+T3U
U4A1=T4U*T50U+T7D
U4A2=C1R
)";

TEST(Fleet, TimersOfAllLanesAtOnce) {
  const compilation::Compilation compiled = Compiled("timers.plc", kTimers);
  ASSERT_TRUE(compiled.ok());
  const Layout layout = LayOut(compiled.program, SameEverywhere(compiled.program));
  EXPECT_EQ(layout.clock_count, 8u);
  for (const bool forces : {false, true}) {
    const auto library = Built(compiled.program, 64, forces);
    ASSERT_NE(library, nullptr);
    EXPECT_EQ(CompareLanes(library, 2, 800), "");
    EXPECT_EQ(CompareLanes(library, 3, 800, Hosts::kWild), "");
  }
}

/// Times, counts and slices are one number for all machines: no plane, no mask.
TEST(Fleet, WhatIsTheSameEverywhereIsAScalar) {
  const compilation::Compilation compiled = Compiled("machine.plc", kProgram);
  ASSERT_TRUE(compiled.ok());
  const Layout layout = LayOut(compiled.program, SameEverywhere(compiled.program));
  EXPECT_GE(layout.scalars, 8u);  // the time and the number of the slow cycle
  for (uint32_t s = 0; s < compiled.program.spaces.size(); ++s) {
    if (!compiled.program.spaces[ir::SpaceId(s)].host_visible) continue;
    for (const ByteHome& home : layout.bytes[s]) EXPECT_FALSE(home.is_scalar());
  }
}

/// Programs of each language that has a generator.
TEST(Fleet, RandomProgramsOfEachLanguage) {
  for (const reference::ReferenceDialect& dialect : reference::ReferenceDialects()) {
    for (uint64_t seed = 1; seed <= Volume<uint64_t>(1, 60); ++seed) {
      SCOPED_TRACE(std::string(dialect.name) + ", seed " + std::to_string(seed));
      reference::Random random(seed);
      const reference::RandomProgram program =
          dialect.generate(random, reference::ProgramSize::kSmall, reference::Spelling::kPlain);
      const testing_support::TemporaryDirectory directory;
      std::string scenario_path;
      for (const reference::RenderedFile& file : Render(program, std::string(dialect.name))) {
        scenario_path = (directory.path() / file.name).string();
        std::ofstream(scenario_path, std::ios::binary) << file.text;
      }
      const scenarios::ScenarioOrErrors read = scenarios::ReadScenario(scenario_path, scenarios::Reach::kAnywhere);
      ASSERT_TRUE(std::holds_alternative<scenarios::Scenario>(read));
      const compilation::Compilation compiled =
          compilation::Compile(scenarios::RequestOf(std::get<scenarios::Scenario>(read), {}));
      ASSERT_TRUE(compiled.ok());
      const auto library = Built(compiled.program, 64);
      ASSERT_NE(library, nullptr);
      EXPECT_EQ(CompareLanes(library, seed, 60), "");
    }
  }
}

/// What cannot be sliced is counted.
TEST(Fleet, ShareIsReported) {
  const compilation::Compilation compiled = Compiled("machine.plc", kProgram);
  ASSERT_TRUE(compiled.ok());
  const SameEverywhere same(compiled.program);
  const Code code = WriteCode(compiled.program, LayOut(compiled.program, same), same);
  EXPECT_GT(code.share.sliced, 10 * code.share.per_lane);
}

}  // namespace
}  // namespace plcxx::fleet
