// Why an item differs: the statements that write it, the changed ones before them, and the items that they read.
//
// In: both versions, the items of a comparison with their cells. Out: the items' statements and what they are
// different through. Not its job: verdicts.
#pragma once

#include <map>
#include <set>
#include <vector>

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
struct Gathered {
  DiffItem item;
  std::vector<execute::CellId> old_cells, new_cells;
  const prove::diff::PairResult* worst = nullptr;
};

void AddCauses(std::vector<Gathered>& items, const Named& old_side, const Named& new_side);

}  // namespace plcxx::review::diff
