// Which part of the lowering lowers an instruction.
#pragma once

#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class Bits;
class Control;
class Functions;
class Logic;
class Operands;
class Registers;
class Timing;

class InstructionSet : Context {
 public:
  InstructionSet(const Context& context, Registers& registers, Operands& operands, Logic& logic, Bits& bits,
                 Timing& timing, Control& control, Functions& functions)
      : Context(context),
        registers_(registers),
        operands_(operands),
        logic_(logic),
        bits_(bits),
        timing_(timing),
        control_(control),
        functions_(functions) {}

  void Lower(InstructionId id);

 private:
  void Load(const Instruction& instruction);
  void Transfer(const Operand& target);
  void Compare(const Instruction& instruction, ir::OpKind bytes, ir::OpKind words);

  Registers& registers_;
  Operands& operands_;
  Logic& logic_;
  Bits& bits_;
  Timing& timing_;
  Control& control_;
  Functions& functions_;
};

}  // namespace plcxx::prostep
