#include "transpiler/dialects/technol/accesses.h"

namespace plcxx::technol {
namespace {

/// Which of its operands an instruction writes.
bool IsWritten(const Instruction& instruction, uint32_t index) {
  const InstructionInfo& info = Info(instruction.op);
  switch (info.form) {
    case Form::kFlag:
      return index == 1;
    case Form::kExchange:
      return true;
    default:
      return index == 0 && (info.first == Access::kWrite || info.first == Access::kReadWrite);
  }
}

bool IsRead(const Instruction& instruction, uint32_t index) {
  const InstructionInfo& info = Info(instruction.op);
  if (info.form == Form::kFlag) return false;
  if (index > 0) return true;
  return info.first == Access::kRead || info.first == Access::kReadWrite;
}

AccessKind WriteKind(const Program& program, const Instruction& instruction) {
  switch (instruction.op) {
    case Op::kWr:
      return AccessKind::kCoil;
    case Op::kFl:
    case Op::kFl1:
    case Op::kFl0:
      return program.OperandOf(instruction, 0).value == 0 ? AccessKind::kClear : AccessKind::kSet;
    default:
      return AccessKind::kStore;
  }
}

}  // namespace

std::vector<MemoryAccess> AccessesOf(const Program& program) {
  std::vector<MemoryAccess> accesses;
  for (uint32_t i = 0; i < program.instructions.size(); ++i) {
    const Instruction& instruction = program.instructions[InstructionId(i)];
    if (instruction.faulty) continue;
    for (uint32_t k = 0; k < instruction.operands.count; ++k) {
      const Operand& operand = program.OperandOf(instruction, k);
      if (operand.kind != OperandKind::kBit && operand.kind != OperandKind::kMemory) continue;
      if (IsRead(instruction, k)) accesses.push_back({InstructionId(i), AccessKind::kRead, &operand});
      if (IsWritten(instruction, k)) {
        accesses.push_back({InstructionId(i), WriteKind(program, instruction), &operand});
      }
    }
  }
  return accesses;
}

bool Touches(const Operand& operand, Area area, uint32_t offset, uint32_t bytes, uint8_t bit) {
  if (operand.is_activation_bit() || operand.address.area != area) return false;
  if (operand.kind == OperandKind::kBit) {
    const bool inside = operand.address.offset >= offset && operand.address.offset < offset + bytes;
    return inside && (bit == 8 || bit == operand.bit);
  }
  if (operand.address.index != Register::kNone) return true;
  return operand.address.offset < offset + bytes && offset < operand.address.offset + operand.width / 8;
}

}  // namespace plcxx::technol
