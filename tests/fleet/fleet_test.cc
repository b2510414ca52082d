// Each lane of a fleet is a machine of its own, beside a simulator with the same inputs.
#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "tests/fleet/lanes_beside.h"
#include "tests/reference/random_program.h"
#include "tests/reference/reference_dialects.h"
#include "tests/reference/runs.h"
#include "tests/temporary_directory.h"
#include "tests/volume.h"
#include "transpiler/compilation/compilation.h"
#include "transpiler/engines/platform.h"
#include "transpiler/fleet/fleet.h"
#include "transpiler/fleet/lane.h"
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

/// It would end with an instruction that the processor does not have.
TEST(Fleet, WhatThisProcessorCannotExecuteIsNotCompiled) {
  const compilation::Compilation compiled = Compiled("machine.plc", kProgram);
  ASSERT_TRUE(compiled.ok());
  const unsigned too_wide = 2 * WidestFleet();
  const LibraryOrFailure built = CompileFleet(
      compiled.program,
      {.compiler = engines::FindCompiler(), .level = "1", .lanes = too_wide, .forces = false, .cache = {}});
  ASSERT_TRUE(std::holds_alternative<std::string>(built));
  EXPECT_EQ(std::get<std::string>(built), TooWide(too_wide));
  EXPECT_EQ(TooWide(WidestFleet()), "");
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

/// All lanes become what one of another fleet is, with what is stored and timers that run, and go on alike.
TEST(Fleet, AllLanesBecomeOne) {
  const std::string program = std::string(kProgram) + "U50K1=I0A9+U50K1\nT50I(40)=I0A8\nU4A5=T50U\n";
  const compilation::Compilation compiled = Compiled("machine.plc", program);
  ASSERT_TRUE(compiled.ok());
  const auto library = Built(compiled.program, 64);
  ASSERT_NE(library, nullptr);
  std::vector<std::vector<uint8_t>> nothing;
  for (const ir::Space& space : compiled.program.spaces) nothing.emplace_back(space.bytes);
  Fleet one(library), other(library);
  one.PowerOn();
  other.PowerOn();
  reference::Random random(5);
  std::vector<ir::Place> inputs;
  for (const ir::Place& place : compiled.program.places) {
    if (place.type == ir::Type::kBit && !place.is_field() && place.name.starts_with("I0")) inputs.push_back(place);
  }
  ASSERT_FALSE(inputs.empty());
  uint32_t now_ms = 0;
  for (const unsigned lane : {0U, 17U, 63U}) {
    for (int period = 0; period < 30; ++period) {
      for (unsigned each = 0; each < 64; ++each) one.Write(each, random.Pick(inputs), random.Below(2));
      one.Run(Piece::kPeriod, now_ms += 10);
    }
    other.BecomeAll(one, lane);
    for (int period = 0; period < 30; ++period) {
      const ir::Place& input = random.Pick(inputs);
      const uint32_t value = random.Below(2);
      one.Write(lane, input, value);
      for (unsigned each = 0; each < 64; ++each) other.Write(each, input, value);
      if (period == 20) {
        // Power comes back, with the memory that was kept.
        one.StoreRetentive();
        other.StoreRetentive();
        one.PowerOn();
        other.PowerOn();
      }
      one.Run(Piece::kPeriod, now_ms += 10);
      other.Run(Piece::kPeriod, now_ms);
      const std::vector<uint8_t> expected = one.Snapshot(lane, nothing);
      for (unsigned each = 0; each < 64; ++each)
        ASSERT_EQ(other.Snapshot(each, nothing), expected) << lane << ", " << each;
    }
  }
}

/// A control is shown at once what only it writes, up to the first byte that the program may write, too.
TEST(Fleet, ALaneHasWhatOnlyItsHostWrites) {
  const compilation::Compilation compiled = Compiled("machine.plc", kProgram);
  ASSERT_TRUE(compiled.ok());
  const auto library = Built(compiled.program, 64);
  ASSERT_NE(library, nullptr);
  const HostOnlyBytes host_only = FindHostOnly(compiled.program);
  Fleet fleet(library);
  Lane lane(fleet, 3, host_only);
  lane.PowerOn();
  fleet.PowerOn();
  size_t shown = 0, hidden = 0;
  reference::Random random(9);
  for (const ir::Place& place : compiled.program.places) {
    if (place.is_field() || place.indexed || !compiled.program.spaces[place.space].host_visible) continue;
    lane.Write(place, random.Next());
    const uint64_t written = lane.Read(place);
    EXPECT_EQ(fleet.Read(3, place), written) << place.name;
    if (place.type != ir::Type::kI8) continue;
    const std::span<const uint8_t> bytes = lane.MemoryFrom(place.space, place.offset);
    (bytes.empty() ? hidden : shown) += 1;
    if (!bytes.empty()) EXPECT_EQ(bytes.front(), written) << place.name;
  }
  EXPECT_GT(shown, 0U);
  EXPECT_GT(hidden, 0U);
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
      const scenarios::ScenarioOrErrors read = reference::WriteRandom(program, dialect, directory.path().string());
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
