#include "transpiler/dialects/host50/lowering/numbers.h"

#include <bit>

#include "transpiler/dialects/host50/lowering/cells.h"

namespace plcxx::host50 {
namespace {

using ir::OpKind;
using ir::ValueId;

struct RelationRow {
  Op op;  // of a compare block
  ExprKind expr;
  OpKind integer, real;
};
constexpr RelationRow kRelations[] = {
    {Op::kEq, ExprKind::kEqual, OpKind::kEqual32, OpKind::kEqualF32},
    {Op::kNe, ExprKind::kNotEqual, OpKind::kNotEqual32, OpKind::kNotEqualF32},
    {Op::kGt, ExprKind::kGreater, OpKind::kSignedGreater32, OpKind::kGreaterF32},
    {Op::kGe, ExprKind::kGreaterEqual, OpKind::kSignedGreaterEqual32, OpKind::kGreaterEqualF32},
    {Op::kLt, ExprKind::kLess, OpKind::kSignedLess32, OpKind::kLessF32},
    {Op::kLe, ExprKind::kLessEqual, OpKind::kSignedLessEqual32, OpKind::kLessEqualF32},
};

struct OperatorRow {
  ExprKind expr;
  OpKind integer, real;
};
constexpr OperatorRow kOperators[] = {
    {ExprKind::kMultiply, OpKind::kMul32, OpKind::kMulF32},
    {ExprKind::kDivide, OpKind::kQuotientOrDividend32, OpKind::kQuotientOrDividendF32},
    {ExprKind::kAdd, OpKind::kAdd32, OpKind::kAddF32},
    {ExprKind::kSubtract, OpKind::kSub32, OpKind::kSubF32},
    {ExprKind::kAnd, OpKind::kAnd32, OpKind::kPoison},  // integers only: refused by the parser
    {ExprKind::kOr, OpKind::kOr32, OpKind::kPoison},
};

uint32_t AsFloatBits(uint32_t word) { return std::bit_cast<uint32_t>(static_cast<float>(static_cast<int32_t>(word))); }

ir::Type IrType(Type type) { return type == Type::kFloat ? ir::Type::kF32 : ir::Type::kI32; }

}  // namespace

/// A constant beside a float becomes one here, so that it reads as one.
ValueId Numbers::Constant(uint32_t bits, Type type, Type wanted, source::Range spelled) {
  if (type != Type::kFloat && wanted == Type::kFloat) return builder_.Constant(ir::Type::kF32, AsFloatBits(bits));
  if (type == Type::kFloat) return Convert(builder_.Constant(ir::Type::kF32, bits), type, wanted);
  const std::string_view text = sources_.Text(spelled);
  return builder_.Constant(ir::Type::kI32, bits, text.starts_with('$') ? 16 : 10);
}

ValueId Numbers::Convert(ValueId value, Type from, Type to) {
  if (from == to) return value;
  if (to == Type::kFloat) return builder_.Pure(OpKind::kSignedToF32, {value});
  const bool rounds = settings_.ftow == FtowOption::kRound;
  return builder_.Pure(rounds ? OpKind::kRoundF32 : OpKind::kTruncateF32, {value});
}

ValueId Numbers::Of(const Operand& operand, Type wanted) {
  if (operand.kind == OperandKind::kConstant) return Constant(operand.bits, operand.type, wanted, operand.range);
  PLCXX_CHECK(operand.kind == OperandKind::kAddress);
  return Convert(cells_.Load(operand.address), TypeOf(operand.address), wanted);
}

ValueId Numbers::Comparison(const Instruction& instruction) {
  if (instruction.op == Op::kComp) return EvaluateExpr(tree_.exprs[OperandOf(instruction, 0).expr]);
  const Operand& left = OperandOf(instruction, 0);
  const Operand& right = OperandOf(instruction, 1);
  const bool real = left.type == Type::kFloat || right.type == Type::kFloat;
  const Type type = real ? Type::kFloat : Type::kInteger;
  for (const RelationRow& row : kRelations) {
    if (row.op != instruction.op) continue;
    const ValueId a = Of(left, type);
    return builder_.Pure(real ? row.real : row.integer, {a, Of(right, type)});
  }
  PLCXX_UNREACHABLE();
}

ValueId Numbers::Evaluate(ExprId id, Type wanted) {
  const Expr& expr = tree_.exprs[id];
  if (expr.kind == ExprKind::kConstant) return Constant(expr.bits, expr.type, wanted, expr.range);
  return Convert(EvaluateExpr(expr), expr.type, wanted);
}

ValueId Numbers::EvaluateExpr(const Expr& expr) {
  switch (expr.kind) {
    case ExprKind::kConstant:
      return Constant(expr.bits, expr.type, expr.type, expr.range);
    case ExprKind::kAddress: {
      const ValueId value = cells_.Load(expr.address);
      return TypeOf(expr.address) == Type::kBit ? builder_.Pure(OpKind::kWiden1To32, {value}) : value;
    }
    case ExprKind::kNegate: {
      const Expr& operand = tree_.exprs[expr.left];
      if (operand.kind == ExprKind::kConstant) {
        constexpr uint32_t kSign = 0x80000000;
        const bool real = expr.type == Type::kFloat;
        return builder_.Constant(IrType(expr.type), real ? operand.bits ^ kSign : uint32_t{0} - operand.bits);
      }
      const ValueId value = EvaluateExpr(operand);
      if (expr.type == Type::kFloat) return builder_.Pure(OpKind::kNegateF32, {value});
      return builder_.Pure(OpKind::kSub32, {builder_.Constant(ir::Type::kI32, 0), value});
    }
    case ExprKind::kMultiply:
    case ExprKind::kDivide:
    case ExprKind::kAdd:
    case ExprKind::kSubtract:
    case ExprKind::kAnd:
    case ExprKind::kOr:
      for (const OperatorRow& row : kOperators) {
        if (row.expr != expr.kind) continue;
        const ValueId left = Evaluate(expr.left, expr.type);
        return builder_.Pure(expr.type == Type::kFloat ? row.real : row.integer,
                             {left, Evaluate(expr.right, expr.type)});
      }
      break;
    case ExprKind::kGreater:
    case ExprKind::kLess:
    case ExprKind::kGreaterEqual:
    case ExprKind::kLessEqual:
    case ExprKind::kEqual:
    case ExprKind::kNotEqual: {
      const bool real = tree_.exprs[expr.left].type == Type::kFloat || tree_.exprs[expr.right].type == Type::kFloat;
      const Type type = real ? Type::kFloat : Type::kInteger;
      for (const RelationRow& row : kRelations) {
        if (row.expr != expr.kind) continue;
        const ValueId left = Evaluate(expr.left, type);
        return builder_.Pure(real ? row.real : row.integer, {left, Evaluate(expr.right, type)});
      }
      break;
    }
    case ExprKind::kError:
      break;  // reported: nothing is lowered
  }
  PLCXX_UNREACHABLE();
}

}  // namespace plcxx::host50
