// A loop as one unknown function of what it reads: for loops of which nobody knows how often they go round.
//
// Two loops with the same text are the same function of their cells, wherever these lie, so they are equal without
// being unrolled when the cells are; what is said of a summarized loop holds for every loop of that text, the real one
// among them. A cell that it writes and never reads depends on what it reads and on its own value before, so that what
// another part has written there spoils nothing else. In: a loop. Out: its text, what it reads, writes and leaves for.
// Not its job: executing.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/symbolic/execute/cells.h"

namespace plcxx::execute {

struct LoopSummary {
  std::string text;                  // the same for two loops that do the same
  std::vector<ir::ValueId> outside;  // values from around the loop, in the order of their first use
  std::vector<CellId> cells;         // read or written, in the order of their first use
  std::vector<uint32_t> written;     // indices of `cells`, ascending
  std::vector<bool> reads;           // by index of `cells`: the loop looks at what is there
  std::vector<ir::InstId> targets;   // blocks and loops around it for which it leaves, in the order of their first use
  /// It calls a function that sees or writes the state, or goes on with a loop around it: there is no summary.
  bool opaque = false;
};

/// The names of the functions that stand for loops begin with this.
inline constexpr std::string_view kLoopFunction = "loop ";

/// Whether all iterations of a loop with a proven bound have at most `most` instructions.
bool IsShort(const ir::Program& program, const ir::Loop& loop, uint32_t most);

LoopSummary SummarizeLoop(const ir::Program& program, const Cells& cells, ir::InstId loop);

}  // namespace plcxx::execute
