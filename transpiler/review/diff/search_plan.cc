// What the search for runs looks at and what it sets: found out once, from both programs and the scenarios.
#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

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
using prove::diff::SetCell;
using prove::machine::Version;

constexpr size_t kMostReadByChanged = 256, kMostBehind = 1000;
constexpr int kNearDepth = 2, kBehindDepth = 6;

std::set<ir::StatementId> ChangedIn(const DiffSide& side, const DiffSide& other) {
  std::set<ir::StatementId> changed;
  for (const ItemStatement& statement : ChangedStatements(side, other)) changed.insert(statement.statement);
  return changed;
}

/// What is read by the statements, by those that these need, and by those that write what all of these read, and so on.
class ReadCells {
 public:
  /// `needed`: by statement; see NeededBy.
  ReadCells(const Version& version, const std::set<ir::StatementId>& statements, StatementHeads needed)
      : accesses_(AccessesOf(version)),
        needed_(std::move(needed)),
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
      machines_(old_side, new_side, old_version, new_version, match, cells),
      cells_(cells) {
  is_settable_.assign(old_version.cells.count, false);
  for (const CellId cell : cells) is_settable_[cell.index] = true;
  const prove::machine::Uses &old_uses = machines_.old_uses(), &new_uses = machines_.new_uses();
  for (uint32_t i = 0; i < old_version.cells.count; ++i) {
    const CellId new_cell = match.new_of_old[i];
    if (!new_cell.valid()) continue;
    const bool is_used =
        old_uses.reads[i] || old_uses.writes[i] || new_uses.reads[new_cell.index] || new_uses.writes[new_cell.index];
    if (!is_used) is_settable_[i] = true;
  }
  ReadScenarios();
  FindInputs(Reads::kItsOwn);
  // It is computed in other statements, or decided in others whether they are executed.
  if (machines_.news.read().empty() || near_.empty()) FindInputs(Reads::kAllNeeded);
  FindConstants();
  counts_.emplace(machines_, inputs_, constants_);
  machines_.BeginSearch(known_.size());
}

void DirectedSearch::FindConstants() {
  const ChangedConstants changed = FindChangedConstants(old_version_, new_version_);
  has_changed_constants_ = changed.are_any;
  waits_ms_ = {100, 500, 1000, 3000, 10'000};
  for (const uint32_t ms : changed.times_ms) {
    if (ms <= 60'000) waits_ms_.push_back(ms);
  }
  std::set<uint64_t> constants;
  for (const ir::Program* const program : {&old_side_.whole, &new_side_.whole}) {
    ir::ForEachNumber(*program, [&constants](uint64_t number) { constants.insert(number); });
  }
  constants_.assign(constants.begin(), constants.end());
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
  const std::optional<dialects::Location> one = locate(old_side_, machines_.old_machine()),
                                          other = locate(new_side_, machines_.new_machine());
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

std::set<CellId> DirectedSearch::FindWords() {
  inputs_.clear();
  const std::vector<SetCell> all = InputsOf(old_version_, new_version_, match_);
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
  return taken;
}

void DirectedSearch::FindKept(std::set<CellId> cells) {
  kept_.clear();
  while (!cells.empty()) {
    const CellId first = *cells.begin();
    std::vector<CellId> word = old_words_.WordOf(first).cells;
    if (std::ranges::find(word, first) == word.end()) word = {first};
    Input bits;
    for (const CellId cell : word) {
      if (cells.erase(cell) != 0) bits.push_back({.old_cell = cell, .new_cell = match_.new_of_old[cell.index]});
    }
    kept_.push_back(std::move(bits));
  }
}

void DirectedSearch::FindInputs(Reads reads) {
  const auto needed = [reads](const Version& version) {
    return reads == Reads::kAllNeeded ? NeededBy(version) : StatementHeads();
  };
  ReadCells old_read(old_version_, ChangedIn(old_side_, new_side_), needed(old_version_)),
      new_read(new_version_, ChangedIn(new_side_, old_side_), needed(new_version_));
  const auto is_read = [&](CellId old_cell) {
    const CellId new_cell = match_.new_of_old[old_cell.index];
    return old_read.Has(old_cell) || (new_cell.valid() && new_read.Has(new_cell));
  };
  const auto has_partner = [this](uint32_t i) { return match_.new_of_old[i].valid(); };
  const uint32_t count = old_version_.cells.calls;
  std::vector<CellId> by_changed;
  for (uint32_t i = 0; i < count && by_changed.size() < kMostReadByChanged; ++i) {
    if (has_partner(i) && is_read(CellId(i))) by_changed.emplace_back(i);
  }
  const std::set<CellId> taken = FindWords();
  requests_.clear();
  for (const CellId cell : prove::diff::MatchedRequests(old_version_, new_version_, match_))
    requests_.push_back({.old_cell = cell, .new_cell = match_.new_of_old[cell.index]});
  const auto read_inputs = [&] {
    std::vector<Input> read;
    std::ranges::copy_if(inputs_, std::back_inserter(read), [&](const Input& input) {
      return std::ranges::any_of(input, [&](const SetCell& bit) { return is_read(bit.old_cell); });
    });
    return read;
  };
  near_.clear();
  std::set<CellId> before;
  for (int depth = 0; depth < kBehindDepth; ++depth) {
    if (depth <= kNearDepth || near_.empty()) near_ = read_inputs();
    old_read.GoBack();
    new_read.GoBack();
    for (uint32_t i = 0; i < count && before.size() < kMostBehind; ++i) {
      if (has_partner(i) && !taken.contains(CellId(i)) && is_read(CellId(i))) before.emplace(i);
    }
  }
  behind_ = read_inputs();
  machines_.news = News(std::move(by_changed), {before.begin(), before.end()});
  std::set<CellId> kept;
  for (uint32_t i = 0; i < count; ++i) {
    const CellId cell(i);
    const bool may_be_kept = prove::diff::MayBeKept(old_version_, new_version_, match_, cell);
    if (may_be_kept && !taken.contains(cell) && is_read(cell)) kept.insert(cell);
  }
  FindKept(std::move(kept));
}

}  // namespace plcxx::review::diff
