#include "transpiler/dialects/prostep/analysis/accesses.h"

namespace plcxx::prostep {
namespace {

bool IsMemory(const Operand& operand) { return operand.exists() && operand.space() != Space::kNone; }

/// A bit, byte or word operand.
MemoryAccess Plain(const Operand& operand, Access access) {
  MemoryAccess result{.space = operand.space(), .first = operand.number, .bytes = 1, .access = access};
  if (operand.shape() == Shape::kBit) result.bits = static_cast<uint8_t>(1u << operand.bit);
  if (operand.shape() == Shape::kWord) result.bytes = 2;
  result.range = operand.range;
  return result;
}

void AddArguments(const Program& program, const Instruction& instruction, std::vector<MemoryAccess>& accesses) {
  const FunctionInfo& info = Info(*instruction.function);
  const bool writes = info.ax_use == AxUse::kReads;  // what AX holds is stored
  for (uint32_t i = 0; i < info.count; ++i) {
    const Operand& operand = program.Argument(instruction, i);
    if (!IsMemory(operand)) continue;
    const ShapeInfo& shape = Info(info.arguments[i]);
    MemoryAccess access = Plain(operand, shape.access);
    if (info.arguments[i] == ArgumentShape::kBase) {
      access.first = 0;
      access.bytes = BytesOf(operand.space());
      access.access = writes ? Access::kWrite : Access::kRead;
      access.indirect = true;
    } else if (shape.field_bytes != 0) {
      access.bytes = shape.field_bytes;
    }
    accesses.push_back(access);
  }
}

}  // namespace

bool IsDisabled(const Program& program, const Instruction& instruction) {
  if (!instruction.function) return false;
  const FunctionInfo& info = Info(*instruction.function);
  for (uint32_t i = 0; i < info.count; ++i) {
    const bool constant = program.Argument(instruction, i).kind == OperandClass::kK;
    if (constant && Info(info.arguments[i]).constant == Constant::kDisables) return true;
  }
  return false;
}

std::vector<MemoryAccess> AccessesOf(const Program& program, const Instruction& instruction) {
  std::vector<MemoryAccess> accesses;
  const Access access = Info(instruction.op).access;
  if (IsMemory(instruction.operand)) accesses.push_back(Plain(instruction.operand, access));
  if (instruction.function) {
    if (!IsDisabled(program, instruction)) AddArguments(program, instruction, accesses);
    return accesses;
  }
  for (uint32_t i = 0; i < instruction.arguments.count; ++i) {
    const Operand& operand = program.Argument(instruction, i);
    if (IsMemory(operand)) accesses.push_back(Plain(operand, access));
  }
  return accesses;
}

bool MayWrite(const MemoryAccess& access, Space space, uint32_t byte, uint8_t bits) {
  const bool writes = access.access == Access::kWrite || access.access == Access::kReadWrite;
  return writes && access.space == space && access.first <= byte && byte < access.first + access.bytes &&
         (access.bits & bits) != 0;
}

}  // namespace plcxx::prostep
