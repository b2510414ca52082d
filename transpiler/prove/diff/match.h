// Which cell of one version of a program is which of the other one.
//
// Inputs and outputs are the same when their addresses are. Internal memory is matched by its names first, so that a
// flag or variable may move, then by address, so that it may be renamed; instances by kind and name, then by kind and
// order. A wrong guess makes nothing wrong: what is matched is compared, it only may come out as different. In: two
// programs, and what the user says is the same. Not its job: whether matched cells behave alike.
#pragma once

#include <utility>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/prove/machine/version.h"
#include "transpiler/symbolic/execute/cells.h"

namespace plcxx::prove::diff {

struct Match {
  std::vector<execute::CellId> new_of_old;  // by cell of the old version; none: it is not in the new one
  std::vector<execute::CellId> old_of_new;
  /// By old cell: whether it is in a word that the versions begin with different values of, as another preset. Who sets
  /// some of its bits in both sets two words, which no scenario says.
  std::vector<bool> starts_otherwise;
};

/// `same`: places of the old and the new version that the user says are one (--map).
Match MatchCells(const machine::Version& old_version, const machine::Version& new_version,
                 const std::vector<std::pair<ir::Place, ir::Place>>& same);

/// Notes in both versions which of their short loops the other one has, too: not what they are about, but every word of
/// what they do.
void ShareLoops(machine::Version& old_version, machine::Version& new_version);

/// Whether a matched pair is an input, which anybody may set between two parts: memory that the control writes
/// (inputs of the machine, and what both write), or that a version at least never writes. What both versions write is
/// theirs, and so is what one alone uses and writes.
bool IsInputPair(const machine::Version& old_version, const machine::Version& new_version,
                 const machine::Uses& old_uses, const machine::Uses& new_uses, const Match& match,
                 execute::CellId old_cell);

/// Whether both versions keep the cell without power, so that they may find anything there when power comes for the
/// first time: what an earlier program has left.
bool MayBeKept(const machine::Version& old_version, const machine::Version& new_version, const Match& match,
               execute::CellId old_cell);

/// Old cells that the program sets and the control takes back (machine/requests.h) in both versions.
std::vector<execute::CellId> MatchedRequests(const machine::Version& old_version, const machine::Version& new_version,
                                             const Match& match);

}  // namespace plcxx::prove::diff
