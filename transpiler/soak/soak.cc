#include "transpiler/soak/soak.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

namespace plcxx::soak {
namespace {

constexpr size_t kMostEntries = 300;  // moments in memory
constexpr uint64_t kTrialMs = 120'000;
constexpr size_t kMostFindings = 100;
constexpr int kMostRefuted = 10;  // runs of one cause that do not repeat
/// Whether more is begun when the time is over.
enum class WhenLate : uint8_t { kStop, kGoOn };
/// For what was found at last, once it is late: who ends a job by a signal does not wait for long.
constexpr std::chrono::seconds kGrace{3};
/// A message that stood so long, while inputs changed so often, and never went.
constexpr uint64_t kStoodMs = 10 * 60'000, kStoodSteps = 300;

uint64_t ChanceOf(uint64_t seed, uint64_t machine, uint64_t generation) {
  return (seed * 0x9E3779B97F4A7C15 + machine) * 0xD1B54A32D192ED03 + generation;
}

std::string MessageText(const ir::Program& program, uint32_t number) {
  for (const ir::MessageText& message : program.messages) {
    if (message.number == number) return message.text;
  }
  return {};
}

class Generations {
 public:
  Generations(const SoakRequest& request, const Goals& goals, const Inputs& inputs, const WatchPlan& plan)
      : request_(request),
        goals_(goals),
        known_{.inputs = inputs,
               .plan = plan,
               .scenarios = request.scenarios,
               .entries = {},
               .given = std::vector<uint8_t>(plan.program().insts.size()),
               .open = {},
               .standing = {},
               .gone = {},
               .causes = {}},
        findings_(
            request.machine, request.request, plan, request.make, request.plant,
            {.directory = request.directory, .is_taken = request.is_taken, .is_late = [this] { return IsOverdue(); }}),
        given_(plan.program().insts.size()) {
    soaked_.outputs.ones.resize(plan.outputs().size());
    soaked_.outputs.zeros.resize(plan.outputs().size());
    // Instructions that tell nothing: what a value is, and where a statement begins more than once.
    for (uint32_t i = 0; i < known_.given.size(); ++i) {
      const ir::Inst& inst = plan.program()[ir::InstId(i)];
      if (inst.op == ir::OpKind::kConst) known_.given[i] = 0xFF;
    }
    const size_t jobs = std::max(1U, request.jobs);
    for (size_t i = 0; i < jobs; ++i) {
      machines_.push_back(request.make(1));
      words_.push_back(std::make_unique<Words>(request.machine.compilation));
      if (request.wide) wide_.push_back(std::make_unique<WideMachines>(request.wide));
    }
  }

  Soaked Run() {
    soaked_.repeated = RunAsTheyAre(request_.corpus);
    RunAsTheyAre(request_.scenarios);
    while (soaked_.machine_ms < request_.machine_ms && !Late() && !soaked_.is_found) RunGeneration();
    const bool is_short = soaked_.machine_ms < request_.machine_ms && !soaked_.is_found;
    soaked_.was_asked_to_end = is_short && IsAskedToEnd();
    soaked_.out_of_time = is_short && !soaked_.was_asked_to_end;
    LookForMessages();
    // What was found to stand for long may have gone at last.
    std::erase_if(soaked_.findings, [this](const Finding& finding) {
      return finding.cause.kind == CauseKind::kMessage && soaked_.messages[finding.cause.number].went != 0;
    });
    Finish();
    return std::move(soaked_);
  }

 private:
  bool IsAskedToEnd() const { return request_.is_asked_to_end && request_.is_asked_to_end(); }
  bool Late() const { return IsAskedToEnd() || (request_.end && std::chrono::steady_clock::now() >= *request_.end); }

  /// Whether it has been late for so long that runs are not shortened any further.
  bool IsOverdue() {
    if (!Late()) return false;
    const std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now();
    if (!late_since_) late_since_ = now;
    return now - *late_since_ >= kGrace;
  }

  /// Which of them were run.
  std::vector<bool> RunAsTheyAre(const std::vector<Stimuli>& runs) {
    if (runs.empty()) return {};
    return RunAll(runs.size(),
                  [&](size_t i, Words& words) { return std::make_unique<Trial>(known_, words, nullptr, runs[i]); });
  }

  uint64_t ChanceOfMachine(uint64_t number) const {
    return ChanceOf(request_.seed, request_.first_machine + number * request_.every, soaked_.generations);
  }

  void RunGeneration() {
    const uint64_t left = request_.machine_ms - soaked_.machine_ms;
    const uint64_t each = std::min(kTrialMs, (left + request_.machines - 1) / request_.machines);
    if (request_.wide) {
      // Long waits are not cut to the time of a generation: what waits for them would never be seen.
      RunWide(each, (left + request_.machines - 1) / request_.machines);
    } else {
      RunAll(request_.machines,
             [&](size_t i, Words& words) { return std::make_unique<Trial>(known_, words, ChanceOfMachine(i), each); });
    }
    ++soaked_.generations;
    if (request_.until) LookForMessages();
  }

  void RunWide(uint64_t each, uint64_t left) {
    Prepare();
    const std::vector<std::optional<WideResult>> results =
        InThreads<WideResult>(request_.machines / kWideMachines, WhenLate::kStop, [&](size_t i, size_t job) {
          const uint64_t first = i * kWideMachines;
          const uint64_t chance =
              ChanceOf(~request_.seed, request_.first_machine + i * request_.every, soaked_.generations);
          return wide_[job]->Run(known_, *words_[job],
                                 {.run = chance,
                                  .of_machine = [&](uint32_t machine) { return ChanceOfMachine(first + machine); },
                                  .most_ms = each,
                                  .left_ms = left,
                                  .is_late = [this] { return Late(); }});
        });
    std::vector<const Promise*> promises;
    for (const std::optional<WideResult>& result : results) {
      if (!result) continue;
      soaked_.parts += result->parts;
      soaked_.wide_parts += result->parts;
      soaked_.outputs.Add(result->outputs);
      soaked_.machine_ms += result->machine_ms;
      soaked_.steps += result->steps;
      for (const Promise& promise : result->promises) promises.push_back(&promise);
    }
    // Late or not: without them those scans would count, and what they came to would be lost. They are few.
    RunAll(
        promises.size(),
        [&](size_t i, Words& words) {
          return std::make_unique<Trial>(known_, words, promises[i]->from, promises[i]->stimuli);
        },
        WhenLate::kGoOn);
  }

  /// What `make(i, job)` gives, by i; none of those for which there was no time.
  template <class Result, class Make>
  std::vector<std::optional<Result>> InThreads(size_t count, WhenLate when_late, const Make& make) {
    std::vector<std::optional<Result>> results(count);
    std::atomic<size_t> next = 0;
    const auto work = [&](size_t job) {
      for (size_t i = next++; i < count && (when_late == WhenLate::kGoOn || !Late()); i = next++)
        results[i] = make(i, job);
    };
    std::vector<std::thread> threads;
    for (size_t job = 1; job < machines_.size(); ++job) threads.emplace_back(work, job);
    work(0);
    for (std::thread& thread : threads) thread.join();
    return results;
  }

  /// Which of them were run.
  template <class MakeTrial>
  std::vector<bool> RunAll(size_t count, const MakeTrial& make, WhenLate when_late = WhenLate::kStop) {
    Prepare();
    std::vector<std::optional<TrialResult>> results =
        InThreads<TrialResult>(count, when_late, [&](size_t i, size_t job) {
          const std::unique_ptr<Trial> trial = make(i, *words_[job]);
          Trial* const one = trial.get();
          RunTrials(*machines_[job], {&one, 1});
          return trial->Take();
        });
    std::vector<bool> were_run;
    for (std::optional<TrialResult>& result : results) {
      were_run.push_back(result.has_value());
      if (result) Merge(*result);
    }
    Tell();
    return were_run;
  }

  void Prepare() {
    for (size_t i = 0; i < given_.size(); ++i) known_.given[i] |= given_[i];
    FindStanding();
    const GoalSet reached = goals_.Reached(given_);
    known_.open.clear();
    for (size_t i = 0; i < goals_.all().size(); ++i) {
      const ir::StatementId statement = goals_.all()[i].statement;
      const bool is_new = known_.open.empty() || known_.open.back() != statement;
      if (!reached.Has(i) && is_new) known_.open.push_back(statement);
    }
  }

  std::vector<uint32_t> WritersOfMessage(uint32_t number) const {
    const ir::Program& program = known_.plan.program();
    const execute::Cells& cells = known_.plan.cells();
    std::vector<uint32_t> writers;
    const auto add = [&](execute::CellId cell) {
      for (const uint32_t writer : known_.inputs.WritersOf(cell)) writers.push_back(writer);
    };
    for (const ir::MessageBits& stretch : program.message_bits) {
      if (number < stretch.first_number || number - stretch.first_number >= stretch.count) continue;
      const uint32_t bit = number - stretch.first_number;
      add(cells.OfBit(stretch.space, stretch.offset + bit / 8, static_cast<uint8_t>(bit % 8)));
    }
    for (const ir::MessageWord& word : program.message_words) {
      add(execute::CellsOf(program, cells, program.places[word.place]).front());
    }
    return writers;
  }

  void FindStanding() {
    known_.standing.clear();
    for (const auto& [number, life] : soaked_.messages) {
      if (life.went != 0) {
        known_.gone.insert(number);
        came_.erase(number);
      } else if (const auto at = came_.find(number); at != came_.end()) {
        known_.standing.push_back({.entry = at->second, .writers = WritersOfMessage(number)});
      }
    }
  }

  void Merge(TrialResult& result) {
    for (Entry& entry : result.entries) {
      bool is_news = false;
      for (size_t i = 0; i < given_.size(); ++i) {
        is_news = is_news || (entry.given[i] & ~(given_[i] | known_.given[i])) != 0;
      }
      if (!is_news) continue;
      for (size_t i = 0; i < given_.size(); ++i) given_[i] |= entry.given[i];
      known_.entries.push_back(std::make_shared<Entry>(std::move(entry)));
    }
    // What came after the last moment that was kept.
    for (size_t i = 0; i < given_.size(); ++i) given_[i] |= result.given[i];
    if (known_.entries.size() > kMostEntries) Thin();
    for (const auto& [number, life] : result.messages) soaked_.messages[number].Add(life);
    for (auto& [number, entry] : result.came) {
      std::shared_ptr<const Entry>& shortest = came_[number];
      if (shortest && shortest->stimuli.size() <= entry.stimuli.size()) continue;
      shortest = std::make_shared<Entry>(std::move(entry));
    }
    soaked_.outputs.Add(result.outputs);
    soaked_.parts += result.parts;
    soaked_.machine_ms += result.machine_ms;
    soaked_.steps += result.steps;
    for (TrialResult::Found& found : result.found) AddFinding(found.cause, found.stimuli);
  }

  void AddFinding(const Cause& cause, const Stimuli& stimuli) {
    if (known_.causes.contains(cause.key)) return;
    if (soaked_.findings.size() >= kMostFindings) {
      soaked_.more.insert(cause.key);
      return;
    }
    if (request_.progress) request_.progress("shortening a run: " + cause.text);
    if (std::optional<Finding> finding = findings_.Describe(cause, stimuli)) {
      known_.causes.insert(cause.key);
      if (request_.until && cause.text.find(*request_.until) != std::string::npos) soaked_.is_found = true;
      soaked_.findings.push_back(std::move(*finding));
      return;
    }
    if (++refuted_[cause.key] == kMostRefuted) {
      known_.causes.insert(cause.key);
      soaked_.not_repeated.emplace_back(cause, "seen from moments on, and not from power-on");
    }
  }

  /// Of many moments those stay that are needed for what is reached, and the newest.
  void Thin() {
    std::vector<GoalSet> reached;
    for (const auto& entry : known_.entries) reached.push_back(goals_.Reached(entry->given));
    const std::vector<size_t> needed = Needed(reached, goals_.Reached(given_));
    std::vector<std::shared_ptr<const Entry>> kept;
    for (size_t i = 0; i < known_.entries.size(); ++i) {
      const bool is_new = i + kMostEntries / 3 >= known_.entries.size();
      if (is_new || std::ranges::binary_search(needed, i)) kept.push_back(std::move(known_.entries[i]));
    }
    known_.entries = std::move(kept);
  }

  void LookForMessages() {
    for (const auto& [number, life] : soaked_.messages) {
      if (life.went != 0 || life.stood_ms < kStoodMs || life.steps < kStoodSteps) continue;
      const auto run = came_.find(number);
      if (run != came_.end()) {
        AddFinding(WatchPlan::MessageCause(number, MessageText(known_.plan.program(), number)), run->second->stimuli);
      }
    }
  }

  void Finish() {
    soaked_.reached = goals_.Reached(given_);
    std::vector<GoalSet> reached;
    for (const auto& entry : known_.entries) reached.push_back(goals_.Reached(entry->given));
    for (const size_t i : Needed(reached, soaked_.reached)) {
      soaked_.corpus.push_back({known_.entries[i]->stimuli, reached[i]});
    }
  }

  void Tell() const {
    if (!request_.progress) return;
    const GoalSet reached = goals_.Reached(given_);
    const uint64_t percent =
        100 * std::min(soaked_.machine_ms, request_.machine_ms) / std::max<uint64_t>(1, request_.machine_ms);
    request_.progress(std::to_string(percent) + " % of the machine-hours, " + std::to_string(reached.Count()) + " of " +
                      std::to_string(goals_.all().size()) + " goals, " + std::to_string(soaked_.findings.size()) +
                      (soaked_.findings.size() == 1 ? " finding" : " findings"));
  }

  const SoakRequest& request_;
  const Goals& goals_;
  Known known_;
  Findings findings_;
  std::vector<std::unique_ptr<Machines>> machines_;  // of each job one
  std::vector<std::unique_ptr<Words>> words_;
  std::vector<std::unique_ptr<WideMachines>> wide_;
  std::vector<uint8_t> given_;                             // by all
  std::map<uint32_t, std::shared_ptr<const Entry>> came_;  // by message
  std::map<std::string, int> refuted_;
  std::optional<std::chrono::steady_clock::time_point> late_since_;  // as far as anybody asked
  Soaked soaked_;
};

}  // namespace

Soaked Soak(const SoakRequest& request, const Goals& goals, const Inputs& inputs, const WatchPlan& plan) {
  return Generations(request, goals, inputs, plan).Run();
}

std::vector<size_t> Needed(const std::vector<GoalSet>& runs, const GoalSet& all) {
  std::vector<size_t> needed;
  if (runs.empty()) return needed;
  // The one that adds most, again and again.
  GoalSet left = all;
  std::vector<bool> taken(runs.size());
  for (;;) {
    size_t best = runs.size(), most = 0;
    for (size_t i = 0; i < runs.size(); ++i) {
      if (taken[i]) continue;
      const size_t adds = left.CountShared(runs[i]);
      if (adds > most) {
        most = adds;
        best = i;
      }
    }
    if (best == runs.size()) break;
    taken[best] = true;
    left.Remove(runs[best]);
    needed.push_back(best);
  }
  // What came first may have become redundant by what came later.
  for (size_t i = 0; i < needed.size();) {
    std::vector<size_t> others = needed;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    GoalSet alone = runs[needed[i]];
    for (const size_t other : others) alone.Remove(runs[other]);
    if (alone.Count() == 0) {
      needed = std::move(others);
    } else {
      ++i;
    }
  }
  std::ranges::sort(needed);
  return needed;
}

}  // namespace plcxx::soak
