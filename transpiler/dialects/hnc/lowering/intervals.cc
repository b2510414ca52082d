#include "transpiler/dialects/hnc/lowering/intervals.h"

#include <algorithm>

#include "transpiler/dialects/hnc/analysis/loop_counts.h"
#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/support/check.h"

namespace plcxx::hnc {

std::optional<Cell> Intervals::CellOf(const Lvalue& lvalue) const {
  if (lvalue.bit_field != nullptr) return std::nullopt;
  if (lvalue.local.valid()) return Cell{objects_.OfVariable(lvalue.local), 0, TypeAt(lvalue.type).size};
  if (lvalue.address.targets.objects.size() != 1 || lvalue.address.index.valid()) return std::nullopt;
  return Cell{lvalue.address.targets.objects.front(), lvalue.address.base, TypeAt(lvalue.type).size};
}

void Intervals::NoteStore(const Lvalue& lvalue, const Value& value) {
  if (lvalue.local.valid()) flow_.unassigned.erase(lvalue.local);
  const std::optional<Cell> cell = CellOf(lvalue);
  if (!cell) {
    for (const ObjectId object : lvalue.address.targets.objects) flow_.Forget(object);
    return;
  }
  flow_.Forget(*cell);
  const Type& type = TypeAt(lvalue.type);
  if (!IsInteger(type) || value.bounds == BoundsOf(type)) return;
  flow_.Learn(*cell, value.bounds, lvalue.local.valid() ? Origin::kTested : Origin::kStored);
}

void Intervals::ForgetAfterCall(const Expr& expr) {
  for (const ObjectId object : facts_.WritesOf(expr).objects) flow_.Forget(object);
}

void Intervals::ForgetWrites(StatementId id) {
  if (!id.valid()) return;
  ForEachExprIn(unit_, id, [&](ExprId part) { ForgetWritesOf(part); });
}

void Intervals::ForgetWritesOf(ExprId id) {
  const Expr& expr = ExprAt(id);
  if (expr.kind == ExprKind::kAssign || expr.kind == ExprKind::kCompoundAssign || expr.kind == ExprKind::kIncrement) {
    if (const std::optional<StaticAddress> at = facts_.AddressOf(expr.a)) {
      flow_.Forget(Cell{at->object, at->offset, std::max(1u, TypeAt(ExprAt(expr.a).type).size)});
      if (TypeAt(ExprAt(expr.a).type).kind == TypeKind::kPointer) flow_.Forget(at->object);
      return;
    }
  }
  for (const ObjectId object : facts_.WritesOf(expr).objects) flow_.Forget(object);
}

Flow Intervals::RefineWaysOut(ExprId condition, bool counts) {
  const Flow evaluated = flow_;
  Refine(condition, false);
  Flow behind = flow_;
  flow_ = evaluated;
  Refine(condition, true);
  if (counts) behind.JoinWith(flow_);
  return behind;
}

bool Intervals::IsLocalObject(ObjectId object) const {
  return objects_[object].kind == ObjectKind::kVariable && !facts_.IsInMemory(VariableId(objects_[object].index));
}

std::optional<Cell> Intervals::CellOfRead(ExprId id) const {
  while (id.valid() && ExprAt(id).kind == ExprKind::kConvert) {
    const Type& from = unit_.TypeOf(ExprAt(id).a);
    const Type& to = unit_.TypeOf(id);
    if (!IsInteger(from) || !IsInteger(to) || !BoundsOf(from).Within(BoundsOf(to))) return std::nullopt;
    id = ExprAt(id).a;
  }
  if (!id.valid() || ExprAt(id).kind != ExprKind::kLoad) return std::nullopt;
  return facts_.IntegerCellOf(ExprAt(id).a);
}

void Intervals::RefineComparison(const Expr& expr, bool holds) {
  const BinaryOp op = holds ? expr.binary : Negated(expr.binary);
  for (const bool turned : {false, true}) {
    const ExprId read = turned ? expr.b : expr.a, limit = turned ? expr.a : expr.b;
    const std::optional<Cell> cell = CellOfRead(read);
    if (!cell || !limit.valid() || !IsInteger(unit_.TypeOf(limit))) continue;
    // What is known of the cell keeps its origin; what it is compared with must hold for good.
    const Bounds now = BoundsOfExpr(read, Origin::kStored), other = BoundsOfExpr(limit, Origin::kTested);
    Bounds bounds = now;
    const bool upward = op == BinaryOp::kGreater || op == BinaryOp::kGreaterEqual;
    switch (op) {
      case BinaryOp::kLess:
      case BinaryOp::kLessEqual:
      case BinaryOp::kGreater:
      case BinaryOp::kGreaterEqual: {
        const int64_t strict = op == BinaryOp::kLess || op == BinaryOp::kGreater ? 1 : 0;
        if (upward != turned) {
          bounds.low = std::max(bounds.low, other.low + strict);
        } else {
          bounds.high = std::min(bounds.high, other.high - strict);
        }
        break;
      }
      case BinaryOp::kEqual:
        bounds = {std::max(now.low, other.low), std::min(now.high, other.high)};
        break;
      case BinaryOp::kNotEqual:
        if (other.IsOne() && bounds.low == other.low) ++bounds.low;
        if (other.IsOne() && bounds.high == other.low) --bounds.high;
        break;
      case BinaryOp::kAdd:
      case BinaryOp::kSubtract:
      case BinaryOp::kMultiply:
      case BinaryOp::kDivide:
      case BinaryOp::kRemainder:
      case BinaryOp::kShiftLeft:
      case BinaryOp::kShiftRight:
      case BinaryOp::kBitAnd:
      case BinaryOp::kBitXor:
      case BinaryOp::kBitOr:
      case BinaryOp::kPointerAdd:
      case BinaryOp::kPointerSubtract:
      case BinaryOp::kPointerDifference:
        break;
    }
    if (bounds.low <= bounds.high && bounds != now) flow_.Narrow(*cell, bounds);
  }
}

void Intervals::Refine(ExprId condition, bool holds) {
  std::vector<ExprId> open = {condition};
  while (!open.empty()) {
    const ExprId id = open.back();
    open.pop_back();
    if (!ExprAt(id).type.valid()) continue;
    const Expr& expr = ExprAt(id);
    switch (expr.kind) {
      case ExprKind::kAnd:
      case ExprKind::kOr:
        if (holds != (expr.kind == ExprKind::kAnd) || !IsSimple(expr.b)) break;  // either side may be why
        open.push_back(expr.b);
        open.push_back(expr.a);
        break;
      case ExprKind::kUnary:
        if (expr.unary == UnaryOp::kNot && open.empty()) {
          holds = !holds;
          open.push_back(expr.a);
        }
        break;
      case ExprKind::kBinary:
        if (IsComparison(expr.binary) && IsSimple(id)) {
          RefineComparison(expr, holds);
        }
        break;
      case ExprKind::kLoad:
      case ExprKind::kConvert: {
        const std::optional<Cell> cell = CellOfRead(id);
        if (!cell) break;
        Bounds bounds = BoundsOfExpr(id, Origin::kStored);
        if (!holds && bounds.Holds(0)) {
          flow_.Narrow(*cell, {0, 0});
        } else if (holds && bounds.low == 0 && bounds.high > 0) {
          flow_.Narrow(*cell, {1, bounds.high});
        }
        break;
      }
      case ExprKind::kPoison:
      case ExprKind::kConstant:
      case ExprKind::kString:
      case ExprKind::kVariable:
      case ExprKind::kFunction:
      case ExprKind::kDecay:
      case ExprKind::kCast:
      case ExprKind::kNull:
      case ExprKind::kConditional:
      case ExprKind::kComma:
      case ExprKind::kAssign:
      case ExprKind::kCompoundAssign:
      case ExprKind::kIncrement:
      case ExprKind::kAddress:
      case ExprKind::kDereference:
      case ExprKind::kIndex:
      case ExprKind::kMember:
      case ExprKind::kCall:
        break;
    }
  }
}

/// What a constant object of the source has from its initialiser, where no store can reach it.
std::optional<Bounds> Intervals::DeclaredBounds(const Cell& cell) const {
  const Object& object = objects_[cell.object];
  if (object.kind != ObjectKind::kVariable) return std::nullopt;
  const Variable& variable = unit_.variables[VariableId(object.index)];
  if (!variable.is_const || !variable.initialised) return std::nullopt;
  for (uint32_t i = 0; i < unit_.functions.size(); ++i) {
    if (facts_.WritesOf(FunctionId(i)).Has(cell.object)) return std::nullopt;
  }
  for (const InitialValue& initial : variable.initial) {
    if (initial.offset != cell.offset || initial.is_bit_field || TypeAt(initial.type).size != cell.size) continue;
    if (!IsInteger(TypeAt(initial.type))) return std::nullopt;  // a union of a real number and an integer
    const std::optional<Constant>& value = ExprAt(initial.value).constant;
    if (!value) return std::nullopt;
    return Bounds{value->integer, value->integer};
  }
  return std::nullopt;
}

Bounds Intervals::BoundsOfExpr(ExprId id, Origin believed) {
  const Expr& expr = ExprAt(id);
  if (!expr.type.valid() || !IsInteger(TypeAt(expr.type))) return {0, 0};
  const Type& type = TypeAt(expr.type);
  const Bounds all = BoundsOf(type);
  if (expr.constant) return {expr.constant->integer, expr.constant->integer};
  switch (expr.kind) {
    case ExprKind::kLoad: {
      if (const Member* field = facts_.BitFieldOf(expr.a))
        return BoundsOf(field->bit_width, TypeAt(field->type).is_signed);
      const std::optional<Cell> cell = facts_.IntegerCellOf(expr.a);
      if (!cell) return all;
      // The same bytes may have been looked at through a type with the other sign.
      const bool all_count = believed != Origin::kTested || IsLocalObject(cell->object);
      std::optional<Bounds> known = all_count ? flow_.Find(*cell) : flow_.FindTested(*cell);
      if (believed == Origin::kDeclared) {
        // A comparison before may have said less of the object than its declaration does.
        const std::optional<Bounds> declared = DeclaredBounds(*cell);
        if (declared) known = known ? Meet(*known, *declared) : declared;
      }
      return known && known->Within(all) ? *known : all;
    }
    case ExprKind::kConvert: {
      if (!IsInteger(unit_.TypeOf(expr.a))) return all;
      const Bounds from = BoundsOfExpr(expr.a, believed);
      return from.Within(all) ? from : all;
    }
    case ExprKind::kBinary: {
      if (!IsInteger(unit_.TypeOf(expr.a))) return all;
      const Bounds a = BoundsOfExpr(expr.a, believed), b = BoundsOfExpr(expr.b, believed);
      const std::optional<Bounds> result = Apply(expr.binary, a, b, type);
      return result && result->Within(all) ? *result : all;
    }
    case ExprKind::kUnary: {
      if (expr.unary == UnaryOp::kNot) return {0, 1};
      const Bounds a = BoundsOfExpr(expr.a, believed);
      const Bounds result = expr.unary == UnaryOp::kMinus        ? Bounds{-a.high, -a.low}
                            : expr.unary == UnaryOp::kComplement ? Bounds{~a.high, ~a.low}
                                                                 : a;
      return result.Within(all) ? result : all;
    }
    case ExprKind::kConditional: {
      const Flow before = flow_;
      Refine(expr.a, true);
      const Bounds then = BoundsOfExpr(expr.b, believed);
      flow_ = before;
      Refine(expr.a, false);
      const Bounds otherwise = BoundsOfExpr(expr.c, believed);
      flow_ = before;
      return Join(then, otherwise);
    }
    case ExprKind::kAnd:
    case ExprKind::kOr:
      return {0, 1};
    case ExprKind::kCall: {
      const std::optional<SystemFunction> system = unit_.functions[expr.function].system;
      if (!system || RowOf(*system).form != FunctionForm::kAbsolute) return ResultOf(expr.function).value_or(all);
      if (!IsInteger(unit_.TypeOf(expr.arguments.front()))) return all;
      return AbsoluteOf(BoundsOfExpr(expr.arguments.front(), believed), type);
    }
    case ExprKind::kPoison:
    case ExprKind::kConstant:
    case ExprKind::kString:
    case ExprKind::kVariable:
    case ExprKind::kFunction:
    case ExprKind::kDecay:
    case ExprKind::kCast:
    case ExprKind::kNull:
    case ExprKind::kComma:
    case ExprKind::kAssign:
    case ExprKind::kCompoundAssign:
    case ExprKind::kIncrement:
    case ExprKind::kAddress:
    case ExprKind::kDereference:
    case ExprKind::kIndex:
    case ExprKind::kMember:
      return all;
  }
  PLCXX_UNREACHABLE();
}

std::optional<Bounds> Intervals::ResultOf(FunctionId function) const {
  const auto found = results_.find(function.index);
  return found == results_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace plcxx::hnc
