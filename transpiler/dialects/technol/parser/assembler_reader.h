// Operands of inline assembler (specification 6.9): registers, memory, constants, and whether their sizes match.
#pragma once

#include <cstdint>
#include <optional>

#include "transpiler/dialects/technol/parser/memory_reader.h"
#include "transpiler/dialects/technol/parser/operand_reader.h"

namespace plcxx::technol {

class AssemblerReader : private OperandReader {
 public:
  AssemblerReader(OperandReading& reading, MemoryReader& memory) : OperandReader(reading), memory_(memory) {}

  void ReadTwo();
  void ReadOne();
  /// Register or memory, then a constant or CL.
  void ReadShift();
  void ReadExchange();
  /// A register and what it takes, which is narrower.
  void ReadExtend();
  void ReadStack();

 private:
  enum class Operands : uint8_t { kRegisterOrMemory, kAny };

  void ReadPair(Operands second);
  std::optional<Operand> ReadOperand(Operands allowed);
  std::optional<Operand> ReadRegister();
  std::optional<Operand> ReadShiftCount();
  bool IsForeignOperand();
  void Match(Operand& left, Operand& right);
  bool CheckSize(const Operand& operand);
  bool CheckImmediate(Operand& constant, uint8_t width);

  MemoryReader& memory_;
};

}  // namespace plcxx::technol
