#include "transpiler/dialects/host50/lowering/effects.h"

#include <algorithm>

#include "transpiler/dialects/host50/machine/places.h"

namespace plcxx::host50 {
namespace {

const Operand& OperandAt(const Program& tree, const Instruction& instruction, uint32_t index) {
  PLCXX_CHECK(index < instruction.operands.count);
  return tree.operands[instruction.operands.first + index];
}

bool Hits(const WriteSet& writes, Area area, uint32_t first, uint32_t last) {
  if (writes.everything) return true;
  return std::ranges::any_of(writes.ranges, [&](const AddressRange& range) {
    return range.area == area && range.first <= last && first <= range.last;
  });
}

bool Hits(const WriteSet& writes, const Address& address) {
  return Hits(writes, address.area, address.number, address.number);
}

bool ExprReads(const Program& tree, ExprId id, const WriteSet& writes) {
  const Expr& expr = tree.exprs[id];
  if (expr.kind == ExprKind::kAddress) return Hits(writes, expr.address);
  return (expr.left.valid() && ExprReads(tree, expr.left, writes)) ||
         (expr.right.valid() && ExprReads(tree, expr.right, writes));
}

}  // namespace

WriteSet WritesOf(const Program& tree, const Instruction& instruction) {
  const InstructionInfo& info = Info(instruction.op);
  WriteSet writes{.everything = instruction.op == Op::kCall, .ranges = {}};
  for (uint32_t i = 0; i < instruction.operands.count; ++i) {
    const Operand& operand = OperandAt(tree, instruction, i);
    if (operand.kind != OperandKind::kAddress) continue;
    const bool keeps_state = operand.role == OperandRole::kTimer || operand.role == OperandRole::kCounter;
    if (!Writes(operand.role) && !keeps_state) continue;
    const uint32_t count =
        operand.role == OperandRole::kFieldResult ? OperandAt(tree, instruction, i + 1).bits : uint32_t{1};
    writes.ranges.push_back({operand.address.area, operand.address.number, operand.address.number + count - 1});
  }
  if (info.state == State::kAxis) {
    for (const uint32_t first : {kAxisMove, kAxisPositionMode, kAxisAbsolute, kAxisHoming}) {
      writes.ranges.push_back({Area::kQ, first, first + kAxes - 1});
    }
    writes.ranges.push_back({Area::kQw, kAxisMethod, kAxisMethod + kAxes - 1});
    writes.ranges.push_back({Area::kQf, kAxisSpeed, kAxisPosition + kAxes - 1});
  }
  return writes;
}

bool ReadsOwn(const Program& tree, const Instruction& instruction, const WriteSet& writes) {
  for (uint32_t i = 0; i < instruction.operands.count; ++i) {
    const Operand& operand = OperandAt(tree, instruction, i);
    if (operand.kind == OperandKind::kAddress && Hits(writes, operand.address)) return true;
    if (operand.kind == OperandKind::kExpression && ExprReads(tree, operand.expr, writes)) return true;
  }
  return false;
}

}  // namespace plcxx::host50
