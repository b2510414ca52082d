// Inline assembler: shifts and rotations with their flags (specification 6.9).
//
// With the count in CL a count of 0 changes nothing, flags included (D41): what a flag was before is asked for then.
#pragma once

#include <optional>

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Flags;
class Operands;

class Shifts : Context {
 public:
  enum class Kind : uint8_t { kLeft, kRight, kArithmeticRight };

  Shifts(const Context& context, Operands& operands, Flags& flags)
      : Context(context), operands_(operands), flags_(flags) {}

  void Shift(const Instruction& instruction, Kind kind);
  void Rotate(const Instruction& instruction, Turn turn);
  void RotateWithCarry(const Instruction& instruction, Turn turn);

 private:
  void ShiftByConstant(const Instruction& instruction, Kind kind, uint32_t count);
  void ShiftByCl(const Instruction& instruction, Kind kind);
  ir::ValueId Shifted(Kind kind, ir::ValueId value, ir::ValueId count, uint32_t width);
  /// The last bit that goes out; `count` is 1 to 31.
  ir::ValueId ShiftedOut(Kind kind, ir::ValueId value, ir::ValueId count, uint32_t width);
  /// As far as it counts; none: it is in CL.
  static std::optional<uint32_t> ConstantCount(const Operand& count);
  ir::ValueId CountInCl();
  ir::ValueId BitAt(ir::ValueId value, uint32_t bit);

  Operands& operands_;
  Flags& flags_;
};

}  // namespace plcxx::technol
