#include "transpiler/scenarios/suite.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include "transpiler/compilation/source_loading.h"
#include "transpiler/compile/child_process.h"
#include "transpiler/engines/compiled_program.h"
#include "transpiler/scenarios/groups.h"
#include "transpiler/scenarios/separate_processes.h"
#include "transpiler/support/system_words.h"

namespace plcxx::scenarios {
namespace {

namespace fs = std::filesystem;

TestCase CaseOf(const std::string& path) {
  return {path, fs::path(path).parent_path().generic_string(), TestOutcome::kPassed, {}};
}

/// One path of the command line: what it holds, or why it cannot be run.
struct Item {
  std::string path;
  std::optional<Scenario> scenario;
  std::string errors;
};

Item ReadItem(const std::string& path, Reach reach) {
  Item item{path, std::nullopt, {}};
  ScenarioOrErrors read = ReadScenario(path, reach);
  if (auto* scenario = std::get_if<Scenario>(&read)) {
    item.scenario = std::move(*scenario);
    return item;
  }
  for (const ScenarioError& error : std::get<std::vector<ScenarioError>>(read)) {
    item.errors += (item.errors.empty() ? "" : "\n") + ToText(error);
  }
  return item;
}

/// A result as the bytes that go from a child to its parent.
std::string Encode(const ScenarioResult& result) {
  std::string bytes(1, static_cast<char>(result.test.outcome));
  for (const std::string* text : {&result.test.text, &result.ran, &result.waveform}) {
    bytes += std::to_string(text->size()) + ":" + *text;
  }
  return bytes;
}

ScenarioResult Decode(const std::string& path, const std::string& bytes) {
  ScenarioResult result{CaseOf(path), {}, {}};
  result.test.outcome = static_cast<TestOutcome>(bytes[0]);
  size_t at = 1;
  for (std::string* text : {&result.test.text, &result.ran, &result.waveform}) {
    const size_t colon = bytes.find(':', at);
    const size_t size = std::stoull(bytes.substr(at, colon - at));
    *text = bytes.substr(colon + 1, size);
    at = colon + 1 + size;
  }
  return result;
}

/// The programs of a group, each compiled once.
class GroupPrograms {
 public:
  explicit GroupPrograms(const ProgramOverrides& overrides) : overrides_(overrides) {}

  ScenarioProgram& Of(const Scenario& scenario) {
    compilation::CompilationRequest request = RequestOf(scenario, overrides_);
    const std::string key = KeyOf(request);
    return programs_.try_emplace(key, std::move(request)).first->second;
  }

  /// A program runs there: its scenario is chosen, and has steps.
  void Want(const PlatformUse& use, ScenarioProgram& program, emit::Flavour flavour) {
    std::vector<Wanted>& wanted = wanted_[use.platform.get()];
    if (std::ranges::find(wanted, Wanted{&program, flavour}) == wanted.end()) wanted.push_back({&program, flavour});
  }

  void Build(const std::shared_ptr<const engines::Platform>& platform) {
    const std::vector<Wanted>& wanted = wanted_[platform.get()];
    std::vector<engines::ProgramToCompile> programs;
    for (const auto& [program, flavour] : wanted) {
      const compilation::Compilation& compilation = program->Compiled();
      programs.push_back({&compilation.program, compilation.sources.get(), flavour});
    }
    std::vector<engines::CompiledOrFailure> built = engines::CompileTogether(platform, programs);
    for (size_t i = 0; i < wanted.size(); ++i) wanted[i].first->Give(*platform, wanted[i].second, std::move(built[i]));
  }

 private:
  const ProgramOverrides& overrides_;
  std::map<std::string, ScenarioProgram> programs_;  // by key
  using Wanted = std::pair<ScenarioProgram*, emit::Flavour>;
  std::map<const engines::Platform*, std::vector<Wanted>> wanted_;
};

/// Has the items worked on in child processes, and hands the results to `report`, in order.
class Suite {
 public:
  Suite(std::vector<Item> items, const SuiteOptions& options, const std::function<void(const ScenarioResult&)>& report)
      : items_(std::move(items)), options_(options), report_(report), results_(items_.size()) {}

  std::vector<ScenarioResult> Run() {
    std::vector<GroupedScenario> runnable;
    std::vector<std::vector<std::string>> sources(items_.size());
    for (uint32_t i = 0; i < items_.size(); ++i) {
      if (items_[i].scenario) {
        const compilation::CompilationRequest& request =
            runnable.emplace_back(GroupedScenario{i, RequestOf(*items_[i].scenario, options_.programs)}).request;
        for (const std::string& source : request.sources)
          sources[i].push_back(compilation::FromBase(request.base_directory, source));
      } else {
        ScenarioResult result{CaseOf(items_[i].path), {}, {}};
        result.test.outcome = TestOutcome::kUnusable;
        result.test.text = items_[i].errors;
        results_[i] = std::move(result);
      }
    }
    ReportFirst();
    const SeparateOptions separate{.jobs = options_.jobs, .item_seconds = options_.time_limit};
    WorkSeparately(
        MakeGroups(runnable, options_.jobs), separate,
        [this](const ItemGroup& items, WorkReport& work) { Work(items, work); },
        [this](uint32_t item, const ItemEnd& end) { Ended(item, end); });
    std::vector<ScenarioResult> results;
    for (size_t i = 0; i < results_.size(); ++i) {
      results.push_back(*std::move(results_[i]));
      results.back().sources = std::move(sources[i]);
    }
    return results;
  }

 private:
  /// In a child.
  void Work(const ItemGroup& items, WorkReport& work) const {
    // What a child leaves behind that was ended goes with the suite.
    setenv("TMPDIR", scratch_.path().c_str(), 1);
    GroupPrograms programs(options_.programs);
    for (const uint32_t item : items) {
      work.Begin(item);
      const Scenario& scenario = *items_[item].scenario;
      if (!scenario.steps || RequestOf(scenario, options_.programs).sources.empty()) continue;
      ScenarioProgram& program = programs.Of(scenario);
      if (!program.Compiled().ok()) continue;
      for (const PlatformUse& use : options_.platforms) {
        if (RunsOn(use.one_in, scenario)) programs.Want(use, program, FlavourFor(scenario));
      }
    }
    work.BeginCommon();
    for (const PlatformUse& use : options_.platforms) programs.Build(use.platform);
    for (const uint32_t item : items) {
      work.Begin(item);
      const Scenario& scenario = *items_[item].scenario;
      work.Done(item, Encode(TestScenario(scenario, options_, programs.Of(scenario))));
    }
  }

  void Ended(uint32_t item, const ItemEnd& end) {
    const std::string& path = items_[item].path;
    if (end.result) {
      results_[item] = Decode(path, *end.result);
    } else {
      ScenarioResult result{CaseOf(path), {}, {}};
      result.test.outcome = TestOutcome::kFailed;
      result.test.text = path + ": " + end.why;
      results_[item] = std::move(result);
    }
    ReportFirst();
  }

  /// Those before which none is missing.
  void ReportFirst() {
    while (reported_ < results_.size() && results_[reported_]) report_(*results_[reported_++]);
  }

  std::vector<Item> items_;
  const SuiteOptions& options_;
  const std::function<void(const ScenarioResult&)>& report_;
  compile::TemporaryDirectory scratch_;
  std::vector<std::optional<ScenarioResult>> results_;
  size_t reported_ = 0;
};

}  // namespace

std::variant<std::vector<std::string>, std::string> FindScenarios(const std::vector<std::string>& paths) {
  std::vector<std::string> scenarios;
  for (const std::string& path : paths) {
    std::error_code error;
    if (!fs::is_directory(path, error)) {
      scenarios.push_back(path);  // what is wrong with it is told when it is read
      continue;
    }
    std::vector<std::string> found;
    // One without the right to look at it is passed over below; it says nothing where it was named.
    fs::directory_iterator named(path, error);
    if (error) return "cannot read directory '" + path + "': " + support::SystemWords(error.value());
    const auto options = fs::directory_options::skip_permission_denied;
    for (auto entry = fs::recursive_directory_iterator(path, options, error);
         entry != fs::recursive_directory_iterator(); entry.increment(error)) {
      if (error) break;
      // What belongs to other tools (.git, .github) is in hidden folders.
      if (entry->path().filename().string().starts_with('.') && entry->is_directory(error))
        entry.disable_recursion_pending();
      const bool is_other = project::IsNoScenario(entry->path().string());
      if (entry->path().extension() == ".yaml" && !is_other && entry->is_regular_file(error))
        found.push_back(path == "." ? entry->path().lexically_normal().generic_string()
                                    : entry->path().generic_string());
    }
    if (error) return "cannot read directory '" + path + "': " + support::SystemWords(error.value());
    if (found.empty()) return "there is no scenario (*.yaml) in directory '" + path + "'";
    std::sort(found.begin(), found.end());
    scenarios.insert(scenarios.end(), found.begin(), found.end());
  }
  return scenarios;
}

std::vector<ScenarioResult> TestScenarios(const std::vector<std::string>& paths, const SuiteOptions& options,
                                          const std::function<void(const ScenarioResult&)>& report) {
  std::vector<Item> items;
  for (const std::string& path : paths) items.push_back(ReadItem(path, options.reach));
  return Suite(std::move(items), options, report).Run();
}

}  // namespace plcxx::scenarios
