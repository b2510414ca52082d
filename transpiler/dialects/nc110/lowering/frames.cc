#include "transpiler/dialects/nc110/lowering/frames.h"

#include <vector>

#include "transpiler/dialects/nc110/lowering/expirations.h"
#include "transpiler/dialects/nc110/lowering/latched_inputs.h"
#include "transpiler/dialects/nc110/lowering/routines.h"
#include "transpiler/dialects/nc110/lowering/system_places.h"
#include "transpiler/dialects/nc110/lowering/texts.h"

namespace plcxx::nc110 {

Frames::Frames(const Context& context, const Routines& routines, SystemPlaces& system, LatchedInputs& inputs,
               Texts& texts, const Expirations& expirations)
    : Context(context),
      routines_(routines),
      system_(system),
      inputs_(inputs),
      texts_(texts),
      expirations_(expirations) {}

void Frames::LowerFast() {
  builder_.SetRange({});
  const std::vector<ir::StateId>& driven = expirations_.Of(Part::kFast);
  if (driven.empty()) return;
  // The number goes on before the statements stamp with it, so that at the end an equal stamp means "in this one".
  if (system_.IsUsed(SystemPlace::kFastCount)) {
    program_.routines[routines_.fast()].prologue = builder_.NewRegion();
    builder_.SetRegion(program_.routines[routines_.fast()].prologue);
    builder_.Increment(system_.Of(SystemPlace::kFastCount));
  }
  program_.routines[routines_.fast()].epilogue = builder_.NewRegion();
  builder_.SetRegion(program_.routines[routines_.fast()].epilogue);
  for (const ir::StateId state : driven) {
    if (program_.states[state].kind == ir::StateKind::kRingCounter) {
      builder_.Step(ir::OpKind::kExpireCounterFast, state, {system_.Load(SystemPlace::kFastCount)});
    } else {
      builder_.Step(ir::OpKind::kExpirePulseFast, state, {system_.Load(SystemPlace::kSlowDone)});
    }
  }
}

void Frames::LowerSlowPrologue() {
  const ir::RegionId prologue = builder_.NewRegion();
  builder_.SetRegion(prologue);
  if (system_.IsUsed(SystemPlace::kSlowCycle)) builder_.Increment(system_.Of(SystemPlace::kSlowCycle));
  if (sliced()) system_.Store(SystemPlace::kSlowOpen, Byte(1));
  texts_.Update();
  inputs_.Latch();
  if (!program_.regions[prologue].insts.empty()) program_.routines[routines_.slow()].prologue = prologue;
}

void Frames::LowerSlow() {
  builder_.SetRange({});
  LowerSlowPrologue();
  const ir::RegionId epilogue = builder_.NewRegion();
  builder_.SetRegion(epilogue);
  if (sliced()) system_.Store(SystemPlace::kSlowOpen, Byte(0));
  builder_.Increment(system_.Of(SystemPlace::kSlowDone));
  for (const ir::StateId state : expirations_.Of(Part::kSlow)) {
    const bool counter = program_.states[state].kind == ir::StateKind::kRingCounter;
    builder_.Step(counter ? ir::OpKind::kExpireCounterSlow : ir::OpKind::kExpirePulseSlow, state,
                  {system_.Load(SystemPlace::kSlowCycle)});
  }
  program_.routines[routines_.slow()].epilogue = epilogue;
}

}  // namespace plcxx::nc110
