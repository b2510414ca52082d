#include "transpiler/mutate/mutate.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "transpiler/scenarios/separate_processes.h"
#include "transpiler/scenarios/suite.h"

namespace plcxx::mutate {
namespace {

/// A change may make a loop run to its bound again and again: what executes so much more than before is noticed.
constexpr uint64_t kMostGrowth = 50, kAlwaysAllowed = 10'000'000;
constexpr size_t kChangesInAProcess = 32;

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
    Try(mutated.results);
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
            const std::string failure = RunScenario(item, seen);
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
  std::string RunScenario(uint32_t scenario, scenarios::Observation& seen) const {
    scenarios::ScenarioProgram program(request_.compilation);
    const scenarios::TestCase test =
        scenarios::TestScenario(request_.scenarios[scenario], InTheSimulator(seen), program).test;
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

  void Try(std::vector<ChangeResult>& results) {
    std::vector<uint32_t> reached;
    std::vector<std::vector<uint32_t>> scenarios_of(results.size());
    for (uint32_t i = 0; i < results.size(); ++i) {
      scenarios_of[i] = Reaching(results[i].change);
      if (!scenarios_of[i].empty()) reached.push_back(i);
    }
    std::vector<scenarios::ItemGroup> groups;
    for (size_t i = 0; i < reached.size(); ++i) {
      if (i % kChangesInAProcess == 0) groups.emplace_back();
      groups.back().push_back(reached[i]);
    }
    size_t done = 0;
    scenarios::WorkSeparately(
        groups, Separate(),
        [&](const scenarios::ItemGroup& items, scenarios::WorkReport& report) {
          for (const uint32_t item : items) {
            report.Begin(item);
            report.Done(item, IsNoticed(results[item].change, scenarios_of[item]) ? "n" : "p");
          }
        },
        [&](uint32_t item, const scenarios::ItemEnd& end) {
          results[item].outcome = end.result == "p" ? Outcome::kNotNoticed : Outcome::kNoticed;
          if (request_.progress) request_.progress(++done, reached.size());
        });
  }

  /// In a child: the program stays changed until the next change begins anew.
  bool IsNoticed(const Change& change, const std::vector<uint32_t>& scenarios) const {
    ir::Program& program = request_.compilation.program;
    program = original_;
    Apply(change, program);
    return std::ranges::any_of(scenarios, [&](uint32_t scenario) {
      scenarios::Observation seen;
      seen.most = kAlwaysAllowed + kMostGrowth * before_[scenario].executed;
      return !RunScenario(scenario, seen).empty() || seen.stopped;
    });
  }

  const MutateRequest& request_;
  const ir::Program original_;
  std::vector<Before> before_;  // by scenario
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
