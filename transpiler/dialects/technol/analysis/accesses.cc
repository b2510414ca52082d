#include "transpiler/dialects/technol/analysis/accesses.h"

namespace plcxx::technol {
namespace {

/// Which of its operands an instruction writes.
bool IsWritten(const Instruction& instruction, uint32_t index) {
  const InstructionInfo& info = Info(instruction.op);
  if (info.form == Form::kFlag) return index == 1;
  if (info.form == Form::kExchange) return true;
  return index == 0 && (info.first == Access::kWrite || info.first == Access::kReadWrite);
}

bool IsRead(const Instruction& instruction, uint32_t index) {
  const InstructionInfo& info = Info(instruction.op);
  if (info.form == Form::kFlag) return false;
  if (index > 0) return true;
  return info.first == Access::kRead || info.first == Access::kReadWrite;
}

AccessKind WriteKind(const Program& program, const Instruction& instruction) {
  switch (Info(instruction.op).form) {
    case Form::kWriteBit:
      return AccessKind::kCoil;
    case Form::kFlag:
      return program.OperandOf(instruction, 0).value == 0 ? AccessKind::kClear : AccessKind::kSet;
    case Form::kNone:
    case Form::kBit:
    case Form::kJump:
    case Form::kCall:
    case Form::kWaitLimit:
    case Form::kDelay:
    case Form::kMechanism:
    case Form::kData:
    case Form::kNarrowData:
    case Form::kWideData:
    case Form::kStore:
    case Form::kRotation:
    case Form::kError:
    case Form::kTwo:
    case Form::kOne:
    case Form::kMultiply:
    case Form::kShift:
    case Form::kExchange:
    case Form::kExtend:
    case Form::kStack:
      return AccessKind::kStore;
  }
  PLCXX_UNREACHABLE();
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

void TouchedMemory::Add(const Operand& operand) {
  if (operand.is_activation_bit()) return;
  const bool bit = operand.kind == OperandKind::kBit;
  Bytes& area = areas_[operand.address.area];
  if (!bit && operand.address.index != Register::kNone) {
    area.anywhere = true;
    return;
  }
  if (operand.address.offset < 0) return;
  const auto first = static_cast<size_t>(operand.address.offset), end = first + (bit ? 1 : operand.width / 8);
  if (area.bits.size() < end) area.bits.resize(end);
  for (size_t i = first; i < end; ++i) area.bits[i] |= static_cast<uint8_t>(bit ? 1U << operand.bit : 0xFFU);
}

bool TouchedMemory::Holds(Area area, uint32_t offset, uint32_t bytes, uint8_t bit) const {
  const auto found = areas_.find(area);
  if (found == areas_.end()) return false;
  if (found->second.anywhere) return true;
  const std::vector<uint8_t>& bits = found->second.bits;
  const uint32_t wanted = bit == 8 ? 0xFFU : 1U << bit;
  for (size_t i = offset; i < bits.size() && i < size_t{offset} + bytes; ++i) {
    if ((bits[i] & wanted) != 0) return true;
  }
  return false;
}

}  // namespace plcxx::technol
