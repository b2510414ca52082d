#include "transpiler/dialects/hnc/lowering/expressions.h"

#include <bit>

#include "transpiler/dialects/hnc/lowering/accesses.h"
#include "transpiler/dialects/hnc/lowering/addresses.h"
#include "transpiler/dialects/hnc/lowering/calls.h"
#include "transpiler/dialects/hnc/lowering/conversions.h"
#include "transpiler/dialects/hnc/lowering/intervals.h"
#include "transpiler/dialects/hnc/lowering/locals.h"
#include "transpiler/dialects/hnc/lowering/operators.h"
#include "transpiler/dialects/hnc/lowering/pointers.h"
#include "transpiler/dialects/hnc/lowering/stated_facts.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

namespace {

bool IsRecordType(const Type& type) { return type.kind == TypeKind::kRecord; }

}  // namespace

Value Expressions::Evaluate(ExprId id) {
  // A chain a + b + c nests on its left side without limit: down to its first operand, then up again.
  std::vector<ExprId> spine;
  for (;;) {
    if (!id.valid()) return conversions_.Zero(int_);
    const Expr& expr = ExprAt(id);
    if (expr.constant || !expr.type.valid()) break;
    const bool number = IsArithmetic(TypeAt(expr.type)) && expr.a.valid() && ExprAt(expr.a).type.valid() &&
                        IsArithmetic(TypeAt(ExprAt(expr.a).type));
    const bool chain = expr.kind == ExprKind::kBinary || expr.kind == ExprKind::kConvert ||
                       (expr.kind == ExprKind::kUnary && expr.unary != UnaryOp::kNot);
    if (!number || !chain) break;
    spine.push_back(id);
    id = expr.a;
  }
  Value value = EvaluateLeaf(id);
  for (size_t i = spine.size(); i-- > 0;) {
    const Expr& expr = ExprAt(spine[i]);
    if (expr.kind == ExprKind::kConvert) {
      const bool keeps_bit = value.is_bit && expr.type == int_;
      if (!keeps_bit) value = conversions_.Convert(value, expr.type);
    } else if (expr.kind == ExprKind::kUnary) {
      value = operators_.Unary(expr.unary, value);
    } else {
      value = operators_.Binary(expr.binary, value, Evaluate(expr.b), expr);
    }
  }
  return value;
}

uint32_t Expressions::BaseOf(const Expr& constant) const {
  const std::string_view text = sources_.Text(constant.range);
  return text.starts_with("0x") || text.starts_with("0X") ? 16 : 10;
}

Value Expressions::EvaluateLeaf(ExprId id) {
  const Expr& expr = ExprAt(id);
  if (!expr.type.valid()) return conversions_.Zero(int_);
  if (expr.constant && IsArithmetic(TypeAt(expr.type))) {
    if (IsInteger(TypeAt(expr.type))) {
      return conversions_.Number(expr.constant->integer, expr.type, BaseOf(expr));
    }
    const bool narrow = TypeAt(expr.type).bits == 32;
    const uint64_t bits = narrow ? std::bit_cast<uint32_t>(static_cast<float>(expr.constant->real))
                                 : std::bit_cast<uint64_t>(expr.constant->real);
    return conversions_.Make(builder_.Constant(IrType(expr.type), bits), expr.type);
  }
  switch (expr.kind) {
    case ExprKind::kLoad:
      return accesses_.Load(addresses_.EvaluateLvalue(expr.a));
    case ExprKind::kConvert:
      return conversions_.Convert(Evaluate(expr.a), expr.type);
    case ExprKind::kUnary:
      if (expr.unary == UnaryOp::kNot) return conversions_.FromBit(Pure(OpKind::kBitNot, {Condition(expr.a)}));
      return operators_.Unary(expr.unary, Evaluate(expr.a));
    case ExprKind::kBinary:
      if (expr.binary == BinaryOp::kPointerDifference) return addresses_.PointerDifference(expr);
      if (TypeAt(ExprAt(expr.a).type).kind == TypeKind::kPointer) return addresses_.ComparePointers(expr);
      return conversions_.Zero(expr.type);
    case ExprKind::kAnd:
    case ExprKind::kOr:
      return conversions_.FromBit(Logical(id));
    case ExprKind::kConditional:
      return Conditional(expr);
    case ExprKind::kComma:
      Execute(expr.a);
      return Evaluate(expr.b);
    case ExprKind::kAssign:
      return Assign(id);
    case ExprKind::kCompoundAssign:
      return CompoundAssign(id);
    case ExprKind::kIncrement:
      return Increment(id);
    case ExprKind::kCall: {
      const CallResult result = calls_.Call(id);
      return result.value ? *result.value : conversions_.Zero(IsArithmetic(TypeAt(expr.type)) ? expr.type : int_);
    }
    case ExprKind::kMember:  // of a record value
      if (!expr.is_lvalue) return accesses_.Load(addresses_.EvaluateLvalue(id));
      break;
    case ExprKind::kPoison:
    case ExprKind::kConstant:
    case ExprKind::kString:
    case ExprKind::kVariable:
    case ExprKind::kFunction:
    case ExprKind::kDecay:
    case ExprKind::kCast:
    case ExprKind::kNull:
    case ExprKind::kAddress:
    case ExprKind::kDereference:
    case ExprKind::kIndex:
      break;
  }
  return conversions_.Zero(IsArithmetic(TypeAt(expr.type)) ? expr.type : int_);
}

void Expressions::Execute(ExprId id) {
  if (!id.valid()) return;
  const Expr& expr = ExprAt(id);
  if (!expr.type.valid()) return;
  switch (expr.kind) {
    case ExprKind::kComma:
      Execute(expr.a);
      Execute(expr.b);
      return;
    case ExprKind::kConvert:
    case ExprKind::kCast:
      Execute(expr.a);
      return;
    case ExprKind::kCall:
      calls_.Call(id);
      return;
    case ExprKind::kConditional:
      if (IsSimple(expr.b) && IsSimple(expr.c)) {
        Execute(expr.a);
        return;
      }
      {
        const ValueId condition = Condition(expr.a);
        const Flow before = flow_;
        Flow then;
        builder_.Choose(
            condition,
            [&] {
              intervals_.Refine(expr.a, true);
              Execute(expr.b);
              then = flow_;
            },
            [&] {
              flow_ = before;
              intervals_.Refine(expr.a, false);
              Execute(expr.c);
            });
        flow_.JoinWith(then);
      }
      return;
    case ExprKind::kAnd:
    case ExprKind::kOr:
      if (IsSimple(expr.b)) {
        Execute(expr.a);
        return;
      }
      {
        const bool both = expr.kind == ExprKind::kAnd;
        const ValueId first = Condition(expr.a);
        const Flow before = flow_;
        builder_.When(both ? first : Pure(OpKind::kBitNot, {first}), [&] {
          intervals_.Refine(expr.a, both);
          Execute(expr.b);
        });
        flow_.JoinWith(before);
      }
      return;
    case ExprKind::kIncrement:
      if (TypeAt(expr.type).kind == TypeKind::kPointer) {
        addresses_.EvaluatePointer(id);
      } else {
        Increment(id);
      }
      return;
    case ExprKind::kPoison:
    case ExprKind::kConstant:
    case ExprKind::kString:
    case ExprKind::kVariable:
    case ExprKind::kFunction:
    case ExprKind::kLoad:
    case ExprKind::kDecay:
    case ExprKind::kNull:
    case ExprKind::kUnary:
    case ExprKind::kBinary:
    case ExprKind::kAssign:
    case ExprKind::kCompoundAssign:
    case ExprKind::kAddress:
    case ExprKind::kDereference:
    case ExprKind::kIndex:
    case ExprKind::kMember:
      break;
  }
  const Type& type = TypeAt(expr.type);
  if (type.kind == TypeKind::kPointer) {
    addresses_.EvaluatePointer(id);
  } else if (IsRecordType(type)) {
    addresses_.RecordAddress(id);
  } else if (type.kind != TypeKind::kVoid) {
    Evaluate(id);
  }
}

ValueId Expressions::Condition(ExprId id) {
  const Expr& expr = ExprAt(id);
  if (!expr.type.valid()) return builder_.Bit(0);
  if (expr.constant) {  // a null pointer as well
    return builder_.Bit(IsInteger(TypeAt(expr.type)) ? expr.constant->integer != 0 : expr.constant->real != 0);
  }
  if (TypeAt(expr.type).kind == TypeKind::kPointer) return pointers_.IsNotNull(addresses_.EvaluatePointer(id), id);
  if (expr.kind == ExprKind::kAnd || expr.kind == ExprKind::kOr) return Logical(id);
  return conversions_.AsBit(Evaluate(id));
}

/// a && b && c: what only computes is computed at once, so that the worst scan costs what the mean scan costs.
ValueId Expressions::Logical(ExprId id) {
  const bool both = ExprAt(id).kind == ExprKind::kAnd;
  std::vector<ExprId> operands;
  ExprId left = id;
  while (ExprAt(left).kind == (both ? ExprKind::kAnd : ExprKind::kOr) && !ExprAt(left).constant) {
    operands.push_back(ExprAt(left).b);
    left = ExprAt(left).a;
  }
  ValueId value = Condition(left);
  const Flow before = flow_;
  ExprId so_far = left;
  for (size_t i = operands.size(); i-- > 0;) {
    const ExprId next = operands[i];
    if (IsSimple(next)) {
      value = Pure(both ? OpKind::kBitAnd : OpKind::kBitOr, {value, Condition(next)});
      continue;
    }
    const ir::PlaceId kept = locals_.Add(both ? "both" : "either", ir::Type::kBit);
    builder_.Store(kept, value);
    const Flow outside = flow_;
    builder_.When(both ? value : Pure(OpKind::kBitNot, {value}), [&] {
      intervals_.Refine(so_far, both);
      builder_.Store(kept, Condition(next));
    });
    flow_.JoinWith(outside);
    value = builder_.Load(kept);
    so_far = next;
  }
  return value;
}

Value Expressions::Conditional(const Expr& expr) {
  const ValueId condition = Condition(expr.a);
  const Flow before = flow_;
  if (IsSimple(expr.b) && IsSimple(expr.c)) {
    // Both are computed, each under what holds where it is chosen.
    Value then, otherwise;
    intervals_.Refine(expr.a, true);
    stated_.Where(condition, true, [&] { then = Evaluate(expr.b); });
    flow_ = before;
    intervals_.Refine(expr.a, false);
    stated_.Where(condition, false, [&] { otherwise = Evaluate(expr.c); });
    flow_ = before;
    return operators_.SelectValue(condition, then, otherwise, expr.type);
  }
  const ir::PlaceId kept = locals_.Add("chosen", IrType(expr.type));
  Bounds bounds;
  Flow then;
  builder_.Choose(
      condition,
      [&] {
        intervals_.Refine(expr.a, true);
        const Value value = conversions_.Convert(Evaluate(expr.b), expr.type);
        bounds = value.bounds;
        builder_.Store(kept, value.id);
        then = flow_;
      },
      [&] {
        flow_ = before;
        intervals_.Refine(expr.a, false);
        const Value value = conversions_.Convert(Evaluate(expr.c), expr.type);
        bounds = Join(bounds, value.bounds);
        builder_.Store(kept, value.id);
      });
  flow_.JoinWith(then);
  Value result = conversions_.Make(builder_.Load(kept), expr.type);
  if (IsInteger(TypeAt(expr.type))) result.bounds = bounds;
  return result;
}

Value Expressions::Assign(ExprId id) {
  const Expr& expr = ExprAt(id);
  if (ExprAt(expr.a).kind == ExprKind::kPoison) {
    Execute(expr.b);
    return conversions_.Zero(int_);
  }
  Value value = Evaluate(expr.b);  // the right side first (D55)
  const Lvalue target = addresses_.EvaluateLvalue(expr.a);
  value = conversions_.Convert(value, target.type);
  accesses_.Store(target, value);
  return target.bit_field != nullptr ? accesses_.InBitField(value, target) : value;
}

Value Expressions::CompoundAssign(ExprId id) {
  const Expr& expr = ExprAt(id);
  if (TypeAt(expr.type).kind == TypeKind::kPointer) {
    addresses_.EvaluatePointer(id);
    return conversions_.Zero(int_);
  }
  const Value right = Evaluate(expr.b);
  const Lvalue target = addresses_.EvaluateLvalue(expr.a);
  Value left = accesses_.Load(target);
  if (expr.computation.valid()) left = conversions_.Convert(left, expr.computation);
  const Value result = conversions_.Convert(operators_.Binary(expr.binary, left, right, expr), target.type);
  accesses_.Store(target, result, IndexFault::kRecorded);
  return target.bit_field != nullptr ? accesses_.InBitField(result, target) : result;
}

Value Expressions::Increment(ExprId id) {
  const Expr& expr = ExprAt(id);
  const Lvalue target = addresses_.EvaluateLvalue(expr.a);
  const Value before = accesses_.Load(target);
  const bool up = expr.increment == IncrementOp::kPreIncrement || expr.increment == IncrementOp::kPostIncrement;
  const bool returns_new = expr.increment == IncrementOp::kPreIncrement || expr.increment == IncrementOp::kPreDecrement;
  const Type& type = TypeAt(target.type);
  Value after = before;
  if (type.kind == TypeKind::kReal) {
    const Value one = conversions_.Make(builder_.Constant(ir::Type::kF64, std::bit_cast<uint64_t>(1.0)), double_);
    after = conversions_.Convert(
        operators_.BinaryReal(up ? BinaryOp::kAdd : BinaryOp::kSubtract, conversions_.Convert(before, double_), one),
        target.type);
  } else {
    // In the operand's own width (6.2); a byte is computed as int and narrowed, which is the same.
    const TypeId wide = type.bits == 8 ? int_ : target.type;
    const Value one = conversions_.Number(1, wide);
    const Value widened = conversions_.Convert(before, wide);
    after = conversions_.Convert(operators_.Binary(up ? BinaryOp::kAdd : BinaryOp::kSubtract, widened, one, expr),
                                 target.type);
  }
  accesses_.Store(target, after, IndexFault::kRecorded);
  if (!returns_new) return before;
  return target.bit_field != nullptr ? accesses_.InBitField(after, target) : after;
}

}  // namespace plcxx::hnc
