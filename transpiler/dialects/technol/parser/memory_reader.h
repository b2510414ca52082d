// Addresses of memory (specification 6.1): prefixes, fields, indexes, and whether the access is inside its area.
#pragma once

#include <cstdint>
#include <optional>

#include "transpiler/dialects/technol/parser/operand_reader.h"

namespace plcxx::technol {

enum class Prefixes : uint8_t { kTechnol, kAssembler };

class MemoryReader : private OperandReader {
 public:
  using OperandReader::OperandReader;

  /// Does the operand at the reader name memory? A constant expression does not.
  bool IsAddressAhead() const;
  /// [BYTE.|WORD.|DWRD.] address, or assembler's BYTE PTR; width 0 where nothing tells it. Checks ranges when the width
  /// is known. None when it is wrong (reported).
  std::optional<Operand> ReadMemory(Prefixes prefixes);
  /// Is the whole access inside its area? Warns when it leaves its symbol.
  void CheckRange(const Operand& operand);
  bool CheckWidth(const Operand& operand);

 private:
  std::optional<uint8_t> ReadPrefix(Prefixes prefixes);
  bool ReadAddress(Address& address, uint8_t& width, uint32_t level);
  bool ReadBase(Address& address, uint8_t& width, uint32_t level);
  bool ReadField(Address& address, uint8_t& width);
  bool ReadIndex(Address& address);
  bool ReadIndexRegister(Address& address);
  void ReportBitAsData(const Token& token);
};

}  // namespace plcxx::technol
