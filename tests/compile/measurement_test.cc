// Figures of compiled code whose size is known.
#include "transpiler/compile/measurement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/compile/compiled_fixture.h"

namespace plcxx::compile {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr const char* kText = R"(#include <stdint.h>
namespace sample {
struct Host;
void fault(Host& host, volatile uint8_t* bytes) noexcept;
__attribute__((noinline)) static void Deep(Host& host) noexcept {
  volatile uint8_t bytes[200];
  bytes[0] = 1;
  fault(host, bytes);
  bytes[1] = 2;
}
void slow(Host& host, uint32_t& value, uint32_t end) noexcept {
  for (uint32_t i = 0; i < end; ++i) {
    value = value * 5u + (value >> 3);
  }
  Deep(host);
  value = value + 1u;
}
}
)";
constexpr uint32_t kLoopLine = 12;

Figures Of(const ProgramCode& code, std::optional<uint64_t> rounds) {
  const LoopBounds bounds{.loops = {LoopAt("text.cpp", kText, kLoopLine, rounds)}};
  const uint32_t function = code.Find("sample::slow");
  EXPECT_NE(function, kNoFunction);
  return Measurement(code, bounds).From(function);
}

TEST(Measurement, RoundsStackAndCallsCount) {
  for (const Tools& tools : InstalledTools()) {
    SCOPED_TRACE(std::string(tools.target->name) + ", " + tools.toolchain.version);
    const auto code = CompileText(kText, *tools.target, tools.toolchain);
    ASSERT_TRUE(code);
    const Figures ten = Of(*code, 10), twenty = Of(*code, 20), thirty = Of(*code, 30);
    EXPECT_THAT(ten.not_whole, IsEmpty());
    EXPECT_GE(twenty.longest.instructions - ten.longest.instructions, 30u);
    EXPECT_EQ(twenty.longest.instructions - ten.longest.instructions,
              thirty.longest.instructions - twenty.longest.instructions);
    EXPECT_GT(twenty.longest.cycles, ten.longest.cycles);
    EXPECT_GE(ten.stack_bytes, 200u);
    EXPECT_LE(ten.stack_bytes, 400u);
    EXPECT_GT(ten.code_bytes, 20u);
    EXPECT_THAT(ten.host, ElementsAre("sample::fault"));
    EXPECT_THAT(Of(*code, std::nullopt).not_whole,
                ElementsAre("loop without known bound in sample::slow (text.cpp:12): its repetitions are not in"));
  }
}

TEST(Measurement, LoopsOfABudgetShareItsRounds) {
  for (const Tools& tools : InstalledTools()) {
    SCOPED_TRACE(std::string(tools.target->name) + ", " + tools.toolchain.version);
    const auto code = CompileText(kText, *tools.target, tools.toolchain);
    ASSERT_TRUE(code);
    LoopBounds bounds{.loops = {LoopAt("text.cpp", kText, kLoopLine, std::nullopt)}};
    bounds.loops.front().budget = 7;
    const uint32_t function = code->Find("sample::slow");
    Measurement measurement(*code, bounds);
    EXPECT_THAT(measurement.From(function).not_whole, testing::SizeIs(1));
    const Figures shared = measurement.From(function, {{7, 20}});
    EXPECT_THAT(shared.not_whole, IsEmpty());
    // Compilers make two loops of one, for many rounds at once and for the rest: each may have all of its own rounds.
    const Figures alone = Of(*code, 20), once = measurement.From(function, {{7, 0}});
    EXPECT_LE(shared.longest.instructions, alone.longest.instructions);
    EXPECT_LE(shared.longest.cycles, alone.longest.cycles);
    EXPECT_GE(shared.longest.instructions, once.longest.instructions + 20 * 3);
  }
}

// Loops that compilers make of an assignment go round at most once for each byte of the object.
TEST(Measurement, ALoopOfTheCompilersOwnIsBoundedByTheLargestObject) {
  constexpr const char* kCopies = R"(#include <stdint.h>
namespace sample {
struct Large { uint32_t words[300]; };
void clear(Large& large) noexcept { large = Large{}; }
}
)";
  constexpr uint64_t kBytes = 1200;
  for (const Tools& tools : InstalledTools()) {
    SCOPED_TRACE(std::string(tools.target->name) + ", " + tools.toolchain.version);
    const auto code = CompileText(kCopies, *tools.target, tools.toolchain);
    ASSERT_TRUE(code);
    const LoopBounds bounds{.loops = {}, .largest_object = kBytes};
    EXPECT_THAT(Measurement(*code, bounds).From(code->Find("sample::clear")).not_whole, IsEmpty());
  }
}

TEST(Measurement, ALoopEndsAtItsBrace) {
  const KnownLoop loop = LoopAt("text.cpp", kText, kLoopLine, 10);
  EXPECT_EQ(loop.first, 12u);
  EXPECT_EQ(loop.last, 14u);
}

TEST(Measurement, LoopsOfTheRuntimeAreKnown) {
  std::vector<KnownLoop> loops;
  AddRuntimeLoops(loops, 77);
  std::vector<uint64_t> bcd, state;
  for (const KnownLoop& loop : loops) {
    if (loop.file == "plcxx/bcd.h") bcd.push_back(loop.rounds.value_or(0));
    if (loop.file == "plcxx/state.h") state.push_back(loop.rounds.value_or(0));
  }
  EXPECT_THAT(bcd, ElementsAre(4, 8, 8));
  EXPECT_THAT(state, ElementsAre(77, 77));
}

}  // namespace
}  // namespace plcxx::compile
