#include "transpiler/dialects/technol/lowering/data.h"

#include "transpiler/dialects/technol/lowering/faults.h"
#include "transpiler/dialects/technol/lowering/operands.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::ValueId;

namespace {

constexpr Register kDr = Register::kEcx;
constexpr uint64_t kMaxBcd16 = 9'999, kMaxBcd32 = 79'999'999;

}  // namespace

ValueId Data::Dr(uint32_t width) {
  const ValueId whole = registers_.ReadWhole(kDr);
  return frame_.width == 32 ? builder_.ToWidth(whole, width) : builder_.ToWidth(builder_.ToWidth(whole, 16), width);
}

void Data::SetDr(ValueId value, uint32_t width) {
  const ValueId cut = builder_.ToWidth(value, width);
  registers_.WriteWhole(kDr, cut);
}

void Data::Load(const Instruction& instruction) {
  const Operand& operand = OperandOf(instruction, 0);
  const uint32_t width = OperationWidth(16, operand.width);
  SetDr(operands_.ReadAs(operand, width), width);
}

void Data::Store(const Instruction& instruction) {
  const Operand& target = OperandOf(instruction, 0);
  const ValueId value = Dr(target.width);
  operands_.Write(target, value);
}

void Data::Combine(const Instruction& instruction, const ByWidth& operation) {
  const Operand& operand = OperandOf(instruction, 0);
  const uint32_t width = OperationWidth(frame_.width, operand.width);
  const ValueId dr = Dr(width), value = operands_.ReadAs(operand, width);
  SetDr(Pure(operation.At(width), {dr, value}), width);
}

void Data::Multiply(const Instruction& instruction, uint32_t factor_width) {
  const ValueId factor = builder_.ToWidth(Dr(factor_width), 32);
  const ValueId value = operands_.ReadAs(OperandOf(instruction, 0), 32);
  SetDr(Pure(OpKind::kMul32, {factor, value}), 2 * factor_width);
}

/// By zero: all ones, the remainder is 0, and a fault.
void Data::Divide(const Instruction& instruction, uint32_t width) {
  const ValueId dividend = builder_.ToWidth(Dr(width), 32);
  const ValueId divisor = operands_.ReadAs(OperandOf(instruction, 0), 32);
  const auto divide = [&] {
    SetDr(Pure(OpKind::kUnsignedDiv32, {dividend, divisor}), width);
    registers_.Write(Register::kDx, builder_.Low16(Pure(OpKind::kUnsignedRem32, {dividend, divisor})));
  };
  const auto fail = [&] {
    SetDr(builder_.Constant(0xFFFFFFFFU, width, 16), width);
    registers_.Write(Register::kDx, builder_.Constant(0, 16));
    faults_.Report(Fault::kDivide);
  };
  if (const auto known = builder_.KnownValue(divisor)) return *known != 0 ? divide() : fail();
  registers_.Split(Pure(OpKind::kNotEqual32, {divisor, builder_.Number(0)}), divide, fail);
}

void Data::Rotate(const Instruction& instruction, Turn turn) {
  const bool left = turn == Turn::kLeft;
  const Operand& operand = OperandOf(instruction, 0);
  const ValueId dr = Dr(frame_.width);
  if (settings_.rotation == Rotation::kRotate) {
    ValueId count = operands_.ReadAs(operand, 32);
    if (const auto known = builder_.KnownValue(count)) count = builder_.Number(*known % frame_.width);
    const ByWidth rotate = left ? ByWidth{OpKind::kRotateLeft8, OpKind::kRotateLeft16, OpKind::kRotateLeft32}
                                : ByWidth{OpKind::kRotateRight8, OpKind::kRotateRight16, OpKind::kRotateRight32};
    if (builder_.KnownValue(count) != 0) return SetDr(Pure(rotate.At(frame_.width), {dr, count}), frame_.width);
    return SetDr(dr, frame_.width);
  }
  const ValueId count = operand.kind == OperandKind::kConstant && (operand.value < 0 || operand.value > 0xFF)
                            ? builder_.Constant(0xFF, frame_.width)
                            : operands_.ReadAs(operand, frame_.width);
  const ByWidth shift = left ? ByWidth{OpKind::kShiftLeft16, OpKind::kShiftLeft16, OpKind::kShiftLeft32}
                             : ByWidth{OpKind::kShiftRight16, OpKind::kShiftRight16, OpKind::kShiftRight32};
  SetDr(Pure(shift.At(frame_.width), {dr, count}), frame_.width);
}

void Data::Compare(const Instruction& instruction, OpKind comparison) {
  const Operand& operand = OperandOf(instruction, 0);
  const uint32_t width = OperationWidth(frame_.width, operand.width);
  const ValueId dr = Dr(width), value = operands_.ReadAs(operand, width);
  registers_.rlo().Set(Pure(comparison, {builder_.ToWidth(dr, 32), builder_.ToWidth(value, 32)}));
}

void Data::ToBcd() {
  const ValueId dr = Dr(frame_.width);
  if (frame_.width == 16) {
    faults_.ReportWhen(Pure(OpKind::kGreater32, {builder_.ToWidth(dr, 32), builder_.Number(kMaxBcd16)}),
                       Fault::kBcdRange);
    return SetDr(Pure(OpKind::kToBcd16, {dr}), 16);
  }
  const ValueId magnitude = Pure(OpKind::kAbs32, {dr});
  faults_.ReportWhen(Pure(OpKind::kGreater32, {magnitude, builder_.Number(kMaxBcd32)}), Fault::kBcdRange);
  SetDr(Pure(OpKind::kToSignedBcd32, {dr}), 32);
}

void Data::FromBcd() {
  const ValueId dr = Dr(frame_.width);
  const bool word = frame_.width == 16;
  const ValueId digits =
      word ? builder_.ToWidth(dr, 32) : Pure(OpKind::kAnd32, {dr, builder_.Constant(ir::Type::kI32, 0x7FFFFFFF, 16)});
  faults_.ReportWhen(Pure(OpKind::kHasNoDigit32, {digits}), Fault::kBcdDigit);
  SetDr(Pure(word ? OpKind::kFromBcd16 : OpKind::kFromSignedBcd32, {dr}), frame_.width);
}

}  // namespace plcxx::technol
