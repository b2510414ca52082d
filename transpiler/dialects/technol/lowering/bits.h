// Logic on bits: RLO is loaded, combined, and written (specification 6.2, 6.3).
#pragma once

#include "transpiler/dialects/common/logic_stack.h"
#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Mechanisms;
class Operands;

class Bits : Context {
 public:
  Bits(const Context& context, Operands& operands, Mechanisms& mechanisms)
      : Context(context), operands_(operands), mechanisms_(mechanisms) {}

  void Load(const Instruction& instruction);
  void Combine(const Instruction& instruction, dialects::Join join);
  void WriteRlo(const Instruction& instruction);
  /// FL 0 and FL 1.
  void SetFlag(const Instruction& instruction);
  void SetFlagIfRlo(const Instruction& instruction, uint64_t rlo);

 private:
  ir::ValueId Read(const Operand& operand);
  void Write(const Operand& operand, ir::ValueId value);

  Operands& operands_;
  Mechanisms& mechanisms_;
};

}  // namespace plcxx::technol
