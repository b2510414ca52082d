// All operands of one instruction, by its Form.
#pragma once

#include "transpiler/dialects/technol/parser/assembler_reader.h"
#include "transpiler/dialects/technol/parser/bit_reader.h"
#include "transpiler/dialects/technol/parser/data_operand_reader.h"
#include "transpiler/dialects/technol/parser/memory_reader.h"
#include "transpiler/dialects/technol/parser/operand_reader.h"
#include "transpiler/dialects/technol/parser/target_reader.h"
#include "transpiler/dialects/technol/parser/timer_reader.h"

namespace plcxx::technol {

class InstructionReader : private OperandReader {
 public:
  explicit InstructionReader(OperandReading& reading)
      : OperandReader(reading),
        memory_(reading),
        bits_(reading),
        targets_(reading),
        data_(reading, memory_),
        timers_(reading, memory_, data_),
        assembler_(reading, memory_) {}
  InstructionReader(const InstructionReader&) = delete;
  InstructionReader& operator=(const InstructionReader&) = delete;

  /// Its op becomes the assembler's where the number of operands says so.
  void ReadInstruction();

 private:
  bool HasTwoOperands() const;
  void ReadForm(Form form);
  /// main[,sub]
  void ReadError();
  void CheckEnd();

  MemoryReader memory_;
  BitReader bits_;
  TargetReader targets_;
  DataOperandReader data_;
  TimerReader timers_;
  AssemblerReader assembler_;
};

}  // namespace plcxx::technol
