#include "transpiler/review/diff/paired_machines.h"

#include <algorithm>
#include <bit>

#include "transpiler/prove/machine/transition.h"
#include "transpiler/support/mixed.h"

namespace plcxx::review::diff {
namespace {

using execute::CellId;
using execute::CellKind;
using prove::diff::SetCell;

constexpr size_t kMostSignatures = 4000;
constexpr size_t kMomentBytes = size_t{192} << 20, kMostMoments = 300, kLeastMoments = 6;
constexpr uint32_t kMostPassPeriods = 100;       // of a whole slow pass
constexpr size_t kMostKeptInputs = 8'000'000;    // of all runs; what is seen after that differs, and is not shown
constexpr uint64_t kMostShownPeriods = 100'000;  // of a run to a moment that is kept
constexpr uint32_t kWatchedPeriods = 60;         // of a wait, one by one; the rest in larger pieces

}  // namespace

News::News(std::vector<CellId> read, const std::vector<CellId>& before) : read_(std::move(read)) {
  for (const CellId cell : before) before_.emplace(cell, 0);
}

uint64_t News::Signature(const DiffMachine& old_machine, const DiffMachine& new_machine,
                         const prove::diff::Match& match) const {
  uint64_t hash = 0;
  for (const CellId cell : read_) {
    const uint64_t value = old_machine.Seen(cell);
    // Of a number its magnitude.
    hash = support::Mixed(hash, value <= 1 ? value : 2 + static_cast<uint64_t>(std::bit_width(value)));
    const uint64_t other = new_machine.Seen(match.new_of_old[cell.index]);
    if (other != value) hash = support::Mixed(hash, 7);
  }
  return hash;
}

bool News::NoteMagnitudes(const DiffMachine& old_machine) {
  bool is_first = false;
  for (auto& [cell, seen] : before_) {
    const uint64_t bit = uint64_t{1} << std::min(63, static_cast<int>(std::bit_width(old_machine.Seen(cell))));
    is_first = is_first || (seen & bit) == 0;
    seen |= bit;
  }
  return is_first;
}

News::Kind News::Note(const DiffMachine& old_machine, const DiffMachine& new_machine, const prove::diff::Match& match) {
  const bool is_first = NoteMagnitudes(old_machine);
  if (signatures_.size() < kMostSignatures && signatures_.insert(Signature(old_machine, new_machine, match)).second)
    return Kind::kRead;
  return is_first ? Kind::kBefore : Kind::kNone;
}

PairedMachines::PairedMachines(const DiffSide& old_side, const DiffSide& new_side,
                               const prove::machine::Version& old_version, const prove::machine::Version& new_version,
                               const prove::diff::Match& match, const std::vector<CellId>& cells)
    : old_version_(old_version),
      new_version_(new_version),
      match_(match),
      old_uses_(prove::machine::UsesOf(old_version)),
      new_uses_(prove::machine::UsesOf(new_version)),
      old_machine_(old_side, old_version, Time::max() - std::chrono::hours(1)),
      new_machine_(new_side, new_version, Time::max() - std::chrono::hours(1)),
      period_ms_(std::max(1U, old_side.compilation.program.schedule.period_ms)) {
  size_t bytes = 0;
  for (const ir::Program* const program : {&old_side.whole, &new_side.whole}) {
    for (const ir::Space& space : program->spaces) bytes += 3 * size_t{space.bytes};
  }
  most_moments_ = std::clamp(kMomentBytes / std::max<size_t>(1, bytes), kLeastMoments, kMostMoments);
  FindCompared(cells);
}

void PairedMachines::BeginSearch(size_t known_runs) {
  known_.scenario = known_runs;
  Keep(Kept::kBetweenSteps);
  // The first pass may be due at once.
  const Stimulus pass{.inputs = {}, .words = {}, .slow = 1};
  if (!old_machine_.Apply(pass, &SetCell::old_cell)) return;
  const uint64_t begin_ms = old_machine_.time_ms();
  if (!old_machine_.Apply(pass, &SetCell::old_cell)) return;
  const auto periods = static_cast<uint32_t>((old_machine_.time_ms() - begin_ms) / period_ms_);
  pass_periods_ = std::clamp(periods, 1U, kMostPassPeriods);
}

void PairedMachines::FindCompared(const std::vector<CellId>& cells) {
  std::map<std::pair<uint32_t, uint32_t>, Compared> bytes;
  old_machine_.Look();
  new_machine_.Look();
  for (const CellId old_cell : cells) {
    const CellId new_cell = match_.new_of_old[old_cell.index];
    const execute::Cell cell = execute::CellAt(*old_version_.program, old_version_.cells, old_cell);
    if (cell.kind == CellKind::kCalls) {
      compared_calls_.push_back(old_cell);
      continue;
    }
    const uint32_t old_at = old_machine_.ByteOf(old_cell), new_at = new_machine_.ByteOf(new_cell);
    if (old_at >= old_machine_.picture().size() || new_at >= new_machine_.picture().size()) continue;
    const auto width = static_cast<uint32_t>(execute::CellWidth(*old_version_.program, cell));
    const execute::Cell other = execute::CellAt(*new_version_.program, new_version_.cells, new_cell);
    if (cell.kind == CellKind::kBit && cell.bit == other.bit) {
      Compared& compared = bytes[{old_at, new_at}];
      if (compared.cells.empty()) compared = {.old_at = old_at, .new_at = new_at, .mask = 0, .cells = {}};
      compared.mask = static_cast<uint8_t>(compared.mask | 1U << cell.bit);
      compared.cells.push_back(old_cell);
    } else if (cell.kind == CellKind::kField) {
      compared_.push_back({.old_at = old_at, .new_at = new_at, .bytes = (width + 7) / 8, .cells = {old_cell}});
    } else {
      // A bit that has moved within its byte: looked at one by one.
      compared_.push_back({.old_at = old_at, .new_at = new_at, .bytes = 0, .cells = {old_cell}});
    }
  }
  for (auto& [at, compared] : bytes) compared_.push_back(std::move(compared));
}

void PairedMachines::EndAt(Time end) {
  end_ = end;
  old_machine_.EndAt(end);
  new_machine_.EndAt(end);
}

void PairedMachines::GoTo(const Moment& moment) {
  old_machine_.Restore(moment.old_saved);
  new_machine_.Restore(moment.new_saved);
  stimuli_ = moment.stimuli;
  periods_ = moment.periods;
  known_ = moment.known;
}

PairedMachines::Moment PairedMachines::Here() const {
  return {.old_saved = old_machine_.Save(),
          .new_saved = new_machine_.Save(),
          .stimuli = stimuli_,
          .periods = periods_,
          .known = known_};
}

void PairedMachines::Keep(Kept why) {
  Moments& kept = kept_moments(why);
  auto moment = std::make_shared<Moment>(Here());
  if (kept.size() < most_moments_ / 3) {
    kept.push_back(std::move(moment));
  } else {
    // The first one is power-on.
    kept[1 + random.Next() % (kept.size() - 1)] = std::move(moment);
  }
}

PairedMachines::Differences PairedMachines::Compare(RandomRuns& result) {
  Differences differences;
  std::vector<CellId> differ;
  const std::vector<uint8_t>&old_picture = old_machine_.picture(), &new_picture = new_machine_.picture();
  const auto compare = [&](CellId cell) {
    if (old_machine_.Seen(cell) == new_machine_.Seen(match_.new_of_old[cell.index])) return;
    differences.any = true;
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
    std::ranges::for_each(compared.cells, compare);
  }
  std::ranges::for_each(compared_calls_, compare);
  differences.is_new = !differ.empty();
  if (differences.is_new) AddDifferences(differ, result);
  return differences;
}

void PairedMachines::AddDifferences(const std::vector<CellId>& differ, RandomRuns& result) {
  const auto run = static_cast<uint32_t>(result.runs.size());
  for (const Stimulus& stimulus : stimuli_) kept_inputs_ += stimulus.inputs.size();
  result.runs.push_back(kept_inputs_ < kMostKeptInputs ? stimuli_ : Stimuli());
  kept_runs_.insert(run);
  for (const CellId cell : differ) {
    result.difference_of[cell] = {
        .run = run, .steps = static_cast<uint32_t>(result.runs.back().size()), .periods = periods_};
  }
}

void PairedMachines::KeepShown(RandomRuns& result) {
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
    GoToPowerOn();
    const Stimuli& stimuli = result.runs[run];
    const bool is_done = std::all_of(stimuli.begin(), stimuli.begin() + difference.steps,
                                     [this](const Stimulus& stimulus) { return Apply(stimulus); });
    if (!is_done) continue;
    stimuli_.assign(stimuli.begin(), stimuli.begin() + difference.steps);
    periods_ = difference.periods;
    if (Compare(result).any) Keep(Kept::kDiffers);
  }
}

bool PairedMachines::ApplyUnseen(const Stimulus& stimulus) {
  return !Late() && old_machine_.Apply(stimulus, &SetCell::old_cell) &&
         new_machine_.Apply(stimulus, &SetCell::new_cell);
}

void PairedMachines::Look() {
  old_machine_.Look();
  new_machine_.Look();
}

bool PairedMachines::Apply(const Stimulus& stimulus) {
  if (!ApplyUnseen(stimulus)) return false;
  Look();
  return true;
}

bool PairedMachines::Step(const Stimulus& stimulus, RandomRuns& result) {
  const auto apply = [&](const Stimulus& piece) {
    if (!Apply(piece)) return false;
    AddPeriodsOf(piece);
    return true;
  };
  // All but the first piece only let time pass.
  stimuli_.push_back(stimulus);
  if (before_step) before_step();
  Stimulus piece = stimulus;
  const bool waits = stimulus.ms != 0;
  const uint32_t count = waits ? stimulus.ms : stimulus.slow != 0 ? stimulus.slow : stimulus.fast;
  const uint32_t least = waits ? period_ms_ : 1;
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
    if (Compare(result).is_new) Keep(Kept::kDiffers);
    piece.inputs.clear();
    piece.words.clear();
    piece.power_cycle = false;
    piece.kept.clear();
  }
  if (after_step) after_step();
  switch (news.Note(old_machine_, new_machine_, match_)) {
    case News::Kind::kRead:
      Keep(Kept::kNew);
      break;
    case News::Kind::kBefore:
      Keep(Kept::kOnTheWay);
      break;
    case News::Kind::kNone:
      break;
  }
  return true;
}

void PairedMachines::Repeat(const prove::diff::Run& run, uint32_t period_ms, RandomRuns& result) {
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

void PairedMachines::ForEachSeenState(
    prove::diff::Which which, const std::function<void(const prove::invariants::CellValues&, uint64_t now_ms)>& visit) {
  const bool is_old = which == prove::diff::Which::kOld;
  DiffMachine& machine = is_old ? old_machine_ : new_machine_;
  for (const Moments* const kept :
       {&kept_moments(Kept::kBetweenSteps), &kept_moments(Kept::kNew), &kept_moments(Kept::kDiffers)}) {
    for (const std::shared_ptr<Moment>& moment : *kept) {
      machine.Restore(is_old ? moment->old_saved : moment->new_saved);
      visit([&machine](CellId cell) { return machine.ValueOf(cell); }, machine.time_ms());
    }
  }
}

void PairedMachines::ForEachSeenPair(
    const std::function<void(const prove::invariants::CellValues& of_old, const prove::invariants::CellValues& of_new,
                             uint64_t now_ms)>& visit) {
  for (const Moments* const kept : {&kept_moments(Kept::kBetweenSteps), &kept_moments(Kept::kNew),
                                    &kept_moments(Kept::kOnTheWay), &kept_moments(Kept::kDiffers)}) {
    for (const std::shared_ptr<Moment>& moment : *kept) {
      old_machine_.Restore(moment->old_saved);
      new_machine_.Restore(moment->new_saved);
      visit([this](CellId cell) { return old_machine_.ValueOf(cell); },
            [this](CellId cell) { return new_machine_.ValueOf(cell); }, old_machine_.time_ms());
    }
  }
}

prove::diff::UnrolledVersions PairedMachines::Unrollable() const {
  return {.old_version = old_version_,
          .new_version = new_version_,
          .match = match_,
          .old_uses = old_uses_,
          .new_uses = new_uses_,
          .requests = {}};
}

prove::diff::SeenState PairedMachines::Seen() const {
  return {.value =
              [this](prove::diff::Which which, CellId cell) {
                return (which == prove::diff::Which::kOld ? old_machine_ : new_machine_).ValueOf(cell);
              },
          .now_ms = old_machine_.time_ms()};
}

}  // namespace plcxx::review::diff
