// Every mention of an operand in a program, in source order, with what the statement does to it.
//
// For checks and documentation. Faulty statements are left out: their faults have been reported.
#pragma once

#include "transpiler/dialects/nc110/syntax/syntax.h"

namespace plcxx::nc110 {

enum class AccessKind : uint8_t {
  kRead,
  kWrite,
  kWriteConstant,
  kPair,  // a parameter: reads the word and the one after it
};

struct Access {
  AccessKind kind = AccessKind::kRead;
  Operand operand;
  source::Range range;
};

constexpr bool IsWrite(AccessKind kind) { return kind == AccessKind::kWrite || kind == AccessKind::kWriteConstant; }

/// The word after `low`: the high byte of a pair.
constexpr Operand HighByteOf(Operand low) {
  low.number = static_cast<uint16_t>(low.number + (low.index + 1) / 4);
  low.index = static_cast<uint8_t>((low.index + 1) % 4);
  return low;
}

template <class Visit>
void ForEachRead(const Program& tree, ExprId id, const Visit& visit) {
  if (!id.valid()) return;
  const Expr& expr = tree.exprs[id];
  if (expr.kind == ExprKind::kOperand && expr.operand.kind != OperandKind::kNone) {
    visit(Access{AccessKind::kRead, expr.operand, expr.range});
  }
  ForEachRead(tree, expr.left, visit);
  ForEachRead(tree, expr.right, visit);
}

/// `visit(Access)`; the target of an assignment comes before its expression.
template <class Visit>
void ForEachAccess(const Program& tree, const Assignment& assignment, const Visit& visit) {
  if (assignment.target.operand.kind == OperandKind::kNone) return;
  const bool constant = assignment.value.valid() && tree.exprs[assignment.value].kind == ExprKind::kConstant;
  visit(Access{constant ? AccessKind::kWriteConstant : AccessKind::kWrite, assignment.target.operand,
               assignment.target.range});
  if (assignment.parameter.valid()) {
    const Expr& parameter = tree.exprs[assignment.parameter];
    if (parameter.kind == ExprKind::kOperand && parameter.operand.kind == OperandKind::kWord) {
      visit(Access{AccessKind::kPair, parameter.operand, parameter.range});
    }
  }
  ForEachRead(tree, assignment.value, visit);
  if (!assignment.mux.valid()) return;
  const Mux& mux = tree.muxes[assignment.mux];
  for (uint32_t i = mux.first; i < mux.first + mux.count; ++i) {
    ForEachRead(tree, tree.mux_inputs[i].word, visit);
    ForEachRead(tree, tree.mux_inputs[i].selector, visit);
  }
}

template <class Visit>
void ForEachAccess(const Program& tree, const Visit& visit) {
  for (const Item& item : tree.items) {
    if (item.faulty) continue;
    if (item.kind == ItemKind::kAssignment) ForEachAccess(tree, tree.assignments[item.assignment()], visit);
    if (item.kind == ItemKind::kBlockHead) ForEachRead(tree, tree.blocks[item.block()].condition, visit);
  }
}

}  // namespace plcxx::nc110
