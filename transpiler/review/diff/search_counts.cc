// Counting as far as a program counts: what advanced a number once is done again and again.
#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <utility>

#include "transpiler/prove/diff/runs_from.h"
#include "transpiler/review/diff/items.h"
#include "transpiler/review/diff/search.h"

namespace plcxx::review::diff {
namespace {

using execute::CellId;
using prove::diff::SetCell;

constexpr size_t kMostCounters = 256, kMostPulsesOfOne = 6;
constexpr uint64_t kMostAdvance = 16;          // of a number that is counted, at once
constexpr uint64_t kMostCounted = 100'000;     // no limit of a machine is farther away
constexpr uint64_t kMostCarried = 2'000'000;   // counts until something that counts their carries is at its end
constexpr uint64_t kCountsWithoutLimit = 300;  // where a program names no limit
constexpr size_t kMostAlone = 8;
constexpr size_t kMostBeside = 4;                      // inputs
constexpr size_t kMostCountedFrom = 4;                 // moments at which something differs, each time
constexpr size_t kMostPassed = 12;                     // constants of one number
constexpr size_t kLongestPulse = 4, kLongestWay = 16;  // steps; to one advance from the one before
constexpr uint32_t kProofs = 3;                        // that a pulse advances the number each time
constexpr uint32_t kMostStops = 6;                     // pulses in a row that do not: it has come to its end
constexpr uint32_t kFirstCounts = 128;
constexpr uint32_t kAtOnce = 64;  // pulses, where a number is far from all constants

uint64_t MaskOf(uint32_t bytes) { return ~uint64_t{0} >> (64 - 8 * bytes); }

/// How far it went, in the digits that it has; 0: no step of a count.
uint64_t Advance(uint64_t before, uint64_t after, uint32_t bytes) {
  const uint64_t up = (after - before) & MaskOf(bytes), down = (before - after) & MaskOf(bytes);
  return std::min(up, down) <= kMostAdvance ? up : 0;
}

}  // namespace

uint64_t DirectedSearch::Counter::Value(const std::vector<uint8_t>& picture, uint32_t lowest) const {
  uint64_t value = 0;
  for (uint32_t i = 0; i < bytes; ++i) {
    const uint32_t byte = is_big ? lowest - i : lowest + i;
    if (byte < picture.size()) value |= uint64_t{picture[byte]} << (8 * i);
  }
  return value;
}

void DirectedSearch::FindCounters() {
  const ir::Program& program = *old_version_.program;
  std::set<CellId> read(read_by_changed_.begin(), read_by_changed_.end()), is_set;
  for (const Input& input : inputs_) {
    for (const SetCell& bit : input) is_set.insert(bit.old_cell);
  }
  std::set<std::pair<uint32_t, uint32_t>> taken;
  const auto add = [&](std::span<const CellId> cells, uint32_t bytes) {
    const CellId first = cells.front(), of_new = match_.new_of_old[first.index];
    if (!old_uses_.writes[first.index] || !old_uses_.reads[first.index] || !of_new.valid() || is_set.contains(first))
      return;
    const uint32_t at = old_machine_.ByteOf(first), new_at = new_machine_.ByteOf(of_new);
    if (at >= old_machine_.picture().size() || new_at >= new_machine_.picture().size()) return;
    if (!taken.insert({at, bytes}).second) return;
    const auto any = [&](const auto& known) {
      return std::ranges::any_of(cells, [&](CellId cell) { return known.contains(cell); });
    };
    const uint32_t rank = any(read) ? 0 : any(seen_behind_) ? 1 : 2;
    const bool is_big = cells.size() > 1 && old_machine_.ByteOf(cells.back()) < at;
    counters_.push_back({.at = at,
                         .new_at = new_at,
                         .bytes = bytes,
                         .is_big = is_big,
                         .rank = rank,
                         .cells = {cells.begin(), cells.end()}});
  };
  for (const ir::Place& place : program.places) {
    const bool is_number = !place.is_field() && !place.indexed && place.type != ir::Type::kBit &&
                           place.type != ir::Type::kF32 && place.type != ir::Type::kF64;
    if (!is_number || !execute::IsInside(program, place)) continue;
    add(execute::CellsOf(program, old_version_.cells, place), ir::Bytes(place.type));
  }
  for (uint32_t i = 0; i < program.states.size(); ++i) {
    uint32_t cell = old_version_.cells.states[i];
    for (const ir::FieldInfo& field : ir::Info(program.states[ir::StateId(i)].kind).fields) {
      const bool is_number =
          !field.hidden && field.count == 1 &&
          (field.type == ir::Type::kI8 || field.type == ir::Type::kI16 || field.type == ir::Type::kI32);
      if (const CellId first(cell); is_number) add(std::span(&first, 1), ir::Bytes(field.type));
      cell += field.count;
    }
  }
  std::ranges::stable_sort(counters_, {}, &Counter::rank);
  if (counters_.size() > kMostCounters) counters_.resize(kMostCounters);
  most_counted_ = kCountsWithoutLimit;
  for (const uint64_t constant : constants_) {
    if (constant <= kMostCounted) most_counted_ = std::max(most_counted_, constant + kMostStops);
  }
}

void DirectedSearch::LookAtCounters() {
  for (Counter& counter : counters_) counter.before = ValueIn(counter);
}

void DirectedSearch::NoteAdvances() {
  for (Counter& counter : counters_) {
    if (counter.pulses == kMostPulsesOfOne) continue;
    const uint64_t value = ValueIn(counter);
    if (value == counter.before || Advance(counter.before, value, counter.bytes) == 0) continue;
    // The first ones, and where it has come farther.
    const uint64_t magnitude = uint64_t{1} << std::min(63, static_cast<int>(std::bit_width(value)));
    if (counter.pulses >= 2 && (counter.magnitudes & magnitude) != 0) continue;
    counter.magnitudes |= magnitude;
    ++counter.pulses;
    pulses_.push_back({.counter = static_cast<size_t>(&counter - counters_.data()), .run = stimuli_});
  }
}

bool DirectedSearch::Apply(const Stimulus& stimulus) {
  if (Late()) return false;
  if (!old_machine_.Apply(stimulus, &SetCell::old_cell) || !new_machine_.Apply(stimulus, &SetCell::new_cell))
    return false;
  old_machine_.Look();
  new_machine_.Look();
  return true;
}

Stimulus DirectedSearch::Undone(const Stimulus& stimulus) const {
  Stimulus undone;
  for (const SetCell& input : stimulus.inputs) {
    undone.inputs.push_back(input);
    undone.inputs.back().value = old_machine_.ValueOf(input.old_cell);
  }
  for (const auto& [location, value] : stimulus.words) {
    if (const std::optional<uint64_t> was = old_machine_.ValueOfWord(location))
      undone.words.emplace_back(location, std::to_string(*was));
  }
  return undone;
}

std::vector<Stimuli> DirectedSearch::PulsesOf(const Pulse& pulse) {
  const Counter& counter = counters_[pulse.counter];
  const Stimuli& run = pulse.run;
  std::vector<Stimulus> undone;  // by step
  std::vector<size_t> advances;  // after so many steps
  GoTo(*between_.front());
  for (const Stimulus& stimulus : run) {
    undone.push_back(Undone(stimulus));
    const uint64_t before = ValueIn(counter);
    if (!Apply(stimulus)) return {};
    if (ValueIn(counter) != before) advances.push_back(undone.size());
  }
  std::vector<Stimuli> pulses{{{.inputs = {}, .words = {}, .slow = 1}}};
  const auto last = [&run](size_t count) { return Stimuli(run.end() - static_cast<std::ptrdiff_t>(count), run.end()); };
  // One of the inputs goes back, and comes again: what else was set then may be what it needs.
  for (size_t i = 0; i < undone.back().inputs.size() && i < kMostAlone; ++i) {
    const SetCell was = undone.back().inputs[i], is = run.back().inputs[i];
    if (was == is) continue;
    Stimulus again = run.back();
    again.inputs = {is};
    again.words.clear();
    pulses.push_back({{.inputs = {was}, .words = {}, .slow = 1}, std::move(again)});
  }
  // All that was set goes back, and is set again.
  Stimulus back{.inputs = {}, .words = {}, .slow = 1};
  for (size_t count = 1; count <= std::min(kLongestPulse, run.size()); ++count) {
    // What an earlier step found there counts.
    Stimulus of_step = undone[run.size() - count];
    const auto is_new = [&of_step](const SetCell& input) {
      return std::ranges::find(of_step.inputs, input.old_cell, &SetCell::old_cell) == of_step.inputs.end();
    };
    const auto is_new_word = [&of_step](const auto& word) {
      return std::ranges::find(of_step.words, word.first, &std::pair<std::string, std::string>::first) ==
             of_step.words.end();
    };
    std::ranges::copy_if(back.inputs, std::back_inserter(of_step.inputs), is_new);
    std::ranges::copy_if(back.words, std::back_inserter(of_step.words), is_new_word);
    back.inputs = std::move(of_step.inputs);
    back.words = std::move(of_step.words);
    Stimuli cycle = last(count);
    cycle.insert(cycle.begin(), back);
    pulses.push_back(std::move(cycle));
  }
  // From one advance to the next.
  if (advances.size() >= 2 && advances.back() - advances[advances.size() - 2] <= kLongestWay)
    pulses.push_back(last(advances.back() - advances[advances.size() - 2]));
  for (size_t count = 2; count <= std::min(kLongestPulse, run.size()); ++count) pulses.push_back(last(count));
  return pulses;
}

void DirectedSearch::AimAtCounters(RandomRuns& result) {
  constexpr uint32_t kMostAsked = 8;
  constexpr auto kMostForOne = std::chrono::milliseconds(300);
  // Shortly before a pass, so that the solver need not look far ahead.
  constexpr uint32_t kPeriodsBefore = 2;
  GoTo(*between_.front());
  if (!Step({.inputs = {}, .words = {}, .slow = 1}, result)) return;
  if (pass_periods_ > kPeriodsBefore &&
      !Step({.inputs = {}, .words = {}, .ms = (pass_periods_ - kPeriodsBefore) * period_ms_}, result))
    return;
  const Moment begin = Here();
  const std::vector<uint8_t> begin_picture = old_machine_.picture();
  uint32_t asked = 0;
  for (Counter& counter : counters_) {
    if (counter.rank > 1 || counter.pulses != 0 || std::exchange(counter.is_asked, true)) continue;
    if (++asked > kMostAsked || Late()) return;
    const auto aim = [&](const Moment& from, bool is_none, const std::vector<uint64_t>& values) {
      GoTo(from);
      const std::optional<prove::diff::Run> run =
          prove::diff::RunTo(Unrollable(), Seen(), {.cells = counter.cells, .values = values, .is_none = is_none},
                             {.most_periods = pass_periods_ + kPeriodsBefore,
                              .end = std::min(end_, std::chrono::steady_clock::now() + kMostForOne)});
      if (!run) return false;
      GoTo(from);
      Repeat(*run, period_ms_, result);
      return true;
    };
    const auto advance = [&](const Moment& from) {
      GoTo(from);
      const uint64_t value = ValueIn(counter);
      return aim(from, false, {value + 1, (value - 1) & MaskOf(counter.bytes)});
    };
    // One that counts down has to be set first.
    if (!advance(begin) && aim(begin, true, {counter.Value(begin_picture, counter.at)})) advance(Here());
  }
}

uint64_t DirectedSearch::AdvanceBy(const Stimuli& cycle, const Counter& counter, const Moment& begin) {
  GoTo(begin);
  uint64_t advance = 0;
  for (uint32_t proofs = 0; proofs < kProofs; ++proofs) {
    const uint64_t before = ValueIn(counter);
    if (!std::ranges::all_of(cycle, [this](const Stimulus& stimulus) { return Apply(stimulus); })) return 0;
    const uint64_t now = Advance(before, ValueIn(counter), counter.bytes);
    if (now == 0 || (proofs != 0 && now != advance)) return 0;
    advance = now;
  }
  return advance;
}

void DirectedSearch::FindCounting(const Pulse& pulse) {
  const Counter& counter = counters_[pulse.counter];
  const std::vector<Stimuli> cycles = PulsesOf(pulse);
  if (cycles.empty()) return;
  stimuli_ = pulse.run;
  const auto begin = std::make_shared<Moment>(Here());
  for (Stimuli cycle : cycles) {
    const uint64_t advance = AdvanceBy(cycle, counter, *begin);
    if (advance == 0) continue;
    // It is done very often: no longer than it needs.
    for (Stimulus& stimulus : cycle) {
      const uint32_t whole = stimulus.ms;
      for (const uint32_t ms : {100U, 500U, 1000U, 2000U, 5000U, whole}) {
        stimulus.ms = std::min(ms, whole);
        if (stimulus.ms == whole || AdvanceBy(cycle, counter, *begin) == advance) break;
      }
    }
    countings_.push_back({.counter = pulse.counter, .advance = advance, .at = begin, .cycle = cycle, .begin = begin});
    return;
  }
}

void DirectedSearch::FindCountingsFromDiffering() {
  // The last ones are the news, and the first one is the plainest.
  Moments moments;
  for (auto moment = differing_.rbegin(); moment != differing_.rend() && moments.size() < kMostCountedFrom; ++moment) {
    if (!(*moment)->is_counted) moments.push_back(*moment);
  }
  const size_t known = countings_.size();
  for (const std::shared_ptr<Moment>& moment : moments) {
    moment->is_counted = true;
    for (size_t i = 0; i < known && !Late(); ++i) {
      const Counting counting = countings_[i];
      if (counting.from_differs) continue;
      const uint64_t advance = AdvanceBy(counting.cycle, counters_[counting.counter], *moment);
      if (advance == 0) continue;
      countings_.push_back({.counter = counting.counter,
                            .advance = advance,
                            .at = moment,
                            .cycle = counting.cycle,
                            .differs = true,
                            .from_differs = true});
    }
  }
}

std::vector<DirectedSearch::Input> DirectedSearch::InputsBeside(const std::vector<CellId>& cells) const {
  std::vector<bool> is_wanted(old_version_.cells.count), is_read(old_version_.cells.count);
  for (const CellId cell : cells) is_wanted[cell.index] = true;
  const std::vector<StatementAccess> accesses = AccessesOf(old_version_);
  std::set<ir::StatementId> writers;
  for (const StatementAccess& access : accesses) {
    if (!access.writes || !access.statement.valid()) continue;
    if (std::any_of(is_wanted.begin() + access.begin, is_wanted.begin() + access.end,
                    [](bool wanted) { return wanted; }))
      writers.insert(access.statement);
  }
  for (const StatementAccess& access : accesses) {
    if (!access.writes && writers.contains(access.statement))
      std::fill(is_read.begin() + access.begin, is_read.begin() + access.end, true);
  }
  std::vector<Input> beside;
  for (const Input& input : inputs_) {
    if (input.size() == 1 && is_read[input.front().old_cell.index] && beside.size() < kMostBeside)
      beside.push_back(input);
  }
  return beside;
}

bool DirectedSearch::VaryCountings(const std::vector<Input>& hiding) {
  const size_t known = countings_.size();
  for (size_t i = 0; i < known && !Late(); ++i) {
    if (std::exchange(countings_[i].is_varied, true) || !countings_[i].begin ||
        counters_[countings_[i].counter].rank > 1)
      continue;
    for (const Input& input : hiding) {
      const Counting counting = countings_[i];
      GoTo(*counting.begin);
      Stimulus opposite{.inputs = input, .words = {}, .slow = 1};
      opposite.inputs.front().value = old_machine_.ValueOf(input.front().old_cell) ^ 1;
      if (!Apply(opposite)) return false;
      stimuli_.push_back(opposite);
      ++periods_;
      const auto begin = std::make_shared<Moment>(Here());
      if (AdvanceBy(counting.cycle, counters_[counting.counter], *begin) != counting.advance) continue;
      countings_.push_back({.counter = counting.counter,
                            .advance = counting.advance,
                            .at = begin,
                            .cycle = counting.cycle,
                            .is_varied = true,
                            .most = counting.most});
    }
    if (countings_.size() > known) return true;
  }
  return false;
}

void DirectedSearch::FindCountings(Time end) {
  EndAt(end);
  while (!Late() && !pulses_.empty()) {
    const auto next =
        std::ranges::min_element(pulses_, {}, [this](const Pulse& pulse) { return counters_[pulse.counter].rank; });
    const Pulse pulse = std::move(*next);
    pulses_.erase(next);
    // One way to count it is enough, and another one where that has come to its end.
    const auto is_counted = [&pulse](const Counting& counting) {
      return counting.counter == pulse.counter && !counting.is_over;
    };
    if (std::ranges::none_of(countings_, is_counted)) FindCounting(pulse);
  }
}

/// What is compared with a constant may be so for one pulse only.
bool DirectedSearch::IsFarFromConstants(uint64_t value, uint64_t advance, uint32_t bytes) const {
  const uint64_t way = kAtOnce * advance, other = (value + way) & MaskOf(bytes);
  const auto [low, high] = std::minmax(value, other);
  const auto at = std::ranges::lower_bound(constants_, low - std::min(low, 2 * kMostAdvance));
  return at == constants_.end() || *at > high + 2 * kMostAdvance;
}

/// Where the versions part there is more to be seen, though it was known.
void DirectedSearch::CompareCounted(Counting& counting, RandomRuns& result) {
  has_new_difference_ = false;
  Compare(result);
  if (has_new_difference_ || (differs_now_ && !counting.differs)) Keep(Kept::kDiffers);
  counting.differs = differs_now_;
}

void DirectedSearch::KeepAtConstant(Counter& counter, uint64_t before) {
  if (counter.rank > 1 || counter.passed.size() >= kMostPassed) return;
  const auto [low, high] = std::minmax(before, ValueIn(counter));
  for (auto at = std::ranges::upper_bound(constants_, low); at != constants_.end() && *at <= high; ++at) {
    if (*at > 1 && counter.passed.insert(*at).second) Keep(Kept::kNew);
  }
}

void DirectedSearch::NoteCarries(Counting& counting) {
  if (counting.carried.empty()) {
    for (size_t i = 0; i < counters_.size(); ++i) {
      if (i != counting.counter && counters_[i].rank <= 1)
        counting.carried.push_back({.counter = i, .value = ValueIn(counters_[i]), .at = counting.done});
    }
  }
  for (Carried& carried : counting.carried) {
    const Counter& counter = counters_[carried.counter];
    const uint64_t value = ValueIn(counter), before = std::exchange(carried.value, value);
    if (value == before || Advance(before, value, counter.bytes) == 0) continue;
    const uint64_t distance = counting.done - carried.at;
    carried.at = counting.done;
    // The first one may have been under way.
    if (++carried.times < 2 || distance <= 1) continue;
    counting.most = std::max(counting.most, std::min(kMostCarried, distance * most_counted_));
  }
}

bool DirectedSearch::CountAtOnce(Counting& counting, RandomRuns& result) {
  const Counter& counter = counters_[counting.counter];
  const uint64_t before = ValueIn(counter);
  if (!IsFarFromConstants(before, counting.advance, counter.bytes)) return false;
  const Moment here = Here();
  for (uint32_t i = 0; i < kAtOnce; ++i) {
    for (const Stimulus& stimulus : counting.cycle) {
      if (Late() || !old_machine_.Apply(stimulus, &SetCell::old_cell) ||
          !new_machine_.Apply(stimulus, &SetCell::new_cell)) {
        GoTo(here);
        return false;
      }
      periods_ += stimulus.slow + stimulus.fast + stimulus.ms / period_ms_;
    }
  }
  old_machine_.Look();
  new_machine_.Look();
  const uint64_t expected = (before + kAtOnce * counting.advance) & MaskOf(counter.bytes);
  if (ValueIn(counter) != expected || counter.Value(new_machine_.picture(), counter.new_at) != expected) {
    GoTo(here);
    return false;
  }
  stimuli_.back().times += kAtOnce;
  counting.done += kAtOnce;
  NoteCarries(counting);
  CompareCounted(counting, result);
  return true;
}

void DirectedSearch::CountOn(Counting& counting, RandomRuns& result) {
  Counter& counter = counters_[counting.counter];
  GoTo(*counting.at);
  if (counting.done == 0) stimuli_.push_back({.inputs = {}, .words = {}, .repeated = counting.cycle});
  const size_t begin = stimuli_.size();
  const auto most_of_all = [&] { return std::max(counting.most, most_counted_); };
  const uint64_t most = std::min(most_of_all(), std::max<uint64_t>(kFirstCounts, 4 * counting.done));
  const auto keep = [&] { counting.at = std::make_shared<Moment>(Here()); };
  uint32_t one_by_one = 0;
  while (counting.done < most && counting.stops < kMostStops) {
    if (one_by_one == 0 && CountAtOnce(counting, result)) continue;
    one_by_one = one_by_one == 0 ? kAtOnce : one_by_one - 1;
    if (counting.done != 0 && counting.done % kAtOnce == 0) keep();
    const uint64_t before = ValueIn(counter);
    for (const Stimulus& stimulus : counting.cycle) {
      stimuli_.push_back(stimulus);
      if (!Apply(stimulus)) {
        // Late: it goes on where it was kept. Stuck: it does not.
        counting.done = counting.at->stimuli.size() == begin ? counting.at->stimuli.back().times : 0;
        counting.is_over = !Late();
        return;
      }
      periods_ += stimulus.slow + stimulus.fast + stimulus.ms / period_ms_;
      CompareCounted(counting, result);
    }
    stimuli_.resize(begin);
    ++stimuli_.back().times;
    ++counting.done;
    NoteCarries(counting);
    KeepAtConstant(counter, before);
    counting.stops = Advance(before, ValueIn(counter), counter.bytes) == 0 ? counting.stops + 1 : 0;
  }
  counting.is_over = counting.done >= most_of_all() || counting.stops >= kMostStops;
  keep();
  Keep(Kept::kOnTheWay);
}

void DirectedSearch::RunCounts(const std::vector<CellId>& sought, Time end, RandomRuns& result) {
  const Time begin = std::chrono::steady_clock::now();
  EndAt(begin + (end - begin) / 2);
  AimAtCounters(result);
  FindCountings(begin + (end - begin) / 3 * 2);
  EndAt(end);
  FindCountingsFromDiffering();
  while (!Late()) {
    if (std::ranges::all_of(sought, [&](CellId cell) { return result.difference_of.contains(cell); })) return;
    Counting* next = nullptr;
    const auto order = [this](const Counting& counting) {
      // What has nothing to do with the change, as far as can be seen, comes late.
      constexpr std::array<uint64_t, 3> kWeights = {1, 4, 64};
      const uint32_t rank = counting.from_differs ? 0 : counters_[counting.counter].rank;
      return std::pair((counting.done + 1) * kWeights[rank], rank);
    };
    for (Counting& counting : countings_) {
      if (!counting.is_over && (next == nullptr || order(counting) < order(*next))) next = &counting;
    }
    if (next == nullptr) {
      std::vector<CellId> open = sought;
      std::erase_if(open, [&](CellId cell) { return result.difference_of.contains(cell); });
      if (!VaryCountings(InputsBeside(open))) return;
      continue;
    }
    CountOn(*next, result);
  }
}

}  // namespace plcxx::review::diff
