// Operands as places of the memory map, timers and counters as instances.
#pragma once

#include <unordered_map>

#include "transpiler/dialects/nc110/lowering/context.h"

namespace plcxx::nc110 {

class Cells : Context {
 public:
  explicit Cells(const Context& context);

  ir::PlaceId PlaceOf(const Operand& operand);
  ir::StateId InstanceOf(const Operand& operand);
  /// A bit that has a symbol is named by it, also where the source writes its address, with I or with U.
  Operand AsNamed(const Operand& operand) const;

 private:
  ir::Place MakePlace(const Operand& operand);

  std::unordered_map<uint32_t, ir::PlaceId> places_;     // by KeyOf
  std::unordered_map<uint32_t, ir::StateId> instances_;  // by kind and number
  std::unordered_map<uint32_t, SymbolId> symbols_;       // first one of exactly this operand
  std::unordered_map<uint32_t, SymbolId> bit_symbols_;   // first one of this bit, I or U
};

}  // namespace plcxx::nc110
