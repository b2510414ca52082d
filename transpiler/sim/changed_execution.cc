#include "transpiler/sim/changed_execution.h"

#include <span>

#include "transpiler/sim/execution.h"
#include "transpiler/sim/instructions.h"
#include "transpiler/support/check.h"

namespace plcxx::sim {

using ir::Inst;
using ir::InstId;

namespace {

Flow ExecuteChangedInst(Execution& execution) {
  if (execution.changes.changed().what.how == ChangedHow::kLeftOut) return Flow::kOn;
  return ExecuteAs(execution, execution.changes.changed().what.id, execution.changes.changed().inst);
}

Flow ExecuteChangedRung(Execution& execution, const Decoded& rung) {
  const uint32_t count = rung.step_count() + (rung.has_statement() ? 1 : 0) + (rung.has_coil() ? 1 : 0);
  for (uint32_t at = rung.first(); at < rung.first() + count; ++at) {
    const Decoded& inst = execution.code.decoded[at];
    const Flow flow = inst.id == execution.changes.changed().what.id.index ? ExecuteChangedInst(execution)
                                                                           : inst.execute(execution, inst);
    PLCXX_CHECK(flow == Flow::kOn);
  }
  return Flow::kOn;
}

/// Of what has effects: whether it would be executed with something else.
bool DiffersBefore(const Execution& execution, const Changed& changed) {
  if (changed.what.how != ChangedHow::kOperand) return true;
  return execution.values[changed.operand] != changed.what.number;
}

/// Of what only computes.
bool DiffersInResult(Execution& execution, const Changed& changed) {
  execution.values[execution.changes.NumberValue()] = changed.what.number;
  ExecuteAs(execution, InstId(execution.changes.OtherResult()), changed.inst);
  return execution.values[execution.changes.OtherResult()] != execution.values[changed.what.id.index];
}

}  // namespace

Flow ExecuteChangedRegion(Execution& execution, const DecodedRegion& region) {
  const Changes& changes = execution.changes;
  execution.values[changes.NumberValue()] = changes.changed().what.number;
  const uint32_t count = region.end - region.begin;
  execution.executed += count;
  for (uint32_t at = region.ready_begin; at < region.ready_end; ++at) {
    const Decoded& inst = execution.code.ready[at];
    const Flow flow = at != changes.entry()         ? inst.execute(execution, inst)
                      : inst.execute == ExecuteRung ? ExecuteChangedRung(execution, inst)
                                                    : ExecuteChangedInst(execution);
    if (flow == Flow::kOn) continue;
    execution.executed -= count - (inst.order + 1);
    return flow;
  }
  return Flow::kOn;
}

Flow ExecuteLookingForDifferences(Execution& execution, const Decoded& inst) {
  const std::span<const uint32_t> changes = execution.changes.Of(InstId(inst.id));
  if (changes.empty()) return inst.execute(execution, inst);
  const Inst& program_inst = execution.program[InstId(inst.id)];
  const ir::Shape shape = ir::Info(program_inst.op).shape;
  const bool computes = shape == ir::Shape::kPure || shape == ir::Shape::kLoad;
  const bool stores = shape == ir::Shape::kStore;
  const auto is_judged_behind = [&](const Changed& changed) {
    return computes || (stores && changed.what.how == ChangedHow::kLeftOut);
  };
  const auto look = [&](bool behind, auto&& differs) {
    for (const uint32_t number : changes) {
      const Changed& changed = execution.changes.difference(number);
      if (changed.wanted && is_judged_behind(changed) == behind && differs(changed)) execution.changes.Found(number);
    }
  };
  look(false, [&](const Changed& changed) { return DiffersBefore(execution, changed); });
  const PlaceAccess* const place = stores ? &execution.code.places[program_inst.payload] : nullptr;
  const auto stored = [&] {
    return stores ? execution.memory.Get(*place, place->indexed ? execution.values[program_inst.b] : 0) : 0;
  };
  const uint64_t before = stored();
  const Flow flow = inst.execute(execution, inst);
  if (computes) look(true, [&](const Changed& changed) { return DiffersInResult(execution, changed); });
  if (stores && stored() != before) look(true, [](const Changed&) { return true; });
  return flow;
}

}  // namespace plcxx::sim
