#include "transpiler/review/diff/search.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>

#include "transpiler/prove/diff/runs_from.h"
#include "transpiler/prove/machine/transition.h"
#include "transpiler/support/mixed.h"

namespace plcxx::review::diff {
namespace {

using execute::CellId;
using prove::diff::SetCell;

constexpr size_t kMostSignatures = 4000;
constexpr size_t kManyInputs = 100;  // of a program with so many a few others change nothing that is far away
constexpr uint32_t kQuestionOfManyMs = 40;
constexpr size_t kMostKeptInputs = 8'000'000;    // of all runs; what is seen after that differs, and is not shown
constexpr int kAimedOfMany = 4;                  // times the time that is spent otherwise
constexpr uint32_t kAimedPasses = 4;             // whole slow passes that the solver looks ahead
constexpr uint64_t kMostShownPeriods = 100'000;  // of a run to a moment that is kept
constexpr std::array<uint32_t, 3> kWaitsMs = {1500, 4000, 25'000};
constexpr uint32_t kWatchedPeriods = 60;  // of a wait, one by one; the rest in larger pieces

}  // namespace

void DirectedSearch::EndAt(Time end) {
  end_ = end;
  old_machine_.EndAt(end);
  new_machine_.EndAt(end);
}

void DirectedSearch::GoTo(const Moment& moment) {
  old_machine_.Restore(moment.old_saved);
  new_machine_.Restore(moment.new_saved);
  stimuli_ = moment.stimuli;
  periods_ = moment.periods;
  scenario_ = moment.scenario;
  next_step_ = moment.next_step;
}

DirectedSearch::Moment DirectedSearch::Here() const {
  return {.old_saved = old_machine_.Save(),
          .new_saved = new_machine_.Save(),
          .stimuli = stimuli_,
          .periods = periods_,
          .scenario = scenario_,
          .next_step = next_step_};
}

void DirectedSearch::Keep(Kept why) {
  Moments& kept = why == Kept::kDiffers    ? differing_
                  : why == Kept::kNew      ? new_
                  : why == Kept::kOnTheWay ? on_the_way_
                                           : between_;
  auto moment = std::make_shared<Moment>(Here());
  if (kept.size() < most_moments_ / 3) {
    kept.push_back(std::move(moment));
  } else {
    // The first one is power-on.
    kept[1 + random_.Next() % (kept.size() - 1)] = std::move(moment);
  }
}

void DirectedSearch::GoBack() {
  const uint64_t which = random_.Next() % 8;
  const bool is_on_the_way = which >= 5 && which < 7 && !on_the_way_.empty();
  const Moments& kept = is_on_the_way                      ? on_the_way_
                        : which < 3 && !differing_.empty() ? differing_
                        : which < 6 && !new_.empty()       ? new_
                                                           : between_;
  waits_next_ = is_on_the_way && random_.OneIn(3);
  // The last ones are the news.
  const size_t count = random_.OneIn(2) ? kept.size() : std::min<size_t>(kept.size(), 8);
  GoTo(*kept[kept.size() - 1 - random_.Next() % count]);
}

void DirectedSearch::Compare(RandomRuns& result) {
  std::vector<CellId> differ;
  const std::vector<uint8_t>&old_picture = old_machine_.picture(), &new_picture = new_machine_.picture();
  differs_now_ = false;
  const auto add = [&](CellId cell) {
    differs_now_ = true;
    if (!result.difference_of.contains(cell)) differ.push_back(cell);
  };
  for (const Compared& compared : compared_) {
    if (compared.bytes == 1) {
      if (((old_picture[compared.old_at] ^ new_picture[compared.new_at]) & compared.mask) == 0) continue;
    } else if (compared.bytes != 0 &&
               std::equal(old_picture.begin() + compared.old_at, old_picture.begin() + compared.old_at + compared.bytes,
                          new_picture.begin() + compared.new_at)) {
      continue;
    }
    for (const CellId cell : compared.cells) {
      if (old_machine_.Seen(cell) != new_machine_.Seen(match_.new_of_old[cell.index])) add(cell);
    }
  }
  for (const CellId cell : compared_calls_) {
    if (old_machine_.Seen(cell) != new_machine_.Seen(match_.new_of_old[cell.index])) add(cell);
  }
  if (differ.empty()) return;
  const auto run = static_cast<uint32_t>(result.runs.size());
  for (const Stimulus& stimulus : stimuli_) kept_inputs_ += stimulus.inputs.size();
  result.runs.push_back(kept_inputs_ < kMostKeptInputs ? stimuli_ : Stimuli());
  kept_runs_.insert(run);
  for (const CellId cell : differ) {
    result.difference_of[cell] = {
        .run = run, .steps = static_cast<uint32_t>(result.runs.back().size()), .periods = periods_};
  }
  has_new_difference_ = true;
}

void DirectedSearch::KeepShown(RandomRuns& result) {
  // By run the shortest part of it that shows something.
  std::map<uint32_t, RandomRuns::Difference> shown;
  for (const auto& [cell, difference] : result.difference_of) {
    if (kept_runs_.contains(difference.run)) continue;
    const auto [at, added] = shown.try_emplace(difference.run, difference);
    if (!added && difference.steps < at->second.steps) at->second = difference;
  }
  for (const auto& [run, difference] : shown) {
    if (Late() || difference.periods > kMostShownPeriods) continue;
    kept_runs_.insert(run);
    GoTo(*between_.front());
    const Stimuli& stimuli = result.runs[run];
    const bool is_done = std::all_of(stimuli.begin(), stimuli.begin() + difference.steps,
                                     [this](const Stimulus& stimulus) { return Apply(stimulus); });
    if (!is_done) continue;
    stimuli_.assign(stimuli.begin(), stimuli.begin() + difference.steps);
    periods_ = difference.periods;
    Compare(result);
    if (differs_now_) Keep(Kept::kDiffers);
  }
}

uint64_t DirectedSearch::Signature() const {
  uint64_t hash = 0;
  for (const CellId cell : read_by_changed_) {
    const uint64_t value = old_machine_.Seen(cell);
    // Of a number its magnitude.
    hash = support::Mixed(hash, value <= 1 ? value : 2 + static_cast<uint64_t>(std::bit_width(value)));
    const uint64_t other = new_machine_.Seen(match_.new_of_old[cell.index]);
    if (other != value) hash = support::Mixed(hash, 7);
  }
  return hash;
}

bool DirectedSearch::HasFirstValue() {
  bool has = false;
  for (auto& [cell, seen] : seen_behind_) {
    const uint64_t bit = uint64_t{1} << std::min(63, static_cast<int>(std::bit_width(old_machine_.Seen(cell))));
    has = has || (seen & bit) == 0;
    seen |= bit;
  }
  return has;
}

bool DirectedSearch::Step(const Stimulus& stimulus, RandomRuns& result) {
  const uint32_t period_ms = period_ms_;
  const auto apply = [&](const Stimulus& piece) {
    if (Late()) return false;
    if (!old_machine_.Apply(piece, &SetCell::old_cell) || !new_machine_.Apply(piece, &SetCell::new_cell)) return false;
    old_machine_.Look();
    new_machine_.Look();
    periods_ += piece.slow + piece.fast + piece.ms / period_ms;
    return true;
  };
  // All but the first piece only let time pass.
  stimuli_.push_back(stimulus);
  LookAtCounters();
  Stimulus piece = stimulus;
  const bool waits = stimulus.ms != 0;
  const uint32_t count = waits ? stimulus.ms : stimulus.slow != 0 ? stimulus.slow : stimulus.fast;
  const uint32_t least = waits ? period_ms : 1;
  if (count == 0 && !apply(piece)) return false;
  for (uint32_t done = 0, pieces = 0; done < count; ++pieces) {
    const uint32_t length = pieces < kWatchedPeriods ? least : std::max(least, (count - done) / 8 / least * least);
    const uint32_t now = std::min(length, count - done);
    uint32_t& amount = waits ? piece.ms : stimulus.slow != 0 ? piece.slow : piece.fast;
    amount = now;
    if (!apply(piece)) return false;
    done += now;
    Stimulus& last = stimuli_.back();
    (waits ? last.ms : stimulus.slow != 0 ? last.slow : last.fast) = done;
    has_new_difference_ = false;
    Compare(result);
    if (has_new_difference_) Keep(Kept::kDiffers);
    piece.inputs.clear();
    piece.words.clear();
    piece.power_cycle = false;
    piece.kept.clear();
  }
  NoteAdvances();
  const bool has_first = HasFirstValue();
  if (signatures_.size() < kMostSignatures && signatures_.insert(Signature()).second) {
    Keep(Kept::kNew);
  } else if (has_first) {
    Keep(Kept::kOnTheWay);
  }
  return true;
}

void DirectedSearch::Disturb(const Input& input, std::vector<SetCell>& sets) {
  uint64_t value = 0;
  for (size_t i = 0; i < input.size() && i < 64; ++i) value |= old_machine_.Seen(input[i].old_cell) << i;
  if (input.size() == 1) {
    value ^= random_.OneIn(8) ? 0 : 1;
  } else {
    switch (random_.Next() % 6) {
      case 0:
        value = 0;
        break;
      case 1:
        value = random_.Next() % 5;
        break;
      case 2:
      case 3:
        if (!constants_.empty()) value = constants_[random_.Next() % constants_.size()] + random_.Next() % 3 - 1;
        break;
      case 4:
        value ^= uint64_t{1} << random_.Next() % std::min<size_t>(64, input.size());
        break;
      default:
        value = random_.Next();
    }
  }
  for (size_t i = 0; i < input.size(); ++i) {
    sets.push_back(input[i]);
    sets.back().value = i < 64 ? value >> i & 1 : 0;
  }
}

void DirectedSearch::DisturbMany(Stimulus& stimulus) {
  const uint64_t one_in = uint64_t{2} << random_.Next() % 6, ones = 1 + random_.Next() % 7;  // of eight
  for (const Input& input : inputs_) {
    if (!random_.OneIn(one_in)) continue;
    for (const SetCell& bit : input) {
      stimulus.inputs.push_back(bit);
      stimulus.inputs.back().value = random_.Next() % 8 < ones ? 1 : 0;
    }
  }
}

Stimulus DirectedSearch::Unexpected() {
  Stimulus stimulus;
  if (std::exchange(waits_next_, false)) {
    stimulus.ms = waits_ms_[random_.Next() % waits_ms_.size()];
    return stimulus;
  }
  const bool follows = scenario_ < known_.size() && next_step_ < known_[scenario_].size();
  if (follows && random_.OneIn(3)) {
    stimulus = known_[scenario_][next_step_++];
    if (!random_.OneIn(4)) return stimulus;
  } else if (!known_.empty() && random_.OneIn(6)) {
    const Stimuli& other = known_[random_.Next() % known_.size()];
    const Stimulus& step = other[random_.Next() % other.size()];
    stimulus.words = step.words;
    stimulus.inputs = step.inputs;
  }
  // The control has done what it was asked for.
  for (const SetCell& request : requests_) {
    if (random_.OneIn(4)) stimulus.inputs.push_back(request);
  }
  if (inputs_.size() > kManyInputs && random_.OneIn(2)) DisturbMany(stimulus);
  for (uint64_t i = random_.Next() % 4; i > 0; --i) {
    const uint64_t which = random_.Next() % 8;
    const std::vector<Input>& from = which < 4 && !near_.empty()     ? near_
                                     : which < 7 && !behind_.empty() ? behind_
                                                                     : inputs_;
    if (!from.empty()) Disturb(from[random_.Next() % from.size()], stimulus.inputs);
  }
  if (stimulus.slow != 0 || stimulus.fast != 0 || stimulus.ms != 0) return stimulus;
  const bool has_fast = prove::machine::HasFastPart(old_version_) || prove::machine::HasFastPart(new_version_);
  stimulus.power_cycle = random_.OneIn(40);
  const uint64_t what = random_.Next() % 16;
  if (what == 0) {
    stimulus.ms = waits_ms_[random_.Next() % waits_ms_.size()];
  } else if (what < 3 && has_fast) {
    stimulus.fast = 1;
  } else if (what < 6) {
    stimulus.ms = std::max(1U, old_side_.compilation.program.schedule.period_ms);
  } else {
    stimulus.slow = 1 + static_cast<uint32_t>(random_.OneIn(4) ? random_.Next() % 12 : 0);
  }
  return stimulus;
}

void DirectedSearch::BeginWithKept(Time end, RandomRuns& result) {
  constexpr int kStarts = 12;
  EndAt(end);
  for (int start = 0; start < kStarts && !kept_.empty() && !Late(); ++start) {
    GoTo(*between_.front());
    Stimulus power_on{.inputs = {}, .words = {}, .slow = 1, .power_cycle = true};
    for (uint64_t words = 1 + (random_.Next() >> 20) % 3; words > 0; --words)
      Disturb(kept_[(random_.Next() >> 20) % kept_.size()], power_on.kept);
    if (Step(power_on, result)) Keep(Kept::kBetweenSteps);
  }
}

void DirectedSearch::RunScenarios(Time end, RandomRuns& result) {
  EndAt(end);
  for (size_t scenario = 0; scenario < known_.size() && !Late(); ++scenario) {
    GoTo(*between_.front());
    scenario_ = scenario;
    for (const Stimulus& stimulus : known_[scenario]) {
      ++next_step_;
      if (!Step(stimulus, result)) break;
      Keep(Kept::kBetweenSteps);
    }
  }
}

void DirectedSearch::Follow(const std::vector<prove::diff::Run>& computed, Time end, RandomRuns& result) {
  EndAt(end);
  constexpr size_t kMostFollowed = 30;
  for (; followed_ < std::min(computed.size(), kMostFollowed) && !Late(); ++followed_) {
    // As whole passes, and as time: where the slow part is in slices they are not the same.
    for (const bool by_time : {false, true}) {
      GoTo(*between_.front());
      for (const Stimulus& power_on : PowerOnWith(computed[followed_].kept)) Step(power_on, result);
      for (const std::vector<SetCell>& inputs : computed[followed_].periods) {
        Stimulus stimulus{.inputs = inputs, .words = {}};
        (by_time ? stimulus.ms : stimulus.slow) = by_time ? old_side_.compilation.program.schedule.period_ms : 1;
        if (!Step(stimulus, result)) break;
      }
    }
  }
}

void DirectedSearch::ForEachSeenState(
    prove::diff::Which which, const std::function<void(const prove::invariants::CellValues&, uint64_t now_ms)>& visit) {
  const bool is_old = which == prove::diff::Which::kOld;
  DiffMachine& machine = is_old ? old_machine_ : new_machine_;
  for (const Moments* const kept : {&between_, &new_, &differing_}) {
    for (const std::shared_ptr<Moment>& moment : *kept) {
      machine.Restore(is_old ? moment->old_saved : moment->new_saved);
      visit([&machine](CellId cell) { return machine.ValueOf(cell); }, machine.time_ms());
    }
  }
}

void DirectedSearch::ForEachSeenPair(
    const std::function<void(const prove::invariants::CellValues& of_old, const prove::invariants::CellValues& of_new,
                             uint64_t now_ms)>& visit) {
  for (const Moments* const kept : {&between_, &new_, &on_the_way_, &differing_}) {
    for (const std::shared_ptr<Moment>& moment : *kept) {
      old_machine_.Restore(moment->old_saved);
      new_machine_.Restore(moment->new_saved);
      visit([this](CellId cell) { return old_machine_.ValueOf(cell); },
            [this](CellId cell) { return new_machine_.ValueOf(cell); }, old_machine_.time_ms());
    }
  }
}

DirectedSearch::Moment* DirectedSearch::NextToAsk() {
  // What differs leads to what is computed from it: the last moments are the farthest.
  if (random_.OneIn(2)) {
    const auto last = std::find_if(differing_.rbegin(), differing_.rend(), [](const auto& m) { return !m->is_asked; });
    if (last != differing_.rend()) return last->get();
  }
  for (const Moments* const kept : {&new_, &between_, &differing_, &on_the_way_}) {
    const auto found = std::ranges::find_if(*kept, [](const auto& m) { return !m->is_asked; });
    if (found != kept->end()) return found->get();
  }
  return nullptr;
}

DirectedSearch::Moment* DirectedSearch::NextToWait() {
  for (const Moments* const kept : {&differing_, &on_the_way_, &new_, &between_}) {
    const auto last = std::find_if(kept->rbegin(), kept->rend(), [](const auto& m) { return !m->is_waited; });
    if (last != kept->rend()) return last->get();
  }
  return nullptr;
}

void DirectedSearch::Wait(Moment& moment, RandomRuns& result) {
  moment.is_waited = true;
  GoTo(moment);
  for (const uint32_t ms : kWaitsMs) {
    if (!Step({.inputs = {}, .words = {}, .ms = ms}, result)) return;
  }
}

void DirectedSearch::Aim(Moment& moment, const std::vector<CellId>& sought, RandomRuns& result) {
  using Clock = std::chrono::steady_clock;
  constexpr Clock::duration kMostForOne = std::chrono::milliseconds(400);
  // A busy machine may need longer.
  const Clock::time_point begin = Clock::now();
  const Clock::time_point limit = std::min(end_, begin + std::max(kMostForOne, (end_ - begin) / 3));
  moment.is_asked = true;
  GoTo(moment);
  // The moment may have gone when others are kept.
  const Moment from = Here();
  const auto repeat = [&](const prove::diff::Run& run) {
    GoTo(from);
    Repeat(run, period_ms_, result);
  };
  prove::diff::AimLimits limits{.most_periods = kAimedPasses * pass_periods_, .end = limit};
  // Each answer is one more location then, and most of them are small questions.
  if (sought.size() > kMostSought) {
    limits.most_questions = sought.size();
    limits.question_ms = kQuestionOfManyMs;
  }
  prove::diff::RunsFrom(
      Unrollable(), Seen(), sought, limits, [&result](CellId cell) { return !result.difference_of.contains(cell); },
      repeat);
  if (!Late()) return;
  // To be asked again when there is more time.
  GoTo(from);
  Keep(Kept::kNew);
}

void DirectedSearch::Repeat(const prove::diff::Run& run, uint32_t period_ms, RandomRuns& result) {
  // What is set, and as much time as passes until something is set again.
  for (size_t period = 0; period < run.periods.size();) {
    Stimulus stimulus{.inputs = run.periods[period], .words = {}};
    do {
      stimulus.ms += period_ms;
      ++period;
    } while (period < run.periods.size() && run.periods[period].empty());
    if (!Step(stimulus, result)) return;
  }
}

prove::diff::UnrolledVersions DirectedSearch::Unrollable() const {
  return {.old_version = old_version_,
          .new_version = new_version_,
          .match = match_,
          .old_uses = old_uses_,
          .new_uses = new_uses_,
          .requests = {}};
}

prove::diff::SeenState DirectedSearch::Seen() const {
  return {.value =
              [this](prove::diff::Which which, CellId cell) {
                return (which == prove::diff::Which::kOld ? old_machine_ : new_machine_).ValueOf(cell);
              },
          .now_ms = old_machine_.time_ms()};
}

prove::diff::WideRuns& DirectedSearch::Wide() {
  if (!wide_) {
    // What was not executed in time would be of no use later either: a little more is better than nothing for good.
    const Time now = std::chrono::steady_clock::now();
    prove::diff::UnrolledVersions versions = Unrollable();
    versions.requests = prove::diff::MatchedRequests(old_version_, new_version_, match_);
    wide_.emplace(std::move(versions), cells_, end_ + (end_ - now) / 2);
  }
  return *wide_;
}

void DirectedSearch::RunWideFromMoments(const std::vector<CellId>& sought, Time end, RandomRuns& result) {
  EndAt(end);
  using prove::diff::WideStarts;
  WideStarts starts{.visit = {}, .read = read_by_changed_};
  // What differs already, and the news: what was kept last is the farthest.
  Moments moments;
  const auto take = [&](bool is_again) {
    for (const Moments* const kept : {&differing_, &new_, &between_, &on_the_way_}) {
      std::copy_if(kept->rbegin(), kept->rend(), std::back_inserter(moments),
                   [&](const auto& moment) { return is_again || !moment->is_spread; });
    }
  };
  take(false);
  if (moments.empty()) {
    take(true);
    starts.changes = WideStarts::Changes::kSeveral;
    for (size_t i = moments.size(); i > 1; --i) std::swap(moments[i - 1], moments[(random_.Next() >> 20) % i]);
  }
  starts.count = moments.size();
  starts.visit = [&](size_t start, const std::function<void(const prove::diff::SeenState&)>& use) {
    GoTo(*moments[start]);
    moments[start]->is_spread = true;
    use(Seen());
  };
  Wide().SearchFrom(
      starts, sought, end, [&result](CellId cell) { return !result.difference_of.contains(cell); },
      [&](const prove::diff::Run& run, size_t start) {
        GoTo(*moments[start]);
        Repeat(run, Wide().period_ms(), result);
      });
}

void DirectedSearch::RunWide(const std::vector<CellId>& sought, Time end, RandomRuns& result) {
  EndAt(end);
  // Runs that begin alike are repeated from where they part, or a little before.
  constexpr size_t kPeriodsBetweenMoments = 8;
  std::vector<Moment> moments;  // one for so many periods each
  Wide().Search(
      sought, end, [&result](CellId cell) { return !result.difference_of.contains(cell); },
      [&](const prove::diff::Run& run, size_t shared) {
        const size_t kept = std::min(moments.size(), shared / kPeriodsBetweenMoments + 1);
        moments.erase(moments.begin() + static_cast<std::ptrdiff_t>(kept), moments.end());
        GoTo(moments.empty() ? *between_.front() : moments.back());
        size_t period = moments.empty() ? 0 : (moments.size() - 1) * kPeriodsBetweenMoments;
        for (; period < run.periods.size(); ++period) {
          if (period == moments.size() * kPeriodsBetweenMoments) moments.push_back(Here());
          if (!Step({.inputs = run.periods[period], .words = {}, .ms = Wide().period_ms()}, result)) return;
        }
      });
}

void DirectedSearch::Run(const std::vector<CellId>& sought, Time end, RandomRuns& result) {
  EndAt(end);
  KeepShown(result);
  const auto is_open = [&](CellId cell) { return !result.difference_of.contains(cell); };
  using Clock = std::chrono::steady_clock;
  while (!Late()) {
    const Clock::time_point begin = Clock::now();
    std::vector<CellId> open = sought;
    std::erase_if(open, [&](CellId cell) { return !is_open(cell); });
    if (open.empty()) return;
    const bool is_many = open.size() > kMostSought;
    const bool may_aim = is_many ? aimed_ <= kAimedOfMany * searched_ : aimed_ <= searched_;
    if (Moment* const moment = may_aim ? NextToAsk() : nullptr) {
      Aim(*moment, open, result);
      aimed_ += Clock::now() - begin;
    } else if (Moment* const begun = waited_ <= searched_ ? NextToWait() : nullptr) {
      Wait(*begun, result);
      waited_ += Clock::now() - begin;
    } else {
      GoBack();
      for (uint64_t left = 1 + random_.Next() % 10; left > 0; --left) {
        if (!Step(Unexpected(), result)) break;
      }
      searched_ += Clock::now() - begin;
    }
  }
}

}  // namespace plcxx::review::diff
