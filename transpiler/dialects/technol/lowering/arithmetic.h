// Inline assembler: sums, differences, logic (specification 6.9).
#pragma once

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Conditions;
class Flags;
class Operands;

class Arithmetic : Context {
 public:
  enum class Sum : uint8_t { kAdd, kAddWithCarry, kSubtract, kSubtractWithBorrow, kCompare };
  enum class Logic : uint8_t { kAnd, kOr, kXor, kTest };
  enum class Step : uint8_t { kUp, kDown };

  Arithmetic(const Context& context, Operands& operands, Flags& flags, Conditions& conditions)
      : Context(context), operands_(operands), flags_(flags), conditions_(conditions) {}

  void AddOrSubtract(const Instruction& instruction, Sum sum);
  void Combine(const Instruction& instruction, Logic logic);
  void Count(const Instruction& instruction, Step step);
  void Negate(const Instruction& instruction);
  void Invert(const Instruction& instruction);

 private:
  void HalfCarry(ir::ValueId left, ir::ValueId right, ir::ValueId result);

  Operands& operands_;
  Flags& flags_;
  Conditions& conditions_;
};

}  // namespace plcxx::technol
