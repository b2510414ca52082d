#include "transpiler/prove/machine/transition.h"

#include <algorithm>
#include <array>

namespace plcxx::prove::machine {
namespace {

/// Notes of an execution: for each function that sees something, one for each observed cell.
class SeenByHost {
 public:
  SeenByHost(terms::Terms& terms, const Version& version, const std::vector<execute::CellId>& observed)
      : terms_(terms), version_(version), observed_(observed), begins_(version.program->host_functions.size()) {
    for (const execute::CellId cell : observed)
      spaces_.push_back(execute::CellAt(*version.program, version.cells, cell).space);
    for (uint32_t& begin : begins_) {
      const ir::HostFunctionId function(static_cast<uint32_t>(&begin - begins_.data()));
      const bool sees_any = std::ranges::any_of(spaces_, [&](ir::SpaceId space) { return Sees(function, space); });
      begin = sees_any ? notes_ : kNothing;
      notes_ += sees_any ? static_cast<uint32_t>(observed.size()) : 0;
    }
  }
  uint32_t notes() const { return notes_; }

  void Note(execute::Memory& memory, ir::HostFunctionId function, terms::TermId when) {
    if (begins_[function.index] == kNothing) return;
    const terms::FunctionId seen = terms_.Function("seen by " + version_.program->host_functions[function].name, 64);
    for (uint32_t i = 0; i < observed_.size(); ++i) {
      if (!Sees(function, spaces_[i])) continue;
      const execute::CellId note = NoteOf(function, i);
      const terms::TermId before = memory.Read(note);
      const std::array arguments{before, memory.Read(observed_[i])};
      memory.Write(note, terms_.Ite(when, terms_.Apply(seen, arguments), before));
    }
  }

  std::vector<Seen> After(execute::Memory& memory) const {
    std::vector<Seen> all;
    for (uint32_t f = 0; f < begins_.size(); ++f) {
      const ir::HostFunctionId function(f);
      if (begins_[f] == kNothing) continue;
      Seen seen{.function = function, .cells = std::vector<terms::TermId>(observed_.size())};
      for (uint32_t i = 0; i < observed_.size(); ++i) {
        if (Sees(function, spaces_[i])) seen.cells[i] = memory.Read(NoteOf(function, i));
      }
      all.push_back(std::move(seen));
    }
    return all;
  }

 private:
  static constexpr uint32_t kNothing = 0xFFFFFFFF;

  bool Sees(ir::HostFunctionId function, ir::SpaceId space) const {
    return execute::HostSees(version_.program->host_functions[function].access, version_.program->spaces[space]);
  }
  execute::CellId NoteOf(ir::HostFunctionId function, uint32_t observed) const {
    return execute::CellId(version_.cells.count + begins_[function.index] + observed);
  }

  terms::Terms& terms_;
  const Version& version_;
  const std::vector<execute::CellId>& observed_;
  std::vector<ir::SpaceId> spaces_;  // by index of observed
  std::vector<uint32_t> begins_;     // by function: its first note
  uint32_t notes_ = 0;
};

Transition RunRoutine(terms::Terms& terms, const Version& version, ir::RoutineId routine,
                      const PartEnvironment& environment,
                      const std::function<terms::TermId(execute::CellId)>& stored = {}) {
  Transition transition;
  SeenByHost seen(terms, version, environment.observed);
  execute::Environment execution{.initial = environment.initial,
                                 .observe = {},
                                 .host_bit = environment.host_bit,
                                 .may_be_left = environment.may_be_left,
                                 .cut = environment.cut,
                                 .is_cut = environment.is_cut,
                                 .now = environment.now,
                                 .stored = stored,
                                 .has_copy = environment.has_copy,
                                 .notes = seen.notes(),
                                 .host_answers = environment.answers == HostAnswers::kAny,
                                 .summarize_after = 16,
                                 .never_holds = environment.never_holds,
                                 .unroll_up_to = kMostUnrolled,
                                 .never_unrolled = &version.shared_loops,
                                 .is_late = environment.is_late};
  execution.observe = [&](execute::Memory& memory, ir::HostFunctionId function, terms::TermId when) {
    seen.Note(memory, function, when);
  };
  execute::Memory memory(terms, *version.program, version.cells, std::move(execution));
  transition.refusal = execute::Execute(memory, routine);
  transition.seen = seen.After(memory);
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

bool PowerOnValue(const Version& version, execute::CellId id) {
  const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
  return cell.kind == execute::CellKind::kBit && PowerOnBit(version.program->spaces[cell.space], cell.offset, cell.bit);
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

Transition RunCalledByHost(terms::Terms& terms, const Version& version, ir::RoutineId routine,
                           const PartEnvironment& environment) {
  return RunRoutine(terms, version, routine, environment);
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
