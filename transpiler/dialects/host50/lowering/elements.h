// Blocks with a state or result of their own: timers, CNUD, ROT (6.5, 7.2, 7.3).
#pragma once

#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class Cells;
class Faults;
class Logic;
class Numbers;
class Results;

class Elements : Context {
 public:
  Elements(const Context& context, Cells& cells, Faults& faults, Logic& logic, Numbers& numbers, Results& results)
      : Context(context), cells_(cells), faults_(faults), logic_(logic), numbers_(numbers), results_(results) {}

  /// Gives the block's Q.
  ir::ValueId Execute(const Instruction& instruction);

 private:
  ir::ValueId StepTimer(const Instruction& instruction, ir::ValueId input);
  ir::ValueId StepCounter(const Instruction& instruction, ir::ValueId input);
  ir::ValueId Rotate(const Instruction& instruction, ir::ValueId input);
  ir::ValueId PinValue(const Pin& pin);

  Cells& cells_;
  Faults& faults_;
  Logic& logic_;
  Numbers& numbers_;
  Results& results_;
};

}  // namespace plcxx::host50
