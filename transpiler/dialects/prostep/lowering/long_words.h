// FM 60 to FM 88: double words; S tells of the result (specification 6.9). All sources are read before anything is
// written, so that fields may overlap.
#pragma once

#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class Cells;
class Registers;

class LongWords : Context {
 public:
  LongWords(const Context& context, Cells& cells, Registers& registers)
      : Context(context), cells_(cells), registers_(registers) {}

  void Combine(const Instruction& instruction, ir::OpKind op);
  void Compare(const Instruction& instruction, ir::OpKind op);
  void Move(const Instruction& instruction);
  void Multiply(const Instruction& instruction);
  /// S tells that nothing was done: by 0, or the one quotient that does not fit.
  void Divide(const Instruction& instruction);
  void Negate(const Instruction& instruction);
  void Complement(const Instruction& instruction);
  void Increment(const Instruction& instruction);
  void Decrement(const Instruction& instruction);

 private:
  ir::ValueId Load(const Instruction& instruction, uint32_t argument);
  /// The only operand; S tells that it is 0 now.
  void Change(const Instruction& instruction, ir::ValueId result);
  void Finish(const Operand& target, ir::ValueId result);

  Cells& cells_;
  Registers& registers_;
};

}  // namespace plcxx::prostep
