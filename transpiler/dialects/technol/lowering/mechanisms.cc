#include "transpiler/dialects/technol/lowering/mechanisms.h"

#include "transpiler/dialects/technol/lowering/exits.h"
#include "transpiler/dialects/technol/lowering/locals.h"
#include "transpiler/dialects/technol/lowering/mechanism_places.h"

namespace plcxx::technol {

using ir::Type;

void Mechanisms::Enter(const Routine& mechanism) {
  const Routine* caller = frame_.routine;
  const bool shares_rounds = caller != nullptr && caller->loops && mechanism.loops && caller->calls && mechanism.calls;
  const auto run = [&] {
    if (!shares_rounds) {
      builder_.CallRoutine(mechanism.id, {});
      return;
    }
    const ir::PlaceId rounds = locals_("rounds_left", Type::kI32), own = locals_("rounds_of_module", Type::kI32);
    builder_.Store(own, builder_.Load(rounds));
    builder_.CallRoutine(mechanism.id, {});
    builder_.Store(rounds, builder_.Load(own));
  };
  builder_.When(builder_.Load(places_.Activation(mechanism.unit)), run);
}

void Mechanisms::Rewind(UnitId unit) {
  const Routine* routine = routines_.OfUnit(unit);
  if (routine != nullptr && !routine->entries.empty()) builder_.Store(places_.Step(unit), builder_.Constant(0, 16));
  for (uint32_t i = 0; i < tree_.units[unit].timers; ++i) {
    builder_.Store(places_.Timer(unit, i), builder_.Constant(0, 16));
  }
}

bool Mechanisms::Keeps(const Routine& mechanism) const {
  return !mechanism.entries.empty() || tree_.units[mechanism.unit].timers > 0;
}

void Mechanisms::RewindCleared() {
  if (settings_.mech_clear != MechClear::kAbort) return;
  for (const Routine& routine : routines_.all()) {
    if (!IsMechanism(routine) || !Keeps(routine)) continue;
    const ir::ValueId active = builder_.Load(places_.Activation(routine.unit));
    builder_.When(builder_.Not(active), [&] { Rewind(routine.unit); });
  }
}

void Mechanisms::End(UnitId unit) {
  builder_.Store(places_.Activation(unit), builder_.Bit(0));
  Rewind(unit);
}

void Mechanisms::Init(const Instruction& instruction) {
  const UnitId mechanism = OperandOf(instruction, 0).mechanism;
  End(mechanism);
  LeaveStopped(mechanism);
  if (mechanism == frame_.routine->unit) registers_.Forget();
}

void Mechanisms::Stop(UnitId mechanism) {
  Rewind(mechanism);
  LeaveStopped(mechanism);
}

/// A mechanism that stops itself is left at once. A subprogram runs to its end, so that one that stops everything does,
/// and the mechanism that has called it is left then (6.7, 7.1).
void Mechanisms::LeaveStopped(UnitId mechanism) {
  if (mechanism == frame_.routine->unit) return exits_.ToEnd();
  const Routine* stopped = routines_.OfUnit(mechanism);
  if (!frame_.routine->unit.valid() && stopped != nullptr && stopped->stopped_by_callee) {
    builder_.Store(StoppedPlace(mechanism), builder_.Bit(1));
  }
}

ir::PlaceId Mechanisms::StoppedPlace(UnitId mechanism) {
  return locals_(tree_.units[mechanism].name + "_stopped", Type::kBit);
}

}  // namespace plcxx::technol
