#include "transpiler/dialects/technol/lowering/moves.h"

#include <string>

#include "transpiler/dialects/technol/lowering/locals.h"
#include "transpiler/dialects/technol/lowering/operands.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

void Moves::Move(const Instruction& instruction) {
  const Operand& target = OperandOf(instruction, 0);
  operands_.Write(target, operands_.ReadAs(OperandOf(instruction, 1), target.width));
}

void Moves::Exchange(const Instruction& instruction) {
  const Operand &first = OperandOf(instruction, 0), &second = OperandOf(instruction, 1);
  const bool first_is_memory = first.kind == OperandKind::kMemory;
  const Operand &memory = first_is_memory ? first : second, &reg = first_is_memory ? second : first;
  if (memory.kind == OperandKind::kMemory) {
    const Operands::Reach reach = operands_.ReachOf(memory);
    const ValueId value = builder_.Load(reach.place, reach.index);
    builder_.Store(reach.place, operands_.Read(reg), reach.index);
    return operands_.Write(reg, value);
  }
  const ValueId left = operands_.Read(first), right = operands_.Read(second);
  operands_.Write(first, right);
  operands_.Write(second, left);
}

void Moves::ZeroExtend(const Instruction& instruction) {
  const Operand& target = OperandOf(instruction, 0);
  const ValueId value = operands_.Read(OperandOf(instruction, 1));
  operands_.Write(target, builder_.ToWidth(value, target.width));
}

void Moves::SignExtend(const Instruction& instruction) {
  const Operand &target = OperandOf(instruction, 0), &source = OperandOf(instruction, 1);
  const ValueId value = operands_.Read(source);
  if (source.width == 8 && target.width == 16) {
    return operands_.Write(target, Pure(OpKind::kSignExtend8To16, {value}));
  }
  operands_.Write(target, builder_.SignedTo32(value));
}

void Moves::ByteToWord() {
  registers_.Write(Register::kAx, Pure(OpKind::kSignExtend8To16, {registers_.Read(Register::kAl)}));
}

void Moves::WordToPair() {
  const ValueId wide = builder_.SignedTo32(registers_.Read(Register::kAx));
  registers_.Write(Register::kDx, Pure(OpKind::kHighHalf32, {wide}));
}

void Moves::WordToDouble() { registers_.Write(Register::kEax, builder_.SignedTo32(registers_.Read(Register::kAx))); }

void Moves::DoubleToPair() {
  const ValueId low = registers_.Read(Register::kEax);
  registers_.Write(Register::kEdx, Pure(OpKind::kArithmeticShiftRight32, {low, builder_.Number(31)}));
}

ir::PlaceId Moves::StackSlot(uint32_t depth, const Operand& reg) {
  const uint32_t slot = frame_.routine->level * kStackWords + depth;
  const bool wide = reg.width == 32;
  return locals_("pushed" + std::to_string(slot) + (wide ? "_wide" : ""), wide ? Type::kI32 : Type::kI16);
}

void Moves::Push(const Instruction& instruction) {
  const Operand& reg = OperandOf(instruction, 0);
  const ir::PlaceId slot = StackSlot(flow_.PushesBefore(frame_.now), reg);
  builder_.Store(slot, operands_.Read(reg));
}

void Moves::Pop(const Instruction& instruction) {
  const Operand& reg = OperandOf(instruction, 0);
  operands_.Write(reg, builder_.Load(StackSlot(flow_.PushesBefore(frame_.now) - 1, reg)));
}

}  // namespace plcxx::technol
