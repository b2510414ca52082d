// Instructions of timers and counters (specification section 7).
#pragma once

#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class Instances;
class Logic;
class Operands;
class Scalars;

class Timing : Context {
 public:
  Timing(const Context& context, Scalars& scalars, Instances& instances, Operands& operands, Logic& logic)
      : Context(context), scalars_(scalars), instances_(instances), operands_(operands), logic_(logic) {}

  void StartTimer(const Instruction& instruction, ir::OpKind start);
  void ResetTimer(const Instruction& instruction);
  void Count(const Instruction& instruction, ir::OpKind step);
  void SetCounter(const Instruction& instruction);
  void ResetCounter(const Instruction& instruction);
  /// What is left of a timer's time, in ms or as a time word.
  ir::ValueId TimeLeft(const Instruction& instruction, ir::OpKind step);
  ir::ValueId CounterValue(const Instruction& instruction);

 private:
  /// Whether the start instruction takes its time word now: 7.1.
  ir::ValueId StartsTimer(const Instruction& instruction, ir::OpKind start, ir::ValueId condition);
  /// A port is read only when its word is needed: reading is an event at the machine.
  ir::ValueId PortWord(const Operand& operand, ir::ValueId needed);
  /// The time word or preset of an instruction, no port.
  ir::ValueId Parameter(const Instruction& instruction);

  Scalars& scalars_;
  Instances& instances_;
  Operands& operands_;
  Logic& logic_;
};

}  // namespace plcxx::prostep
