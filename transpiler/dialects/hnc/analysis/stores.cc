#include "transpiler/dialects/hnc/analysis/stores.h"

#include <vector>

namespace plcxx::hnc {

std::optional<ChangedBits> ChangedBy(const Unit& unit, const Facts& facts, const Expr& store) {
  const std::optional<StaticAddress> at = facts.AddressOf(store.a);
  if (!at) return std::nullopt;
  const uint32_t size = unit.types[unit.expressions[store.a].type].size;
  if (size == 0 || size > 8) return std::nullopt;
  const uint64_t all = size == 8 ? ~uint64_t{0} : (uint64_t{1} << (8 * size)) - 1;
  ChangedBits changed{at->object, at->offset, size, all};
  const bool compound = store.kind == ExprKind::kCompoundAssign && unit.expressions[store.b].constant;
  if (!compound) return changed;
  const auto value = static_cast<uint64_t>(unit.expressions[store.b].constant->integer);
  if (store.binary == BinaryOp::kBitOr || store.binary == BinaryOp::kBitXor) changed.mask = value & all;
  if (store.binary == BinaryOp::kBitAnd) changed.mask = ~value & all;
  return changed;
}

std::optional<ModWord> WordOfG(const Unit& unit, const Objects& objects, const Facts& facts, ExprId lvalue) {
  if (const std::optional<StaticAddress> at = facts.AddressOf(lvalue)) {
    if (!objects.IsArea(at->object, Area::kG)) return std::nullopt;
    return ModWord{at->offset / 2, false};
  }
  const Expr& expr = unit.expressions[lvalue];
  if (expr.kind != ExprKind::kDereference || unit.expressions[expr.a].kind != ExprKind::kLoad) return std::nullopt;
  const Expr& element = unit.expressions[unit.expressions[expr.a].a];
  if (element.kind != ExprKind::kIndex || unit.expressions[element.a].kind != ExprKind::kVariable) return std::nullopt;
  const Variable& table = unit.variables[unit.expressions[element.a].variable];
  if (!table.view || table.view->area != Area::kG) return std::nullopt;
  ModWord found{0, true};
  std::vector<ExprId> open = {element.b};
  while (!open.empty()) {
    const Expr& part = unit.expressions[open.back()];
    open.pop_back();
    if (part.constant) {
      found.word += part.constant->integer;
    } else if (part.kind == ExprKind::kConvert) {
      open.push_back(part.a);
    } else if (part.kind == ExprKind::kBinary && part.binary == BinaryOp::kAdd) {
      open.push_back(part.a);
      open.push_back(part.b);
    }
  }
  return found;
}

}  // namespace plcxx::hnc
