#include "transpiler/prove/compare/transition.h"

#include <algorithm>

namespace plcxx::prove {
namespace {

Transition RunRoutine(Terms& terms, const Version& version, ir::RoutineId routine, const Surroundings& surroundings,
                      const std::function<TermId(CellId)>& stored = {}) {
  Transition transition;
  Environment environment{.initial = surroundings.initial,
                          .observe = {},
                          .host_bit = surroundings.host_bit,
                          .cut = surroundings.cut,
                          .is_cut = surroundings.is_cut,
                          .now = surroundings.now,
                          .stored = stored,
                          .host_answers = surroundings.answers == HostAnswers::kAny,
                          .summarize_after = 16};
  environment.observe = [&](Memory& memory, ir::HostFunctionId function, TermId when) {
    Observation observation{.function = function, .when = when, .outputs = {}};
    for (const CellId cell : surroundings.outputs) observation.outputs.push_back(memory.Read(cell));
    transition.observations.push_back(std::move(observation));
  };
  Memory memory(terms, *version.program, version.cells, std::move(environment));
  transition.refusal = Execute(memory, routine);
  transition.next.resize(version.cells.count);
  for (uint32_t i = 0; i < version.cells.count; ++i) {
    if (memory.IsWritten(CellId(i))) transition.next[i] = memory.Read(CellId(i));
  }
  return transition;
}

}  // namespace

bool PowerOnBit(const ir::Space& space, uint32_t offset, uint8_t bit) {
  const auto at = std::ranges::lower_bound(space.initial, offset, {}, &ir::InitialByte::offset);
  return at != space.initial.end() && at->offset == offset && (at->value >> bit & 1) != 0;
}

bool HasFastPart(const Version& version) { return version.program->schedule.fast_ms != 0; }

bool HasRetentiveMemory(const Version& version) {
  return std::ranges::any_of(version.program->spaces,
                             [](const ir::Space& space) { return space.lifetime == ir::Lifetime::kRetentive; });
}

Transition RunPart(Terms& terms, const Version& version, Part part, const Surroundings& surroundings) {
  const ir::Schedule& schedule = version.program->schedule;
  return RunRoutine(terms, version, part == Part::kFast ? schedule.fast_only : schedule.period, surroundings);
}

Transition RunInit(Terms& terms, const Version& version, const Surroundings& surroundings) {
  Surroundings at_power_on = surroundings;
  at_power_on.initial = [&](CellId id) {
    const Cell cell = CellAt(*version.program, version.cells, id);
    switch (cell.kind) {
      case CellKind::kCalls:
        return surroundings.initial(id);
      case CellKind::kField:
        return terms.Const(0, CellWidth(*version.program, cell));
      case CellKind::kBit:
        break;
    }
    return terms.Bit(PowerOnBit(version.program->spaces[cell.space], cell.offset, cell.bit));
  };
  Transition transition = RunRoutine(terms, version, version.program->schedule.init, at_power_on, surroundings.initial);
  for (uint32_t i = 0; i < version.cells.count; ++i) {
    if (!transition.next[i].valid()) transition.next[i] = at_power_on.initial(CellId(i));
  }
  // A period is one step here: what happens between two would be left out.
  if (version.program->schedule.elapses_every_ms && transition.refusal.empty())
    transition.refusal = "what the control does at every millisecond between two ticks is not followed yet";
  return transition;
}

}  // namespace plcxx::prove
