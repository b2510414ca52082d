// Jumps, calls, the module's end (specification 6.5 to 6.7).
#pragma once

#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class Faults;
class Logic;
class Registers;
class Scalars;

class Control : Context {
 public:
  Control(const Context& context, Scalars& scalars, Faults& faults, Registers& registers, Logic& logic)
      : Context(context), scalars_(scalars), faults_(faults), registers_(registers), logic_(logic) {}

  void BeginModule() { end_is_used_ = false; }
  void Jump(InstructionId id);
  void JumpIf(InstructionId id);
  void Call(const Instruction& instruction);
  void CallIf(const Instruction& instruction);
  void EndModule(InstructionId id);
  void EndModuleIf(InstructionId id);
  /// The label in front of an instruction of the module.
  void BindLabel(InstructionId at) { builder_.Label(LabelBefore(at)); }
  /// That of its end, where something jumps to it.
  void BindEnd();

 private:
  uint32_t LabelBefore(InstructionId at) const { return at.index - module().begin_of().index + 1; }
  void JumpTo(InstructionId target, InstructionId from, ir::ValueId condition);
  void ToEnd(ir::ValueId condition);
  /// At the end of the text the module ends anyway.
  bool IsLast(InstructionId id) const { return id.index + 1 == module().end_of().index; }

  Scalars& scalars_;
  Faults& faults_;
  Registers& registers_;
  Logic& logic_;
  bool end_is_used_ = false;
};

}  // namespace plcxx::prostep
