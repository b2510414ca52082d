#include "transpiler/dialects/technol/lowering/entries.h"

#include <algorithm>

namespace plcxx::technol {
namespace {

void FindEntries(const Flow& flow, Routine& routine) {
  std::vector<InstructionId>& entries = routine.entries;
  const auto add = [&](InstructionId id) {
    if (id == routine.instructions.front()) return;  // step 0
    const auto at = std::lower_bound(entries.begin(), entries.end(), id);
    if (at == entries.end() || *at != id) entries.insert(at, id);
  };
  for (const InstructionId id : routine.instructions) {
    if (IsWait(flow.program().instructions[id].op)) add(flow.ResumeOf(id));
  }
  // Each new one may be between another jump and its label.
  for (size_t count = 0; count != entries.size();) {
    count = entries.size();
    for (const InstructionId id : routine.instructions) {
      flow.ForEachSuccessor(id, [&](InstructionId to, Edge edge) {
        if (edge != Edge::kJump || to > id || routine.SegmentOf(to) == routine.SegmentOf(id)) return;
        routine.goes_back = true;
        add(to);
      });
    }
  }
}

}  // namespace

void FindSegments(const Flow& flow, Routine& routine) {
  FindEntries(flow, routine);
  if (routine.entries.empty()) return;
  for (const InstructionId id : routine.instructions) {
    bool crosses = false;
    flow.ForEachSuccessor(id, [&](InstructionId to, Edge edge) {
      if (edge != Edge::kJump || to <= id || routine.SegmentOf(to) == routine.SegmentOf(id)) return;
      const bool to_end_of_own = routine.SegmentOf(to) == routine.SegmentOf(id) + 1 && routine.IsEntry(to);
      const bool to_tail = to > routine.entries.back();
      crosses |= !to_end_of_own && !to_tail;
      if (to_tail && (!routine.tail || to < *routine.tail)) routine.tail = to;
    });
    if (crosses) return;
  }
  bool into_last_case = false;
  for (const InstructionId id : routine.instructions) {
    flow.ForEachSuccessor(id, [&](InstructionId to, Edge edge) {
      if (edge != Edge::kJump || !routine.tail || id < *routine.tail || to >= *routine.tail) return;
      routine.tail_goes_back = true;
      into_last_case |= to >= routine.entries.back();  // which the tail, a part of the same segment, is outside of
    });
  }
  routine.segments_are_cases = !into_last_case;
  if (into_last_case) routine.tail.reset();
}

}  // namespace plcxx::technol
