#include "transpiler/dialects/prostep/lowering/operands.h"

#include "transpiler/dialects/prostep/lowering/cells.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::ValueId;

void Operands::SendLatch(uint32_t port) {
  host_(HostCall::kWritePort, {Number(port), builder_.Load(cells_.Latch(port))});
}

/// Beyond the twelve output bytes there are extra cards, which keep no latch.
void Operands::WritePort(uint32_t port, ValueId byte) {
  if (port < kMostOutputBytes) builder_.Store(cells_.Latch(port), byte);
  host_(HostCall::kWritePort, {Number(port), byte});
}

ValueId Operands::Read(const Operand& operand) {
  if (operand.shape() == Shape::kConstant) {
    const uint32_t base = operand.form == NumberForm::kDecimal ? 10 : 16;
    return builder_.Constant(ir::Type::kI16, operand.value, base);
  }
  const bool byte = operand.shape() == Shape::kByte;
  if (operand.space() != Space::kP) {
    return cells_.Load(operand.space(), operand.number, byte ? ir::Type::kI8 : ir::Type::kI16);
  }
  const ValueId low = ReadPort(operand.number);
  if (byte) return low;
  const ValueId high = ReadPort(operand.number + 1u);
  return Pure(OpKind::kPair16, {low, high});
}

void Operands::Write(const Operand& operand, ValueId value) {
  const bool byte = operand.shape() == Shape::kByte;
  if (operand.space() != Space::kP) {
    return cells_.Store(operand.space(), operand.number, byte ? ir::Type::kI8 : ir::Type::kI16, value);
  }
  if (byte) return WritePort(operand.number, value);
  WritePort(operand.number, Pure(OpKind::kLowByte16, {value}));
  WritePort(operand.number + 1u, Pure(OpKind::kHighByte16, {value}));
}

ValueId Operands::Value32(const Operand& operand) {
  const bool zero = settings_.muldiv == MulDiv::kUnsigned;
  if (operand.shape() == Shape::kConstant) {
    return Number(zero ? operand.value : static_cast<uint32_t>(static_cast<int16_t>(operand.value)));
  }
  const ValueId value = Read(operand);
  if (operand.shape() == Shape::kByte) return Pure(OpKind::kWiden8To32, {value});
  return Pure(zero ? OpKind::kWiden16To32 : OpKind::kSignExtend16To32, {value});
}

ValueId Operands::Value16(const Operand& operand) {
  const ValueId value = Read(operand);
  return operand.shape() == Shape::kByte ? Pure(OpKind::kWiden8To16, {value}) : value;
}

ValueId Operands::Value8(const Operand& operand) {
  if (operand.shape() == Shape::kConstant) return Byte(operand.value);
  const ValueId value = Read(operand);
  return operand.shape() == Shape::kByte ? value : Pure(OpKind::kLowByte16, {value});
}

}  // namespace plcxx::prostep
