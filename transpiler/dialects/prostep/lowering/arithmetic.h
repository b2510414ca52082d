// FM 0 to FM 14: bytes, words and AX (specification 6.9).
#pragma once

#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class Cells;
class Faults;
class Operands;
class Registers;

class Arithmetic : Context {
 public:
  Arithmetic(const Context& context, Cells& cells, Faults& faults, Registers& registers, Operands& operands)
      : Context(context), cells_(cells), faults_(faults), registers_(registers), operands_(operands) {}

  /// A byte destination gets the low byte, which depends on the low bytes alone.
  void AddOrSubtract(const Instruction& instruction, ir::OpKind bytes, ir::OpKind words);
  void Multiply(const Instruction& instruction);
  void Divide(const Instruction& instruction);
  /// FM 4: S tells that AX has more than four digits, and is left as it is.
  void ToBcd();
  void Shift(const Instruction& instruction, ir::OpKind op);
  void Bitwise(const Instruction& instruction, ir::OpKind bytes, ir::OpKind words);

 private:
  ir::ValueId DoesNotFit(ir::ValueId quotient);

  Cells& cells_;
  Faults& faults_;
  Registers& registers_;
  Operands& operands_;
};

}  // namespace plcxx::prostep
