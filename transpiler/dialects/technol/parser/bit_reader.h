// Operands of the instructions on bits (specification 6.2, 6.3).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "transpiler/dialects/technol/parser/operand_reader.h"

namespace plcxx::technol {

class BitReader : private OperandReader {
 public:
  using OperandReader::OperandReader;

  void ReadBit(Access access);
  /// 0 or 1, a comma and a bit.
  void ReadFlag();

 private:
  int64_t CountOperands() const;
  bool IsSingleBit();
  /// 0 or 1 and the comma; false when that is not there (reported).
  bool ReadFlagValue(int64_t& flag);
  std::optional<Operand> ReadBitName();
  std::string BitOfByte(SymbolId cell) const;
  void CheckRequest(const Operand& bit, int64_t value);
};

}  // namespace plcxx::technol
