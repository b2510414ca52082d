// Blocks without Q: arithmetic, conversions, bit fields, calls (6.3, 6.4, 6.7).
#pragma once

#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class Cells;
class Numbers;
class Routines;

class Blocks : Context {
 public:
  Blocks(const Context& context, Cells& cells, Numbers& numbers, Routines& routines)
      : Context(context), cells_(cells), numbers_(numbers), routines_(routines) {}

  /// What the block does; its condition holds.
  void Act(const Instruction& instruction);

 private:
  void Calculate(const Instruction& instruction);
  void Negate(const Instruction& instruction);
  void Move(const Instruction& instruction);
  void BitsToWord(const Instruction& instruction);
  void WordToBits(const Instruction& instruction);
  void Assign(const Instruction& instruction);

  Cells& cells_;
  Numbers& numbers_;
  Routines& routines_;
};

}  // namespace plcxx::host50
