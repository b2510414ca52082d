#include "transpiler/checks/part_uses.h"

#include <algorithm>
#include <optional>

#include "transpiler/ir/builder.h"

namespace plcxx::checks {
namespace {

Times Then(const Times& before, const Times& after) {
  if (before.count == 0) return after;
  if (after.count == 0 || before.count > 1) return before;
  return {2, before.first, after.first};
}

Times Either(const Times& left, const Times& right) { return left.count >= right.count ? left : right; }

Times Again(const Times& once) { return Then(once, once); }

/// Merges the counts of `other` into `uses`, place by place.
template <class Merge>
void MergeInto(PartUses& uses, const PartUses& other, Merge merge) {
  for (const auto& [place, use] : other.places) {
    Use& own = uses.places[place];
    own.reads = merge(own.reads, use.reads);
    own.writes = merge(own.writes, use.writes);
  }
  for (const auto& [state, times] : other.runs) uses.runs[state] = merge(uses.runs[state], times);
  uses.state_calls.insert(other.state_calls.begin(), other.state_calls.end());
}

class UseWalk {
 public:
  explicit UseWalk(const ir::Program& program) : program_(program), routines_(program.routines.size()) {}

  const PartUses& Routine(ir::RoutineId id) {
    std::optional<PartUses>& known = routines_[id.index];
    if (known) return *known;
    PartUses uses;
    const ir::Routine& routine = program_.routines[id];
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (region.valid()) Region(region, uses);
    }
    return known.emplace(std::move(uses));  // calls make no circle
  }

 private:
  void Region(ir::RegionId region, PartUses& uses) {
    for (const ir::InstId id : program_.regions[region].insts) Inst(program_[id], uses);
  }

  void Inst(const ir::Inst& inst, PartUses& uses) {
    switch (ir::Info(inst.op).shape) {
      case ir::Shape::kLoad:
        return Read(ir::PlaceId(inst.payload), inst.range, uses);
      case ir::Shape::kStore:
        return Write(ir::PlaceId(inst.payload), inst.range, uses);
      case ir::Shape::kStep:
      case ir::Shape::kText: {
        Times& times = uses.runs[inst.payload];
        times = Then(times, {1, inst.range, {}});
        if (ir::Info(inst.op).shape == ir::Shape::kText)
          uses.runs.emplace(inst.a, Times{1, inst.range, {}});  // the inbox
        return;
      }
      case ir::Shape::kIf:
      case ir::Shape::kSwitch:
        return Branches(inst, uses);
      case ir::Shape::kLoop:
      case ir::Shape::kRepeat:
        return Rounds(inst, uses);
      case ir::Shape::kBlock:
        for (const ir::RegionId owned : ir::OwnedRegions(program_, inst)) Region(owned, uses);
        return;
      case ir::Shape::kCall:
        return MergeInto(uses, Routine(program_.calls[ir::CallId(inst.payload)].routine), Then);
      case ir::Shape::kHostCall: {
        const ir::Call& call = program_.calls[ir::CallId(inst.payload)];
        if (call.out.valid()) Write(call.out, inst.range, uses);
        if (program_.host_functions[call.host].access != ir::HostAccess::kNone)
          uses.state_calls.emplace(call.host.index, inst.range);
        return;
      }
      case ir::Shape::kPure:
      case ir::Shape::kConst:
      case ir::Shape::kStatement:
      case ir::Shape::kExit:
      case ir::Shape::kJump:
      case ir::Shape::kLabel:
        return;
    }
  }

  /// Of the arms of a branch one is executed; of a switch several, where cases run on into the next.
  void Branches(const ir::Inst& inst, PartUses& uses) {
    bool falls_through = false;
    if (inst.op == ir::OpKind::kSwitch) {
      for (const ir::SwitchCase& one : program_.switches[ir::SwitchId(inst.payload)].cases)
        falls_through = falls_through || one.falls_through;
    }
    PartUses arms;
    for (const ir::RegionId owned : ir::OwnedRegions(program_, inst)) {
      PartUses arm;
      Region(owned, arm);
      MergeInto(arms, arm, falls_through ? Then : Either);
    }
    MergeInto(uses, arms, Then);
  }

  /// What stands in a loop is executed again; so is a budget's counter.
  void Rounds(const ir::Inst& inst, PartUses& uses) {
    PartUses round;
    for (const ir::RegionId owned : ir::OwnedRegions(program_, inst)) Region(owned, round);
    if (inst.op == ir::OpKind::kLoop) {
      const ir::Loop& loop = program_.loops[ir::LoopId(inst.payload)];
      if (loop.kind == ir::LoopBound::kBudget) {
        Read(loop.budget, inst.range, round);
        Write(loop.budget, inst.range, round);
      }
    }
    for (auto& [place, use] : round.places) use = {Again(use.reads), Again(use.writes)};
    for (auto& [state, times] : round.runs) times = Again(times);
    MergeInto(uses, round, Then);
  }

  bool IsLocal(ir::PlaceId place) const {
    const ir::Place& at = program_.places[place];
    return !at.is_field() && program_.spaces[at.space].lifetime == ir::Lifetime::kRoutine;
  }

  void Read(ir::PlaceId place, source::Range range, PartUses& uses) const {
    if (IsLocal(place)) return;
    Times& times = uses.places[place.index].reads;
    times = Then(times, {1, range, {}});
  }

  void Write(ir::PlaceId place, source::Range range, PartUses& uses) const {
    if (IsLocal(place)) return;
    Times& times = uses.places[place.index].writes;
    times = Then(times, {1, range, {}});
  }

  const ir::Program& program_;
  std::vector<std::optional<PartUses>> routines_;  // by RoutineId
};

}  // namespace

PartUses CollectUses(const ir::Program& program, const std::vector<ir::RoutineKind>& kinds) {
  UseWalk walk(program);
  PartUses uses;
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    if (std::ranges::find(kinds, program.routines[ir::RoutineId(i)].kind) == kinds.end()) continue;
    MergeInto(uses, walk.Routine(ir::RoutineId(i)), Then);
  }
  return uses;
}

}  // namespace plcxx::checks
