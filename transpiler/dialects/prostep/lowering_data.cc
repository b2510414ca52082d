// L, LD, T and the direct ports (specification 6.4, 6.1.1, 6.2).

#include "transpiler/dialects/prostep/lowering_internal.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::ValueId;

ValueId Lowering::ReadPort(uint32_t port) { return host_(HostCall::kReadPort, {Number(port)}); }

void Lowering::SendLatch(uint32_t port) {
  host_(HostCall::kWritePort, {Number(port), builder_.Load(LatchPlace(port))});
}

/// Beyond the twelve output bytes there are extra cards, which keep no latch.
void Lowering::WritePort(uint32_t port, ValueId byte) {
  if (port < kMostOutputBytes) builder_.Store(LatchPlace(port), byte);
  host_(HostCall::kWritePort, {Number(port), byte});
}

ValueId Lowering::ReadData(const Operand& operand) {
  if (operand.shape() == Shape::kConstant) {
    const uint32_t base = operand.form == NumberForm::kDecimal ? 10 : 16;
    return builder_.Constant(ir::Type::kI16, operand.value, base);
  }
  const bool byte = operand.shape() == Shape::kByte;
  if (operand.space() != Space::kP) {
    return LoadAt(operand.space(), operand.number, byte ? ir::Type::kI8 : ir::Type::kI16);
  }
  const ValueId low = ReadPort(operand.number);
  if (byte) return low;
  const ValueId high = ReadPort(operand.number + 1u);
  return builder_.Pure(OpKind::kPair16, {low, high});
}

void Lowering::WriteData(const Operand& operand, ValueId value) {
  const bool byte = operand.shape() == Shape::kByte;
  if (operand.space() != Space::kP) {
    return StoreAt(operand.space(), operand.number, byte ? ir::Type::kI8 : ir::Type::kI16, value);
  }
  if (byte) return WritePort(operand.number, value);
  WritePort(operand.number, builder_.Pure(OpKind::kLowByte16, {value}));
  WritePort(operand.number + 1u, builder_.Pure(OpKind::kHighByte16, {value}));
}

ValueId Lowering::LowByte() {
  const ValueId word = ax_->Get();
  const ir::Inst& inst = program_[word];
  if (inst.op == OpKind::kWiden8To16) return ValueId(inst.a);
  if (inst.op == OpKind::kWithLowByte16) return ValueId(inst.b);
  if (inst.op == OpKind::kConst) return builder_.Constant(ir::Type::kI8, ir::ConstantValue(inst) & 0xFF, inst.c);
  return builder_.Pure(OpKind::kLowByte16, {word});
}

void Lowering::SetLowByte(ValueId byte) {
  const auto widened = [&] { ax_->Set(builder_.Pure(OpKind::kWiden8To16, {byte})); };
  const std::optional<uint64_t> known = ax_->Known();
  if (known && *known <= 0xFF) return widened();
  ValueId word = ax_->Get();
  const ir::Inst& inst = program_[word];
  if (inst.op == OpKind::kWiden8To16) return widened();
  if (inst.op == OpKind::kWithLowByte16) word = ValueId(inst.a);
  ax_->Set(builder_.Pure(OpKind::kWithLowByte16, {word, byte}));
}

void Lowering::Load(const Instruction& instruction) {
  const ValueId value = ReadData(instruction.operand);
  builder_.SetRange(instruction.whole);
  if (instruction.operand.shape() == Shape::kByte) return SetLowByte(value);
  ax_->Set(value);
}

void Lowering::Transfer(const Operand& target) {
  WriteData(target, target.shape() == Shape::kByte ? LowByte() : ax_->Get());
}

}  // namespace plcxx::prostep
