#include "transpiler/dialects/technol/lowering/entries.h"

#include <utility>

#include "transpiler/dialects/technol/analysis/resume_points.h"

namespace plcxx::technol {
void FindSegments(const Flow& flow, Routine& routine) {
  ResumePoints resumes = ResumePointsOf(flow, routine.instructions);
  routine.entries = std::move(resumes.points);
  routine.goes_back = resumes.goes_back;
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
    flow.ForEachSuccessor(id, [&](InstructionId to, Edge) {
      if (!routine.tail || id < *routine.tail || to >= *routine.tail) return;
      routine.tail_goes_back = true;
      into_last_case |= to >= routine.entries.back();  // which the tail, a part of the same segment, is outside of
    });
  }
  routine.segments_are_cases = !into_last_case;
  if (into_last_case) routine.tail.reset();
}

}  // namespace plcxx::technol
