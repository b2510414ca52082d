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

/// The steps but for those in [begin, end): what these set goes to the next one that is left.
Stimuli Without(const Stimuli& stimuli, size_t begin, size_t end) {
  Stimuli rest(stimuli.begin(), stimuli.begin() + static_cast<std::ptrdiff_t>(begin));
  Stimulus carried;
  for (size_t step = begin; step < stimuli.size(); ++step) {
    const bool carries = step <= end && step > begin;
    Stimulus stimulus = stimuli[step];
    if (carries) {
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

void Shortener::DropInputs() {
  for (size_t step = 0; step < stimuli_.size(); ++step) {
    DropSets(stimuli_[step].inputs);
    DropSets(stimuli_[step].words);
  }
}

void Shortener::DropTime() {
  if (!std::ranges::any_of(stimuli_, IsWait)) return;
  Stimuli at_once = stimuli_;
  for (Stimulus& stimulus : at_once) {
    if (!IsWait(stimulus)) continue;
    stimulus.ms = 0;
    stimulus.slow = 1;
  }
  if (Try(std::move(at_once))) return;
  for (size_t step = 0; step < stimuli_.size(); ++step) {
    if (!IsWait(stimuli_[step])) continue;
    Stimuli shorter = stimuli_;
    shorter[step].ms = 0;
    shorter[step].slow = 1;
    Try(std::move(shorter));
  }
}

void Shortener::RoundTime() {
  constexpr uint32_t kFewPasses = 4;
  for (size_t step = 0; step < stimuli_.size(); ++step) {
    const bool many_passes = stimuli_[step].slow > kFewPasses;
    for (const uint32_t ms : {100U, 200U, 500U, 1000U, 2000U, 5000U, 10'000U, 20'000U, 60'000U}) {
      if (!many_passes && stimuli_[step].ms <= ms) break;
      Stimuli shorter = stimuli_;
      shorter[step].slow = shorter[step].fast = 0;
      shorter[step].ms = ms;
      if (Try(std::move(shorter))) break;
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
  DropInputs();
  DropTime();
  RoundTime();
  stimuli_ = Joined(stimuli_);
  // A wait that came in pieces is one number now, perhaps a rounder one; two steps are one, perhaps.
  RoundTime();
  DropSteps();
  JoinWaits();
  RoundTime();
  return std::move(stimuli_);
}

Stimuli Joined(const Stimuli& stimuli) {
  Stimuli joined;
  for (const Stimulus& stimulus : stimuli) {
    const bool sets = !stimulus.inputs.empty() || !stimulus.words.empty() || stimulus.power_cycle;
    const auto part_of = [](const Stimulus& of) { return std::pair(of.slow != 0, of.fast != 0); };
    if (!joined.empty() && !sets && part_of(joined.back()) == part_of(stimulus)) {
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
