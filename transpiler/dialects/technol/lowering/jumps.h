// Jumps, forward and back (specification 6.4, 6.9).
#pragma once

#include "transpiler/dialects/technol/lowering/conditions.h"
#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Exits;
class Faults;
class Flags;
class Locals;
class Segments;

class Jumps : Context {
 public:
  Jumps(const Context& context, Locals& locals, Faults& faults, Exits& exits, Flags& flags, Conditions& conditions,
        Segments& segments)
      : Context(context),
        locals_(locals),
        faults_(faults),
        exits_(exits),
        flags_(flags),
        conditions_(conditions),
        segments_(segments) {}

  /// To the label of the instruction.
  void Always(const Instruction& instruction);
  void IfRlo(const Instruction& instruction, uint64_t rlo);
  void If(const Instruction& instruction, Relation relation);
  void IfFlag(const Instruction& instruction, Resources flag);
  void IfNotFlag(const Instruction& instruction, Resources flag);
  /// LOOP: CX is one less, and not 0 then.
  void IfCounting(const Instruction& instruction);
  void IfCxIsZero(const Instruction& instruction);

 private:
  void IfCx(const Instruction& instruction, ir::ValueId count, ir::OpKind comparison_with_zero);
  void If(const Instruction& instruction, ir::ValueId condition);
  void To(InstructionId target, ir::ValueId condition);
  InstructionId TargetOf(const Instruction& instruction) const;

  Locals& locals_;
  Faults& faults_;
  Exits& exits_;
  Flags& flags_;
  Conditions& conditions_;
  Segments& segments_;
};

}  // namespace plcxx::technol
