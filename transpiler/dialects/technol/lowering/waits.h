// Waits of a mechanism: it stores its step, leaves its routine, and goes on there in the next pass (specification 6.7).
#pragma once

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Exits;
class Jumps;
class MechanismPlaces;
class Operands;

class Waits : Context {
 public:
  Waits(const Context& context, MechanismPlaces& mechanisms, Exits& exits, Operands& operands, Jumps& jumps)
      : Context(context), mechanisms_(mechanisms), exits_(exits), operands_(operands), jumps_(jumps) {}

  /// For one pass.
  void OnePass();
  void UntilRlo(uint64_t rlo);
  /// But no longer than the time of the instruction; then it goes to its label.
  void UntilRloAtMost(const Instruction& instruction, uint64_t rlo);
  /// As long as the instruction says.
  void Delay(const Instruction& instruction);

 private:
  void Leave();
  /// 16 bits: a constant, or a word that is looked at in each pass.
  ir::ValueId LimitOf(const Instruction& instruction);
  ir::ValueId Compare(ir::OpKind comparison, ir::ValueId count, ir::ValueId limit);

  MechanismPlaces& mechanisms_;
  Exits& exits_;
  Operands& operands_;
  Jumps& jumps_;
};

}  // namespace plcxx::technol
