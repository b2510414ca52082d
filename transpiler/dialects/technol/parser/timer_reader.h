// Cells and limits of timers (specification 6.7).
#pragma once

#include <optional>

#include "transpiler/dialects/technol/parser/data_operand_reader.h"
#include "transpiler/dialects/technol/parser/memory_reader.h"
#include "transpiler/dialects/technol/parser/operand_reader.h"

namespace plcxx::technol {

class TimerReader : private OperandReader {
 public:
  TimerReader(OperandReading& reading, MemoryReader& memory, DataOperandReader& data)
      : OperandReader(reading), memory_(memory), data_(data) {}

  /// '-': an automatic timer; else a word of the program.
  void ReadCell();
  /// A constant, CNST.constant or a word, after the comma.
  void ReadTime();

 private:
  bool LacksOperands() const;
  /// True: what is there is no cell (reported).
  bool RefuseOther(size_t first);
  void RefuseCell(size_t first, std::string_view what);
  void ReadTimeCell(size_t first);

  MemoryReader& memory_;
  DataOperandReader& data_;
};

}  // namespace plcxx::technol
