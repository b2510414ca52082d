#include "transpiler/prove/machine/transition.h"

#include <algorithm>

namespace plcxx::prove::machine {
namespace {

Transition RunRoutine(terms::Terms& terms, const Version& version, ir::RoutineId routine,
                      const PartEnvironment& environment,
                      const std::function<terms::TermId(execute::CellId)>& stored = {}) {
  Transition transition;
  execute::Environment execution{.initial = environment.initial,
                                 .observe = {},
                                 .host_bit = environment.host_bit,
                                 .may_be_left = environment.may_be_left,
                                 .cut = environment.cut,
                                 .is_cut = environment.is_cut,
                                 .now = environment.now,
                                 .stored = stored,
                                 .host_answers = environment.answers == HostAnswers::kAny,
                                 .summarize_after = 16,
                                 .is_late = environment.is_late};
  execution.observe = [&](execute::Memory& memory, ir::HostFunctionId function, terms::TermId when) {
    if (version.program->host_functions[function].access == ir::HostAccess::kWritesState) return;
    Observation observation{.function = function, .when = when, .outputs = {}};
    for (const execute::CellId cell : environment.outputs) observation.outputs.push_back(memory.Read(cell));
    transition.observations.push_back(std::move(observation));
  };
  execute::Memory memory(terms, *version.program, version.cells, std::move(execution));
  transition.refusal = execute::Execute(memory, routine);
  transition.next.resize(version.cells.count);
  for (uint32_t i = 0; i < version.cells.count; ++i) {
    if (memory.IsWritten(execute::CellId(i))) transition.next[i] = memory.Read(execute::CellId(i));
  }
  return transition;
}

}  // namespace

bool PowerOnBit(const ir::Space& space, uint32_t offset, uint8_t bit) {
  const auto at = std::ranges::lower_bound(space.initial, offset, {}, &ir::InitialByte::offset);
  return at != space.initial.end() && at->offset == offset && (at->value >> bit & 1) != 0;
}

bool HasFastPart(const Version& version) {
  const ir::Schedule& schedule = version.program->schedule;
  return schedule.fast_only.valid() && schedule.fast_only != schedule.period;
}

bool HasTimedFastPart(const Version& version) { return version.program->schedule.fast_ms != 0; }

bool HasRetentiveMemory(const Version& version) {
  return std::ranges::any_of(version.program->spaces,
                             [](const ir::Space& space) { return space.lifetime == ir::Lifetime::kRetentive; });
}

Transition RunPart(terms::Terms& terms, const Version& version, Part part, const PartEnvironment& environment) {
  const ir::Schedule& schedule = version.program->schedule;
  return RunRoutine(terms, version, part == Part::kFast ? schedule.fast_only : schedule.period, environment);
}

Transition RunInit(terms::Terms& terms, const Version& version, const PartEnvironment& environment) {
  PartEnvironment at_power_on = environment;
  at_power_on.initial = [&](execute::CellId id) {
    const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
    switch (cell.kind) {
      case execute::CellKind::kCalls:
        return environment.initial(id);
      case execute::CellKind::kField:
        return terms.Const(0, execute::CellWidth(*version.program, cell));
      case execute::CellKind::kBit:
        break;
    }
    return terms.Bit(PowerOnBit(version.program->spaces[cell.space], cell.offset, cell.bit));
  };
  Transition transition = RunRoutine(terms, version, version.program->schedule.init, at_power_on, environment.initial);
  for (uint32_t i = 0; i < version.cells.count; ++i) {
    if (!transition.next[i].valid()) transition.next[i] = at_power_on.initial(execute::CellId(i));
  }
  // A period is one step here: what happens between two would be left out.
  if (version.program->schedule.elapses_every_ms && transition.refusal.empty())
    transition.refusal = "what the control does at every millisecond between two ticks is not followed yet";
  return transition;
}

}  // namespace plcxx::prove::machine
