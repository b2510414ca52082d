// Random programs with fixed seeds, in the simulator and in the reference. More of them: dev/soak.
#include <gtest/gtest.h>

#include <string>

#include "tests/reference/reference_dialects.h"
#include "tests/reference/runs.h"
#include "tests/temporary_directory.h"

namespace plcxx::reference {
namespace {

constexpr uint32_t kPrograms = 200, kLargeOneIn = 20;

class RandomPrograms : public testing::TestWithParam<ReferenceDialect> {};

TEST_P(RandomPrograms, Agree) {
  const ReferenceDialect& dialect = GetParam();
  const testing_support::TemporaryDirectory directory;
  uint64_t compared = 0;
  for (uint32_t i = 0; i < kPrograms; ++i) {
    Random random(i);
    const bool large = i % kLargeOneIn == kLargeOneIn - 1;
    const RandomProgram program = dialect.generate(random, large ? ProgramSize::kLarge : ProgramSize::kSmall);
    const RunResult result = RunRandom(program, dialect, directory.path().string());
    compared += result.compared;
    EXPECT_EQ(result.outcome, Outcome::kAgrees) << "seed " << i << ": " << result.text;
  }
  GTEST_LOG_(INFO) << dialect.name << ": " << compared << " values compared";
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
