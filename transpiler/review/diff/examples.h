// Which items get a run that shows their difference, and how long its search may take.
//
// In: the items of a comparison, the runs that were found. Out: the items with a counterexample, and undecided where
// what was computed could not be shown. Not its job: making one (runs.h), compiling it (confirm.h).
#pragma once

#include <chrono>
#include <vector>

#include "transpiler/review/diff/named_items.h"
#include "transpiler/review/diff/runs.h"

namespace plcxx::review::diff {

/// Adds counterexamples to those of `items` that differ, the first ones first, until `end`. `runs`: both versions were
/// run beside each other there.
void AddExamples(DiffSide& old_side, DiffSide& new_side, const Named& old_named, const Named& new_named,
                 const prove::diff::Match& match, const RandomRuns& runs, const DiffOptions& options,
                 std::chrono::steady_clock::time_point end, std::vector<NamedItem>& items);

}  // namespace plcxx::review::diff
