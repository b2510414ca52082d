#include "transpiler/mutate/mutate.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <utility>

#include "transpiler/mutate/side_by_side.h"
#include "transpiler/scenarios/separate_processes.h"
#include "transpiler/scenarios/suite.h"

namespace plcxx::mutate {
namespace {

/// A change may make a loop run to its bound again and again: what executes so much more than before is noticed.
constexpr uint64_t kMostGrowth = 50, kAlwaysAllowed = 10'000'000;
/// Side by side; each may have a machine of its own. Whoever works on fewer has the original run more often.
constexpr size_t kChangesInAProcess = 400;

/// What a child tells of a change.
constexpr std::string_view kPasses = "p", kNoticed = "n", kPassesAlone = "pa", kNoticedAlone = "na";

/// A scenario before any change.
struct Before {
  std::vector<bool> reached;  // by InstId
  uint64_t executed = 0;
  std::string failure;  // not empty: it fails
};

scenarios::SuiteOptions InTheSimulator(scenarios::Observation& seen) {
  scenarios::SuiteOptions options;
  options.explains = false;
  options.observation = &seen;
  return options;
}

/// What a child tells of a scenario that passed: the instructions it executed, then a byte for each that there is.
std::string Encode(const scenarios::Observation& seen) {
  std::string bytes(sizeof seen.executed, '\0');
  std::memcpy(bytes.data(), &seen.executed, sizeof seen.executed);
  return bytes.append(seen.given.begin(), seen.given.end());
}

class Mutation {
 public:
  explicit Mutation(const MutateRequest& request) : request_(request), original_(request.compilation.program) {}

  std::variant<Mutated, std::vector<FailsBefore>> Run() {
    std::vector<FailsBefore> failing = RunBefore();
    if (!failing.empty()) return failing;
    Mutated mutated;
    std::vector<Change> changes = FindChanges(original_, *request_.compilation.sources);
    mutated.found = changes.size();
    for (Change& change : Chosen(std::move(changes)))
      mutated.results.push_back({std::move(change), Outcome::kNotReached});
    Try(mutated);
    return mutated;
  }

 private:
  std::vector<FailsBefore> RunBefore() {
    before_.resize(request_.scenarios.size());
    std::vector<scenarios::ItemGroup> groups;
    for (uint32_t i = 0; i < request_.scenarios.size(); ++i) groups.push_back({i});
    scenarios::WorkSeparately(
        groups, Separate(),
        [this](const scenarios::ItemGroup& items, scenarios::WorkReport& report) {
          for (const uint32_t item : items) {
            report.Begin(item);
            scenarios::Observation seen;
            scenarios::SuiteOptions options = InTheSimulator(seen);
            options.explains = true;  // what fails here is told
            const std::string failure = RunScenario(item, options);
            report.Done(item, failure.empty() ? "p" + Encode(seen) : "f" + failure);
          }
        },
        [this](uint32_t item, const scenarios::ItemEnd& end) { before_[item] = BeforeOf(end); });
    std::vector<FailsBefore> failing;
    for (size_t i = 0; i < before_.size(); ++i) {
      if (!before_[i].failure.empty()) failing.push_back({request_.scenarios[i].path, before_[i].failure});
    }
    return failing;
  }

  static Before BeforeOf(const scenarios::ItemEnd& end) {
    Before before;
    if (!end.result) {
      before.failure = end.why;
    } else if (end.result->front() == 'f') {
      before.failure = end.result->substr(1);
    } else {
      const std::string_view bytes = std::string_view(*end.result).substr(1);
      std::memcpy(&before.executed, bytes.data(), sizeof before.executed);
      for (const char given : bytes.substr(sizeof before.executed)) before.reached.push_back(given != 0);
    }
    return before;
  }

  /// Why it does not pass; empty: it does.
  std::string RunScenario(uint32_t scenario, const scenarios::SuiteOptions& options) const {
    scenarios::ScenarioProgram program(request_.compilation);
    const scenarios::TestCase test = scenarios::TestScenario(request_.scenarios[scenario], options, program).test;
    if (test.outcome == scenarios::TestOutcome::kPassed) return {};
    return test.text.empty() ? "it fails" : test.text;
  }

  scenarios::SeparateOptions Separate() const { return {.jobs = request_.jobs, .item_seconds = request_.time_limit}; }

  std::vector<Change> Chosen(std::vector<Change> changes) const {
    if (request_.most == 0 || changes.size() <= request_.most) return changes;
    std::vector<Change> chosen;
    for (size_t i = 0; i < request_.most; ++i) chosen.push_back(std::move(changes[i * changes.size() / request_.most]));
    return chosen;
  }

  /// Those that execute what is changed, the shortest first.
  std::vector<uint32_t> Reaching(const Change& change) const {
    std::vector<uint32_t> scenarios;
    for (uint32_t i = 0; i < before_.size(); ++i) {
      if (before_[i].reached[change.inst.index]) scenarios.push_back(i);
    }
    std::ranges::stable_sort(scenarios, {}, [this](uint32_t i) { return before_[i].executed; });
    return scenarios;
  }

  void Try(Mutated& mutated) {
    std::vector<ChangeResult>& results = mutated.results;
    scenarios::ItemGroup reached;
    scenarios_of_.resize(results.size());
    for (uint32_t i = 0; i < results.size(); ++i) {
      scenarios_of_[i] = Reaching(results[i].change);
      if (!scenarios_of_[i].empty()) reached.push_back(i);
    }
    scenarios::SeparateOptions separate = Separate();
    separate.common_seconds = request_.time_limit * static_cast<unsigned>(kChangesInAProcess);
    size_t done = 0;
    scenarios::WorkSeparately(
        GroupsOf(reached), separate,
        [&](const scenarios::ItemGroup& items, scenarios::WorkReport& report) { Work(results, items, report); },
        [&](uint32_t item, const scenarios::ItemEnd& end) {
          const std::string_view word = end.result ? std::string_view(*end.result) : kNoticedAlone;
          results[item].outcome = word == kPasses || word == kPassesAlone ? Outcome::kNotNoticed : Outcome::kNoticed;
          mutated.alone += word == kPassesAlone || word == kNoticedAlone ? 1 : 0;
          if (request_.progress) request_.progress(++done, reached.size());
        });
  }

  /// Neighbours stay together: they are executed by the same scenarios.
  std::vector<scenarios::ItemGroup> GroupsOf(const scenarios::ItemGroup& items) const {
    const size_t needed = (items.size() + kChangesInAProcess - 1) / kChangesInAProcess;
    const size_t count = std::max<size_t>(request_.jobs, needed);
    std::vector<scenarios::ItemGroup> groups(count);
    for (size_t i = 0; i < items.size(); ++i) groups[i * count / items.size()].push_back(items[i]);
    return groups;
  }

  /// In a child. What ends one that works on several is found by those that work on one of them.
  void Work(const std::vector<ChangeResult>& results, const scenarios::ItemGroup& items,
            scenarios::WorkReport& report) const {
    const bool together = request_.way == Way::kSideBySide && items.size() > 1;
    for (const uint32_t item : together ? TrySideBySide(results, items, report) : items) {
      report.Begin(item);
      report.Done(item, IsNoticed(results[item].change, scenarios_of_[item]) ? kNoticedAlone : kPassesAlone);
    }
  }

  /// Gives those that have to be tried alone; the others are reported.
  scenarios::ItemGroup TrySideBySide(const std::vector<ChangeResult>& results, scenarios::ItemGroup items,
                                     scenarios::WorkReport& report) const {
    report.BeginCommon();
    std::vector<uint32_t> shortest_first(before_.size());
    std::iota(shortest_first.begin(), shortest_first.end(), 0U);
    std::ranges::stable_sort(shortest_first, {}, [this](uint32_t i) { return before_[i].executed; });
    scenarios::ItemGroup alone;
    for (const uint32_t scenario : shortest_first) {
      scenarios::ItemGroup reaching;
      std::vector<sim::ChangedInst> changes;
      for (const uint32_t item : items) {
        if (!before_[scenario].reached[results[item].change.inst.index]) continue;
        reaching.push_back(item);
        changes.push_back(AsExecuted(results[item].change, original_));
      }
      if (reaching.empty()) continue;
      const std::vector<Ending> endings =
          RunSideBySide({.compilation = request_.compilation,
                         .scenario = request_.scenarios[scenario],
                         .changes = changes,
                         .most = MostOf(scenario),
                         .failed = [&](uint32_t change) { report.Done(reaching[change], kNoticed); }});
      for (size_t i = 0; i < endings.size(); ++i) {
        if (endings[i] != Ending::kPasses) std::erase(items, reaching[i]);
        if (endings[i] == Ending::kUnclear) alone.push_back(reaching[i]);
      }
    }
    for (const uint32_t item : items) report.Done(item, kPasses);
    return alone;
  }

  uint64_t MostOf(uint32_t scenario) const { return kAlwaysAllowed + kMostGrowth * before_[scenario].executed; }

  /// In a child: the program stays changed until the next change begins anew.
  bool IsNoticed(const Change& change, const std::vector<uint32_t>& scenarios) const {
    ir::Program& program = request_.compilation.program;
    program = original_;
    Apply(change, program);
    return std::ranges::any_of(scenarios, [&](uint32_t scenario) {
      scenarios::Observation seen;
      seen.most = MostOf(scenario);
      return !RunScenario(scenario, InTheSimulator(seen)).empty() || seen.stopped;
    });
  }

  const MutateRequest& request_;
  const ir::Program original_;
  std::vector<Before> before_;                       // by scenario
  std::vector<std::vector<uint32_t>> scenarios_of_;  // by result: those that execute its place
};

}  // namespace

std::string_view Name(Outcome outcome) {
  switch (outcome) {
    case Outcome::kNoticed:
      return "noticed";
    case Outcome::kNotNoticed:
      return "not-noticed";
    case Outcome::kNotReached:
      return "not-reached";
  }
  return {};
}

std::variant<Mutated, std::vector<FailsBefore>> Mutate(const MutateRequest& request) { return Mutation(request).Run(); }

}  // namespace plcxx::mutate
