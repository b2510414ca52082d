#include "transpiler/review/diff/search.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "transpiler/prove/diff/runs_from.h"
#include "transpiler/prove/machine/transition.h"

namespace plcxx::review::diff {
namespace {

using execute::CellId;
using prove::diff::SetCell;

constexpr size_t kManyInputs = 100;  // of a program with so many a few others change nothing that is far away
constexpr uint32_t kQuestionOfManyMs = 40;
constexpr int kAimedOfMany = 4;       // times the time that is spent otherwise
constexpr uint32_t kAimedPasses = 4;  // whole slow passes that the solver looks ahead
constexpr std::array<uint32_t, 3> kWaitsMs = {1500, 4000, 25'000};

}  // namespace

void DirectedSearch::GoBack() {
  const uint64_t which = machines_.random.Next() % 8;
  const bool is_on_the_way = which >= 5 && which < 7 && !MomentsOf(Kept::kOnTheWay).empty();
  const Moments& kept = is_on_the_way                                     ? MomentsOf(Kept::kOnTheWay)
                        : which < 3 && !MomentsOf(Kept::kDiffers).empty() ? MomentsOf(Kept::kDiffers)
                        : which < 6 && !MomentsOf(Kept::kNew).empty()     ? MomentsOf(Kept::kNew)
                                                                          : MomentsOf(Kept::kBetweenSteps);
  waits_next_ = is_on_the_way && machines_.random.OneIn(3);
  // The last ones are the news.
  const size_t count = machines_.random.OneIn(2) ? kept.size() : std::min<size_t>(kept.size(), 8);
  machines_.GoTo(*kept[kept.size() - 1 - machines_.random.Next() % count]);
}

void DirectedSearch::Disturb(const Input& input, std::vector<SetCell>& sets) {
  uint64_t value = 0;
  for (size_t i = 0; i < input.size() && i < 64; ++i) value |= machines_.old_machine().Seen(input[i].old_cell) << i;
  if (input.size() == 1) {
    value ^= machines_.random.OneIn(8) ? 0 : 1;
  } else {
    switch (machines_.random.Next() % 6) {
      case 0:
        value = 0;
        break;
      case 1:
        value = machines_.random.Next() % 5;
        break;
      case 2:
      case 3:
        if (!constants_.empty())
          value = constants_[machines_.random.Next() % constants_.size()] + machines_.random.Next() % 3 - 1;
        break;
      case 4:
        value ^= uint64_t{1} << machines_.random.Next() % std::min<size_t>(64, input.size());
        break;
      default:
        value = machines_.random.Next();
    }
  }
  for (size_t i = 0; i < input.size(); ++i) {
    sets.push_back(input[i]);
    sets.back().value = i < 64 ? value >> i & 1 : 0;
  }
}

void DirectedSearch::DisturbMany(Stimulus& stimulus) {
  const uint64_t one_in = uint64_t{2} << machines_.random.Next() % 6,
                 ones = 1 + machines_.random.Next() % 7;  // of eight
  for (const Input& input : inputs_) {
    if (!machines_.random.OneIn(one_in)) continue;
    for (const SetCell& bit : input) {
      stimulus.inputs.push_back(bit);
      stimulus.inputs.back().value = machines_.random.Next() % 8 < ones ? 1 : 0;
    }
  }
}

Stimulus DirectedSearch::Unexpected() {
  Stimulus stimulus;
  if (std::exchange(waits_next_, false)) {
    stimulus.ms = waits_ms_[machines_.random.Next() % waits_ms_.size()];
    return stimulus;
  }
  auto& [scenario, next_step] = machines_.known();
  const bool follows = scenario < known_.size() && next_step < known_[scenario].size();
  if (follows && machines_.random.OneIn(3)) {
    stimulus = known_[scenario][next_step++];
    if (!machines_.random.OneIn(4)) return stimulus;
  } else if (!known_.empty() && machines_.random.OneIn(6)) {
    const Stimuli& other = known_[machines_.random.Next() % known_.size()];
    const Stimulus& step = other[machines_.random.Next() % other.size()];
    stimulus.words = step.words;
    stimulus.inputs = step.inputs;
  }
  // The control has done what it was asked for.
  for (const SetCell& request : requests_) {
    if (machines_.random.OneIn(4)) stimulus.inputs.push_back(request);
  }
  if (inputs_.size() > kManyInputs && machines_.random.OneIn(2)) DisturbMany(stimulus);
  for (uint64_t i = machines_.random.Next() % 4; i > 0; --i) {
    const uint64_t which = machines_.random.Next() % 8;
    const std::vector<Input>& from = which < 4 && !near_.empty()     ? near_
                                     : which < 7 && !behind_.empty() ? behind_
                                                                     : inputs_;
    if (!from.empty()) Disturb(from[machines_.random.Next() % from.size()], stimulus.inputs);
  }
  if (stimulus.slow != 0 || stimulus.fast != 0 || stimulus.ms != 0) return stimulus;
  const bool has_fast = prove::machine::HasFastPart(old_version_) || prove::machine::HasFastPart(new_version_);
  stimulus.power_cycle = machines_.random.OneIn(40);
  const uint64_t what = machines_.random.Next() % 16;
  if (what == 0) {
    stimulus.ms = waits_ms_[machines_.random.Next() % waits_ms_.size()];
  } else if (what < 3 && has_fast) {
    stimulus.fast = 1;
  } else if (what < 6) {
    stimulus.ms = std::max(1U, old_side_.compilation.program.schedule.period_ms);
  } else {
    stimulus.slow = 1 + static_cast<uint32_t>(machines_.random.OneIn(4) ? machines_.random.Next() % 12 : 0);
  }
  return stimulus;
}

void DirectedSearch::BeginWithKept(Time end, RandomRuns& result) {
  constexpr int kStarts = 12;
  machines_.EndAt(end);
  for (int start = 0; start < kStarts && !kept_.empty() && !machines_.Late(); ++start) {
    machines_.GoToPowerOn();
    Stimulus power_on{.inputs = {}, .words = {}, .slow = 1, .power_cycle = true};
    for (uint64_t words = 1 + (machines_.random.Next() >> 20) % 3; words > 0; --words)
      Disturb(kept_[(machines_.random.Next() >> 20) % kept_.size()], power_on.kept);
    if (machines_.Step(power_on, result)) machines_.Keep(Kept::kBetweenSteps);
  }
}

void DirectedSearch::RunScenarios(Time end, RandomRuns& result) {
  machines_.EndAt(end);
  for (size_t scenario = 0; scenario < known_.size() && !machines_.Late(); ++scenario) {
    machines_.GoToPowerOn();
    machines_.known().scenario = scenario;
    for (const Stimulus& stimulus : known_[scenario]) {
      ++machines_.known().next_step;
      if (!machines_.Step(stimulus, result)) break;
      machines_.Keep(Kept::kBetweenSteps);
    }
  }
}

void DirectedSearch::Follow(const std::vector<prove::diff::Run>& computed, Time end, RandomRuns& result) {
  machines_.EndAt(end);
  constexpr size_t kMostFollowed = 30;
  for (; followed_ < std::min(computed.size(), kMostFollowed) && !machines_.Late(); ++followed_) {
    // As whole passes, and as time: where the slow part is in slices they are not the same.
    for (const bool by_time : {false, true}) {
      machines_.GoToPowerOn();
      for (const Stimulus& power_on : PowerOnWith(computed[followed_].kept)) machines_.Step(power_on, result);
      for (const std::vector<SetCell>& inputs : computed[followed_].periods) {
        Stimulus stimulus{.inputs = inputs, .words = {}};
        (by_time ? stimulus.ms : stimulus.slow) = by_time ? old_side_.compilation.program.schedule.period_ms : 1;
        if (!machines_.Step(stimulus, result)) break;
      }
    }
  }
}

DirectedSearch::Moment* DirectedSearch::NextToAsk() {
  // What differs leads to what is computed from it: the last moments are the farthest.
  if (machines_.random.OneIn(2)) {
    const auto last = std::find_if(MomentsOf(Kept::kDiffers).rbegin(), MomentsOf(Kept::kDiffers).rend(),
                                   [](const auto& m) { return !m->is_asked; });
    if (last != MomentsOf(Kept::kDiffers).rend()) return last->get();
  }
  for (const Moments* const kept : {&MomentsOf(Kept::kNew), &MomentsOf(Kept::kBetweenSteps), &MomentsOf(Kept::kDiffers),
                                    &MomentsOf(Kept::kOnTheWay)}) {
    const auto found = std::ranges::find_if(*kept, [](const auto& m) { return !m->is_asked; });
    if (found != kept->end()) return found->get();
  }
  return nullptr;
}

DirectedSearch::Moment* DirectedSearch::NextToWait() {
  for (const Moments* const kept : {&MomentsOf(Kept::kDiffers), &MomentsOf(Kept::kOnTheWay), &MomentsOf(Kept::kNew),
                                    &MomentsOf(Kept::kBetweenSteps)}) {
    const auto last = std::find_if(kept->rbegin(), kept->rend(), [](const auto& m) { return !m->is_waited; });
    if (last != kept->rend()) return last->get();
  }
  return nullptr;
}

void DirectedSearch::Wait(Moment& moment, RandomRuns& result) {
  moment.is_waited = true;
  machines_.GoTo(moment);
  for (const uint32_t ms : kWaitsMs) {
    if (!machines_.Step({.inputs = {}, .words = {}, .ms = ms}, result)) return;
  }
}

void DirectedSearch::Aim(Moment& moment, const std::vector<CellId>& sought, RandomRuns& result) {
  using Clock = std::chrono::steady_clock;
  constexpr Clock::duration kMostForOne = std::chrono::milliseconds(400);
  // A busy machine may need longer.
  const Clock::time_point begin = Clock::now();
  const Clock::time_point limit =
      std::min(machines_.end(), begin + std::max(kMostForOne, (machines_.end() - begin) / 3));
  moment.is_asked = true;
  machines_.GoTo(moment);
  // The moment may have gone when others are kept.
  const Moment from = machines_.Here();
  const auto repeat = [&](const prove::diff::Run& run) {
    machines_.GoTo(from);
    machines_.Repeat(run, machines_.period_ms(), result);
  };
  prove::diff::AimLimits limits{.most_periods = kAimedPasses * machines_.pass_periods(), .end = limit};
  // Each answer is one more location then, and most of them are small questions.
  if (sought.size() > kMostSought) {
    limits.most_questions = sought.size();
    limits.question_ms = kQuestionOfManyMs;
  }
  prove::diff::RunsFrom(
      machines_.Unrollable(), machines_.Seen(), sought, limits,
      [&result](CellId cell) { return !result.difference_of.contains(cell); }, repeat);
  if (!machines_.Late()) return;
  // To be asked again when there is more time.
  machines_.GoTo(from);
  machines_.Keep(Kept::kNew);
}

prove::diff::WideRuns& DirectedSearch::Wide() {
  if (!wide_) {
    // What was not executed in time would be of no use later either: a little more is better than nothing for good.
    const Time now = std::chrono::steady_clock::now();
    prove::diff::UnrolledVersions versions = machines_.Unrollable();
    versions.requests = prove::diff::MatchedRequests(old_version_, new_version_, match_);
    wide_.emplace(std::move(versions), cells_, machines_.end() + (machines_.end() - now) / 2);
  }
  return *wide_;
}

void DirectedSearch::RunWideFromMoments(const std::vector<CellId>& sought, Time end, RandomRuns& result) {
  machines_.EndAt(end);
  using prove::diff::WideStarts;
  WideStarts starts{.visit = {}, .read = machines_.news.read()};
  // What differs already, and the news: what was kept last is the farthest.
  Moments moments;
  const auto take = [&](bool is_again) {
    for (const Moments* const kept : {&MomentsOf(Kept::kDiffers), &MomentsOf(Kept::kNew),
                                      &MomentsOf(Kept::kBetweenSteps), &MomentsOf(Kept::kOnTheWay)}) {
      std::copy_if(kept->rbegin(), kept->rend(), std::back_inserter(moments),
                   [&](const auto& moment) { return is_again || !moment->is_spread; });
    }
  };
  take(false);
  if (moments.empty()) {
    take(true);
    starts.changes = WideStarts::Changes::kSeveral;
    for (size_t i = moments.size(); i > 1; --i) std::swap(moments[i - 1], moments[(machines_.random.Next() >> 20) % i]);
  }
  starts.count = moments.size();
  starts.visit = [&](size_t start, const std::function<void(const prove::diff::SeenState&)>& use) {
    machines_.GoTo(*moments[start]);
    moments[start]->is_spread = true;
    use(machines_.Seen());
  };
  Wide().SearchFrom(
      starts, sought, end, [&result](CellId cell) { return !result.difference_of.contains(cell); },
      [&](const prove::diff::Run& run, size_t start) {
        machines_.GoTo(*moments[start]);
        machines_.Repeat(run, Wide().period_ms(), result);
      });
}

void DirectedSearch::RunWide(const std::vector<CellId>& sought, Time end, RandomRuns& result) {
  machines_.EndAt(end);
  // Runs that begin alike are repeated from where they part, or a little before.
  constexpr size_t kPeriodsBetweenMoments = 8;
  std::vector<Moment> moments;  // one for so many periods each
  Wide().Search(
      sought, end, [&result](CellId cell) { return !result.difference_of.contains(cell); },
      [&](const prove::diff::Run& run, size_t shared) {
        const size_t kept = std::min(moments.size(), shared / kPeriodsBetweenMoments + 1);
        moments.erase(moments.begin() + static_cast<std::ptrdiff_t>(kept), moments.end());
        machines_.GoTo(moments.empty() ? *MomentsOf(Kept::kBetweenSteps).front() : moments.back());
        size_t period = moments.empty() ? 0 : (moments.size() - 1) * kPeriodsBetweenMoments;
        for (; period < run.periods.size(); ++period) {
          if (period == moments.size() * kPeriodsBetweenMoments) moments.push_back(machines_.Here());
          if (!machines_.Step({.inputs = run.periods[period], .words = {}, .ms = Wide().period_ms()}, result)) return;
        }
      });
}

void DirectedSearch::Run(const std::vector<CellId>& sought, Time end, RandomRuns& result) {
  machines_.EndAt(end);
  machines_.KeepShown(result);
  const auto is_open = [&](CellId cell) { return !result.difference_of.contains(cell); };
  using Clock = std::chrono::steady_clock;
  while (!machines_.Late()) {
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
      for (uint64_t left = 1 + machines_.random.Next() % 10; left > 0; --left) {
        if (!machines_.Step(Unexpected(), result)) break;
      }
      searched_ += Clock::now() - begin;
    }
  }
}

}  // namespace plcxx::review::diff
