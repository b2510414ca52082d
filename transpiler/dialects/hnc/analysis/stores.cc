#include "transpiler/dialects/hnc/analysis/stores.h"

#include <vector>

#include "transpiler/support/low_bits.h"

namespace plcxx::hnc {
namespace {

using support::LowBits;

constexpr uint64_t kAllBits = ~uint64_t{0};

/// Which bits of a store's right side are 0 for certain, and which are those that the cell has already.
class RightSide {
 public:
  RightSide(const Unit& unit, const Facts& facts, const StaticAddress& cell, uint32_t size)
      : unit_(unit), facts_(facts), cell_(cell), size_(size) {}

  /// Bits that may be 1.
  uint64_t Possible(ExprId id) const {
    const Expr& expr = unit_.expressions[id];
    if (!expr.type.valid() || !IsInteger(unit_.types[expr.type])) return kAllBits;
    if (expr.constant) return static_cast<uint64_t>(expr.constant->integer);
    const Type& type = unit_.types[expr.type];
    const uint64_t all = type.is_signed ? kAllBits : LowBits(type.bits);
    if (expr.kind == ExprKind::kConvert || expr.kind == ExprKind::kCast) {
      if (!IsIntegerAt(expr.a)) return all;
      // A sign goes on into the upper bits.
      const uint64_t from = Possible(expr.a);
      const bool may_be_negative = type.is_signed && (from >> (type.bits - 1) & 1) != 0;
      return may_be_negative ? all : from & LowBits(type.bits);
    }
    if (expr.kind == ExprKind::kConditional) return Possible(expr.b) | Possible(expr.c);
    if (expr.kind == ExprKind::kAnd || expr.kind == ExprKind::kOr) return 1;
    if (expr.kind == ExprKind::kUnary) return expr.unary == UnaryOp::kNot ? 1 : all;
    if (expr.kind != ExprKind::kBinary) return all;
    if (IsComparison(expr.binary)) return 1;
    if (expr.binary == BinaryOp::kBitAnd) return Possible(expr.a) & Possible(expr.b);
    if (expr.binary == BinaryOp::kBitOr || expr.binary == BinaryOp::kBitXor) return Possible(expr.a) | Possible(expr.b);
    const std::optional<Constant>& count = unit_.expressions[expr.b].constant;
    if (expr.binary == BinaryOp::kShiftLeft && count && count->integer >= 0 && count->integer < type.bits) {
      const uint64_t moved = Possible(expr.a) << count->integer;
      return type.is_signed && (moved >> (type.bits - 1) & 1) != 0 ? kAllBits : moved & LowBits(type.bits);
    }
    return all;
  }

  /// Bits that are those of the cell, in front of the store and behind it.
  uint64_t Kept(ExprId id) const {
    const Expr& expr = unit_.expressions[id];
    if (expr.constant || !IsIntegerAt(id)) return 0;
    if (expr.kind == ExprKind::kLoad) {
      const std::optional<StaticAddress> at = facts_.AddressOf(expr.a);
      const bool is_cell = at && at->object == cell_.object && at->offset == cell_.offset;
      return is_cell && unit_.types[expr.type].size == size_ ? LowBits(8 * size_) : 0;
    }
    if (expr.kind == ExprKind::kConvert || expr.kind == ExprKind::kCast) {
      return IsIntegerAt(expr.a) ? Kept(expr.a) & LowBits(unit_.types[expr.type].bits) : 0;
    }
    if (expr.kind == ExprKind::kConditional) return Kept(expr.b) & Kept(expr.c);
    if (expr.kind != ExprKind::kBinary) return 0;
    if (expr.binary == BinaryOp::kBitAnd) {
      const auto ones = [this](ExprId side) {
        const std::optional<Constant>& value = unit_.expressions[side].constant;
        return value ? static_cast<uint64_t>(value->integer) : 0;
      };
      return (Kept(expr.a) & ones(expr.b)) | (Kept(expr.b) & ones(expr.a));
    }
    if (expr.binary == BinaryOp::kBitOr || expr.binary == BinaryOp::kBitXor) {
      return (Kept(expr.a) & ~Possible(expr.b)) | (Kept(expr.b) & ~Possible(expr.a));
    }
    return 0;
  }

 private:
  bool IsIntegerAt(ExprId id) const {
    const TypeId type = unit_.expressions[id].type;
    return type.valid() && IsInteger(unit_.types[type]);
  }

  const Unit& unit_;
  const Facts& facts_;
  const StaticAddress cell_;
  const uint32_t size_;
};

}  // namespace

std::optional<ChangedBits> ChangedBy(const Unit& unit, const Facts& facts, const Expr& store) {
  const std::optional<StaticAddress> at = facts.AddressOf(store.a);
  if (!at) return std::nullopt;
  const uint32_t size = unit.types[unit.expressions[store.a].type].size;
  if (size == 0 || size > 8) return std::nullopt;
  const uint64_t all = LowBits(8 * size);
  ChangedBits changed{at->object, at->offset, size, all};
  const RightSide right(unit, facts, *at, size);
  if (store.kind == ExprKind::kAssign) changed.mask = all & ~right.Kept(store.b);
  if (store.kind != ExprKind::kCompoundAssign) return changed;
  if (store.binary == BinaryOp::kBitOr || store.binary == BinaryOp::kBitXor)
    changed.mask = right.Possible(store.b) & all;
  const std::optional<Constant>& value = unit.expressions[store.b].constant;
  if (store.binary == BinaryOp::kBitAnd && value) changed.mask = ~static_cast<uint64_t>(value->integer) & all;
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
