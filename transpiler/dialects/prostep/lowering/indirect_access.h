// FM 15 to FM 18: bytes and words at a computed address (specification 6.9, D40).
#pragma once

#include <optional>

#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class Cells;
class Faults;
class IndexedCells;
class Operands;
class Registers;

class IndirectAccess : Context {
 public:
  IndirectAccess(const Context& context, Cells& cells, IndexedCells& indexed, Faults& faults, Registers& registers,
                 Operands& operands)
      : Context(context),
        cells_(cells),
        indexed_(indexed),
        faults_(faults),
        registers_(registers),
        operands_(operands) {}

  /// Into AX, of a byte into AL.
  void Read(const Instruction& instruction, ir::Type type);
  void Write(const Instruction& instruction, ir::Type type);

 private:
  /// What an access reaches: a constant address, or one that is computed.
  struct Reach {
    std::optional<int32_t> constant;
    ir::ValueId address;  // i32
    ir::ValueId outside;  // bit; none: it is always inside
  };
  Reach ReachOf(const Instruction& instruction, uint32_t bytes);

  Cells& cells_;
  IndexedCells& indexed_;
  Faults& faults_;
  Registers& registers_;
  Operands& operands_;
};

}  // namespace plcxx::prostep
