#include "transpiler/dialects/technol/lowering/subprograms.h"

#include <utility>
#include <vector>

#include "transpiler/dialects/technol/lowering/exits.h"
#include "transpiler/dialects/technol/lowering/mechanisms.h"

namespace plcxx::technol {

using ir::ValueId;

/// The caller asks after it whether everything is to be left, and whether it was stopped.
void Subprograms::Call(const Instruction& instruction) {
  const uint32_t number = *flow_.CalleeOf(instruction);
  const Routine &caller = *frame_.routine, &callee = routines_.OfSubprogram(number);
  registers_.Spill();
  std::vector<ValueId> arguments;
  if (callee.entry.valid()) {
    uint64_t entry = 0;
    while (callee.subprograms[entry] != number) ++entry;
    arguments.push_back(builder_.Constant(program_.places[callee.entry].type, entry));
  }
  const bool may_be_stopped = caller.stopped_by_callee && callee.MayStop(caller.unit);
  if (may_be_stopped) builder_.Store(mechanisms_.StoppedPlace(caller.unit), builder_.Bit(0));
  const ValueId left = builder_.CallRoutine(callee.id, std::move(arguments));
  registers_.Forget();
  if (callee.leaves && caller.unit.valid()) {
    exits_.ToEnd(left);
  } else if (callee.leaves) {
    builder_.When(left, [&] { exits_.LeaveAll(); });  // the caller's own caller asks, too
  }
  if (may_be_stopped) exits_.ToEnd(builder_.Load(mechanisms_.StoppedPlace(caller.unit)));
}

void Subprograms::Return() {
  registers_.Spill();
  if (frame_.now == frame_.routine->instructions.back()) return;
  exits_.ToEnd();
}

}  // namespace plcxx::technol
