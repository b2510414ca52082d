#include "transpiler/review/diff/left_out.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "transpiler/review/diff/groups.h"

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

}  // namespace

void NameWhatOneVersionHas(const prove::diff::OneSided& one_sided, const CellWords& old_words,
                           const CellWords& new_words, Diff& diff) {
  diff.old_only = NamesOf(one_sided.old_only, old_words);
  diff.new_only = NamesOf(one_sided.new_only, new_words);
  constexpr size_t kMostRangesOfVerdict = 6;
  for (const auto& [names, version] : {std::pair(&diff.old_only, "old"), std::pair(&diff.new_only, "new")}) {
    if (names->empty()) continue;
    diff.not_looked_at.push_back("internal memory that only the " + std::string(version) + " version writes (" +
                                 NamesAsRanges(*names, kMostRangesOfVerdict) + ")");
  }
}

void NameBookkeepingOfSlices(const DiffSide& old_side, const DiffSide& new_side,
                             const std::vector<std::pair<ir::Place, ir::Place>>& same, Diff& diff) {
  const prove::machine::Version old_version = prove::machine::MakeVersion(old_side.compilation.program),
                                new_version = prove::machine::MakeVersion(new_side.compilation.program);
  const prove::machine::Uses old_uses = prove::machine::UsesOf(old_version),
                             new_uses = prove::machine::UsesOf(new_version);
  const prove::diff::Match match = prove::diff::MatchCells(old_version, new_version, same);
  const prove::diff::OneSided found =
      prove::diff::OneSidedMemory(old_version, new_version, old_uses, new_uses, match).Written();
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
