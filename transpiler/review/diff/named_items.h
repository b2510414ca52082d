// The items of a comparison: its pairs of cells, put together by the names that people use for them.
//
// In: the verdicts of all pairs. Out: one item for each name, with the worst of its cells' verdicts. Not its job: why
// an item differs (causes.h), runs that show it (examples.h).
#pragma once

#include <map>
#include <set>
#include <vector>

#include "transpiler/prove/diff/compare.h"
#include "transpiler/review/diff/diff.h"
#include "transpiler/review/diff/items.h"

namespace plcxx::review::diff {

/// One version with all that names and causes need.
struct Named {
  Named(const DiffSide& diff_side, const prove::machine::Version& side_version)
      : side(diff_side),
        compilation(diff_side.compilation),
        version(side_version),
        words(version, compilation),
        accesses(AccessesOf(version)),
        heads(HeadsOf(version)) {}

  const DiffSide& side;
  const compilation::Compilation& compilation;
  const prove::machine::Version& version;
  CellWords words;
  std::vector<StatementAccess> accesses;
  std::map<ir::StatementId, std::set<ir::StatementId>> heads;
};

/// All cells of one name, with the worst verdict of them.
struct NamedItem {
  DiffItem item;
  std::vector<execute::CellId> old_cells, new_cells;
  const prove::diff::PairResult* worst = nullptr;
};

/// Of all pairs that a version writes; `result` outlives the items.
std::vector<NamedItem> MakeItems(const prove::diff::CompareResult& result, const Named& old_side,
                                 const Named& new_side);

/// The order of calls is news where no function by itself is called otherwise; that of the calls which answers depend
/// on is no news of its own, for it is part of the other one. `cells`: of the old version.
void DropOrderOfCalls(std::vector<NamedItem>& items, const execute::Cells& cells);

}  // namespace plcxx::review::diff
