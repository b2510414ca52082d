// Every golden scenario and every sample of a dialect with a second reading, in the simulator and in the reference.
#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "tests/reference/reference_dialects.h"
#include "tests/reference/runs.h"
#include "transpiler/scenarios/suite.h"

namespace plcxx::reference {
namespace {

std::vector<std::string> ScenariosOf(std::string_view dialect) {
  const std::string root = PLCXX_ROOT;
  const auto found = scenarios::FindScenarios(
      {root + "/tests/golden/" + std::string(dialect), root + "/samples/" + std::string(dialect)});
  return std::get<std::vector<std::string>>(found);
}

class ReferenceTest : public testing::TestWithParam<ReferenceDialect> {};

TEST_P(ReferenceTest, GoldenScenarios) {
  const ReferenceDialect& dialect = GetParam();
  uint32_t unsupported = 0, ran = 0;
  uint64_t compared = 0;
  for (const std::string& path : ScenariosOf(dialect.name)) {
    const scenarios::ScenarioOrErrors read = scenarios::ReadScenario(path);
    const auto* const scenario = std::get_if<scenarios::Scenario>(&read);
    if (scenario == nullptr || !scenario->steps || scenario->expect_error) continue;
    compilation::Compilation compilation = compilation::Compile(scenarios::RequestOf(*scenario, {}));
    if (compilation.dialect == nullptr || compilation.dialect->name != dialect.name) continue;
    const RunResult result = RunBeside(*scenario, compilation, dialect);
    compared += result.compared;
    switch (result.outcome) {
      case Outcome::kAgrees:
        ++ran;
        break;
      case Outcome::kDisagrees:
        ADD_FAILURE() << result.text;
        break;
      case Outcome::kUnsupported:
        ++unsupported;
        GTEST_LOG_(INFO) << "unsupported: " << result.text;
        break;
      case Outcome::kNothingToRun:
        ADD_FAILURE() << path << ": the program has errors";
        break;
    }
  }
  EXPECT_EQ(unsupported, dialect.unsupported_scenarios);
  GTEST_LOG_(INFO) << dialect.name << ": " << ran << " scenarios, " << compared << " values compared";
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ReferenceTest);
INSTANTIATE_TEST_SUITE_P(Dialects, ReferenceTest,
                         testing::ValuesIn(ReferenceDialects().begin(), ReferenceDialects().end()),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace plcxx::reference
