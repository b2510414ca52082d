// Data instructions: DR and what it meets (specification 6.5, 6.6).
#pragma once

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Faults;
class Operands;

class Data : Context {
 public:
  Data(const Context& context, Faults& faults, Operands& operands)
      : Context(context), faults_(faults), operands_(operands) {}

  void Load(const Instruction& instruction);
  void Store(const Instruction& instruction);
  void Combine(const Instruction& instruction, const ByWidth& operation);
  /// The low `factor_width` bits of DR by the operand.
  void Multiply(const Instruction& instruction, uint32_t factor_width);
  /// The low `width` bits of DR by the operand; the remainder goes to DX.
  void Divide(const Instruction& instruction, uint32_t width);
  void Rotate(const Instruction& instruction, Turn turn);
  /// Sets the RLO.
  void Compare(const Instruction& instruction, ir::OpKind comparison);
  void ToBcd();
  void FromBcd();

 private:
  /// dr of 6.1 as `width` bits: what lies above the static width does not count.
  ir::ValueId Dr(uint32_t width);
  void SetDr(ir::ValueId value, uint32_t width);

  Faults& faults_;
  Operands& operands_;
};

}  // namespace plcxx::technol
