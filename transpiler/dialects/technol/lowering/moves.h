// Inline assembler: what moves values between registers, memory and the stack (specification 6.9).
#pragma once

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Locals;
class Operands;

class Moves : Context {
 public:
  Moves(const Context& context, Locals& locals, Operands& operands)
      : Context(context), locals_(locals), operands_(operands) {}

  void Move(const Instruction& instruction);
  void Exchange(const Instruction& instruction);
  void ZeroExtend(const Instruction& instruction);
  void SignExtend(const Instruction& instruction);
  void ByteToWord();
  /// To DX:AX.
  void WordToPair();
  void WordToDouble();
  /// To EDX:EAX.
  void DoubleToPair();
  void Push(const Instruction& instruction);
  void Pop(const Instruction& instruction);

 private:
  /// Each depth of the stack is a local of its own; subprograms use those after their callers'.
  ir::PlaceId StackSlot(uint32_t depth, const Operand& reg);

  Locals& locals_;
  Operands& operands_;
};

}  // namespace plcxx::technol
