#include "transpiler/driver/diff_search.h"

#include <algorithm>
#include <bit>
#include <map>

#include "transpiler/driver/diff_statements.h"
#include "transpiler/driver/diff_stimuli.h"
#include "transpiler/driver/known_runs.h"
#include "transpiler/driver/scenario_plan.h"
#include "transpiler/prove/compare/requests.h"
#include "transpiler/prove/compare/transition.h"

namespace plcxx::driver {
namespace {

using prove::compare::SetCell;
using prove::compare::Version;
using prove::execute::CellId;
using prove::execute::CellKind;

constexpr size_t kMomentBytes = size_t{192} << 20, kMostMoments = 300, kLeastMoments = 6;
constexpr size_t kMostSignatures = 4000, kMostReadByChanged = 256;
constexpr int kNearDepth = 2, kBehindDepth = 6;
constexpr uint32_t kWatchedPeriods = 60;  // of a wait, one by one; the rest in larger pieces

std::set<ir::StatementId> ChangedIn(const DiffSide& side, const DiffSide& other) {
  std::set<ir::StatementId> changed;
  for (const ItemStatement& statement : ChangedStatements(side, other)) changed.insert(statement.statement);
  return changed;
}

/// What is read by the statements and by those that write what they read, and so on.
class ReadCells {
 public:
  ReadCells(const Version& version, const std::set<ir::StatementId>& statements)
      : accesses_(AccessesOf(version)), read_(version.cells.count), statements_(statements) {
    AddReads();
  }

  void GoBack() {
    std::set<ir::StatementId> writers;
    for (const StatementAccess& access : accesses_) {
      if (!access.writes || !access.statement.valid()) continue;
      if (std::any_of(read_.begin() + access.begin, read_.begin() + access.end, [](bool is_read) { return is_read; }))
        writers.insert(access.statement);
    }
    statements_ = std::move(writers);
    AddReads();
  }
  bool Has(CellId cell) const { return read_[cell.index]; }

 private:
  void AddReads() {
    for (const StatementAccess& access : accesses_) {
      if (access.writes || !statements_.contains(access.statement)) continue;
      std::fill(read_.begin() + access.begin, read_.begin() + access.end, true);
    }
  }

  std::vector<StatementAccess> accesses_;
  std::vector<bool> read_;
  std::set<ir::StatementId> statements_;
};

uint64_t Mixed(uint64_t hash, uint64_t value) {
  hash = (hash ^ value) * 0x9E3779B97F4A7C15;
  return hash ^ (hash >> 29);
}

}  // namespace

DirectedSearch::DirectedSearch(const DiffSide& old_side, const DiffSide& new_side, const Version& old_version,
                               const Version& new_version, const prove::compare::Match& match,
                               const CellWords& old_words, const std::vector<CellId>& cells)
    : old_side_(old_side),
      new_side_(new_side),
      old_version_(old_version),
      new_version_(new_version),
      match_(match),
      old_words_(old_words),
      old_machine_(old_side, old_version, Time::max() - std::chrono::hours(1)),
      new_machine_(new_side, new_version, Time::max() - std::chrono::hours(1)) {
  const prove::compare::Uses old_uses = prove::compare::UsesOf(old_version),
                             new_uses = prove::compare::UsesOf(new_version);
  is_settable_.assign(old_version.cells.count, false);
  for (const CellId cell : cells) is_settable_[cell.index] = true;
  for (uint32_t i = 0; i < old_version.cells.count; ++i) {
    const CellId new_cell = match.new_of_old[i];
    if (!new_cell.valid()) continue;
    const bool is_used =
        old_uses.reads[i] || old_uses.writes[i] || new_uses.reads[new_cell.index] || new_uses.writes[new_cell.index];
    if (!is_used) is_settable_[i] = true;
  }
  ReadScenarios();
  MakePlan(cells);
  FindInputs();
  const ChangedConstants changed = FindChangedConstants(old_version, new_version);
  waits_ms_ = {100, 500, 1000, 3000, 10'000};
  for (const uint32_t ms : changed.times_ms) {
    if (ms <= 60'000) waits_ms_.push_back(ms);
  }
  std::set<uint64_t> constants;
  for (const ir::Program* const program : {&old_side.whole, &new_side.whole}) {
    for (const ir::Region& region : program->regions) {
      for (const ir::InstId id : region.insts) {
        const ir::Inst& inst = (*program)[id];
        if (inst.op == ir::OpKind::kConst && inst.type != ir::Type::kBit) constants.insert(ir::ConstantValue(inst));
      }
    }
  }
  constants_.assign(constants.begin(), constants.end());
  size_t bytes = 0;
  for (const ir::Program* const program : {&old_side.whole, &new_side.whole}) {
    for (const ir::Space& space : program->spaces) bytes += 3 * size_t{space.bytes};
  }
  most_moments_ = std::clamp(kMomentBytes / std::max<size_t>(1, bytes), kLeastMoments, kMostMoments);
  scenario_ = known_.size();
  Keep(Kept::kBetweenSteps);
}

void DirectedSearch::ReadScenarios() {
  for (const std::vector<KnownStep>& steps : KnownRuns(old_side_.request)) {
    Stimuli stimuli;
    for (const KnownStep& step : steps) {
      Stimulus next{.inputs = {},
                    .words = {},
                    .slow = step.slow,
                    .ms = step.ms,
                    .fast = step.fast,
                    .power_cycle = step.power_cycle};
      for (const auto& word : step.words) SetKnown(word, next);
      stimuli.push_back(std::move(next));
    }
    if (!stimuli.empty()) known_.push_back(std::move(stimuli));
  }
}

void DirectedSearch::SetKnown(const std::pair<std::string, std::string>& word, Stimulus& stimulus) const {
  const auto locate = [&word](const DiffSide& side) {
    return side.compilation.dialect->locate(side.compilation.program, word.first);
  };
  const auto is_memory = [](const std::optional<dialects::Location>& location) {
    return location && !location->absent && !location->cell && !location->text_input && location->bits.empty();
  };
  const std::optional<dialects::Location> one = locate(old_side_), other = locate(new_side_);
  if (!is_memory(one) || !prove::execute::IsInside(*old_version_.program, one->place)) {
    // The control's: it has no other name.
    if (one && other) stimulus.words.push_back(word);
    return;
  }
  const std::vector<CellId> cells = prove::execute::CellsOf(*old_version_.program, old_version_.cells, one->place);
  std::vector<CellId> partners;
  for (const CellId cell : cells) partners.push_back(match_.new_of_old[cell.index]);
  const auto is_settable = [this](CellId cell) { return is_settable_[cell.index]; };
  const bool is_same = std::ranges::all_of(cells, is_settable) && is_memory(other) &&
                       prove::execute::IsInside(*new_version_.program, other->place) &&
                       one->place.type == other->place.type &&
                       prove::execute::CellsOf(*new_version_.program, new_version_.cells, other->place) == partners;
  if (is_same) {
    stimulus.words.push_back(word);
    return;
  }
  const std::optional<uint64_t> value =
      ParseScenarioValue(word.second, one->place.type, *old_side_.compilation.dialect);
  for (size_t i = 0; value && i < cells.size(); ++i) {
    if (!is_settable(cells[i])) continue;
    const uint64_t of_cell = cells.size() == 1 ? *value : *value >> i & 1;
    stimulus.inputs.push_back({.old_cell = cells[i], .new_cell = partners[i], .value = of_cell});
  }
}

void DirectedSearch::MakePlan(const std::vector<CellId>& cells) {
  std::map<std::pair<uint32_t, uint32_t>, Compared> bytes;
  old_machine_.Look();
  new_machine_.Look();
  for (const CellId old_cell : cells) {
    const CellId new_cell = match_.new_of_old[old_cell.index];
    const prove::execute::Cell cell = prove::execute::CellAt(*old_version_.program, old_version_.cells, old_cell);
    if (cell.kind == CellKind::kCalls) {
      compared_calls_.push_back(old_cell);
      continue;
    }
    const uint32_t old_at = old_machine_.ByteOf(old_cell), new_at = new_machine_.ByteOf(new_cell);
    if (old_at >= old_machine_.picture().size() || new_at >= new_machine_.picture().size()) continue;
    const auto width = static_cast<uint32_t>(prove::execute::CellWidth(*old_version_.program, cell));
    const prove::execute::Cell other = prove::execute::CellAt(*new_version_.program, new_version_.cells, new_cell);
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

void DirectedSearch::FindInputs() {
  const std::vector<SetCell> all = InputsOf(old_version_, new_version_, match_);
  ReadCells old_read(old_version_, ChangedIn(old_side_, new_side_)),
      new_read(new_version_, ChangedIn(new_side_, old_side_));
  const auto is_read = [&](CellId old_cell) {
    const CellId new_cell = match_.new_of_old[old_cell.index];
    return old_read.Has(old_cell) || (new_cell.valid() && new_read.Has(new_cell));
  };
  for (uint32_t i = 0; i < old_version_.cells.calls && read_by_changed_.size() < kMostReadByChanged; ++i) {
    if (match_.new_of_old[i].valid() && is_read(CellId(i))) read_by_changed_.emplace_back(i);
  }
  std::map<CellId, SetCell> of_cell;
  for (const SetCell& input : all) of_cell[input.old_cell] = input;
  std::set<CellId> taken;
  for (const SetCell& input : all) {
    if (!taken.insert(input.old_cell).second) continue;
    Input bits{input};
    const CellWord word = old_words_.WordOf(input.old_cell);
    if (word.cells.size() > 1) {
      bits.clear();
      for (const CellId cell : word.cells) {
        const auto at = of_cell.find(cell);
        if (at == of_cell.end()) continue;
        bits.push_back(at->second);
        taken.insert(cell);
      }
    }
    inputs_.push_back(std::move(bits));
  }
  for (const CellId cell : prove::compare::MatchedRequests(old_version_, new_version_, match_))
    requests_.push_back({.old_cell = cell, .new_cell = match_.new_of_old[cell.index]});
  const auto read_inputs = [&] {
    std::vector<Input> read;
    std::ranges::copy_if(inputs_, std::back_inserter(read), [&](const Input& input) {
      return std::ranges::any_of(input, [&](const SetCell& bit) { return is_read(bit.old_cell); });
    });
    return read;
  };
  for (int depth = 0; depth < kBehindDepth; ++depth) {
    if (depth <= kNearDepth || near_.empty()) near_ = read_inputs();
    old_read.GoBack();
    new_read.GoBack();
  }
  behind_ = read_inputs();
}

void DirectedSearch::GoTo(const Moment& moment) {
  old_machine_.Restore(moment.old_saved);
  new_machine_.Restore(moment.new_saved);
  stimuli_ = moment.stimuli;
  periods_ = moment.periods;
  scenario_ = moment.scenario;
  next_step_ = moment.next_step;
}

void DirectedSearch::Keep(Kept why) {
  std::vector<Moment>& kept = why == Kept::kDiffers ? differing_ : why == Kept::kNew ? new_ : between_;
  Moment moment{.old_saved = old_machine_.Save(),
                .new_saved = new_machine_.Save(),
                .stimuli = stimuli_,
                .periods = periods_,
                .scenario = scenario_,
                .next_step = next_step_};
  if (kept.size() < most_moments_ / 3) {
    kept.push_back(std::move(moment));
  } else {
    // The first one is power-on.
    kept[1 + random_.Next() % (kept.size() - 1)] = std::move(moment);
  }
}

void DirectedSearch::GoBack() {
  const uint64_t which = random_.Next() % 8;
  const std::vector<Moment>& kept = which < 3 && !differing_.empty() ? differing_
                                    : which < 6 && !new_.empty()     ? new_
                                                                     : between_;
  // The last ones are the news.
  const size_t count = random_.OneIn(2) ? kept.size() : std::min<size_t>(kept.size(), 8);
  GoTo(kept[kept.size() - 1 - random_.Next() % count]);
}

void DirectedSearch::Compare(RandomRuns& result) {
  std::vector<CellId> differ;
  const std::vector<uint8_t>&old_picture = old_machine_.picture(), &new_picture = new_machine_.picture();
  const auto add = [&](CellId cell) {
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
  result.runs.push_back(stimuli_);
  for (const CellId cell : differ) {
    result.difference_of[cell] = {.run = run, .steps = static_cast<uint32_t>(stimuli_.size()), .periods = periods_};
  }
  has_new_difference_ = true;
}

uint64_t DirectedSearch::Signature() const {
  uint64_t hash = 0;
  for (const CellId cell : read_by_changed_) {
    const uint64_t value = old_machine_.Seen(cell);
    // Of a number its magnitude.
    hash = Mixed(hash, value <= 1 ? value : 2 + static_cast<uint64_t>(std::bit_width(value)));
    const uint64_t other = new_machine_.Seen(match_.new_of_old[cell.index]);
    if (other != value) hash = Mixed(hash, 7);
  }
  return hash;
}

bool DirectedSearch::Step(const Stimulus& stimulus, RandomRuns& result) {
  const uint32_t period_ms = std::max(1U, old_side_.compilation.program.schedule.period_ms);
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
  }
  if (signatures_.size() < kMostSignatures && signatures_.insert(Signature()).second) Keep(Kept::kNew);
  return true;
}

void DirectedSearch::Disturb(const Input& input, Stimulus& stimulus) {
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
    stimulus.inputs.push_back(input[i]);
    stimulus.inputs.back().value = i < 64 ? value >> i & 1 : 0;
  }
}

Stimulus DirectedSearch::Unexpected() {
  Stimulus stimulus;
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
  for (uint64_t i = random_.Next() % 4; i > 0; --i) {
    const uint64_t which = random_.Next() % 8;
    const std::vector<Input>& from = which < 4 && !near_.empty()     ? near_
                                     : which < 7 && !behind_.empty() ? behind_
                                                                     : inputs_;
    if (!from.empty()) Disturb(from[random_.Next() % from.size()], stimulus);
  }
  if (stimulus.slow != 0 || stimulus.fast != 0 || stimulus.ms != 0) return stimulus;
  const bool has_fast = prove::compare::HasFastPart(old_version_) || prove::compare::HasFastPart(new_version_);
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

void DirectedSearch::RunScenarios(Time end, RandomRuns& result) {
  end_ = end;
  old_machine_.EndAt(end);
  new_machine_.EndAt(end);
  for (size_t scenario = 0; scenario < known_.size() && !Late(); ++scenario) {
    GoTo(between_.front());
    scenario_ = scenario;
    for (const Stimulus& stimulus : known_[scenario]) {
      ++next_step_;
      if (!Step(stimulus, result)) break;
      Keep(Kept::kBetweenSteps);
    }
  }
}

void DirectedSearch::Follow(const std::vector<prove::compare::Run>& computed, Time end, RandomRuns& result) {
  end_ = end;
  old_machine_.EndAt(end);
  new_machine_.EndAt(end);
  constexpr size_t kMostFollowed = 30;
  for (; followed_ < std::min(computed.size(), kMostFollowed) && !Late(); ++followed_) {
    // As whole passes, and as time: where the slow part is in slices they are not the same.
    for (const bool by_time : {false, true}) {
      GoTo(between_.front());
      for (const std::vector<SetCell>& inputs : computed[followed_].periods) {
        Stimulus stimulus{.inputs = inputs, .words = {}};
        (by_time ? stimulus.ms : stimulus.slow) = by_time ? old_side_.compilation.program.schedule.period_ms : 1;
        if (!Step(stimulus, result)) break;
      }
    }
  }
}

void DirectedSearch::Run(const std::vector<CellId>& sought, Time end, RandomRuns& result) {
  end_ = end;
  old_machine_.EndAt(end);
  new_machine_.EndAt(end);
  const auto is_open = [&](CellId cell) { return !result.difference_of.contains(cell); };
  size_t seen = result.difference_of.size();
  while (!Late()) {
    GoBack();
    for (uint64_t left = 1 + random_.Next() % 10; left > 0; --left) {
      if (!Step(Unexpected(), result)) break;
    }
    if (result.difference_of.size() == seen) continue;
    seen = result.difference_of.size();
    if (std::ranges::none_of(sought, is_open)) return;
  }
}

}  // namespace plcxx::driver
