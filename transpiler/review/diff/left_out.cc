#include "transpiler/review/diff/left_out.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/ir/symbol_names.h"
#include "transpiler/review/diff/groups.h"
#include "transpiler/support/listed.h"

namespace plcxx::review::diff {
namespace {

using execute::CellId;

/// The words of cells, each once, in their order.
std::vector<std::string> NamesOf(const std::vector<CellId>& cells, const CellWords& words) {
  std::vector<std::string> names;
  std::set<std::string> known;
  for (const CellId cell : cells) {
    std::string name = words.WordOf(cell).name;
    if (known.insert(name).second) names.push_back(std::move(name));
  }
  return names;
}

/// Cells of words of which the other version has the lower digits, and those that it has nothing of.
struct Parts {
  std::vector<CellId> whole;
  std::vector<std::string> upper;  // "the upper 16 bits of PARTS"
};
Parts PartsOf(const std::vector<CellId>& cells, const CellWords& words) {
  std::map<std::string, std::vector<CellId>> of_word;
  std::map<std::string, std::vector<CellId>> all_of_word;
  for (const CellId cell : cells) {
    CellWord word = words.WordOf(cell);
    of_word[word.name].push_back(cell);
    all_of_word[word.name] = std::move(word.cells);
  }
  Parts parts;
  std::set<std::string> told;
  for (const CellId cell : cells) {
    const std::string name = words.WordOf(cell).name;
    std::vector<CellId> of_it = of_word[name];
    const std::vector<CellId>& all = all_of_word[name];
    // From the lowest: those that are here are the last ones.
    const bool is_upper =
        of_it.size() < all.size() && std::ranges::all_of(
                                         all,
                                         [&](const CellId& one) {
                                           const bool is_last =
                                               static_cast<size_t>(&one - all.data()) >= all.size() - of_it.size();
                                           return (std::ranges::find(of_it, one) != of_it.end()) == is_last;
                                         });
    if (!is_upper) {
      parts.whole.push_back(cell);
    } else if (told.insert(name).second) {
      parts.upper.push_back("the upper " + std::to_string(of_it.size()) + " bits of " + name);
    }
  }
  return parts;
}

/// By symbol of the sources: its address.
std::map<std::string, std::string> AddressesOf(const ir::Program& program) {
  std::map<std::string, std::string> addresses;
  for (const ir::Documentation& known : program.documentation) {
    if (known.address.empty()) continue;
    ir::ForEachSymbolName(known, [&](std::string_view symbol) { addresses.emplace(symbol, known.address); });
  }
  return addresses;
}

}  // namespace

void NameWhatOneVersionHas(const prove::diff::OneSided& one_sided, const CellWords& old_words,
                           const CellWords& new_words, Diff& diff) {
  diff.old_only = NamesOf(one_sided.old_only, old_words);
  diff.new_only = NamesOf(one_sided.new_only, new_words);
  constexpr size_t kMostRangesOfVerdict = 6;
  const auto tell = [&](const std::vector<CellId>& cells, const CellWords& words, const std::string& version) {
    const Parts parts = PartsOf(cells, words);
    if (!parts.whole.empty()) {
      diff.not_looked_at.push_back("internal memory that only the " + version + " version writes (" +
                                   NamesAsRanges(NamesOf(parts.whole, words), kMostRangesOfVerdict) + ")");
    }
    // It is compared in the digits that both have.
    for (const std::string& upper : parts.upper)
      diff.not_looked_at.push_back(upper + ", which is wider in the " + version + " version");
  };
  tell(one_sided.old_only, old_words, "old");
  tell(one_sided.new_only, new_words, "new");
  const auto tell_values = [&](const std::vector<CellId>& cells, const CellWords& words, const std::string& version) {
    if (cells.empty()) return;
    diff.not_looked_at.push_back("initial values that only the " + version + " version has (" +
                                 NamesAsRanges(NamesOf(cells, words), kMostRangesOfVerdict) + ")");
  };
  tell_values(one_sided.old_values, old_words, "old");
  tell_values(one_sided.new_values, new_words, "new");
}

void NameMovedRetentive(const prove::machine::Version& old_version, const prove::machine::Version& new_version,
                        const prove::diff::Match& match, const CellWords& old_words, Diff& diff) {
  const prove::machine::Uses old_uses = prove::machine::UsesOf(old_version);
  std::vector<CellId> moved;
  for (uint32_t i = 0; i < old_version.cells.calls; ++i) {
    const CellId old_cell(i), new_cell = match.new_of_old[i];
    if (!new_cell.valid() || !(old_uses.reads[i] || old_uses.writes[i])) continue;
    if (!prove::machine::IsRetentive(old_version, old_cell) || !prove::machine::IsRetentive(new_version, new_cell))
      continue;
    const execute::Cell one = execute::CellAt(*old_version.program, old_version.cells, old_cell),
                        other = execute::CellAt(*new_version.program, new_version.cells, new_cell);
    if (one.kind != execute::CellKind::kBit) continue;
    const uint32_t from = old_version.program->spaces[one.space].part_begin + one.offset,
                   to = new_version.program->spaces[other.space].part_begin + other.offset;
    if (from != to || one.bit != other.bit) moved.push_back(old_cell);
  }
  if (moved.empty()) return;
  constexpr size_t kMostRangesOfVerdict = 6;
  diff.not_looked_at.push_back("what the new version finds in memory that the old one kept without power, where " +
                               NamesAsRanges(NamesOf(moved, old_words), kMostRangesOfVerdict) +
                               (NamesOf(moved, old_words).size() == 1 ? " has" : " have") + " another address");
}

void NameOtherNumbers(const prove::machine::Version& old_version, const prove::machine::Version& new_version,
                      const prove::diff::Match& match, const std::vector<std::pair<ir::Place, ir::Place>>& same,
                      Diff& diff) {
  const ir::Program &old_program = *old_version.program, &new_program = *new_version.program;
  // The memory of an edge has no number in any language.
  std::set<ir::StateId> named;
  for (uint32_t i = 0; i < old_program.states.size(); ++i) {
    if (old_program.states[ir::StateId(i)].kind != ir::StateKind::kEdgeMemory) named.insert(ir::StateId(i));
  }
  for (const auto& [one, other] : same) {
    if (one.is_field()) named.erase(one.state);
  }
  constexpr size_t kMostNamed = 6;
  std::vector<std::string> pairs;
  for (const ir::StateId state : named) {
    const CellId found = match.new_of_old[old_version.cells.states[state.index]];
    if (!found.valid()) continue;
    const execute::Cell what = execute::CellAt(new_program, new_version.cells, found);
    const std::string &before = old_program.states[state].name, &after = new_program.states[what.state].name;
    if (before != after) pairs.push_back(before + " as " + after);
  }
  // A symbol says what is one variable, unless it is an input or output; somebody may still go by the address.
  const auto first_cell = [](const prove::machine::Version& version, const ir::Place& place) {
    const bool has_cells = !place.is_field() && !place.indexed && execute::IsInside(*version.program, place);
    return has_cells ? execute::CellsOf(*version.program, version.cells, place).front() : CellId();
  };
  std::set<std::string> followed;  // symbols that are one variable in both
  std::map<std::string, const ir::Place*> addressed;
  for (const ir::Place& place : new_program.places) {
    if (!place.address.empty()) addressed.emplace(place.name, &place);
  }
  for (const ir::Place& place : old_program.places) {
    const auto found = place.address.empty() ? addressed.end() : addressed.find(place.name);
    if (found == addressed.end() || found->second->address == place.address) continue;
    const CellId from = first_cell(old_version, place), to = first_cell(new_version, *found->second);
    if (!from.valid() || !to.valid() || match.new_of_old[from.index] != to) continue;
    pairs.push_back(place.name + " at " + place.address + " as at " + found->second->address);
    followed.insert(place.name);
  }
  if (!pairs.empty()) {
    diff.not_looked_at.push_back("what somebody finds who goes by numbers and addresses, where they are others now (" +
                                 support::Listed(pairs, kMostNamed) + ")");
  }
  std::vector<std::string> moved;
  const std::map<std::string, std::string> after = AddressesOf(new_program);
  for (const auto& [symbol, address] : AddressesOf(old_program)) {
    const auto found = after.find(symbol);
    if (found != after.end() && found->second != address && !followed.contains(symbol))
      moved.push_back(symbol + " at " + address + ", now at " + found->second);
  }
  if (moved.empty()) return;
  diff.not_looked_at.push_back("what somebody finds who goes by names, where they stand for others now (" +
                               support::Listed(moved, kMostNamed) + ")");
}

void NameOptionsOfSimulation(const DiffSide& old_side, const DiffSide& new_side, Diff& diff) {
  const dialects::Dialect& dialect = *old_side.compilation.dialect;
  if (new_side.compilation.dialect != old_side.compilation.dialect) return;
  std::string changed;
  for (const dialects::OptionInfo& option : dialect.options) {
    if (!option.is_of_simulation) continue;
    const auto value = [&option](const DiffSide& side) {
      const auto at = side.compilation.options.find(std::string(option.key));
      return at == side.compilation.options.end() ? std::string("not set") : at->second;
    };
    const std::string before = value(old_side), after = value(new_side);
    if (before == after) continue;
    changed += (changed.empty() ? "" : ", ") + std::string(option.key) + ": " + before + " -> " + after;
  }
  if (!changed.empty()) diff.not_looked_at.push_back("changed options of the simulated control (" + changed + ")");
}

void NameBookkeepingOfSlices(const DiffSide& old_side, const DiffSide& new_side,
                             const std::vector<std::pair<ir::Place, ir::Place>>& same, Diff& diff) {
  const prove::machine::Version old_version = prove::machine::MakeVersion(old_side.compilation.program),
                                new_version = prove::machine::MakeVersion(new_side.compilation.program);
  const prove::machine::Uses old_uses = prove::machine::UsesOf(old_version),
                             new_uses = prove::machine::UsesOf(new_version);
  const prove::diff::Match match = prove::diff::MatchCells(old_version, new_version, same);
  const prove::diff::OneSided found =
      prove::diff::OneSidedMemory(old_version, new_version, old_uses, new_uses, match).Find();
  const auto add = [&diff](const DiffSide& side, const prove::machine::Version& version,
                           const std::vector<CellId>& cells, const std::vector<std::string>& known) {
    for (std::string& name : NamesOf(cells, CellWords(version, side.compilation))) {
      if (std::ranges::find(known, name) == known.end() &&
          std::ranges::find(diff.of_slices, name) == diff.of_slices.end())
        diff.of_slices.push_back(std::move(name));
    }
  };
  add(old_side, old_version, found.old_only, diff.old_only);
  add(new_side, new_version, found.new_only, diff.new_only);
  if (diff.of_slices.empty()) return;
  constexpr size_t kMostRangesOfVerdict = 3;
  diff.not_looked_at.push_back("what one version alone keeps between two slices (" +
                               NamesAsRanges(diff.of_slices, kMostRangesOfVerdict) + ")");
}

}  // namespace plcxx::review::diff
