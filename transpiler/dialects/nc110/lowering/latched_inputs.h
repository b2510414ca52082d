// SLICES: the slow part sees inputs as they were in slice 0, in copies.
#pragma once

#include <unordered_map>
#include <vector>

#include "transpiler/dialects/nc110/lowering/context.h"

namespace plcxx::nc110 {

class Cells;

class LatchedInputs : Context {
 public:
  LatchedInputs(const Context& context, Cells& cells) : Context(context), cells_(cells) {}

  /// The place to read, which is the copy in the slow part.
  ir::PlaceId ReadPlaceOf(const Operand& operand);
  /// An input that the slow part sees as it was in slice 0.
  bool HasCopy(const Operand& operand) const;
  ir::PlaceId CopyOf(const Operand& operand);
  /// What is there now goes into all copies that were asked for.
  void Latch();

 private:
  Cells& cells_;
  std::unordered_map<uint32_t, ir::PlaceId> latched_;  // by KeyOf
  std::vector<Operand> order_;
};

}  // namespace plcxx::nc110
