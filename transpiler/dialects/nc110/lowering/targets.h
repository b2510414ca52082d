// Assignments: to memory, timers, counters and one-shots, and MUX.
#pragma once

#include "transpiler/dialects/nc110/lowering/context.h"

namespace plcxx::nc110 {

class Cells;
class Expirations;
class Expressions;
class Faults;
class LatchedInputs;
class SystemPlaces;

class Targets : Context {
 public:
  Targets(const Context& context, Cells& cells, LatchedInputs& inputs, SystemPlaces& system, Faults& faults,
          Expressions& expressions, Expirations& expirations);

  void Assign(const Item& item);

 private:
  void AssignMemory(const Operand& target, ir::ValueId value);
  void AssignMux(const Operand& target, const Mux& mux);
  void StepTimer(const Assignment& assignment, ir::ValueId input);
  void StepCounter(const Assignment& assignment, ir::ValueId input);
  void StepOneShot(const Operand& target, ir::ValueId input);
  /// Both bytes of a parametric delay or modulus.
  ir::ValueId Pair(const Operand& low);

  Cells& cells_;
  LatchedInputs& inputs_;
  SystemPlaces& system_;
  Faults& faults_;
  Expressions& expressions_;
  Expirations& expirations_;
};

}  // namespace plcxx::nc110
