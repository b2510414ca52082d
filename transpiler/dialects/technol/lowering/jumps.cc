#include "transpiler/dialects/technol/lowering/jumps.h"

#include "transpiler/dialects/technol/lowering/exits.h"
#include "transpiler/dialects/technol/lowering/faults.h"
#include "transpiler/dialects/technol/lowering/flags.h"
#include "transpiler/dialects/technol/lowering/locals.h"
#include "transpiler/dialects/technol/lowering/segments.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::ValueId;

InstructionId Jumps::TargetOf(const Instruction& instruction) const {
  return tree_.labels[OperandOf(instruction, instruction.operands.count - 1).label].at;
}

/// A jump back takes one of the iterations; when none is left, everything is left (6.4).
void Jumps::To(InstructionId target, ValueId condition) {
  const Routine& routine = *frame_.routine;
  const size_t segment = routine.SegmentOf(target);
  const bool to_other_segment = segment != routine.SegmentOf(frame_.now);
  if (target > frame_.now) {
    const bool to_end_of_own = to_other_segment && routine.segments_are_cases && routine.IsEntry(target);
    return builder_.Jump(to_end_of_own ? segments_.EndBefore(target) : target.index + 1, condition);
  }
  const ir::RegionId refused = builder_.RegionOf([&] {
    faults_.Report(Fault::kLoop);
    exits_.LeaveAll();
  });
  if (to_other_segment) return segments_.JumpToEntry(segment, condition, refused);
  builder_.JumpBack(target.index + 1, condition, locals_("rounds_left", ir::Type::kI32), refused);
}

void Jumps::Always(const Instruction& instruction) { To(TargetOf(instruction), {}); }

void Jumps::If(const Instruction& instruction, ValueId condition) {
  registers_.Spill();
  To(TargetOf(instruction), condition);
}

void Jumps::IfRlo(const Instruction& instruction, uint64_t rlo) {
  const ValueId value = registers_.rlo().Get();
  registers_.Spill();
  To(TargetOf(instruction), rlo == 1 ? value : builder_.Not(value));
  registers_.rlo().Know(1 - rlo);  // a jump that is not taken tells its condition
}

void Jumps::If(const Instruction& instruction, Relation relation) { If(instruction, conditions_.Holds(relation)); }

void Jumps::IfFlag(const Instruction& instruction, Resources flag) { If(instruction, flags_.Value(flag)); }

void Jumps::IfNotFlag(const Instruction& instruction, Resources flag) {
  If(instruction, builder_.Not(flags_.Value(flag)));
}

void Jumps::IfCounting(const Instruction& instruction) {
  const ValueId count = Pure(OpKind::kSub16, {registers_.Read(Register::kCx), builder_.Constant(1, 16)});
  registers_.Write(Register::kCx, count);
  IfCx(instruction, count, OpKind::kNotEqual16);
}

void Jumps::IfCxIsZero(const Instruction& instruction) {
  IfCx(instruction, registers_.Read(Register::kCx), OpKind::kEqual16);
}

void Jumps::IfCx(const Instruction& instruction, ValueId count, OpKind comparison_with_zero) {
  If(instruction, Pure(comparison_with_zero, {count, builder_.Constant(0, 16)}));
}

}  // namespace plcxx::technol
