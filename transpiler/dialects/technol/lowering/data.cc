// Data instructions: DR and what it meets (specification 6.5, 6.6).

#include "transpiler/dialects/technol/lowering/internal.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::ValueId;

namespace {

constexpr Register kDr = Register::kEcx;
constexpr uint64_t kMostBcd16 = 9'999, kMostBcd32 = 79'999'999;

}  // namespace

/// dr of 6.1 as `width` bits: what lies above the static width does not count.
ValueId Lowering::Dr(uint32_t width) {
  const ValueId whole = registers_.ReadWhole(kDr);
  return width_ == 32 ? builder_.ToWidth(whole, width) : builder_.ToWidth(builder_.ToWidth(whole, 16), width);
}

void Lowering::SetDr(ValueId value, uint32_t width) {
  const ValueId cut = builder_.ToWidth(value, width);
  registers_.WriteWhole(kDr, cut);
}

void Lowering::Load(const Instruction& instruction) {
  const Operand& operand = tree_.OperandOf(instruction, 0);
  const uint32_t width = OperationWidth(16, operand.width);
  SetDr(ReadAs(operand, width), width);
}

void Lowering::StoreData(const Instruction& instruction) {
  const Operand& target = tree_.OperandOf(instruction, 0);
  const ValueId value = Dr(target.width);
  Write(target, value);
}

void Lowering::Combine(const Instruction& instruction, const ByWidth& operation) {
  const Operand& operand = tree_.OperandOf(instruction, 0);
  const uint32_t width = OperationWidth(width_, operand.width);
  const ValueId dr = Dr(width), value = ReadAs(operand, width);
  SetDr(builder_.Pure(operation.At(width), {dr, value}), width);
}

void Lowering::MultiplyData(const Instruction& instruction) {
  const bool bytes = instruction.op == Op::kMulb;
  const ValueId factor = builder_.ToWidth(Dr(bytes ? 8 : 16), 32);
  const ValueId value = ReadAs(tree_.OperandOf(instruction, 0), 32);
  SetDr(builder_.Pure(OpKind::kMul32, {factor, value}), bytes ? 16 : 32);
}

/// By zero: all ones, the remainder is 0, and a fault.
void Lowering::DivideData(const Instruction& instruction) {
  const uint32_t width = instruction.op == Op::kDivb ? 16 : 32;
  const ValueId dividend = builder_.ToWidth(Dr(width), 32);
  const ValueId divisor = ReadAs(tree_.OperandOf(instruction, 0), 32);
  const auto divide = [&] {
    SetDr(builder_.Pure(OpKind::kUnsignedDiv32, {dividend, divisor}), width);
    registers_.Write(Register::kDx, builder_.Low16(builder_.Pure(OpKind::kUnsignedRem32, {dividend, divisor})));
  };
  const auto fail = [&] {
    SetDr(builder_.Constant(0xFFFFFFFFU, width, 16), width);
    registers_.Write(Register::kDx, builder_.Constant(0, 16));
    CallFault(Fault::kDivide);
  };
  if (const auto known = builder_.KnownValue(divisor)) return *known != 0 ? divide() : fail();
  registers_.Split(builder_.Pure(OpKind::kNotEqual32, {divisor, builder_.Number(0)}), divide, fail);
}

void Lowering::RotateData(const Instruction& instruction) {
  const bool left = instruction.op == Op::kRl;
  const Operand& operand = tree_.OperandOf(instruction, 0);
  const ValueId dr = Dr(width_);
  if (settings_.rotation == Rotation::kRotate) {
    ValueId count = ReadAs(operand, 32);
    if (const auto known = builder_.KnownValue(count)) count = builder_.Number(*known % width_);
    const ByWidth rotate = left ? ByWidth{OpKind::kRotateLeft8, OpKind::kRotateLeft16, OpKind::kRotateLeft32}
                                : ByWidth{OpKind::kRotateRight8, OpKind::kRotateRight16, OpKind::kRotateRight32};
    if (builder_.KnownValue(count) != 0) return SetDr(builder_.Pure(rotate.At(width_), {dr, count}), width_);
    return SetDr(dr, width_);
  }
  const ValueId count = operand.kind == OperandKind::kConstant && (operand.value < 0 || operand.value > 0xFF)
                            ? builder_.Constant(0xFF, width_)
                            : ReadAs(operand, width_);
  const ByWidth shift = left ? ByWidth{OpKind::kShiftLeft16, OpKind::kShiftLeft16, OpKind::kShiftLeft32}
                             : ByWidth{OpKind::kShiftRight16, OpKind::kShiftRight16, OpKind::kShiftRight32};
  SetDr(builder_.Pure(shift.At(width_), {dr, count}), width_);
}

void Lowering::Compare(const Instruction& instruction, OpKind comparison) {
  const Operand& operand = tree_.OperandOf(instruction, 0);
  const uint32_t width = OperationWidth(width_, operand.width);
  const ValueId dr = Dr(width), value = ReadAs(operand, width);
  registers_.rlo().Set(builder_.Pure(comparison, {builder_.ToWidth(dr, 32), builder_.ToWidth(value, 32)}));
}

void Lowering::ToBcd() {
  const ValueId dr = Dr(width_);
  if (width_ == 16) {
    builder_.When(builder_.Pure(OpKind::kGreater32, {builder_.ToWidth(dr, 32), builder_.Number(kMostBcd16)}),
                  [&] { CallFault(Fault::kBcdRange); });
    return SetDr(builder_.Pure(OpKind::kToBcd16, {dr}), 16);
  }
  const ValueId magnitude = builder_.Pure(OpKind::kAbs32, {dr});
  builder_.When(builder_.Pure(OpKind::kGreater32, {magnitude, builder_.Number(kMostBcd32)}),
                [&] { CallFault(Fault::kBcdRange); });
  SetDr(builder_.Pure(OpKind::kToSignedBcd32, {dr}), 32);
}

void Lowering::FromBcd() {
  const ValueId dr = Dr(width_);
  const bool word = width_ == 16;
  const ValueId digits = word ? builder_.ToWidth(dr, 32)
                              : builder_.Pure(OpKind::kAnd32, {dr, builder_.Constant(ir::Type::kI32, 0x7FFFFFFF, 16)});
  builder_.When(builder_.Pure(OpKind::kHasNoDigit32, {digits}), [&] { CallFault(Fault::kBcdDigit); });
  SetDr(builder_.Pure(word ? OpKind::kFromBcd16 : OpKind::kFromSignedBcd32, {dr}), width_);
}

}  // namespace plcxx::technol
