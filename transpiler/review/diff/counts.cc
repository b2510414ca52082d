#include "transpiler/review/diff/counts.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <utility>

#include "transpiler/prove/diff/runs_from.h"
#include "transpiler/review/diff/items.h"

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

uint64_t Counts::Counter::Value(const std::vector<uint8_t>& picture, uint32_t lowest) const {
  uint64_t value = 0;
  for (uint32_t i = 0; i < bytes; ++i) {
    const uint32_t byte = is_big ? lowest - i : lowest + i;
    if (byte < picture.size()) value |= uint64_t{picture[byte]} << (8 * i);
  }
  return value;
}

Counts::Counts(PairedMachines& machines, const std::vector<Input>& inputs, const std::vector<uint64_t>& constants)
    : machines_(machines), inputs_(inputs), constants_(constants), is_input_(machines.old_version().cells.count) {
  for (const Input& input : inputs_) {
    for (const SetCell& bit : input) is_input_[bit.old_cell.index] = true;
  }
  FindCounters();
  machines_.before_step = [this] { LookAtCounters(); };
  machines_.after_step = [this] { NoteAdvances(); };
}

void Counts::AddCounter(std::span<const CellId> cells, uint32_t bytes) {
  const CellId first = cells.front(), of_new = machines_.match().new_of_old[first.index];
  const prove::machine::Uses& uses = machines_.old_uses();
  if (!uses.writes[first.index] || !uses.reads[first.index] || !of_new.valid() || is_input_[first.index]) return;
  const DiffMachine &old_machine = machines_.old_machine(), &new_machine = machines_.new_machine();
  const uint32_t at = old_machine.ByteOf(first), new_at = new_machine.ByteOf(of_new);
  if (at >= old_machine.picture().size() || new_at >= new_machine.picture().size()) return;
  if (!taken_.insert({at, bytes}).second) return;
  const News& news = machines_.news;
  const auto is_read = [&news](CellId cell) { return news.IsRead(cell); };
  const auto is_before = [&news](CellId cell) { return news.IsBefore(cell); };
  const uint32_t rank = std::ranges::any_of(cells, is_read) ? 0 : std::ranges::any_of(cells, is_before) ? 1 : 2;
  counters_.push_back({.at = at,
                       .new_at = new_at,
                       .bytes = bytes,
                       .is_big = cells.size() > 1 && old_machine.ByteOf(cells.back()) < at,
                       .rank = rank,
                       .cells = {cells.begin(), cells.end()}});
}

void Counts::FindNumbersOfPlaces() {
  const prove::machine::Version& version = machines_.old_version();
  for (const ir::Place& place : version.program->places) {
    const bool is_number = !place.is_field() && !place.indexed && place.type != ir::Type::kBit &&
                           place.type != ir::Type::kF32 && place.type != ir::Type::kF64;
    if (!is_number || !execute::IsInside(*version.program, place)) continue;
    AddCounter(execute::CellsOf(*version.program, version.cells, place), ir::Bytes(place.type));
  }
}

void Counts::FindNumbersOfStates() {
  const prove::machine::Version& version = machines_.old_version();
  const ir::Program& program = *version.program;
  for (uint32_t i = 0; i < program.states.size(); ++i) {
    uint32_t cell = version.cells.states[i];
    for (const ir::FieldInfo& field : ir::Info(program.states[ir::StateId(i)].kind).fields) {
      const bool is_number =
          !field.hidden && field.count == 1 &&
          (field.type == ir::Type::kI8 || field.type == ir::Type::kI16 || field.type == ir::Type::kI32);
      if (const CellId first(cell); is_number) AddCounter(std::span(&first, 1), ir::Bytes(field.type));
      cell += field.count;
    }
  }
}

void Counts::FindCounters() {
  FindNumbersOfPlaces();
  FindNumbersOfStates();
  std::ranges::stable_sort(counters_, {}, &Counter::rank);
  if (counters_.size() > kMostCounters) counters_.resize(kMostCounters);
  most_counted_ = kCountsWithoutLimit;
  for (const uint64_t constant : constants_) {
    if (constant <= kMostCounted) most_counted_ = std::max(most_counted_, constant + kMostStops);
  }
}

void Counts::LookAtCounters() {
  for (Counter& counter : counters_) counter.before = ValueIn(counter);
}

void Counts::NoteAdvances() {
  for (Counter& counter : counters_) {
    if (counter.pulses == kMostPulsesOfOne) continue;
    const uint64_t value = ValueIn(counter);
    if (value == counter.before || Advance(counter.before, value, counter.bytes) == 0) continue;
    // The first ones, and where it has come farther.
    const uint64_t magnitude = uint64_t{1} << std::min(63, static_cast<int>(std::bit_width(value)));
    if (counter.pulses >= 2 && (counter.magnitudes & magnitude) != 0) continue;
    counter.magnitudes |= magnitude;
    ++counter.pulses;
    pulses_.push_back({.counter = static_cast<size_t>(&counter - counters_.data()), .run = machines_.stimuli()});
  }
}

Stimulus Counts::Undone(const Stimulus& stimulus) const {
  Stimulus undone;
  for (const SetCell& input : stimulus.inputs) {
    undone.inputs.push_back(input);
    undone.inputs.back().value = machines_.old_machine().ValueOf(input.old_cell);
  }
  for (const auto& [location, value] : stimulus.words) {
    if (const std::optional<uint64_t> was = machines_.old_machine().ValueOfWord(location))
      undone.words.emplace_back(location, std::to_string(*was));
  }
  return undone;
}

std::vector<Stimuli> Counts::PulsesOf(const Pulse& pulse) {
  const Counter& counter = counters_[pulse.counter];
  const Stimuli& run = pulse.run;
  std::vector<Stimulus> undone;  // by step
  std::vector<size_t> advances;  // after so many steps
  machines_.GoToPowerOn();
  for (const Stimulus& stimulus : run) {
    undone.push_back(Undone(stimulus));
    const uint64_t before = ValueIn(counter);
    if (!machines_.Apply(stimulus)) return {};
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

void Counts::AimAtCounters(RandomRuns& result) {
  constexpr uint32_t kMostAsked = 8;
  constexpr auto kMostForOne = std::chrono::milliseconds(300);
  // Shortly before a pass, so that the solver need not look far ahead.
  constexpr uint32_t kPeriodsBefore = 2;
  machines_.GoToPowerOn();
  if (!machines_.Step({.inputs = {}, .words = {}, .slow = 1}, result)) return;
  if (machines_.pass_periods() > kPeriodsBefore &&
      !machines_.Step(
          {.inputs = {}, .words = {}, .ms = (machines_.pass_periods() - kPeriodsBefore) * machines_.period_ms()},
          result))
    return;
  const Moment begin = machines_.Here();
  const std::vector<uint8_t> begin_picture = machines_.old_machine().picture();
  uint32_t asked = 0;
  for (Counter& counter : counters_) {
    if (counter.rank > 1 || counter.pulses != 0 || std::exchange(counter.is_asked, true)) continue;
    if (++asked > kMostAsked || machines_.Late()) return;
    const auto aim = [&](const Moment& from, bool is_none, const std::vector<uint64_t>& values) {
      machines_.GoTo(from);
      const std::optional<prove::diff::Run> run = prove::diff::RunTo(
          machines_.Unrollable(), machines_.Seen(), {.cells = counter.cells, .values = values, .is_none = is_none},
          {.most_periods = machines_.pass_periods() + kPeriodsBefore,
           .end = std::min(machines_.end(), std::chrono::steady_clock::now() + kMostForOne)});
      if (!run) return false;
      machines_.GoTo(from);
      machines_.Repeat(*run, machines_.period_ms(), result);
      return true;
    };
    const auto advance = [&](const Moment& from) {
      machines_.GoTo(from);
      const uint64_t value = ValueIn(counter);
      return aim(from, false, {value + 1, (value - 1) & MaskOf(counter.bytes)});
    };
    // One that counts down has to be set first.
    if (!advance(begin) && aim(begin, true, {counter.Value(begin_picture, counter.at)})) advance(machines_.Here());
  }
}

uint64_t Counts::AdvanceBy(const Stimuli& cycle, const Counter& counter, const Moment& begin) {
  machines_.GoTo(begin);
  uint64_t advance = 0;
  for (uint32_t proofs = 0; proofs < kProofs; ++proofs) {
    const uint64_t before = ValueIn(counter);
    if (!std::ranges::all_of(cycle, [this](const Stimulus& stimulus) { return machines_.Apply(stimulus); })) return 0;
    const uint64_t now = Advance(before, ValueIn(counter), counter.bytes);
    if (now == 0 || (proofs != 0 && now != advance)) return 0;
    advance = now;
  }
  return advance;
}

void Counts::FindCounting(const Pulse& pulse) {
  const Counter& counter = counters_[pulse.counter];
  const std::vector<Stimuli> cycles = PulsesOf(pulse);
  if (cycles.empty()) return;
  machines_.stimuli() = pulse.run;
  const auto begin = std::make_shared<Moment>(machines_.Here());
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

void Counts::FindCountingsFromDiffering() {
  // The last ones are the news, and the first one is the plainest.
  PairedMachines::Moments moments;
  const PairedMachines::Moments& differing = machines_.kept_moments(PairedMachines::Kept::kDiffers);
  for (auto moment = differing.rbegin(); moment != differing.rend() && moments.size() < kMostCountedFrom; ++moment) {
    if (!(*moment)->is_counted) moments.push_back(*moment);
  }
  const size_t known = countings_.size();
  for (const std::shared_ptr<Moment>& moment : moments) {
    moment->is_counted = true;
    for (size_t i = 0; i < known && !machines_.Late(); ++i) {
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

std::vector<Input> Counts::InputsBeside(const std::vector<CellId>& cells) const {
  std::vector<bool> is_wanted(machines_.old_version().cells.count), is_read(machines_.old_version().cells.count);
  for (const CellId cell : cells) is_wanted[cell.index] = true;
  const std::vector<StatementAccess> accesses = AccessesOf(machines_.old_version());
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

bool Counts::VaryCountings(const std::vector<Input>& hiding) {
  const size_t known = countings_.size();
  for (size_t i = 0; i < known && !machines_.Late(); ++i) {
    if (std::exchange(countings_[i].is_varied, true) || !countings_[i].begin ||
        counters_[countings_[i].counter].rank > 1)
      continue;
    for (const Input& input : hiding) {
      const Counting counting = countings_[i];
      machines_.GoTo(*counting.begin);
      Stimulus opposite{.inputs = input, .words = {}, .slow = 1};
      opposite.inputs.front().value = machines_.old_machine().ValueOf(input.front().old_cell) ^ 1;
      if (!machines_.Apply(opposite)) return false;
      machines_.stimuli().push_back(opposite);
      machines_.AddPeriodsOf(opposite);
      const auto begin = std::make_shared<Moment>(machines_.Here());
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

void Counts::FindCountings(Time end) {
  machines_.EndAt(end);
  while (!machines_.Late() && !pulses_.empty()) {
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
bool Counts::IsFarFromConstants(uint64_t value, uint64_t advance, uint32_t bytes) const {
  const uint64_t way = kAtOnce * advance, other = (value + way) & MaskOf(bytes);
  const auto [low, high] = std::minmax(value, other);
  const auto at = std::ranges::lower_bound(constants_, low - std::min(low, 2 * kMostAdvance));
  return at == constants_.end() || *at > high + 2 * kMostAdvance;
}

/// Where the versions part there is more to be seen, though it was known.
void Counts::CompareCounted(Counting& counting, RandomRuns& result) {
  const PairedMachines::Differences differences = machines_.Compare(result);
  if (differences.is_new || (differences.any && !counting.differs)) machines_.Keep(PairedMachines::Kept::kDiffers);
  counting.differs = differences.any;
}

void Counts::KeepAtConstant(Counter& counter, uint64_t before) {
  if (counter.rank > 1 || counter.passed.size() >= kMostPassed) return;
  const auto [low, high] = std::minmax(before, ValueIn(counter));
  for (auto at = std::ranges::upper_bound(constants_, low); at != constants_.end() && *at <= high; ++at) {
    if (*at > 1 && counter.passed.insert(*at).second) machines_.Keep(PairedMachines::Kept::kNew);
  }
}

void Counts::NoteCarries(Counting& counting) {
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

bool Counts::CountAtOnce(Counting& counting, RandomRuns& result) {
  const Counter& counter = counters_[counting.counter];
  const uint64_t before = ValueIn(counter);
  if (!IsFarFromConstants(before, counting.advance, counter.bytes)) return false;
  const Moment here = machines_.Here();
  for (uint32_t i = 0; i < kAtOnce; ++i) {
    for (const Stimulus& stimulus : counting.cycle) {
      if (!machines_.ApplyUnseen(stimulus)) {
        machines_.GoTo(here);
        return false;
      }
      machines_.AddPeriodsOf(stimulus);
    }
  }
  machines_.Look();
  const uint64_t expected = (before + kAtOnce * counting.advance) & MaskOf(counter.bytes);
  if (ValueIn(counter) != expected || counter.Value(machines_.new_machine().picture(), counter.new_at) != expected) {
    machines_.GoTo(here);
    return false;
  }
  machines_.stimuli().back().times += kAtOnce;
  counting.done += kAtOnce;
  NoteCarries(counting);
  CompareCounted(counting, result);
  return true;
}

void Counts::CountOn(Counting& counting, RandomRuns& result) {
  Counter& counter = counters_[counting.counter];
  machines_.GoTo(*counting.at);
  if (counting.done == 0) machines_.stimuli().push_back({.inputs = {}, .words = {}, .repeated = counting.cycle});
  const size_t begin = machines_.stimuli().size();
  const auto most_of_all = [&] { return std::max(counting.most, most_counted_); };
  const uint64_t most = std::min(most_of_all(), std::max<uint64_t>(kFirstCounts, 4 * counting.done));
  const auto keep = [&] { counting.at = std::make_shared<Moment>(machines_.Here()); };
  uint32_t one_by_one = 0;
  while (counting.done < most && counting.stops < kMostStops) {
    if (one_by_one == 0 && CountAtOnce(counting, result)) continue;
    one_by_one = one_by_one == 0 ? kAtOnce : one_by_one - 1;
    if (counting.done != 0 && counting.done % kAtOnce == 0) keep();
    const uint64_t before = ValueIn(counter);
    for (const Stimulus& stimulus : counting.cycle) {
      machines_.stimuli().push_back(stimulus);
      if (!machines_.Apply(stimulus)) {
        // Late: it goes on where it was kept. Stuck: it does not.
        counting.done = counting.at->stimuli.size() == begin ? counting.at->stimuli.back().times : 0;
        counting.is_over = !machines_.Late();
        return;
      }
      machines_.AddPeriodsOf(stimulus);
      CompareCounted(counting, result);
    }
    machines_.stimuli().resize(begin);
    ++machines_.stimuli().back().times;
    ++counting.done;
    NoteCarries(counting);
    KeepAtConstant(counter, before);
    counting.stops = Advance(before, ValueIn(counter), counter.bytes) == 0 ? counting.stops + 1 : 0;
  }
  counting.is_over = counting.done >= most_of_all() || counting.stops >= kMostStops;
  keep();
  machines_.Keep(PairedMachines::Kept::kOnTheWay);
}

/// The one that is the least far, by its weight: what has nothing to do with the change, as far as can be seen, comes
/// late. Null: all have come to their end.
Counts::Counting* Counts::NextCounting() {
  const auto order = [this](const Counting& counting) {
    constexpr std::array<uint64_t, 3> kWeights = {1, 4, 64};
    const uint32_t rank = counting.from_differs ? 0 : counters_[counting.counter].rank;
    return std::pair((counting.done + 1) * kWeights[rank], rank);
  };
  Counting* next = nullptr;
  for (Counting& counting : countings_) {
    if (!counting.is_over && (next == nullptr || order(counting) < order(*next))) next = &counting;
  }
  return next;
}

void Counts::Run(const std::vector<CellId>& sought, Time end, RandomRuns& result) {
  const Time begin = std::chrono::steady_clock::now();
  machines_.EndAt(begin + (end - begin) / 2);
  AimAtCounters(result);
  FindCountings(begin + (end - begin) / 3 * 2);
  machines_.EndAt(end);
  FindCountingsFromDiffering();
  while (!machines_.Late()) {
    std::vector<CellId> open = sought;
    std::erase_if(open, [&](CellId cell) { return result.difference_of.contains(cell); });
    if (open.empty()) return;
    if (Counting* const next = NextCounting()) {
      CountOn(*next, result);
    } else if (!VaryCountings(InputsBeside(open))) {
      return;
    }
  }
}

}  // namespace plcxx::review::diff
