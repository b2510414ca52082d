#include "transpiler/review/diff/shorten.h"

#include <algorithm>
#include <span>

#include "transpiler/review/diff/machine.h"

namespace plcxx::review::diff {
namespace {

constexpr size_t kMostTries = 400;

/// What the later ones set wins; `key` tells which are the same.
template <class Set, class Key>
std::vector<Set> Merged(std::vector<Set> earlier, const std::vector<Set>& later, Key key) {
  for (const Set& set : later) {
    const auto same = std::ranges::find(earlier, std::invoke(key, set), key);
    if (same == earlier.end()) {
      earlier.push_back(set);
    } else {
      *same = set;
    }
  }
  return earlier;
}

/// All that a stimulus sets, in one: the last of what it repeats wins.
Stimulus SetBy(const Stimulus& stimulus) {
  Stimulus all{.inputs = stimulus.inputs, .words = stimulus.words};
  for (const Stimulus& repeated : stimulus.repeated) {
    const Stimulus of_it = SetBy(repeated);
    all.inputs = Merged(std::move(all.inputs), of_it.inputs, &prove::diff::SetCell::old_cell);
    all.words = Merged(std::move(all.words), of_it.words, &std::pair<std::string, std::string>::first);
  }
  return all;
}

/// The steps but for those in [begin, end): what these set goes to the next one that is left.
Stimuli Without(const Stimuli& stimuli, size_t begin, size_t end) {
  Stimuli rest(stimuli.begin(), stimuli.begin() + static_cast<std::ptrdiff_t>(begin));
  Stimulus carried;
  for (size_t step = begin; step < stimuli.size(); ++step) {
    const bool carries = step <= end && step > begin;
    Stimulus stimulus = step < end ? SetBy(stimuli[step]) : stimuli[step];
    const bool has_carried = !carried.inputs.empty() || !carried.words.empty();
    if (carries && !stimulus.repeated.empty() && has_carried) {
      rest.push_back(std::exchange(carried, {}));
    } else if (carries) {
      stimulus.inputs = Merged(std::move(carried.inputs), stimulus.inputs, &prove::diff::SetCell::old_cell);
      stimulus.words = Merged(std::move(carried.words), stimulus.words, &std::pair<std::string, std::string>::first);
    }
    if (step < end) {
      carried = std::move(stimulus);
    } else {
      rest.push_back(std::move(stimulus));
    }
  }
  return rest;
}

bool IsTimeAlone(const Stimulus& stimulus) {
  return stimulus.inputs.empty() && stimulus.words.empty() && !stimulus.power_cycle && stimulus.repeated.empty();
}

bool IsWait(const Stimulus& stimulus) { return stimulus.ms != 0; }

}  // namespace

Shortener::Shows ShowsDifference(const DiffSide& old_side, const DiffSide& new_side,
                                 const prove::machine::Version& old_version, const prove::machine::Version& new_version,
                                 std::vector<execute::CellId> old_cells, std::vector<execute::CellId> new_cells) {
  return [&old_side, &new_side, &old_version, &new_version, old_cells = std::move(old_cells),
          new_cells = std::move(new_cells)](const Stimuli& stimuli, Shortener::Time end) {
    DiffMachine old_machine(old_side, old_version, end), new_machine(new_side, new_version, end);
    for (const Stimulus& stimulus : stimuli) {
      if (!old_machine.Apply(stimulus, &prove::diff::SetCell::old_cell)) return false;
      if (!new_machine.Apply(stimulus, &prove::diff::SetCell::new_cell)) return false;
    }
    old_machine.Look();
    new_machine.Look();
    for (size_t i = 0; i < old_cells.size(); ++i) {
      if (old_machine.Seen(old_cells[i]) != new_machine.Seen(new_cells[i])) return true;
    }
    return false;
  };
}

bool Shortener::IsOver() const { return tries_ > kMostTries || std::chrono::steady_clock::now() > end_; }

bool Shortener::Try(Stimuli shorter) {
  ++tries_;
  if (IsOver() || !shows_(shorter, end_)) return false;
  stimuli_ = std::move(shorter);
  return true;
}

void Shortener::KeepLastSteps() {
  for (size_t kept = 1; kept < stimuli_.size() && !IsOver(); kept *= 2) {
    if (Try(Without(stimuli_, 0, stimuli_.size() - kept))) return;
  }
}

void Shortener::DropSteps() {
  for (size_t piece = std::max<size_t>(1, stimuli_.size() / 2); piece >= 1; piece /= 2) {
    for (size_t i = 0; i + piece < stimuli_.size() && !IsOver();) {
      if (!Try(Without(stimuli_, i, i + piece))) i += piece;
    }
  }
}

void Shortener::DropForTime() {
  constexpr size_t kFewSteps = 16;
  constexpr uint32_t kMsOfPass = 100;  // as a slow one takes, or more: what is too long is shortened afterwards
  if (stimuli_.size() > kFewSteps) return;
  constexpr uint32_t kParts = 4;  // of the time: what is seen now and then only is not seen after all of it, perhaps
  for (size_t dropped = stimuli_.size(); dropped-- > 1;) {
    const Stimuli shorter = Without(stimuli_, 0, dropped);
    const auto wait = std::ranges::find_if(shorter, IsWait);
    if (wait == shorter.end()) continue;
    uint32_t passed_ms = 0;
    for (const Stimulus& stimulus : std::span(stimuli_).first(dropped)) {
      passed_ms += stimulus.ms + kMsOfPass * (stimulus.slow + stimulus.fast);
    }
    for (uint32_t part = kParts; part > 0 && !IsOver(); --part) {
      Stimuli longer = shorter;
      longer[static_cast<size_t>(wait - shorter.begin())].ms += passed_ms / kParts * part;
      if (Try(std::move(longer))) return;
    }
  }
}

bool Shortener::StillShows() {
  ++tries_;
  return !IsOver() && shows_(stimuli_, end_);
}

template <class Set>
void Shortener::DropSets(std::vector<Set>& sets) {
  for (size_t piece = std::max<size_t>(1, sets.size() / 2); piece >= 1; piece /= 2) {
    for (size_t i = 0; i < sets.size() && !IsOver();) {
      const auto begin = sets.begin() + static_cast<std::ptrdiff_t>(i);
      const auto end = sets.begin() + static_cast<std::ptrdiff_t>(std::min(i + piece, sets.size()));
      const std::vector<Set> dropped(begin, end);
      sets.erase(begin, end);
      if (StillShows()) continue;
      sets.insert(sets.begin() + static_cast<std::ptrdiff_t>(i), dropped.begin(), dropped.end());
      i += piece;
    }
  }
}

void Shortener::DropInputs(Stimuli& stimuli) {
  for (Stimulus& stimulus : stimuli) {
    DropSets(stimulus.kept);
    DropSets(stimulus.inputs);
    DropSets(stimulus.words);
    DropSets(stimulus.repeated);
    DropInputs(stimulus.repeated);
  }
}

void Shortener::DropTime() {
  Stimuli at_once = stimuli_;
  for (Stimulus& stimulus : at_once) {
    if (!IsWait(stimulus)) continue;
    stimulus.ms = 0;
    stimulus.slow = 1;
  }
  if (std::ranges::any_of(stimuli_, IsWait) && Try(std::move(at_once))) return;
  DropWaits(stimuli_);
}

void Shortener::DropWaits(Stimuli& stimuli) {
  for (Stimulus& stimulus : stimuli) {
    DropWaits(stimulus.repeated);
    if (IsWait(stimulus) || stimulus.slow > 1) TakeTime(stimulus, {.inputs = {}, .words = {}, .slow = 1});
  }
}

bool Shortener::TakeTime(Stimulus& stimulus, const Stimulus& time) {
  const Stimulus before{.inputs = {}, .words = {}, .slow = stimulus.slow, .ms = stimulus.ms, .fast = stimulus.fast};
  const auto take = [&stimulus](const Stimulus& from) {
    stimulus.slow = from.slow;
    stimulus.ms = from.ms;
    stimulus.fast = from.fast;
  };
  if (IsOver()) return false;
  take(time);
  if (StillShows()) return true;
  take(before);
  return false;
}

void Shortener::RoundTime(Stimuli& stimuli) {
  constexpr uint32_t kFewPasses = 4;
  for (Stimulus& stimulus : stimuli) {
    RoundTime(stimulus.repeated);
    const bool many_passes = stimulus.slow > kFewPasses;
    if (!many_passes && !IsWait(stimulus)) continue;
    for (const uint32_t ms : {100U, 200U, 500U, 1000U, 2000U, 5000U, 10'000U, 20'000U, 60'000U}) {
      if (!many_passes && stimulus.ms == ms) break;
      // The next longer one, too: so the wait is the same whichever run was found first.
      const bool is_longer = !many_passes && stimulus.ms < ms;
      if (TakeTime(stimulus, {.inputs = {}, .words = {}, .ms = ms}) || is_longer) break;
    }
  }
}

void Shortener::JoinWaits() {
  for (size_t step = 0; step + 1 < stimuli_.size() && !IsOver();) {
    Stimuli shorter = Without(stimuli_, step, step + 1);
    const bool waits = stimuli_[step].ms != 0 && shorter[step].ms != 0;
    shorter[step].ms += stimuli_[step].ms;
    if (!waits || !Try(std::move(shorter))) ++step;
  }
}

Stimuli Shortener::Shorten(Stimuli stimuli) {
  stimuli_ = std::move(stimuli);
  tries_ = 0;
  KeepLastSteps();
  DropSteps();
  DropForTime();
  DropInputs(stimuli_);
  DropTime();
  RoundTime(stimuli_);
  stimuli_ = Joined(stimuli_);
  // A wait that came in pieces is one number now, perhaps a rounder one; two steps are one, perhaps.
  RoundTime(stimuli_);
  DropSteps();
  JoinWaits();
  RoundTime(stimuli_);
  return std::move(stimuli_);
}

Stimuli Joined(const Stimuli& stimuli) {
  Stimuli joined;
  for (Stimulus stimulus : stimuli) {
    // Time that passes in pieces, too.
    if (stimulus.repeated.size() == 1 && IsTimeAlone(stimulus.repeated.front())) {
      const uint32_t times = stimulus.times;
      stimulus = Stimulus(stimulus.repeated.front());
      for (uint32_t* const part : {&stimulus.slow, &stimulus.fast, &stimulus.ms}) *part *= times;
    }
    const auto part_of = [](const Stimulus& of) { return std::pair(of.slow != 0, of.fast != 0); };
    if (!joined.empty() && joined.back().repeated.empty() && IsTimeAlone(stimulus) &&
        part_of(joined.back()) == part_of(stimulus)) {
      joined.back().slow += stimulus.slow;
      joined.back().fast += stimulus.fast;
      joined.back().ms += stimulus.ms;
    } else {
      joined.push_back(stimulus);
    }
  }
  return joined;
}

}  // namespace plcxx::review::diff
