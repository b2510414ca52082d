// What a comparison leaves out, in the words of its verdict: nobody looked at it, and no claim is made of it.
//
// In: what the proof left out, and the programs as they run. Out: the names, in the Diff, and the sentences about them.
// Not its job: to decide what is left out (prove/diff/one_sided.h).
#pragma once

#include <utility>
#include <vector>

#include "transpiler/prove/diff/one_sided.h"
#include "transpiler/review/diff/diff.h"
#include "transpiler/review/diff/items.h"

namespace plcxx::review::diff {

/// What one version alone has inside is no item, but the verdict says that nobody looked at it.
void NameWhatOneVersionHas(const prove::diff::OneSided& one_sided, const CellWords& old_words,
                           const CellWords& new_words, Diff& diff);

/// Timers, counters and their like are compared in pairs; one that has another name in the new version is found under
/// it by whoever looks. Those of `same` are so by the user's own word.
void NameOtherNumbers(const prove::machine::Version& old_version, const prove::machine::Version& new_version,
                      const prove::diff::Match& match, const std::vector<std::pair<ir::Place, ir::Place>>& same,
                      Diff& diff);

/// What a host answers is compared for every answer; options of the simulated control tell nothing about the program.
void NameOptionsOfSimulation(const DiffSide& old_side, const DiffSide& new_side, Diff& diff);

/// Who puts the new version into a machine that has run the old one: a variable that has moved finds another one's
/// value.
void NameMovedRetentive(const prove::machine::Version& old_version, const prove::machine::Version& new_version,
                        const prove::diff::Match& match, const CellWords& old_words, Diff& diff);

/// What the versions remember between two slices is nothing that they do. The programs are compared with the slow part
/// in one piece, which has no such memory.
void NameBookkeepingOfSlices(const DiffSide& old_side, const DiffSide& new_side,
                             const std::vector<std::pair<ir::Place, ir::Place>>& same, Diff& diff);

}  // namespace plcxx::review::diff
