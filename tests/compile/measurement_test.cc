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
  const std::vector<KnownLoop> loops = {LoopAt("text.cpp", kText, kLoopLine, rounds)};
  const uint32_t function = code.Find("sample::slow");
  EXPECT_NE(function, kNoFunction);
  return Measurement(code, loops).From(function);
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
                ElementsAre("loop without known bound in sample::slow: its repetitions are not in"));
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
