// plcxx diff against simulation: random single edits of the golden programs and sample machines of every language.
//
// What diff calls equal must be equal in every simulated run; what it calls different must have a scenario that passes
// on the old version and fails on the new one, where a scenario can show it. The test makes a few edits of each
// language; PLCXX_EDITS=500 makes as many (PLCXX_EDITS_SEED, PLCXX_EDITS_DIALECT and PLCXX_EDITS_OF, a part of the
// scenario's path, choose others), and prints a line for each with what is open.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <variant>

#include "tests/diff/both_simulated.h"
#include "tests/diff/source_edits.h"
#include "tests/scenario_texts.h"
#include "tests/temporary_directory.h"
#include "transpiler/review/diff/diff.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/scenarios/suite.h"

namespace plcxx::review::diff {
namespace {

namespace fs = std::filesystem;

std::string Setting(const char* name, const std::string& otherwise) {
  const char* const value = std::getenv(name);
  return value == nullptr ? otherwise : value;
}

std::string Content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

bool IsLong() { return std::getenv("PLCXX_EDITS") != nullptr; }

/// Scenarios of programs that compile: of the goldens, and in a long run of the sample machines.
std::vector<fs::path> ScenariosOf(const std::string& dialect) {
  std::vector<fs::path> paths;
  const std::string part = Setting("PLCXX_EDITS_OF", "");
  for (const char* const folder : {"tests/golden/", "samples/"}) {
    if (folder == std::string("samples/") && !IsLong()) continue;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(PLCXX_ROOT) / (folder + dialect))) {
      const std::string path = entry.path().string();
      if (entry.path().extension() != ".yaml" || path.ends_with("_bad.yaml") || path.ends_with("properties.yaml") ||
          path.ends_with("plcxx.yaml"))
        continue;
      if (path.find(part) != std::string::npos) paths.push_back(entry.path());
    }
  }
  std::ranges::sort(paths);
  return paths;
}

/// A scenario's program in two copies, one of which is edited.
class EditedProgram {
 public:
  explicit EditedProgram(const fs::path& scenario) {
    const scenarios::ScenarioOrErrors read = scenarios::ReadScenario(scenario.string());
    if (!std::holds_alternative<scenarios::Scenario>(read) || !std::get<scenarios::Scenario>(read).steps) return;
    scenarios::Scenario copied = std::get<scenarios::Scenario>(read);
    for (const auto& [name, text] : TakeTexts(copied)) {
      for (const auto* copy : {&old_, &new_}) copy->Write(name, text);
    }
    // Files beside it may be included, or named by options.
    for (const auto& entry : fs::directory_iterator(scenario.parent_path())) {
      if (entry.is_directory() || entry.path().extension() == ".yaml") continue;
      for (const auto* copy : {&old_, &new_}) fs::copy_file(entry.path(), copy->path() / entry.path().filename());
    }
    // A known run to begin with.
    fs::copy_file(scenario, old_.path() / scenario.filename());
    copied.directory = old_.path().string();
    old_request_ = scenarios::RequestOf(copied, {});
    copied.directory = new_.path().string();
    new_request_ = scenarios::RequestOf(copied, {});
    for (const std::string& source : copied.sources) {
      if (fs::exists(old_.path() / source)) files_[source] = Content(old_.path() / source);
    }
  }

  const std::map<std::string, std::string>& files() const { return files_; }
  std::string directory() const { return old_.path().string(); }
  DiffSide OldSide() const { return MakeDiffSide("old", old_request_); }
  /// The edited copy, until the next call.
  DiffSide NewSide(const SourceEdit& edit) const {
    for (const auto& [name, text] : files_) new_.Write(name, name == edit.file ? edit.text : text);
    return MakeDiffSide("new", new_request_);
  }
  bool PassesOnOld(const std::string& scenario) const { return Passes(scenario, old_request_); }
  bool PassesOnNew(const std::string& scenario) const { return Passes(scenario, new_request_); }

 private:
  bool Passes(const std::string& scenario, const compilation::CompilationRequest& request) const {
    const scenarios::ScenarioOrErrors parsed = scenarios::ParseScenario(old_.File("counterexample.yaml"), scenario);
    if (!std::holds_alternative<scenarios::Scenario>(parsed)) return false;
    scenarios::ScenarioProgram program(request);
    return scenarios::TestScenario(std::get<scenarios::Scenario>(parsed), scenarios::SuiteOptions(), program)
               .test.outcome == scenarios::TestOutcome::kPassed;
  }

  testing_support::TemporaryDirectory old_, new_;
  compilation::CompilationRequest old_request_, new_request_;
  std::map<std::string, std::string> files_;
};

struct Counts {
  int edits = 0, equal = 0, different = 0, items_different = 0, items_undecided = 0, without_scenario = 0;
};

/// Compares one edit, and the comparison with simulations.
void Judge(const EditedProgram& program, DiffSide& old_side, const SourceEdit& edit, terms::Random& random,
           Counts& counts) {
  DiffSide new_side = program.NewSide(edit);
  if (!new_side.compilation.ok() || !new_side.compilation.has_program) return;
  const bool is_long = IsLong();
  const DiffOptions options{
      .same = {}, .time_ms = is_long ? 20'000U : 4'000U, .scenario_directory = program.directory(), .progress = {}};
  const auto begin = std::chrono::steady_clock::now();
  const Diff diff = CompareSides(old_side, new_side, options);
  const auto ms =
      std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - begin).count();
  if (is_long) std::cout << "  " << ms << " ms  " << edit.file << " " << edit.what << "\n";
  if (!diff.refusal.empty()) {
    std::cout << "  REFUSED " << diff.refusal << "\n";
    return;
  }
  ++counts.edits;
  (diff.items.empty() ? counts.equal : counts.different) += 1;
  const SimulatedRuns runs = is_long ? SimulatedRuns{.runs = 24, .steps = 60} : SimulatedRuns{};
  const auto seen = SeenToDiffer(old_side, new_side, diff, options, runs, random);
  EXPECT_FALSE(seen.has_value()) << edit.file << " " << edit.what << "\n" << *seen;
  if (seen) std::cout << "  UNSOUND " << *seen << "\n";
  for (const DiffItem& item : diff.items) {
    switch (item.verdict) {
      case ItemVerdict::kEqual:
        break;
      case ItemVerdict::kUndecided:
        ++counts.items_undecided;
        if (is_long) std::cout << "    undecided " << item.name << ": " << item.reason << "\n";
        break;
      case ItemVerdict::kDifferent: {
        ++counts.items_different;
        const bool has_scenario = item.counterexample && !item.counterexample->scenario.empty();
        if (is_long && item.counterexample && item.counterexample->from_state) {
          std::cout << "    from a state " << item.name << ": " << item.counterexample->steps << "\n";
        }
        if (!has_scenario) {
          ++counts.without_scenario;
          if (is_long)
            std::cout << "    no scenario " << item.name
                      << (item.counterexample ? ": " + item.counterexample->steps : std::string()) << "\n";
          break;
        }
        EXPECT_EQ(item.counterexample->replay, Replay::kSimulator) << edit.what << "\n"
                                                                   << item.counterexample->scenario;
        EXPECT_TRUE(program.PassesOnOld(item.counterexample->scenario)) << edit.what << "\n"
                                                                        << item.counterexample->scenario;
        EXPECT_FALSE(program.PassesOnNew(item.counterexample->scenario)) << edit.what << "\n"
                                                                         << item.counterexample->scenario;
        break;
      }
    }
  }
}

Counts JudgeEdits(const std::string& dialect, int count, uint64_t seed) {
  terms::Random random(seed);
  const std::vector<fs::path> scenarios = ScenariosOf(dialect);
  Counts counts;
  for (int tries = 0; counts.edits < count && tries < 20 * count && !scenarios.empty(); ++tries) {
    const fs::path& scenario = scenarios[random.Next() % scenarios.size()];
    const EditedProgram program(scenario);
    if (program.files().empty()) continue;
    DiffSide old_side = program.OldSide();
    if (!old_side.compilation.ok() || !old_side.compilation.has_program) continue;
    if (IsLong()) std::cout << scenario.string() << std::endl;
    for (int i = 0; i < 6 && counts.edits < count; ++i) {
      const SourceEdit edit = EditedSource(program.files(), random);
      if (!edit.file.empty()) Judge(program, old_side, edit, random, counts);
    }
  }
  std::cout << dialect << ": " << counts.edits << " edits, " << counts.equal << " equal, " << counts.different
            << " different (" << counts.items_different << " locations, " << counts.without_scenario
            << " of them without a scenario), " << counts.items_undecided << " locations not decided" << std::endl;
  return counts;
}

class EditsTest : public testing::TestWithParam<const char*> {};

TEST_P(EditsTest, SimulationSeesWhatDiffSays) {
  const std::string dialect = GetParam(), only = Setting("PLCXX_EDITS_DIALECT", dialect);
  if (only != dialect) GTEST_SKIP() << "another dialect is asked for";
  const int count = std::atoi(Setting("PLCXX_EDITS", "6").c_str());
  const auto seed = static_cast<uint64_t>(std::atoll(Setting("PLCXX_EDITS_SEED", "1").c_str()));
  const Counts counts = JudgeEdits(dialect, count, 0x9E3779B97F4A7C15 * (seed + 1));
  EXPECT_EQ(counts.edits, count);
}

INSTANTIATE_TEST_SUITE_P(Dialects, EditsTest, testing::Values("nc110", "technol", "host50", "prostep", "hnc"),
                         [](const auto& named) { return std::string(named.param); });

}  // namespace
}  // namespace plcxx::review::diff
