// What an instruction reads and writes, to know which results cannot wait.

#include <algorithm>

#include "transpiler/dialects/host50/lowering_internal.h"

namespace plcxx::host50 {
namespace {

bool Hits(const WriteSet& writes, Area area, uint32_t first, uint32_t last) {
  if (writes.everything) return true;
  return std::ranges::any_of(writes.stretches, [&](const Stretch& stretch) {
    return stretch.area == area && stretch.first <= last && first <= stretch.last;
  });
}

bool Hits(const WriteSet& writes, const Address& address) {
  return Hits(writes, address.area, address.number, address.number);
}

}  // namespace

WriteSet Lowering::WritesOf(const Instruction& instruction) const {
  const InstructionInfo& info = Info(instruction.op);
  WriteSet writes{.everything = instruction.op == Op::kCall, .stretches = {}};
  for (uint32_t i = 0; i < instruction.operands.count; ++i) {
    const Operand& operand = OperandOf(tree_, instruction, i);
    if (operand.kind != OperandKind::kAddress) continue;
    const bool keeps_state = operand.role == OperandRole::kTimer || operand.role == OperandRole::kCounter;
    if (!Writes(operand.role) && !keeps_state) continue;
    const uint32_t count =
        operand.role == OperandRole::kFieldResult ? OperandOf(tree_, instruction, i + 1).bits : uint32_t{1};
    writes.stretches.push_back({operand.address.area, operand.address.number, operand.address.number + count - 1});
  }
  if (info.state == State::kAxis) {
    for (const uint32_t first : {kAxisMove, kAxisPositionMode, kAxisAbsolute, kAxisHoming}) {
      writes.stretches.push_back({Area::kQ, first, first + kAxes - 1});
    }
    writes.stretches.push_back({Area::kQw, kAxisMethod, kAxisMethod + kAxes - 1});
    writes.stretches.push_back({Area::kQf, kAxisSpeed, kAxisPosition + kAxes - 1});
  }
  return writes;
}

bool Lowering::ExprReads(ExprId id, const WriteSet& writes) const {
  const Expr& expr = tree_.exprs[id];
  if (expr.kind == ExprKind::kAddress) return Hits(writes, expr.address);
  return (expr.left.valid() && ExprReads(expr.left, writes)) || (expr.right.valid() && ExprReads(expr.right, writes));
}

/// Of its own operands, not of the results that it takes.
bool Lowering::ReadsOwn(const Instruction& instruction, const WriteSet& writes) const {
  for (uint32_t i = 0; i < instruction.operands.count; ++i) {
    const Operand& operand = OperandOf(tree_, instruction, i);
    if (operand.kind == OperandKind::kAddress && Hits(writes, operand.address)) return true;
    if (operand.kind == OperandKind::kExpression && ExprReads(operand.expr, writes)) return true;
  }
  return false;
}

}  // namespace plcxx::host50
