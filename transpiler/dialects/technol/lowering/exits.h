// How a routine is left before its last instruction.
#pragma once

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Locals;

class Exits : Context {
 public:
  Exits(const Context& context, Locals& locals) : Context(context), locals_(locals) {}

  void BeginRoutine() { end_is_used_ = false; }
  /// Goes to the end of the routine, if `condition`; without one in any case.
  void ToEnd(ir::ValueId condition = {});
  /// Leaves the routine and all that have called it: a jump back that was refused (6.4), or a trap.
  void LeaveAll();
  /// The label that ToEnd goes to, where something does.
  void BindEnd();

 private:
  Locals& locals_;
  bool end_is_used_ = false;
};

}  // namespace plcxx::technol
