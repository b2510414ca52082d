#include "transpiler/soak/trial.h"

#include <algorithm>
#include <utility>

#include "transpiler/scenarios/control.h"

namespace plcxx::soak {
namespace {

constexpr size_t kMostSteps = 60;           // of a trial
constexpr size_t kLongestRun = 400;         // steps from power-on of a run that others go on from
constexpr size_t kMostKept = 8;             // moments of a trial
constexpr uint64_t kMostWork = 20'000'000;  // instructions of a trial
constexpr uint64_t kManyInputs = 6;
constexpr size_t kNewest = 16;

uint64_t Scrambled(uint64_t number) {
  number = (number ^ number >> 30) * 0xBF58476D1CE4E5B9;
  number = (number ^ number >> 27) * 0x94D049BB133111EB;
  return (number ^ number >> 31) | 1;
}

}  // namespace

Trial::Trial(const Known& known, Words& words, uint64_t chance, uint64_t most_ms, const Stimuli* follows)
    : known_(known),
      words_(words),
      random_(Scrambled(chance)),
      most_ms_(most_ms),
      follows_(follows),
      given_(known.given.size()),
      given_before_(known.given.size()),
      seen_(known.given),
      watch_(known.plan) {}

void Trial::Begin(Machines& machines, size_t machine) {
  machine_ = machine;
  begin_work_ = machines.Work(machine);
  machines.NoteGiven(machine, given_);
  const uint64_t from = follows_ != nullptr ? 0 : random_.Next() % 16;
  if (from % 4 == 3 && !known_.standing.empty() && follows_ == nullptr) {
    // What makes it go, if anything does?
    const Standing& standing = known_.standing[random_.Next() % known_.standing.size()];
    machines.Restore(machine, *standing.entry->moment);
    stimuli_ = standing.entry->stimuli;
    given_before_ = standing.entry->given;
    if (!standing.writers.empty()) sought_ = &standing.writers;
  } else if (from >= 4 && !known_.entries.empty()) {
    // The newest have seen what nothing else has.
    const size_t count = known_.entries.size();
    const size_t among = random_.OneIn(2) ? count : std::min(count, kNewest);
    const Entry& entry = *known_.entries[count - 1 - random_.Next() % among];
    machines.Restore(machine, *entry.moment);
    stimuli_ = entry.stimuli;
    given_before_ = entry.given;
  } else {
    machines.PowerOn(machine);
    if (from >= 1 && !known_.scenarios.empty() && follows_ == nullptr) {
      scenario_ = &known_.scenarios[random_.Next() % known_.scenarios.size()];
    }
  }
  time_ms_ = machines.TimeMs(machine);
  watch_.BeginFrom(machines, machine);
}

void Trial::SetInput(uint32_t number, Machines& machines, Stimulus& stimulus) {
  const Input& input = known_.inputs.all()[number];
  const uint64_t now = input.location.cell ? 0 : scenarios::ReadLocation(machines.EngineOf(machine_), input.location);
  const uint64_t value = known_.inputs.ValueFor(input, now, random_);
  std::pair<std::string, std::string> word{input.name, Inputs::TextOf(input, value)};
  const auto same = std::ranges::find(stimulus.words, word.first, &std::pair<std::string, std::string>::first);
  if (same == stimulus.words.end()) {
    stimulus.words.push_back(std::move(word));
  } else {
    *same = std::move(word);
  }
}

void Trial::ChooseTime(Stimulus& stimulus) {
  const ir::Schedule& schedule = known_.plan.program().schedule;
  const uint64_t what = random_.Next() % 16;
  if (what < 2) {
    const std::vector<uint32_t>& waits = known_.inputs.waits_ms();
    stimulus.ms = waits[random_.Next() % waits.size()];
  } else if (what == 2 && schedule.fast_done.valid()) {
    stimulus.fast = 1;
  } else if (what < 6) {
    stimulus.ms = std::max(1U, schedule.period_ms);
  } else {
    stimulus.slow = 1 + static_cast<uint32_t>(random_.OneIn(4) ? random_.Next() % 12 : 0);
  }
}

Stimulus Trial::Choose(Machines& machines) {
  Stimulus stimulus;
  const std::vector<Input>& inputs = known_.inputs.all();
  const bool follows = scenario_ != nullptr && next_step_ < scenario_->size();
  if (follows) {
    stimulus = (*scenario_)[next_step_];
    if (!random_.OneIn(4)) ++next_step_;
    if (!random_.OneIn(5)) return stimulus;
  } else if (!known_.scenarios.empty() && random_.OneIn(8)) {
    const Stimuli& other = known_.scenarios[random_.Next() % known_.scenarios.size()];
    stimulus.words = other[random_.Next() % other.size()].words;
  }
  if (!inputs.empty()) {
    const bool all_done = random_.OneIn(2);
    for (uint32_t i = 0; i < inputs.size(); ++i) {
      if (inputs[i].is_request && all_done && random_.OneIn(4)) SetInput(i, machines, stimulus);
    }
    if ((sought_ != nullptr || !known_.open.empty()) && random_.OneIn(2)) {
      const ir::StatementId goal = sought_ != nullptr ? ir::StatementId((*sought_)[random_.Next() % sought_->size()])
                                                      : known_.open[random_.Next() % known_.open.size()];
      for (uint64_t i = 1 + random_.Next() % 4; i > 0; --i) {
        if (const std::optional<uint32_t> input = known_.inputs.Towards(goal, random_)) {
          SetInput(*input, machines, stimulus);
        }
      }
    } else if (random_.OneIn(kManyInputs)) {
      const uint64_t one_in = uint64_t{2} << random_.Next() % 5;
      for (uint32_t i = 0; i < inputs.size(); ++i) {
        if (random_.OneIn(one_in)) SetInput(i, machines, stimulus);
      }
    } else {
      for (uint64_t i = random_.Next() % 4; i > 0; --i) {
        SetInput(static_cast<uint32_t>(random_.Next() % inputs.size()), machines, stimulus);
      }
    }
  }
  if (stimulus.slow == 0 && stimulus.fast == 0 && stimulus.ms == 0) ChooseTime(stimulus);
  if (random_.OneIn(60)) stimulus.power_cycle = true;
  return stimulus;
}

bool Trial::Next(Machines& machines, Piece& piece) {
  if (is_over_) return false;
  Stimulus stimulus;
  if (follows_ != nullptr) {
    if (next_step_ == follows_->size()) return false;
    stimulus = AsItHappens((*follows_)[next_step_++], known_.plan.program().schedule);
  } else {
    const uint64_t work = machines.Work(machine_) - begin_work_;
    if (steps_ >= kMostSteps || machine_ms_ >= most_ms_ || work >= kMostWork || stimuli_.size() >= kLongestRun) {
      return false;
    }
    stimulus = AsItHappens(Choose(machines), known_.plan.program().schedule);
    // The last step goes no further than it may; a period is as short as time is.
    const uint64_t period = std::max(1U, known_.plan.program().schedule.period_ms);
    const uint64_t left = (most_ms_ - machine_ms_ + period - 1) / period * period;
    if (stimulus.ms > left) stimulus.ms = static_cast<uint32_t>(left);
  }
  ++steps_;
  if (stimulus.power_cycle) {
    machines.PowerCycle(machine_);
    watch_.BeginFrom(machines, machine_);
    time_ms_ = machines.TimeMs(machine_);
  }
  for (const auto& word : stimulus.words) words_.Set(word, machines, machine_);
  piece = {.machine = machine_, .slow = stimulus.slow, .fast = stimulus.fast, .ms = stimulus.ms};
  stimuli_.push_back(std::move(stimulus));
  return true;
}

void Trial::AfterPart(Machines& machines, sim::Clock::Part part) { watch_.AfterPart(machines, machine_, part, given_); }

/// What one of the two has that nobody had.
bool Trial::GaveNews() const {
  for (size_t i = 0; i < given_.size(); ++i) {
    if ((given_[i] & ~seen_[i]) != 0) return true;
  }
  return false;
}

Entry Trial::Here(Machines& machines) const {
  Entry entry{.stimuli = stimuli_, .moment = machines.Save(machine_), .given = given_before_};
  for (size_t i = 0; i < given_.size(); ++i) entry.given[i] |= given_[i];
  return entry;
}

void Trial::Keep(Machines& machines) {
  result_.entries.push_back(Here(machines));
  for (size_t i = 0; i < given_.size(); ++i) seen_[i] |= given_[i];
}

void Trial::AfterStep(Machines& machines) {
  const uint64_t now = machines.TimeMs(machine_);
  machine_ms_ += now - std::min(now, time_ms_);
  time_ms_ = now;
  for (const uint32_t number : watch_.came()) {
    if (known_.gone.contains(number) || result_.came.contains(number)) continue;
    if (machines.EndOf(machine_) == PieceEnd::kDone) result_.came.emplace(number, Here(machines));
  }
  watch_.AfterStep(machines, machine_);
  for (Cause& cause : watch_.TakeCauses()) {
    const bool is_known = known_.causes.contains(cause.key) ||
                          std::ranges::any_of(result_.found, [&cause](const TrialResult::Found& found) {
                            return found.cause.key == cause.key;
                          });
    if (!is_known) result_.found.push_back({std::move(cause), stimuli_});
  }
  if (machines.EndOf(machine_) != PieceEnd::kDone) {
    is_over_ = true;
    return;
  }
  if (result_.entries.size() < kMostKept && GaveNews()) Keep(machines);
}

void Trial::End(Machines& machines) {
  // All that was reached is in a run that can be kept, but for the step that did not end.
  if (!is_over_ && GaveNews()) Keep(machines);
  machines.NoteGiven(machine_, {});
  result_.messages = watch_.messages();
  result_.outputs = watch_.outputs();
  result_.parts = watch_.parts();
  result_.machine_ms = machine_ms_;
  result_.steps = steps_;
  result_.given = std::move(given_);
}

Stimulus AsItHappens(Stimulus stimulus, const ir::Schedule& schedule) {
  const bool slow_alone = schedule.fast_ms != 0, fast_alone = !schedule.fast_done.valid();
  const uint32_t period = std::max(1U, schedule.period_ms);
  if (stimulus.slow != 0 && slow_alone) {
    stimulus.ms = stimulus.slow * period;
    stimulus.slow = stimulus.fast = 0;
  } else if (stimulus.slow == 0 && stimulus.fast != 0 && fast_alone) {
    // It runs once in a period, or has its own.
    stimulus.ms = stimulus.fast * (schedule.fast_ms != 0 ? schedule.fast_ms : period);
    stimulus.fast = 0;
  }
  return stimulus;
}

void RunTrials(Machines& machines, std::span<Trial* const> trials) {
  for (size_t begin = 0; begin < trials.size(); begin += machines.count()) {
    const std::span<Trial* const> now = trials.subspan(begin, std::min(machines.count(), trials.size() - begin));
    for (size_t i = 0; i < now.size(); ++i) now[i]->Begin(machines, i);
    const Machines::AfterPart after = [&](size_t machine, sim::Clock::Part part) {
      now[machine]->AfterPart(machines, part);
    };
    for (std::vector<Piece> pieces;; pieces.clear()) {
      for (Trial* const trial : now) {
        if (Piece piece; trial->Next(machines, piece)) pieces.push_back(piece);
      }
      if (pieces.empty()) break;
      machines.Run(pieces, after);
      for (const Piece& piece : pieces) now[piece.machine]->AfterStep(machines);
    }
    for (Trial* const trial : now) trial->End(machines);
  }
}

}  // namespace plcxx::soak
