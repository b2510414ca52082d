#include "transpiler/dialects/technol/lowering/arithmetic.h"

#include "transpiler/dialects/technol/lowering/conditions.h"
#include "transpiler/dialects/technol/lowering/flags.h"
#include "transpiler/dialects/technol/lowering/operands.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::ValueId;

namespace {

constexpr ByWidth kAdd = {OpKind::kAdd8, OpKind::kAdd16, OpKind::kAdd32};
constexpr ByWidth kSub = {OpKind::kSub8, OpKind::kSub16, OpKind::kSub32};
constexpr ByWidth kAnd = {OpKind::kAnd8, OpKind::kAnd16, OpKind::kAnd32};
constexpr ByWidth kOr = {OpKind::kOr8, OpKind::kOr16, OpKind::kOr32};
constexpr ByWidth kXor = {OpKind::kXor8, OpKind::kXor16, OpKind::kXor32};
constexpr ByWidth kNot = {OpKind::kNot8, OpKind::kNot16, OpKind::kNot32};
constexpr ByWidth kCarry = {OpKind::kCarryOfAdd8, OpKind::kCarryOfAdd16, OpKind::kCarryOfAdd32};
constexpr ByWidth kBorrow = {OpKind::kBorrowOfSub8, OpKind::kBorrowOfSub16, OpKind::kBorrowOfSub32};
constexpr ByWidth kAddOverflow = {OpKind::kOverflowOfAdd8, OpKind::kOverflowOfAdd16, OpKind::kOverflowOfAdd32};
constexpr ByWidth kSubOverflow = {OpKind::kOverflowOfSub8, OpKind::kOverflowOfSub16, OpKind::kOverflowOfSub32};

}  // namespace

void Arithmetic::HalfCarry(ValueId left, ValueId right, ValueId result) {
  flags_.Set(kAf, [&] {
    return Pure(OpKind::kHalfCarry8,
                {builder_.ToWidth(left, 8), builder_.ToWidth(right, 8), builder_.ToWidth(result, 8)});
  });
}

void Arithmetic::AddOrSubtract(const Instruction& instruction, Sum sum) {
  const Operand& target = OperandOf(instruction, 0);
  const uint32_t width = target.width;
  const bool adds = sum == Sum::kAdd || sum == Sum::kAddWithCarry;
  const bool carries = sum == Sum::kAddWithCarry || sum == Sum::kSubtractWithBorrow;
  if (IsClearing(tree_, instruction)) {
    registers_.Write(target.reg, builder_.Constant(0, width));
    flags_.Undefine(kFlags & ~kZf);  // 0 is what SUB r,r leaves in them
    return flags_.Set(kZf, [&] { return builder_.Bit(1); });
  }
  const Operands::Reach reach = operands_.ReachOfTarget(target);
  const ValueId left = operands_.ReadAt(target, reach);
  const ValueId right = operands_.ReadAs(OperandOf(instruction, 1), width);
  const ByWidth& row = adds ? kAdd : kSub;
  ValueId result = Pure(row.At(width), {left, right});
  if (carries) {
    const ValueId carry = Pure(OpKind::kWiden1To32, {flags_.Value(kCf)});
    result = Pure(row.At(width), {result, builder_.ToWidth(carry, width)});
  }
  if (sum != Sum::kCompare) operands_.WriteAt(target, reach, result);
  flags_.Set(kCf, [&] {
    if (carries) return Pure((adds ? kCarry : kBorrow).At(width), {left, right, result});
    if (adds) return Pure(OpKind::kLess32, {builder_.ToWidth(result, 32), builder_.ToWidth(left, 32)});
    return Pure(OpKind::kLess32, {builder_.ToWidth(left, 32), builder_.ToWidth(right, 32)});
  });
  flags_.Set(kOf, [&] { return Pure((adds ? kAddOverflow : kSubOverflow).At(width), {left, right, result}); });
  HalfCarry(left, right, result);
  flags_.SetResult(result, width);
  if (!adds && !carries) conditions_.Remember(left, right, width);
}

void Arithmetic::Combine(const Instruction& instruction, Logic logic) {
  const Operand& target = OperandOf(instruction, 0);
  const uint32_t width = target.width;
  ValueId result;
  if (IsClearing(tree_, instruction)) {
    result = builder_.Constant(0, width);
    registers_.Write(target.reg, result);
  } else {
    const Operands::Reach reach = operands_.ReachOfTarget(target);
    const ValueId left = operands_.ReadAt(target, reach);
    const ValueId right = operands_.ReadAs(OperandOf(instruction, 1), width);
    const ByWidth& row = logic == Logic::kOr ? kOr : logic == Logic::kXor ? kXor : kAnd;
    // TEST AX,AX and OR AX,AX ask for the value as it is.
    const bool same = left == right && logic != Logic::kXor;
    result = same ? left : Pure(row.At(width), {left, right});
    if (logic != Logic::kTest && !same) operands_.WriteAt(target, reach, result);
  }
  flags_.Undefine(kCf | kOf);  // both are 0
  flags_.SetResult(result, width);
  conditions_.Remember(result, builder_.Constant(0, width), width);
}

void Arithmetic::Count(const Instruction& instruction, Step step) {
  const Operand& target = OperandOf(instruction, 0);
  const uint32_t width = target.width;
  const bool up = step == Step::kUp;
  const Operands::Reach reach = operands_.ReachOfTarget(target);
  const ValueId left = operands_.ReadAt(target, reach);
  const ValueId one = builder_.Constant(1, width);
  const ValueId result = Pure((up ? kAdd : kSub).At(width), {left, one});
  operands_.WriteAt(target, reach, result);
  flags_.Set(kOf, [&] { return Pure((up ? kAddOverflow : kSubOverflow).At(width), {left, one, result}); });
  flags_.Set(kAf, [&] {
    return Pure(OpKind::kHalfCarry8, {builder_.ToWidth(left, 8), builder_.Byte(1), builder_.ToWidth(result, 8)});
  });
  flags_.SetResult(result, width);
}

void Arithmetic::Negate(const Instruction& instruction) {
  const Operand& target = OperandOf(instruction, 0);
  const uint32_t width = target.width;
  const Operands::Reach reach = operands_.ReachOfTarget(target);
  const ValueId value = operands_.ReadAt(target, reach);
  const ValueId zero = builder_.Constant(0, width);
  const ValueId result = Pure(kSub.At(width), {zero, value});
  operands_.WriteAt(target, reach, result);
  flags_.Set(kCf, [&] { return builder_.Not(flags_.IsZero(value, width)); });
  flags_.Set(kOf, [&] { return Pure(kSubOverflow.At(width), {zero, value, result}); });
  flags_.Set(kAf, [&] {
    return Pure(OpKind::kHalfCarry8, {builder_.Byte(0), builder_.ToWidth(value, 8), builder_.ToWidth(result, 8)});
  });
  flags_.SetResult(result, width);
}

void Arithmetic::Invert(const Instruction& instruction) {
  const Operand& target = OperandOf(instruction, 0);
  const Operands::Reach reach = operands_.ReachOfTarget(target);
  operands_.WriteAt(target, reach, Pure(kNot.At(target.width), {operands_.ReadAt(target, reach)}));
}

}  // namespace plcxx::technol
