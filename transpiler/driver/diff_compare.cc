// The comparison of two versions: cells in, items with names, causes and counterexamples out.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "transpiler/driver/diff.h"
#include "transpiler/driver/diff_items.h"
#include "transpiler/driver/diff_runs.h"
#include "transpiler/passes/pipeline.h"

namespace plcxx::driver {
namespace {

using prove::CellId;
using prove::PairResult;
using prove::PairVerdict;

/// One version with all that names and causes need.
struct Named {
  Named(const DiffSide& diff_side, const prove::Version& side_version)
      : side(diff_side),
        compilation(diff_side.compilation),
        version(side_version),
        words(version, compilation),
        accesses(AccessesOf(version)) {}

  const DiffSide& side;
  const Compilation& compilation;
  const prove::Version& version;
  CellWords words;
  std::vector<StatementAccess> accesses;
};

/// The statement without what does not count: spaces between words.
std::string Normalized(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool space = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (!space) {
      result += c;
    } else if (!result.empty() && result.back() != ' ') {
      result += ' ';
    }
  }
  while (!result.empty() && result.back() == ' ') result.pop_back();
  return result;
}

std::set<std::string> TextsOf(const Compilation& compilation) {
  std::set<std::string> texts;
  for (const ir::Statement& statement : compilation.program.statements) {
    texts.insert(Normalized(compilation.sources->Text(statement.range)));
  }
  return texts;
}

std::string ShownPath(const DiffSide& side, const std::string& path) {
  if (!side.hidden_prefix.empty() && path.starts_with(side.hidden_prefix)) {
    return path.substr(side.hidden_prefix.size());
  }
  return std::filesystem::path(path).lexically_normal().generic_string();
}

ItemStatement StatementOf(const Named& side, ir::StatementId id, const std::set<std::string>& other_texts) {
  const ir::Statement& statement = side.version.program->statements[id];
  const std::string_view text = side.compilation.sources->Text(statement.range);
  const source::Position at = side.compilation.sources->Locate(statement.range.begin);
  return {.statement = id,
          .file = at.file.valid() ? ShownPath(side.side, side.compilation.sources->Get(at.file).path) : std::string(),
          .line = at.line,
          .column = at.column,
          .text = std::string(text.substr(0, text.find_first_of("\r\n"))),
          .changed = !other_texts.contains(Normalized(text))};
}

ItemKind KindOf(const prove::Version& version, CellId cell) {
  if (CellAt(*version.program, version.cells, cell).kind == prove::CellKind::kCalls) return ItemKind::kCalls;
  if (DirectionOf(version, cell) == ir::Direction::kOutput) return ItemKind::kOutput;
  return IsRetentive(version, cell) ? ItemKind::kRetentive : ItemKind::kInternal;
}

/// All cells of one name, with the worst verdict of them.
struct Gathered {
  DiffItem item;
  std::vector<CellId> old_cells, new_cells;
  const PairResult* worst = nullptr;
};

ItemVerdict VerdictOf(const PairResult& pair) {
  switch (pair.verdict) {
    case PairVerdict::kUntouched:
    case PairVerdict::kEqual:
      return ItemVerdict::kEqual;
    case PairVerdict::kDifferent:
      return ItemVerdict::kDifferent;
    case PairVerdict::kUndecided:
      return ItemVerdict::kUndecided;
  }
  return ItemVerdict::kUndecided;
}

/// The worse of two: what differs beats what is not decided.
bool IsWorse(ItemVerdict one, ItemVerdict other) {
  const auto rank = [](ItemVerdict verdict) {
    return verdict == ItemVerdict::kDifferent ? 2 : verdict == ItemVerdict::kUndecided ? 1 : 0;
  };
  return rank(one) > rank(other);
}

std::vector<Gathered> Gather(const prove::CompareResult& result, const Named& old_side, const Named& new_side) {
  std::vector<Gathered> items;
  std::map<std::pair<ItemKind, std::string>, size_t> index;
  for (const PairResult& pair : result.pairs) {
    if (pair.verdict == PairVerdict::kUntouched) continue;
    const Named& side = pair.old_cell.valid() ? old_side : new_side;
    const CellId cell = pair.old_cell.valid() ? pair.old_cell : pair.new_cell;
    CellWord word = side.words.WordOf(cell);
    // A place that only the new version uses has its name there.
    if (!word.place && pair.new_cell.valid()) {
      CellWord other = new_side.words.WordOf(pair.new_cell);
      if (other.place) word = std::move(other);
    }
    const ItemKind kind = KindOf(side.version, cell);
    const auto [at, added] = index.try_emplace({kind, word.name}, items.size());
    if (added) {
      items.push_back({.item = {.name = word.name, .kind = kind, .verdict = ItemVerdict::kEqual}});
      items.back().item.meaning = new_side.words.MeaningOf(word.name);
      if (items.back().item.meaning.empty()) items.back().item.meaning = old_side.words.MeaningOf(word.name);
    }
    Gathered& gathered = items[at->second];
    if (pair.old_cell.valid()) gathered.old_cells.push_back(pair.old_cell);
    if (pair.new_cell.valid()) gathered.new_cells.push_back(pair.new_cell);
    gathered.item.changed_itself = gathered.item.changed_itself || pair.changed_itself;
    if (gathered.worst == nullptr || IsWorse(VerdictOf(pair), gathered.item.verdict)) {
      gathered.worst = &pair;
      gathered.item.verdict = VerdictOf(pair);
      gathered.item.reason = pair.reason;
    }
  }
  return items;
}

bool Touches(const StatementAccess& access, const std::vector<CellId>& cells) {
  return std::ranges::any_of(cells,
                             [&access](CellId cell) { return access.begin <= cell.index && cell.index < access.end; });
}

std::vector<ir::StatementId> Writers(const Named& side, const std::vector<CellId>& cells) {
  std::set<ir::StatementId> writers;
  for (const StatementAccess& access : side.accesses) {
    if (access.writes && access.statement.valid() && Touches(access, cells)) writers.insert(access.statement);
  }
  return {writers.begin(), writers.end()};
}

/// Differing items whose cells the statements read.
std::vector<std::string> ReadItems(const Named& side, const std::vector<ir::StatementId>& statements,
                                   const std::vector<Gathered>& items, const std::string& own, bool is_old) {
  std::vector<std::string> names;
  for (const Gathered& other : items) {
    if (other.item.verdict == ItemVerdict::kEqual || other.item.name == own) continue;
    const std::vector<CellId>& cells = is_old ? other.old_cells : other.new_cells;
    const bool reads = std::ranges::any_of(side.accesses, [&](const StatementAccess& access) {
      return !access.writes && std::ranges::binary_search(statements, access.statement) && Touches(access, cells);
    });
    if (reads) names.push_back(other.item.name);
  }
  return names;
}

void AddCauses(std::vector<Gathered>& items, const Named& old_side, const Named& new_side) {
  const std::set<std::string> old_texts = TextsOf(old_side.compilation), new_texts = TextsOf(new_side.compilation);
  for (Gathered& gathered : items) {
    if (gathered.item.verdict == ItemVerdict::kEqual) continue;
    const std::vector<ir::StatementId> old_writers = Writers(old_side, gathered.old_cells);
    const std::vector<ir::StatementId> new_writers = Writers(new_side, gathered.new_cells);
    for (const ir::StatementId id : old_writers) {
      gathered.item.old_statements.push_back(StatementOf(old_side, id, new_texts));
    }
    for (const ir::StatementId id : new_writers) {
      gathered.item.new_statements.push_back(StatementOf(new_side, id, old_texts));
    }
    std::set<std::string> through;
    for (std::string& name : ReadItems(old_side, old_writers, items, gathered.item.name, true))
      through.insert(std::move(name));
    for (std::string& name : ReadItems(new_side, new_writers, items, gathered.item.name, false))
      through.insert(std::move(name));
    gathered.item.through.assign(through.begin(), through.end());
    // In one scan a difference runs on through everything behind it; those statements are not where it comes from.
    const auto changed = [](const ItemStatement& statement) { return statement.changed; };
    const bool own = std::ranges::any_of(gathered.item.old_statements, changed) ||
                     std::ranges::any_of(gathered.item.new_statements, changed);
    if (!own && !through.empty()) gathered.item.changed_itself = false;
  }
}

/// The places of --map; the first word that is no place of its program, otherwise.
std::optional<std::string> PlacesOf(const DiffSide& old_side, const DiffSide& new_side, const DiffOptions& options,
                                    std::vector<std::pair<ir::Place, ir::Place>>& same) {
  const auto locate = [](const DiffSide& side, const std::string& name) -> std::optional<ir::Place> {
    const std::optional<dialects::Location> location = side.compilation.dialect->locate(side.whole, name);
    if (!location || location->absent || location->cell || location->text_input) return std::nullopt;
    return location->place;
  };
  for (const auto& [old_name, new_name] : options.same) {
    const std::optional<ir::Place> one = locate(old_side, old_name), other = locate(new_side, new_name);
    if (!one) return "--map: '" + old_name + "' is no location of " + old_side.label;
    if (!other) return "--map: '" + new_name + "' is no location of " + new_side.label;
    if (one->type != other->type) return "--map: '" + old_name + "' and '" + new_name + "' have different types";
    same.emplace_back(*one, *other);
  }
  return std::nullopt;
}

}  // namespace

DiffSide MakeDiffSide(std::string label, CompilationRequest request, const std::string& hidden_prefix) {
  DiffSide side{.label = std::move(label),
                .request = request,
                .scenario_base = hidden_prefix.empty() ? request.base_directory : std::string(),
                .hidden_prefix = hidden_prefix,
                .compilation = Compile(request),
                .whole = {}};
  if (!side.compilation.ok() || !side.compilation.has_program) return side;
  side.whole = Compile(request, Stage::kChecked).program;
  for (ir::Routine& routine : side.whole.routines) routine.slices = 1;
  passes::Optimize(side.whole);
  return side;
}

Diff CompareSides(DiffSide& old_side, DiffSide& new_side, const DiffOptions& options) {
  std::vector<std::pair<ir::Place, ir::Place>> same;
  if (std::optional<std::string> wrong = PlacesOf(old_side, new_side, options, same)) return {.refusal = *wrong};
  const prove::Version old_version = prove::MakeVersion(old_side.whole),
                       new_version = prove::MakeVersion(new_side.whole);
  const prove::Match match = MatchCells(old_version, new_version, same);
  std::optional<RandomRuns> runs;  // made when something is not proved equal at once
  prove::CompareLimits limits{.total_ms = options.time_ms, .progress = options.progress};
  const auto find_different = [&](const std::vector<CellId>& cells) {
    runs = RunBoth(old_side, new_side, old_version, new_version, match, cells, options);
    std::vector<CellId> different;
    for (const auto& [cell, difference] : runs->difference_of) different.push_back(cell);
    return different;
  };
  const prove::CompareResult result = CompareVersions(old_version, new_version, match, find_different, limits);
  Diff diff{.invariants = result.invariants, .refusal = result.refusal};
  if (!diff.refusal.empty()) return diff;
  const Named old_named(old_side, old_version), new_named(new_side, new_version);
  std::vector<Gathered> items = Gather(result, old_named, new_named);
  AddCauses(items, old_named, new_named);
  for (Gathered& gathered : items) {
    if (gathered.item.verdict == ItemVerdict::kEqual) {
      ++diff.equal;
      continue;
    }
    const bool shown = gathered.item.verdict == ItemVerdict::kDifferent || gathered.worst->run.has_value();
    if (shown && !gathered.old_cells.empty() && gathered.old_cells.size() == gathered.new_cells.size() && runs) {
      gathered.item.counterexample = FindCounterexample(old_side, new_side,
                                                        {.old_words = old_named.words,
                                                         .new_words = new_named.words,
                                                         .name = gathered.item.name,
                                                         .kind = gathered.item.kind,
                                                         .old_cells = gathered.old_cells,
                                                         .run = gathered.worst->run,
                                                         .runs = *runs,
                                                         .match = match},
                                                        options);
    }
    // A state from which they differ is a difference when it can be set and both were run from it.
    if (gathered.item.verdict == ItemVerdict::kUndecided && gathered.item.counterexample) {
      if (gathered.item.counterexample->confirmed) {
        gathered.item.verdict = ItemVerdict::kDifferent;
      } else {
        gathered.item.counterexample.reset();
      }
    }
    diff.items.push_back(std::move(gathered.item));
  }
  std::ranges::stable_sort(diff.items, {}, &DiffItem::kind);
  return diff;
}

}  // namespace plcxx::driver
