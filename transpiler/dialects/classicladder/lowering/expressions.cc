#include "transpiler/dialects/classicladder/lowering/expressions.h"

namespace plcxx::classicladder {

using ir::OpKind;
using ir::ValueId;

namespace {

OpKind OpOf(Relation relation) {
  switch (relation) {
    case Relation::kEqual:
      return OpKind::kEqual32;
    case Relation::kNotEqual:
      return OpKind::kNotEqual32;
    case Relation::kLess:
      return OpKind::kSignedLess32;
    case Relation::kLessEqual:
      return OpKind::kSignedLessEqual32;
    case Relation::kGreater:
      return OpKind::kSignedGreater32;
    case Relation::kGreaterEqual:
      return OpKind::kSignedGreaterEqual32;
  }
  PLCXX_UNREACHABLE();
}

}  // namespace

Signal Expressions::Compare(uint32_t number) {
  const Expression& comparison = tree_.comparisons.at(number);
  if (comparison.empty) return {};
  const ValueId left = Evaluate(comparison, comparison.left);
  const ValueId right = Evaluate(comparison, comparison.right);
  return Signal::Of(builder_.Pure(OpOf(comparison.relation), {left, right}));
}

void Expressions::Operate(uint32_t number) {
  const Expression& operation = tree_.operations.at(number);
  if (operation.empty) return;
  accesses_.WriteNumber(operation.target, Evaluate(operation, operation.right));
}

/// By 0: 2.9 leaves the left side as it is, and the process of 2.10 ends.
ValueId Expressions::Divide(OpKind op, ValueId dividend, ValueId divisor) {
  if (tree_.sizes.version == LinuxCnc::kTwoNine) {
    // The rest of a division by 0 is the dividend anyway.
    return builder_.Pure(op == OpKind::kSignedDiv32 ? OpKind::kQuotientOrDividend32 : op, {dividend, divisor});
  }
  const ir::Inst& inst = program_[divisor];
  const bool known = inst.op == OpKind::kConst && ir::ConstantValue(inst) != 0;
  if (!known) {
    builder_.When(builder_.Pure(OpKind::kEqual32, {divisor, Word(0)}), [&] { faults_.Report(Fault::kDivision); });
  }
  return builder_.Pure(op, {dividend, divisor});
}

/// Squares `base` as often as `exponent` says. After 31 times nothing changes any more: it is 0 or 1.
ValueId Expressions::Power(ValueId base, ValueId exponent) {
  constexpr uint32_t kMostSquares = 31;
  const ir::Inst inst = program_[exponent];
  const bool known = inst.op == OpKind::kConst;
  const auto times = static_cast<int32_t>(ir::ConstantValue(inst));
  ValueId result = base;
  for (uint32_t i = 0; i < kMostSquares; ++i) {
    if (known && times <= static_cast<int32_t>(i)) break;
    const ValueId square = builder_.Pure(OpKind::kMul32, {result, result});
    if (known) {
      result = square;
    } else {
      const ValueId more = builder_.Pure(OpKind::kSignedGreater32, {exponent, Word(i)});
      result = builder_.Pure(OpKind::kSelect32, {more, square, result});
    }
  }
  return result;
}

ValueId Expressions::Evaluate(const Expression& expression, uint32_t node) {
  const ExprNode& at = expression.nodes[node];
  const auto operand = [&](size_t index) { return Evaluate(expression, at.operands[index]); };
  const auto binary = [&](OpKind op) {
    const ValueId left = operand(0);
    return builder_.Pure(op, {left, operand(1)});
  };
  const auto best = [&](OpKind better) {
    ValueId result = operand(0);
    for (size_t i = 1; i < at.operands.size(); ++i) {
      const ValueId next = operand(i);
      result = builder_.Pure(OpKind::kSelect32, {builder_.Pure(better, {next, result}), next, result});
    }
    return result;
  };
  switch (at.kind) {
    case ExprKind::kConstant:
      return Word(at.value);
    case ExprKind::kVariable:
      return accesses_.ReadNumber(at.variable);
    case ExprKind::kNot: {
      const ValueId zero = builder_.Pure(OpKind::kEqual32, {operand(0), Word(0)});
      return builder_.Pure(OpKind::kWiden1To32, {zero});
    }
    case ExprKind::kPower: {
      const ValueId base = operand(0);
      return Power(base, operand(1));
    }
    case ExprKind::kMultiply:
      return binary(OpKind::kMul32);
    case ExprKind::kDivide:
    case ExprKind::kModulo: {
      const ValueId dividend = operand(0);
      return Divide(at.kind == ExprKind::kDivide ? OpKind::kSignedDiv32 : OpKind::kSignedRem32, dividend, operand(1));
    }
    case ExprKind::kAdd:
      return binary(OpKind::kAdd32);
    case ExprKind::kSubtract:
      return binary(OpKind::kSub32);
    case ExprKind::kAnd:
      return binary(OpKind::kAnd32);
    case ExprKind::kOr:
      return binary(OpKind::kOr32);
    case ExprKind::kAbs:
      return builder_.Pure(OpKind::kAbs32, {operand(0)});
    case ExprKind::kMinimum:
      return best(OpKind::kSignedLess32);
    case ExprKind::kMaximum:
      return best(OpKind::kSignedGreater32);
    case ExprKind::kAverage: {
      ValueId sum = operand(0);
      for (size_t i = 1; i < at.operands.size(); ++i) sum = builder_.Pure(OpKind::kAdd32, {sum, operand(i)});
      return builder_.Pure(OpKind::kSignedDiv32, {sum, Word(static_cast<uint32_t>(at.operands.size()))});
    }
  }
  PLCXX_UNREACHABLE();
}

}  // namespace plcxx::classicladder
