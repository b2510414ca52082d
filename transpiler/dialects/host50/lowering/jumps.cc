#include "transpiler/dialects/host50/lowering/jumps.h"

#include "transpiler/dialects/host50/lowering/faults.h"
#include "transpiler/dialects/host50/lowering/logic.h"
#include "transpiler/dialects/host50/lowering/own_places.h"
#include "transpiler/dialects/host50/lowering/results.h"

namespace plcxx::host50 {

using ir::ValueId;

Jumps::Jumps(const Context& context, OwnPlaces& own_places, Faults& faults, Logic& logic, Results& results)
    : Context(context),
      own_places_(own_places),
      faults_(faults),
      logic_(logic),
      results_(results),
      is_target_(tree_.networks.size()),
      has_way_back_(tree_.sections.size()) {
  for (const Instruction& instruction : tree_.instructions) {
    if (instruction.op != Op::kLbl) continue;
    const NetworkId target = OperandOf(instruction, 0).network;
    is_target_[target.index] = true;
    const SectionId section = tree_.networks[instruction.network].section;
    if (target <= instruction.network) has_way_back_[section.index] = true;
  }
}

void Jumps::Count(ir::Lifetime lifetime) {
  const std::string name = "jumps_left";
  if (lifetime == ir::Lifetime::kRoutine) {
    now_.jumps_left = own_places_.Local(name);
  } else {
    const Section& section = tree_.sections[now_.section];
    const bool is_subroutine = section.kind == SectionKind::kSubroutine;
    now_.jumps_left =
        own_places_.System(is_subroutine ? SubroutineName(section.number) + "_" + name : name, ir::Type::kI32);
  }
}

void Jumps::ToEnd(ValueId condition) {
  now_.end_is_used = true;
  builder_.Jump(now_.end_label, condition);
}

/// A subroutine's refusals are its own matter: it returns, and its caller goes on.
void Jumps::Jump(const Instruction& instruction) {
  ValueId condition = results_.TakeInput(instruction.input);
  builder_.SetRange(instruction.range);
  if (logic_.IsConstant(condition, 1)) condition = {};
  const NetworkId target = OperandOf(instruction, 0).network;
  if (target > now_.network) return builder_.Jump(target.index, condition);
  const ir::RegionId refused = builder_.RegionOf([this] {
    faults_.Call(Fault::kJumpLoop);
    ToEnd();
  });
  builder_.JumpBack(target.index, condition, now_.jumps_left, refused);
}

}  // namespace plcxx::host50
