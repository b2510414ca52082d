// Operands of the data instructions (specification 6.5): memory of known width, constants after CNST.
#pragma once

#include <optional>

#include "transpiler/dialects/technol/parser/memory_reader.h"
#include "transpiler/dialects/technol/parser/operand_reader.h"

namespace plcxx::technol {

class DataOperandReader : private OperandReader {
 public:
  DataOperandReader(OperandReading& reading, MemoryReader& memory) : OperandReader(reading), memory_(memory) {}

  void ReadData(Form form);
  void ReadStore();
  /// CNST.constant or a byte.
  void ReadRotation();
  /// CNST.expression, when the next word is CNST.
  std::optional<Operand> ReadCounted();

 private:
  std::optional<Operand> ReadDataOperand();
  void CheckNarrow(const Operand& operand, Form form);

  MemoryReader& memory_;
};

}  // namespace plcxx::technol
