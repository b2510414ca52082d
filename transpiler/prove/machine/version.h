// One program seen as a machine: its cells, and what it does to each of them.
//
// In: a program. Out: for each cell how the host uses it, whether it lives from scan to scan, whether instructions read
// or write it. Not its job: what a part of the period computes (transition.h), a second version (diff/match.h).
#pragma once

#include <set>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/symbolic/execute/cells.h"
#include "transpiler/symbolic/execute/execute.h"

namespace plcxx::prove::machine {

/// A program with its cells.
struct Version {
  const ir::Program* program = nullptr;
  execute::Cells cells;
  /// Short loops that another version has as well (diff/match.h): unknown functions, so that both are equal however
  /// they end.
  std::set<ir::InstId> shared_loops;
};
Version MakeVersion(const ir::Program& program);

/// How the host uses a cell: bits by their zone; fields are internal, calls go out.
ir::Direction DirectionOf(const Version& version, execute::CellId cell);
/// What the control does to it beside the program; nothing to what is no bit of memory.
execute::ControlWrite WhatControlWrites(const Version& version, execute::CellId cell);
/// Whether a cell lives from scan to scan.
bool IsState(const Version& version, execute::CellId cell);
bool IsRetentive(const Version& version, execute::CellId cell);

/// What a program does to each cell, by CellId.
struct Uses {
  std::vector<bool> reads, writes;
  /// Writes of the schedule that may make it 1; any write of what is no internal memory, or is 1 when power comes. What
  /// is written and never set is only taken back by the program (sets.h): somebody else sets it.
  std::vector<bool> sets;
};
Uses UsesOf(const Version& version);

}  // namespace plcxx::prove::machine
