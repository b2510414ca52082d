// What the search for runs looks at and what it sets: found out once, from both programs and the scenarios.
#include <algorithm>
#include <map>

#include "transpiler/ir/constants.h"
#include "transpiler/prove/machine/requests.h"
#include "transpiler/review/diff/search.h"
#include "transpiler/review/diff/statements.h"
#include "transpiler/review/diff/stimuli.h"
#include "transpiler/scenarios/known_runs.h"
#include "transpiler/scenarios/plan.h"

namespace plcxx::review::diff {
namespace {

using execute::CellId;
using execute::CellKind;
using prove::diff::SetCell;
using prove::machine::Version;

constexpr size_t kMomentBytes = size_t{192} << 20, kMostMoments = 300, kLeastMoments = 6;
constexpr size_t kMostReadByChanged = 256, kMostBehind = 1000;
constexpr int kNearDepth = 2, kBehindDepth = 6;
constexpr uint32_t kMostPassPeriods = 100;  // of a whole slow pass

std::set<ir::StatementId> ChangedIn(const DiffSide& side, const DiffSide& other) {
  std::set<ir::StatementId> changed;
  for (const ItemStatement& statement : ChangedStatements(side, other)) changed.insert(statement.statement);
  return changed;
}

/// What is read by the statements, by those that these need, if that is wanted, and by those that write what all of
/// these read, and so on.
class ReadCells {
 public:
  ReadCells(const Version& version, const std::set<ir::StatementId>& statements, bool with_needed)
      : accesses_(AccessesOf(version)),
        needed_(with_needed ? NeededBy(version) : StatementHeads()),
        read_(version.cells.count),
        statements_(WithNeeded(needed_, statements)) {
    AddReads();
  }

  void GoBack() {
    std::set<ir::StatementId> writers;
    for (const StatementAccess& access : accesses_) {
      if (!access.writes || !access.statement.valid()) continue;
      if (std::any_of(read_.begin() + access.begin, read_.begin() + access.end, [](bool is_read) { return is_read; }))
        writers.insert(access.statement);
    }
    statements_ = WithNeeded(needed_, writers);
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
  StatementHeads needed_;
  std::vector<bool> read_;
  std::set<ir::StatementId> statements_;
};

}  // namespace

DirectedSearch::DirectedSearch(const DiffSide& old_side, const DiffSide& new_side, const Version& old_version,
                               const Version& new_version, const prove::diff::Match& match, const CellWords& old_words,
                               const std::vector<CellId>& cells)
    : old_side_(old_side),
      new_side_(new_side),
      old_version_(old_version),
      new_version_(new_version),
      match_(match),
      old_words_(old_words),
      old_machine_(old_side, old_version, Time::max() - std::chrono::hours(1)),
      new_machine_(new_side, new_version, Time::max() - std::chrono::hours(1)),
      old_uses_(prove::machine::UsesOf(old_version)),
      new_uses_(prove::machine::UsesOf(new_version)),
      period_ms_(std::max(1U, old_side.compilation.program.schedule.period_ms)),
      cells_(cells) {
  is_settable_.assign(old_version.cells.count, false);
  for (const CellId cell : cells) is_settable_[cell.index] = true;
  for (uint32_t i = 0; i < old_version.cells.count; ++i) {
    const CellId new_cell = match.new_of_old[i];
    if (!new_cell.valid()) continue;
    const bool is_used = old_uses_.reads[i] || old_uses_.writes[i] || new_uses_.reads[new_cell.index] ||
                         new_uses_.writes[new_cell.index];
    if (!is_used) is_settable_[i] = true;
  }
  ReadScenarios();
  MakePlan(cells);
  FindInputs(false);
  // It is computed in other statements, or decided in others whether they are executed.
  if (read_by_changed_.empty() || near_.empty()) FindInputs(true);
  const ChangedConstants changed = FindChangedConstants(old_version, new_version);
  has_changed_constants_ = changed.are_any;
  waits_ms_ = {100, 500, 1000, 3000, 10'000};
  for (const uint32_t ms : changed.times_ms) {
    if (ms <= 60'000) waits_ms_.push_back(ms);
  }
  std::set<uint64_t> constants;
  for (const ir::Program* const program : {&old_side.whole, &new_side.whole}) {
    ir::ForEachNumber(*program, [&constants](uint64_t number) { constants.insert(number); });
  }
  constants_.assign(constants.begin(), constants.end());
  FindCounters();
  size_t bytes = 0;
  for (const ir::Program* const program : {&old_side.whole, &new_side.whole}) {
    for (const ir::Space& space : program->spaces) bytes += 3 * size_t{space.bytes};
  }
  most_moments_ = std::clamp(kMomentBytes / std::max<size_t>(1, bytes), kLeastMoments, kMostMoments);
  scenario_ = known_.size();
  Keep(Kept::kBetweenSteps);
  // The first pass may be due at once.
  const Stimulus pass{.inputs = {}, .words = {}, .slow = 1};
  if (old_machine_.Apply(pass, &SetCell::old_cell)) {
    const uint64_t begin_ms = old_machine_.time_ms();
    if (old_machine_.Apply(pass, &SetCell::old_cell)) {
      const auto periods = static_cast<uint32_t>((old_machine_.time_ms() - begin_ms) / period_ms_);
      pass_periods_ = std::clamp(periods, 1U, kMostPassPeriods);
    }
  }
}

void DirectedSearch::ReadScenarios() {
  for (const std::vector<scenarios::KnownStep>& steps : scenarios::KnownRuns(old_side_.request)) {
    Stimuli stimuli;
    for (const scenarios::KnownStep& step : steps) {
      Stimulus next = WithoutWords(step);
      for (const auto& word : step.words) SetKnown(word, next);
      stimuli.push_back(std::move(next));
    }
    if (!stimuli.empty()) known_.push_back(std::move(stimuli));
  }
}

void DirectedSearch::SetKnown(const std::pair<std::string, std::string>& word, Stimulus& stimulus) const {
  const auto locate = [&word](const DiffSide& side, const DiffMachine& machine) {
    return side.compilation.dialect->locate(machine.names(), word.first);
  };
  const auto is_memory = [](const std::optional<dialects::Location>& location) {
    return location && !location->absent && !location->cell && !location->text_input && location->bits.empty();
  };
  const std::optional<dialects::Location> one = locate(old_side_, old_machine_),
                                          other = locate(new_side_, new_machine_);
  if (!is_memory(one) || !execute::IsInside(*old_version_.program, one->place)) {
    // The control's: it has no other name.
    if (one && other) stimulus.words.push_back(word);
    return;
  }
  const std::vector<CellId> cells = execute::CellsOf(*old_version_.program, old_version_.cells, one->place);
  std::vector<CellId> partners;
  for (const CellId cell : cells) partners.push_back(match_.new_of_old[cell.index]);
  const auto is_settable = [this](CellId cell) { return is_settable_[cell.index]; };
  const bool is_same = std::ranges::all_of(cells, is_settable) && is_memory(other) &&
                       execute::IsInside(*new_version_.program, other->place) && one->place.type == other->place.type &&
                       execute::CellsOf(*new_version_.program, new_version_.cells, other->place) == partners;
  if (is_same) {
    stimulus.words.push_back(word);
    return;
  }
  const std::optional<uint64_t> value =
      scenarios::ParseScenarioValue(word.second, one->place.type, *old_side_.compilation.dialect);
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

void DirectedSearch::FindInputs(bool with_needed) {
  for (std::vector<Input>* const inputs : {&inputs_, &behind_, &near_, &kept_}) inputs->clear();
  requests_.clear();
  read_by_changed_.clear();
  seen_behind_.clear();
  const std::vector<SetCell> all = InputsOf(old_version_, new_version_, match_);
  ReadCells old_read(old_version_, ChangedIn(old_side_, new_side_), with_needed),
      new_read(new_version_, ChangedIn(new_side_, old_side_), with_needed);
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
  for (const CellId cell : prove::diff::MatchedRequests(old_version_, new_version_, match_))
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
    for (uint32_t i = 0; i < old_version_.cells.calls && seen_behind_.size() < kMostBehind; ++i) {
      if (match_.new_of_old[i].valid() && !taken.contains(CellId(i)) && is_read(CellId(i)))
        seen_behind_.emplace(CellId(i), 0);
    }
  }
  behind_ = read_inputs();
  std::set<CellId> kept;
  for (uint32_t i = 0; i < old_version_.cells.calls; ++i) {
    const CellId cell(i);
    const bool may_be_kept = prove::diff::MayBeKept(old_version_, new_version_, match_, cell);
    if (may_be_kept && !taken.contains(cell) && is_read(cell)) kept.insert(cell);
  }
  while (!kept.empty()) {
    const CellId first = *kept.begin();
    std::vector<CellId> word = old_words_.WordOf(first).cells;
    if (std::ranges::find(word, first) == word.end()) word = {first};
    Input bits;
    for (const CellId cell : word) {
      if (kept.erase(cell) != 0) bits.push_back({.old_cell = cell, .new_cell = match_.new_of_old[cell.index]});
    }
    kept_.push_back(std::move(bits));
  }
}

}  // namespace plcxx::review::diff
