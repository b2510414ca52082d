#include "transpiler/driver/scenario_suite.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

namespace plcxx::driver {
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

/// Hands out the items to threads and the results to `report`, in order.
class Suite {
 public:
  Suite(std::vector<Item> items, const SuiteOptions& options, const std::function<void(const ScenarioResult&)>& report)
      : items_(std::move(items)),
        options_(options),
        report_(report),
        programs_(options.programs),
        results_(items_.size()) {
    for (const Item& item : items_) {
      if (item.scenario) programs_.Announce(*item.scenario);
    }
  }

  std::vector<ScenarioResult> Run() {
    std::vector<std::thread> threads;
    const size_t count = std::min<size_t>(std::max(1u, options_.jobs), items_.size());
    for (size_t i = 0; i < count; ++i) threads.emplace_back([this] { Work(); });
    for (size_t i = 0; i < items_.size(); ++i) {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return results_[i].has_value(); });
      const ScenarioResult& result = *results_[i];  // stays where it is, so that it can be read without the lock
      lock.unlock();
      report_(result);
    }
    for (std::thread& thread : threads) thread.join();
    std::vector<ScenarioResult> results;
    for (std::optional<ScenarioResult>& result : results_) results.push_back(std::move(*result));
    return results;
  }

 private:
  void Work() {
    for (size_t i = next_++; i < items_.size(); i = next_++) {
      ScenarioResult result = Test(items_[i]);
      const std::lock_guard lock(mutex_);
      results_[i] = std::move(result);
      changed_.notify_one();
    }
  }

  ScenarioResult Test(const Item& item) {
    if (!item.scenario) {
      ScenarioResult result{CaseOf(item.path), {}, {}};
      result.test.outcome = TestOutcome::kUnusable;
      result.test.text = item.errors;
      return result;
    }
    const std::shared_ptr<ScenarioProgram> program = programs_.Take(*item.scenario);
    try {
      return TestScenario(*item.scenario, options_, *program);
    } catch (const std::exception& fault) {  // of the standard library: memory, files
      ScenarioResult result{CaseOf(item.path), {}, {}};
      result.test.outcome = TestOutcome::kFailed;
      result.test.text = item.path + ": " + fault.what();
      return result;
    }
  }

  std::vector<Item> items_;
  const SuiteOptions& options_;
  const std::function<void(const ScenarioResult&)>& report_;
  ScenarioPrograms programs_;
  std::atomic<size_t> next_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::optional<ScenarioResult>> results_;  // guarded by mutex_ until set
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
    const auto options = fs::directory_options::skip_permission_denied;
    for (auto entry = fs::recursive_directory_iterator(path, options, error);
         entry != fs::recursive_directory_iterator(); entry.increment(error)) {
      if (error) break;
      if (entry->path().extension() == ".yaml" && entry->is_regular_file(error))
        found.push_back(entry->path().generic_string());
    }
    if (error) return "cannot read directory '" + path + "': " + error.message();
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

}  // namespace plcxx::driver
