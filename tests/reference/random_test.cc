// Random programs with fixed seeds, in the simulator and in the reference. More of them: dev/soak.
#include <gtest/gtest.h>

#include <string>

#include "tests/reference/crossed.h"
#include "tests/reference/reference_dialects.h"
#include "tests/reference/runs.h"
#include "tests/reference/spellings.h"
#include "tests/temporary_directory.h"

namespace plcxx::reference {
namespace {

constexpr uint32_t kPrograms = 200, kLargeOneIn = 20, kCapriciousOneIn = 3;

class RandomPrograms : public testing::TestWithParam<ReferenceDialect> {};

TEST_P(RandomPrograms, Agree) {
  const ReferenceDialect& dialect = GetParam();
  const testing_support::TemporaryDirectory directory;
  uint64_t compared = 0;
  for (uint32_t i = 0; i < kPrograms; ++i) {
    Random random(i);
    const bool large = i % kLargeOneIn == kLargeOneIn - 1;
    RandomProgram program = dialect.generate(random, large ? ProgramSize::kLarge : ProgramSize::kSmall, Spelling::kAny);
    if (i % kCapriciousOneIn == 0) program.caprices = i;
    const RunResult result = RunRandom(program, dialect, directory.path().string());
    compared += result.compared;
    EXPECT_EQ(result.outcome, Outcome::kAgrees) << "seed " << i << ": " << result.text;
  }
  GTEST_LOG_(INFO) << dialect.name << ": " << compared << " values compared";
}

/// Golden programs with changes. Those that are refused say nothing, so some must not be.
TEST_P(RandomPrograms, CrossedGoldensAgree) {
  const ReferenceDialect& dialect = GetParam();
  const testing_support::TemporaryDirectory directory;
  const Goldens goldens(dialect.name);
  ASSERT_GT(goldens.size(), 100U);
  uint32_t ran = 0;
  for (uint32_t i = 0; i < kPrograms; ++i) {
    Random random(i);
    const RunResult result = RunRandom(goldens.Crossed(random), dialect, directory.path().string());
    EXPECT_NE(result.outcome, Outcome::kDisagrees) << "seed " << i << ": " << result.text;
    ran += result.outcome == Outcome::kAgrees ? 1 : 0;
  }
  EXPECT_GT(ran, 0U);
  GTEST_LOG_(INFO) << dialect.name << ": " << ran << " of " << kPrograms << " ran";
}

TEST_P(RandomPrograms, MeanTheSameInAnySpelling) {
  const ReferenceDialect& dialect = GetParam();
  const testing_support::TemporaryDirectory directory;
  for (uint32_t i = 0; i < kPrograms; ++i) {
    const bool large = i % kLargeOneIn == kLargeOneIn - 1;
    const std::string difference =
        DifferentSpellings(dialect, i, large ? ProgramSize::kLarge : ProgramSize::kSmall, directory.path().string());
    EXPECT_EQ(difference, "") << "seed " << i;
  }
}

TEST(WithoutSpelling, LeavesWhatIsDone) {
  const std::string one =
      "statement s1f subject A\nstate T5 timer\nplace A bit I[4].0 address %A\n  stmt s1f ; A\n"
      "  %0 = const i32 0x1f\n  step T5 %0\n  store A %0\n";
  const std::string other =
      "statement s20 subject B\nstate T timer\nplace B bit I[4].0\n  stmt s20\n"
      "  %0 = const i32 32\n  step T %0\n  store B %0\n";
  EXPECT_EQ(WithoutSpelling(one), WithoutSpelling(other));
  EXPECT_NE(WithoutSpelling(one), WithoutSpelling("statement s20\nstate T timer\nplace B bit I[4].1\n  stmt s20\n"
                                                  "  %0 = const i32 32\n  step T %0\n  store B %0\n"));
}

TEST(Shrink, KeepsWhatFails) {
  RandomProgram program;
  program.files = {{"a", {{"1", {}, ""}, {"if", {{"2", {}, ""}, {"3", {}, ""}}, "end"}, {"4", {}, ""}}}};
  program.steps = {"x", "y"};
  program.options = {{"key", "value"}};
  const RandomProgram small = Shrink(program, [](const RandomProgram& less) {
    const std::string text = Render(less, "d").front().text;
    return text.find('3') != std::string::npos;
  });
  EXPECT_EQ(Render(small, "d").front().text, "3\n");
  EXPECT_TRUE(small.steps.empty());
  EXPECT_TRUE(small.options.empty());
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RandomPrograms);
INSTANTIATE_TEST_SUITE_P(Dialects, RandomPrograms,
                         testing::ValuesIn(ReferenceDialects().begin(), ReferenceDialects().end()),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace plcxx::reference
