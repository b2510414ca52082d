#include "transpiler/dialects/technol/lowering/shifts.h"

#include "transpiler/dialects/technol/lowering/flags.h"
#include "transpiler/dialects/technol/lowering/operands.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::ValueId;

namespace {

constexpr uint32_t kCountMask = 31;

constexpr ByWidth kRotateLeft = {OpKind::kRotateLeft8, OpKind::kRotateLeft16, OpKind::kRotateLeft32};
constexpr ByWidth kRotateRight = {OpKind::kRotateRight8, OpKind::kRotateRight16, OpKind::kRotateRight32};
constexpr ByWidth kRotateCarryLeft = {OpKind::kRotateCarryLeft8, OpKind::kRotateCarryLeft16,
                                      OpKind::kRotateCarryLeft32};
constexpr ByWidth kCarryAfterRotate = {OpKind::kCarryAfterRotate8, OpKind::kCarryAfterRotate16,
                                       OpKind::kCarryAfterRotate32};

}  // namespace

std::optional<uint32_t> Shifts::ConstantCount(const Operand& count) {
  if (count.kind != OperandKind::kConstant) return std::nullopt;
  return static_cast<uint32_t>(count.value) & kCountMask;
}

ValueId Shifts::CountInCl() {
  return Pure(OpKind::kAnd32, {builder_.ToWidth(registers_.Read(Register::kCl), 32), builder_.Number(kCountMask)});
}

ValueId Shifts::BitAt(ValueId value, uint32_t bit) {
  return Pure(OpKind::kTestBit32, {builder_.ToWidth(value, 32), builder_.Number(bit)});
}

/// In 32 bits, so that counts above the width work as well.
ValueId Shifts::Shifted(Kind kind, ValueId value, ValueId count, uint32_t width) {
  const bool left = kind == Kind::kLeft;
  if (kind == Kind::kArithmeticRight) {
    return builder_.ToWidth(Pure(OpKind::kArithmeticShiftRight32, {builder_.SignedTo32(value), count}), width);
  }
  if (width == 32) return Pure(left ? OpKind::kShiftLeft32 : OpKind::kShiftRight32, {value, count});
  const OpKind shift = left ? OpKind::kShiftLeft16 : OpKind::kShiftRight16;
  return builder_.ToWidth(Pure(shift, {builder_.ToWidth(value, 16), builder_.ToWidth(count, 16)}), width);
}

ValueId Shifts::ShiftedOut(Kind kind, ValueId value, ValueId count, uint32_t width) {
  if (kind == Kind::kLeft) {  // bit width - count; beyond the width the number wraps, and there is no such bit
    const ValueId bit = Pure(OpKind::kSub32, {builder_.Number(width), count});
    return Pure(OpKind::kTestBit32, {builder_.ToWidth(value, 32), bit});
  }
  const ValueId wide = kind == Kind::kArithmeticRight ? builder_.SignedTo32(value) : builder_.ToWidth(value, 32);
  return Pure(OpKind::kTestBit32, {wide, Pure(OpKind::kSub32, {count, builder_.Number(1)})});
}

void Shifts::Shift(const Instruction& instruction, Kind kind) {
  const std::optional<uint32_t> count = ConstantCount(OperandOf(instruction, 1));
  if (!count) return ShiftByCl(instruction, kind);
  if (*count != 0) ShiftByConstant(instruction, kind, *count);
}

void Shifts::ShiftByConstant(const Instruction& instruction, Kind kind, uint32_t count) {
  const Operand& target = OperandOf(instruction, 0);
  const uint32_t width = target.width;
  const Operands::Reach reach = operands_.ReachOfTarget(target);
  const ValueId value = operands_.ReadAt(target, reach);
  const ValueId result = Shifted(kind, value, builder_.Number(count), width);
  operands_.WriteAt(target, reach, result);
  const auto out = [&] {
    if (kind == Kind::kLeft) return count > width ? builder_.Bit(0) : BitAt(value, width - count);
    const ValueId wide = kind == Kind::kArithmeticRight ? builder_.SignedTo32(value) : builder_.ToWidth(value, 32);
    return Pure(OpKind::kTestBit32, {wide, builder_.Number(count - 1)});
  };
  flags_.Set(kCf, out);
  if (count == 1) {
    flags_.Set(kOf, [&] {
      if (kind == Kind::kArithmeticRight) return builder_.Bit(0);
      if (kind == Kind::kRight) return flags_.SignOf(value, width);
      return Pure(OpKind::kBitXor, {flags_.SignOf(result, width), out()});
    });
  }
  flags_.SetResult(result, width);
}

/// What the flags are after a count of 0 is what they were.
void Shifts::ShiftByCl(const Instruction& instruction, Kind kind) {
  const Operand& target = OperandOf(instruction, 0);
  const uint32_t width = target.width;
  const ValueId count = CountInCl();
  const Operands::Reach reach = operands_.ReachOfTarget(target);
  const ValueId value = operands_.ReadAt(target, reach);
  const ValueId result = Shifted(kind, value, count, width);
  operands_.WriteAt(target, reach, result);
  flags_.SetUnlessZero(kCf, count, [&] { return ShiftedOut(kind, value, count, width); });
  flags_.SetUnlessZero(kZf, count, [&] { return flags_.IsZero(result, width); });
  flags_.SetUnlessZero(kSf, count, [&] { return flags_.SignOf(result, width); });
}

void Shifts::Rotate(const Instruction& instruction, Turn turn) {
  const Operand& target = OperandOf(instruction, 0);
  const uint32_t width = target.width;
  const bool left = turn == Turn::kLeft;
  const std::optional<uint32_t> bits = ConstantCount(OperandOf(instruction, 1));
  if (bits == 0U) return;
  const ValueId count = bits ? builder_.Number(*bits) : CountInCl();
  const Operands::Reach reach = operands_.ReachOfTarget(target);
  const ValueId value = operands_.ReadAt(target, reach);
  const ValueId result = Pure((left ? kRotateLeft : kRotateRight).At(width), {value, count});
  operands_.WriteAt(target, reach, result);
  const auto out = [&] { return left ? BitAt(result, 0) : flags_.SignOf(result, width); };
  if (!bits) return flags_.SetUnlessZero(kCf, count, out);
  flags_.Set(kCf, out);
  if (*bits != 1) return;
  flags_.Set(kOf, [&] {
    const ValueId other = left ? out() : BitAt(result, width - 2);
    return Pure(OpKind::kBitXor, {flags_.SignOf(result, width), other});
  });
}

/// To the right by n is to the left by what n lacks to the width with the carry.
void Shifts::RotateWithCarry(const Instruction& instruction, Turn turn) {
  const Operand& target = OperandOf(instruction, 0);
  const uint32_t width = target.width;
  const bool left = turn == Turn::kLeft;
  const std::optional<uint32_t> bits = ConstantCount(OperandOf(instruction, 1));
  if (bits == 0U) return;
  const uint32_t positions = width + 1, full_turns = 4 * positions;  // more than any count
  ValueId count;
  if (bits) {
    count = builder_.Number((left ? *bits : full_turns - *bits) % positions);
  } else {
    count = CountInCl();
    if (!left) count = Pure(OpKind::kSub32, {builder_.Number(full_turns), count});
  }
  const ValueId carry = flags_.Value(kCf);
  const Operands::Reach reach = operands_.ReachOfTarget(target);
  const ValueId value = operands_.ReadAt(target, reach);
  const ValueId result = Pure(kRotateCarryLeft.At(width), {value, carry, count});
  operands_.WriteAt(target, reach, result);
  const auto carry_after = [&] { return Pure(kCarryAfterRotate.At(width), {value, carry, count}); };
  flags_.Set(kCf, carry_after);  // a count of 0 leaves it as it was
  if (bits != 1U) return;
  flags_.Set(kOf, [&] {
    const ValueId other = left ? carry_after() : BitAt(result, width - 2);
    return Pure(OpKind::kBitXor, {flags_.SignOf(result, width), other});
  });
}

}  // namespace plcxx::technol
