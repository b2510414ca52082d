// Modules as routines, one instruction after the other.
#pragma once

#include <vector>

#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class Control;
class InstructionSet;
class Logic;
class Registers;
class StatementWriter;

class ModuleWriter : Context {
 public:
  ModuleWriter(const Context& context, Registers& registers, Logic& logic, Control& control,
               InstructionSet& instructions, StatementWriter& statements)
      : Context(context),
        registers_(registers),
        logic_(logic),
        control_(control),
        instructions_(instructions),
        statements_(statements) {}

  /// All of them, without instructions. `init`: what PM 0 is, unless it is called.
  void AddRoutines(ir::RoutineId init);
  void Lower(ModuleId id);

 private:
  void Begin(ModuleId id);
  void FindLabels();
  void Execute(InstructionId id);

  Registers& registers_;
  Logic& logic_;
  Control& control_;
  InstructionSet& instructions_;
  StatementWriter& statements_;
  std::vector<bool> label_at_;  // by instruction of the module: something jumps there
};

}  // namespace plcxx::prostep
