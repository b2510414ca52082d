#include "transpiler/dialects/nc110/analysis/warnings.h"

namespace plcxx::nc110 {
namespace {

// U21K0..U22K31 select the messages 1 to 64, W17K3 holds the number of one.
constexpr uint32_t kFirstConnector = 21, kLastConnector = 22, kBitsPerConnector = 32;
constexpr Operand kNumberWord{.kind = OperandKind::kWord, .package = Package::kK, .number = 17, .index = 3};

bool IsMessageConnector(const Operand& operand) {
  return operand.package == Package::kK && operand.number >= kFirstConnector && operand.number <= kLastConnector;
}

}  // namespace

void CheckMessages(const CheckedProgram& program, diag::Engine& diagnostics) {
  if (!program.messages.given) return;
  const Program& tree = program.tree;
  const auto select = [&](uint32_t number, source::Range range, const Operand& by) {
    if (number == 0 || number > kMostTexts || program.messages.defined[number]) return;
    diagnostics.Report(range, diag::Nc110MessageUndefined, number, ToText(by));
  };
  const auto select_constant = [&](ExprId id, const Operand& target) {
    if (!id.valid()) return;
    const Expr& expr = tree.exprs[id];
    if (expr.kind != ExprKind::kConstant) return;
    if (target == kNumberWord) return select(expr.value, expr.range, target);
    const uint32_t first = 1 + (target.number - kFirstConnector) * kBitsPerConnector + target.index * 8u;
    for (uint32_t bit = 0; bit < 8; ++bit) {
      if ((expr.value >> bit & 1) != 0) select(first + bit, expr.range, target);
    }
  };
  for (const Item& item : tree.items) {
    if (item.kind != ItemKind::kAssignment || item.faulty) continue;
    const Assignment& assignment = tree.assignments[item.assignment()];
    const Operand& target = assignment.target.operand;
    if (target.kind == OperandKind::kOutput && IsMessageConnector(target)) {
      select(1 + (target.number - kFirstConnector) * kBitsPerConnector + target.index, assignment.target.range, target);
    }
    if (target.kind != OperandKind::kWord || !(target == kNumberWord || IsMessageConnector(target))) continue;
    select_constant(assignment.value, target);
    if (!assignment.mux.valid()) continue;
    const Mux& mux = tree.muxes[assignment.mux];
    for (uint32_t i = mux.first; i < mux.first + mux.count; ++i) select_constant(tree.mux_inputs[i].word, target);
  }
}

}  // namespace plcxx::nc110
