// Changes side by side end as each ends by itself: over golden programs of every language and the sample machines.
#include "transpiler/mutate/side_by_side.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "tests/volume.h"
#include "transpiler/dialects/dialect.h"
#include "transpiler/mutate/mutate.h"
#include "transpiler/scenarios/program.h"

namespace plcxx::mutate {
namespace {

namespace fs = std::filesystem;

/// Scenarios of one program.
struct Machine {
  compilation::Compilation compilation;
  std::vector<scenarios::Scenario> scenarios;
};

std::vector<fs::path> ScenariosBelow(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

/// None: it drives nothing, or is about errors.
std::optional<scenarios::Scenario> Driving(const fs::path& path) {
  scenarios::ScenarioOrErrors read = scenarios::ReadScenario(path.string());
  auto* const scenario = std::get_if<scenarios::Scenario>(&read);
  if (scenario == nullptr || !scenario->steps || scenario->expect_error) return std::nullopt;
  if (!scenarios::WhyNoProgram(*scenario, {}).empty()) return std::nullopt;
  return std::move(*scenario);
}

/// The language of "nc110/lathe_16k20", which a build without Clang does not have when it is hnc.
bool IsHere(const std::string& folder) {
  return dialects::DialectByName(folder.substr(0, folder.find('/'))) != nullptr;
}

std::string NameOf(const testing::TestParamInfo<const char*>& named) {
  std::string name = named.param;
  std::ranges::replace_if(name, [](char c) { return c == '/' || c == '.'; }, '_');
  return name;
}

struct Count {
  size_t changes = 0, noticed = 0, alone = 0;
};

void Compare(Machine& machine, size_t most, Count& count) {
  if (!machine.compilation.ok()) return;
  MutateRequest request{
      .compilation = machine.compilation, .scenarios = machine.scenarios, .most = most, .jobs = 1, .way = Way::kAlone};
  const auto alone = Mutate(request);
  request.way = Way::kSideBySide;
  const auto together = Mutate(request);
  const std::string& name = machine.scenarios.front().path;
  ASSERT_EQ(alone.index(), together.index()) << name;
  if (alone.index() != 0) return;  // it fails before
  const auto& one = std::get<Mutated>(alone).results;
  const auto& other = std::get<Mutated>(together).results;
  ASSERT_EQ(one.size(), other.size()) << name;
  for (size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(Name(one[i].outcome), Name(other[i].outcome))
        << name << ": change " << i << " of line of statement " << one[i].change.statement.index << ": "
        << one[i].change.text;
    count.noticed += one[i].outcome == Outcome::kNoticed ? 1 : 0;
  }
  count.changes += one.size();
  const size_t reached = static_cast<size_t>(
      std::ranges::count_if(one, [](const ChangeResult& result) { return result.outcome != Outcome::kNotReached; }));
  if (reached > 1) count.alone += std::get<Mutated>(together).alone;
}

class OfLanguage : public testing::TestWithParam<const char*> {};

TEST_P(OfLanguage, EndAsEachAlone) {
  if (!IsHere(GetParam())) GTEST_SKIP() << "the language is not built";
  const std::vector<fs::path> all = ScenariosBelow(fs::path(PLCXX_ROOT) / "tests/golden" / GetParam());
  const size_t step = testing_support::Volume<size_t>(40, 1);
  Count count;
  for (size_t i = 0; i < all.size(); i += step) {
    std::optional<scenarios::Scenario> scenario = Driving(all[i]);
    if (!scenario) continue;
    Machine machine{.compilation = compilation::Compile(scenarios::RequestOf(*scenario, {})), .scenarios = {}};
    machine.scenarios.push_back(std::move(*scenario));
    Compare(machine, testing_support::Volume<size_t>(25, 0), count);
  }
  EXPECT_GT(count.noticed, 10U);
  EXPECT_LT(count.alone * 5, count.changes) << "hardly any is tried side by side";
}

INSTANTIATE_TEST_SUITE_P(SideBySide, OfLanguage,
                         testing::Values("nc110", "host50", "prostep", "technol", "hnc", "classicladder"), NameOf);

/// What is rare: facts that do not hold, messages, calls, properties, retentive memory.
class OfScenario : public testing::TestWithParam<const char*> {};

TEST_P(OfScenario, EndAsEachAlone) {
  if (!IsHere(GetParam())) GTEST_SKIP() << "the language is not built";
  std::optional<scenarios::Scenario> scenario = Driving(fs::path(PLCXX_ROOT) / "tests/golden" / GetParam());
  ASSERT_TRUE(scenario);
  Machine machine{.compilation = compilation::Compile(scenarios::RequestOf(*scenario, {})), .scenarios = {}};
  machine.scenarios.push_back(std::move(*scenario));
  Count count;
  Compare(machine, 0, count);
  EXPECT_GT(count.noticed, 0U);
}

INSTANTIATE_TEST_SUITE_P(SideBySide, OfScenario,
                         testing::Values("hnc/loops/limit_is_forced.yaml",
                                         "hnc/faults/limit_of_an_index_is_forced.yaml"),
                         NameOf);

class OfMachine : public testing::TestWithParam<const char*> {};

TEST_P(OfMachine, EndAsEachAlone) {
  if (!IsHere(GetParam())) GTEST_SKIP() << "the language is not built";
  std::map<std::string, Machine> machines;
  for (const fs::path& path : ScenariosBelow(fs::path(PLCXX_ROOT) / "samples" / GetParam())) {
    std::optional<scenarios::Scenario> scenario = Driving(path);
    if (!scenario) continue;
    compilation::CompilationRequest request = scenarios::RequestOf(*scenario, {});
    const auto [machine, is_new] = machines.try_emplace(scenarios::KeyOf(request));
    if (is_new) machine->second.compilation = compilation::Compile(request);
    machine->second.scenarios.push_back(std::move(*scenario));
  }
  Count count;
  for (auto& [key, machine] : machines) Compare(machine, testing_support::Volume<size_t>(16, 200), count);
  EXPECT_GT(count.noticed, 4U);
  EXPECT_LT(count.alone * 5, count.changes) << "hardly any is tried side by side";
}

INSTANTIATE_TEST_SUITE_P(SideBySide, OfMachine,
                         testing::Values("nc110/lathe_16k20", "host50/ck6150", "prostep/mill_fnd32", "hnc/mill_xk7132",
                                         "technol/mcv_750", "classicladder/turret"),
                         NameOf);

}  // namespace
}  // namespace plcxx::mutate
