// Items: the stretches of a region that stay together when it is cut into slices, chunks or priced pieces.
//
// An item goes from one statement's marker to the next one's. What closes a block (Statement.closes_block) belongs to
// the item before it, so that a whole chain DOF..ENDF DOE..ENDE (one If) is one item. Instructions before the first
// marker are an item without a statement.
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::ir {

struct Item {
  uint32_t begin = 0, end = 0;  // indices into the region's instructions, half open
  StatementId statement;        // the first marker's; none for a stretch without marker
};

std::vector<Item> Items(const Program& program, RegionId region);

/// The statement that a loop belongs to: of a jump back the first one that it repeats, else the one that the loop is a
/// part of; none in code of the control.
StatementId StatementOfLoop(const Program& program, InstId loop);

}  // namespace plcxx::ir
