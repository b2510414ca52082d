#include "transpiler/dialects/technol/analysis/resume_points.h"

#include <algorithm>
#include <utility>

namespace plcxx::technol {

std::vector<InstructionId> InstructionsOf(const Flow& flow, const Root& root) {
  const Program& program = flow.program();
  std::vector<InstructionId> instructions;
  for (uint32_t i = root.at.index; i <= program.units[root.unit].end.index; ++i) {
    const Instruction& instruction = program.instructions[InstructionId(i)];
    const bool own = instruction.unit == root.unit || instruction.mechanism == root.unit;
    if (own && flow.IsReached(InstructionId(i))) instructions.push_back(InstructionId(i));
  }
  return instructions;
}

ResumePoints ResumePointsOf(const Flow& flow, const std::vector<InstructionId>& instructions) {
  ResumePoints result;
  std::vector<InstructionId>& points = result.points;
  const auto add = [&](InstructionId id) {
    if (id == instructions.front()) return;  // the beginning
    const auto at = std::ranges::lower_bound(points, id);
    if (at == points.end() || *at != id) points.insert(at, id);
  };
  for (const InstructionId id : instructions) {
    if (IsWait(flow.program().instructions[id].op)) add(flow.ResumeOf(id));
  }
  // Each new one may be between another jump and its label.
  for (size_t count = 0; count != points.size();) {
    count = points.size();
    for (const InstructionId id : instructions) {
      flow.ForEachSuccessor(id, [&](InstructionId to, Edge edge) {
        if (edge != Edge::kJump || to > id) return;
        if (std::ranges::upper_bound(points, to) == std::ranges::upper_bound(points, id)) return;
        result.goes_back = true;
        add(to);
      });
    }
  }
  return result;
}

}  // namespace plcxx::technol
