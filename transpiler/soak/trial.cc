#include "transpiler/soak/trial.h"

#include <algorithm>
#include <utility>

namespace plcxx::soak {
namespace {

constexpr size_t kLongestRun = 400;         // steps from power-on of a run that others go on from
constexpr size_t kMostKept = 8;             // moments of a trial
constexpr uint64_t kMostWork = 20'000'000;  // instructions of a trial

}  // namespace

Trial::Trial(const Known& known, Words& words, uint64_t chance, uint64_t most_ms)
    : known_(known),
      words_(words),
      random_(RandomOf(chance)),
      most_ms_(most_ms),
      given_(known.given.size()),
      given_before_(known.given.size()),
      seen_(known.given),
      watch_(known.plan) {}

Trial::Trial(const Known& known, Words& words, std::shared_ptr<const Entry> from, const Stimuli& follows)
    : Trial(known, words, 1, ~uint64_t{0}) {
  begin_.from = std::move(from);
  follows_ = &follows;
}

void Trial::Begin(Machines& machines, size_t machine) {
  machine_ = machine;
  begin_work_ = machines.Work(machine);
  machines.NoteGiven(machine, given_);
  if (follows_ == nullptr) begin_ = ChooseBeginning(known_, random_);
  if (begin_.from) {
    machines.Restore(machine, *begin_.from->moment);
    stimuli_ = begin_.from->stimuli;
    given_before_ = begin_.from->given;
  } else {
    machines.PowerOn(machine);
  }
  time_ms_ = machines.TimeMs(machine);
  watch_.BeginFrom(machines, machine);
}

Stimulus Trial::Choose(Machines& machines) {
  Stimulus stimulus;
  if (begin_.scenario != nullptr && next_step_ < begin_.scenario->size()) {
    stimulus = (*begin_.scenario)[next_step_];
    if (!random_.OneIn(4)) ++next_step_;
    if (!random_.OneIn(5)) return stimulus;
  } else if (const Stimulus* const other = PickOtherStep(known_, random_)) {
    stimulus.words = other->words;
  }
  ChooseInputs(known_, begin_.sought, random_, [&](uint32_t number) {
    const uint64_t value = ChooseValue(known_, number, machines.EngineOf(machine_), random_);
    const Input& input = known_.inputs.all()[number];
    PutWord(stimulus, {input.name, Inputs::TextOf(input, value)});
  });
  if (stimulus.slow == 0 && stimulus.fast == 0 && stimulus.ms == 0) ChooseTime(known_, random_, stimulus);
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
