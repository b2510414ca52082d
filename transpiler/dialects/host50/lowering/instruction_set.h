// Executes the instructions of a rung one by one: each where it is, or where its result is used.
#pragma once

#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class Axes;
class Blocks;
class Cells;
class Contacts;
class Elements;
class Jumps;
class Logic;
class Results;

class InstructionSet : Context {
 public:
  InstructionSet(const Context& context, Cells& cells, Contacts& contacts, Logic& logic, Results& results, Jumps& jumps,
                 Blocks& blocks, Elements& elements, Axes& axes);

  void BeginRung();
  void Execute(InstructionId id);

 private:
  void ExecuteOutput(InstructionId id);
  void Coil(const Instruction& instruction);
  /// Blocks and coils that act only while their input is 1: `if (input) { ... }`, one for neighbours of one input.
  void ActIf(const Instruction& instruction);
  bool SameInput(const Input& a, const Input& b) const;

  Cells& cells_;
  Contacts& contacts_;
  Logic& logic_;
  Results& results_;
  Jumps& jumps_;
  Blocks& blocks_;
  Elements& elements_;
  Axes& axes_;
  struct {
    ir::RegionId then;  // none: no `if` is open
    Input input;
  } open_if_;
};

}  // namespace plcxx::host50
