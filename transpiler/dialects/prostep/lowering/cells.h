// Bits, bytes and words of I, O, F, D and the latches of the outputs as places (specification section 5).
#pragma once

#include <string>
#include <unordered_map>

#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class Cells : Context {
 public:
  explicit Cells(const Context& context) : Context(context) {}

  ir::PlaceId Bit(const Operand& operand);
  ir::PlaceId Latch(uint32_t port);
  /// A value that lies across the border of two parts of D is put together from its halves.
  ir::ValueId Load(Space space, uint32_t address, ir::Type type);
  void Store(Space space, uint32_t address, ir::Type type, ir::ValueId value);
  /// The same at the address of an operand, or at a number of bytes after it.
  ir::ValueId LoadField(const Operand& operand, ir::Type type) { return Load(operand.space(), operand.number, type); }
  void StoreField(const Operand& operand, ir::Type type, ir::ValueId value, uint32_t after = 0) {
    Store(operand.space(), operand.number + after, type, value);
  }
  /// Those that were asked for, by the number KeyOf of address and type.
  const std::unordered_map<uint32_t, ir::PlaceId>& places() const { return places_; }

 private:
  ir::PlaceId At(Space space, uint32_t address, ir::Type type);

  std::unordered_map<uint32_t, ir::PlaceId> places_;
};

}  // namespace plcxx::prostep
