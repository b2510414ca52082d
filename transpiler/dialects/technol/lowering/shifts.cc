// Inline assembler: shifts and rotations with their flags (specification 6.9).
//
// With the count in CL a count of 0 changes nothing, flags included (D41): what a flag was before is asked for then.

#include "transpiler/dialects/technol/lowering/internal.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::ValueId;

namespace {

constexpr uint64_t kCountMask = 31;

bool IsLeft(Op op) { return op == Op::kShl || op == Op::kRol || op == Op::kRcl; }

}  // namespace

/// In 32 bits, so that counts above the width work as well.
ValueId Lowering::Shifted(Op op, ValueId value, ValueId count, uint32_t width) {
  if (op == Op::kSar)
    return builder_.ToWidth(builder_.Pure(OpKind::kArithmeticShiftRight32, {builder_.SignedTo32(value), count}), width);
  if (width == 32) return builder_.Pure(IsLeft(op) ? OpKind::kShiftLeft32 : OpKind::kShiftRight32, {value, count});
  const OpKind shift = IsLeft(op) ? OpKind::kShiftLeft16 : OpKind::kShiftRight16;
  return builder_.ToWidth(builder_.Pure(shift, {builder_.ToWidth(value, 16), builder_.ToWidth(count, 16)}), width);
}

/// The last bit that goes out; `count` is 1 to 31.
ValueId Lowering::ShiftedOut(Op op, ValueId value, ValueId count, uint32_t width) {
  if (IsLeft(op)) {  // bit width - count; beyond the width the number wraps, and there is no such bit
    const ValueId bit = builder_.Pure(OpKind::kSub32, {builder_.Number(width), count});
    return builder_.Pure(OpKind::kTestBit32, {builder_.ToWidth(value, 32), bit});
  }
  const ValueId wide = op == Op::kSar ? builder_.SignedTo32(value) : builder_.ToWidth(value, 32);
  return builder_.Pure(OpKind::kTestBit32, {wide, builder_.Pure(OpKind::kSub32, {count, builder_.Number(1)})});
}

void Lowering::Shift(const Instruction& instruction) {
  const Operand& count = tree_.OperandOf(instruction, 1);
  if (count.kind != OperandKind::kConstant) return ShiftByCl(instruction);
  const auto bits = static_cast<uint32_t>(static_cast<uint64_t>(count.value) & kCountMask);
  if (bits != 0) ShiftByConstant(instruction, bits);
}

void Lowering::ShiftByConstant(const Instruction& instruction, uint32_t count) {
  const Operand& target = tree_.OperandOf(instruction, 0);
  const uint32_t width = target.width;
  const Op op = instruction.op;
  const Reach reach = ReachOfTarget(target);
  const ValueId value = ReadAt(target, reach);
  const ValueId result = Shifted(op, value, builder_.Number(count), width);
  WriteAt(target, reach, result);
  const auto out = [&] {
    if (IsLeft(op)) {
      if (count > width) return builder_.Bit(0);
      return builder_.Pure(OpKind::kTestBit32, {builder_.ToWidth(value, 32), builder_.Number(width - count)});
    }
    const ValueId wide = op == Op::kSar ? builder_.SignedTo32(value) : builder_.ToWidth(value, 32);
    return builder_.Pure(OpKind::kTestBit32, {wide, builder_.Number(count - 1)});
  };
  Flag(kCf, out);
  if (count == 1) {
    Flag(kOf, [&] {
      if (op == Op::kSar) return builder_.Bit(0);
      if (op == Op::kShr) return Sign(value, width);
      return builder_.Pure(OpKind::kBitXor, {Sign(result, width), out()});
    });
  }
  ResultFlags(result, width);
}

/// By CL: what the flags are behind a count of 0 is what they were.
void Lowering::ShiftByCl(const Instruction& instruction) {
  const Operand& target = tree_.OperandOf(instruction, 0);
  const uint32_t width = target.width;
  const ValueId count = builder_.Pure(
      OpKind::kAnd32, {builder_.ToWidth(registers_.Read(Register::kCl), 32), builder_.Number(kCountMask)});
  const Reach reach = ReachOfTarget(target);
  const ValueId value = ReadAt(target, reach);
  const ValueId result = Shifted(instruction.op, value, count, width);
  WriteAt(target, reach, result);
  KeepUnless(kCf, count, [&] { return ShiftedOut(instruction.op, value, count, width); });
  KeepUnless(kZf, count, [&] { return IsZero(result, width); });
  KeepUnless(kSf, count, [&] { return Sign(result, width); });
}

void Lowering::Rotate(const Instruction& instruction) {
  const Operand &target = tree_.OperandOf(instruction, 0), &by = tree_.OperandOf(instruction, 1);
  const uint32_t width = target.width;
  const bool left = instruction.op == Op::kRol;
  const bool fixed = by.kind == OperandKind::kConstant;
  const uint64_t bits = fixed ? static_cast<uint64_t>(by.value) & kCountMask : 0;
  if (fixed && bits == 0) return;
  const ValueId count = fixed ? builder_.Number(bits)
                              : builder_.Pure(OpKind::kAnd32, {builder_.ToWidth(registers_.Read(Register::kCl), 32),
                                                               builder_.Number(kCountMask)});
  const Reach reach = ReachOfTarget(target);
  const ValueId value = ReadAt(target, reach);
  const OpKind row = width == 8    ? (left ? OpKind::kRotateLeft8 : OpKind::kRotateRight8)
                     : width == 16 ? (left ? OpKind::kRotateLeft16 : OpKind::kRotateRight16)
                                   : (left ? OpKind::kRotateLeft32 : OpKind::kRotateRight32);
  const ValueId result = builder_.Pure(row, {value, count});
  WriteAt(target, reach, result);
  const auto out = [&] {
    return left ? builder_.Pure(OpKind::kTestBit32, {builder_.ToWidth(result, 32), builder_.Number(0)})
                : Sign(result, width);
  };
  if (!fixed) return KeepUnless(kCf, count, out);
  Flag(kCf, out);
  if (bits != 1) return;
  Flag(kOf, [&] {
    const ValueId other =
        left ? out() : builder_.Pure(OpKind::kTestBit32, {builder_.ToWidth(result, 32), builder_.Number(width - 2)});
    return builder_.Pure(OpKind::kBitXor, {Sign(result, width), other});
  });
}

/// To the right by n is to the left by what n lacks to the width with the carry.
void Lowering::RotateWithCarry(const Instruction& instruction) {
  const Operand &target = tree_.OperandOf(instruction, 0), &by = tree_.OperandOf(instruction, 1);
  const uint32_t width = target.width;
  const bool left = instruction.op == Op::kRcl;
  const bool fixed = by.kind == OperandKind::kConstant;
  const uint64_t bits = fixed ? static_cast<uint64_t>(by.value) & kCountMask : 0;
  if (fixed && bits == 0) return;
  const uint32_t turn = width + 1, turns = 4 * turn;  // more than any count
  ValueId count;
  if (fixed) {
    count = builder_.Number((left ? bits : turns - bits) % turn);
  } else {
    count = builder_.Pure(OpKind::kAnd32,
                          {builder_.ToWidth(registers_.Read(Register::kCl), 32), builder_.Number(kCountMask)});
    if (!left) count = builder_.Pure(OpKind::kSub32, {builder_.Number(turns), count});
  }
  const ValueId carry = FlagValue(kCf);
  const Reach reach = ReachOfTarget(target);
  const ValueId value = ReadAt(target, reach);
  const OpKind rotate = width == 8    ? OpKind::kRotateCarryLeft8
                        : width == 16 ? OpKind::kRotateCarryLeft16
                                      : OpKind::kRotateCarryLeft32;
  const OpKind out = width == 8    ? OpKind::kCarryAfterRotate8
                     : width == 16 ? OpKind::kCarryAfterRotate16
                                   : OpKind::kCarryAfterRotate32;
  const ValueId result = builder_.Pure(rotate, {value, carry, count});
  WriteAt(target, reach, result);
  const auto carry_behind = [&] { return builder_.Pure(out, {value, carry, count}); };
  Flag(kCf, carry_behind);  // a count of 0 leaves it as it was
  if (!fixed || bits != 1) return;
  Flag(kOf, [&] {
    const ValueId other =
        left ? carry_behind()
             : builder_.Pure(OpKind::kTestBit32, {builder_.ToWidth(result, 32), builder_.Number(width - 2)});
    return builder_.Pure(OpKind::kBitXor, {Sign(result, width), other});
  });
}

}  // namespace plcxx::technol
