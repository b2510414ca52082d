// Routines: kinds, parameters, who calls whom; statements: each exactly once.

#include <algorithm>

#include "transpiler/ir/verifier_state.h"

namespace plcxx::ir {
namespace {

constexpr uint8_t kMostSlices = 64;

void VerifyRoutinePlace(Verifier& verifier, const Routine& routine, PlaceId id, Type type, const std::string& what) {
  if (id.index >= verifier.program.places.size()) {
    verifier.Report(routine.name + ": " + what + " without place");
    return;
  }
  const Place& place = verifier.program.places[id];
  const bool own = !place.is_field() && place.space.index < verifier.program.spaces.size() &&
                   verifier.program.spaces[place.space].lifetime == Lifetime::kRoutine;
  if (!own) verifier.Report(routine.name + ": " + what + " outlives the routine");
  if (place.type != type) verifier.Report(routine.name + ": " + what + " is not of its place's type");
}

void VerifyKind(Verifier& verifier, RoutineId id, RoutineKind kind, std::string_view what) {
  if (!id.valid()) return;
  const auto& routines = verifier.program.routines;
  if (id.index >= routines.size() || routines[id].kind != kind) {
    verifier.Report("schedule: " + std::string(what) + " is of another kind");
  }
}

/// Depth first; a callee that is still open closes a cycle.
struct CallGraph {
  Verifier& verifier;
  enum class Mark : uint8_t { kNew, kOpen, kDone };
  std::vector<Mark> marks;

  void Visit(RoutineId id) {
    marks[id.index] = Mark::kOpen;
    for (const RoutineId callee : verifier.callees[id.index]) {
      if (marks[callee.index] == Mark::kOpen) {
        verifier.Report(verifier.program.routines[id].name + " calls itself through " +
                        verifier.program.routines[callee].name);
      } else if (marks[callee.index] == Mark::kNew) {
        Visit(callee);
      }
    }
    marks[id.index] = Mark::kDone;
  }
};

}  // namespace

void Verifier::VerifyRoutine(const Routine& checked) {
  if (checked.parameters.size() != checked.parameter_places.size()) {
    Report(checked.name + ": parameters without places");
  } else {
    for (size_t i = 0; i < checked.parameters.size(); ++i) {
      VerifyRoutinePlace(*this, checked, checked.parameter_places[i], checked.parameters[i].type,
                         "parameter " + checked.parameters[i].name);
    }
  }
  if (checked.result != Type::kNone) VerifyRoutinePlace(*this, checked, checked.result_place, checked.result, "result");
  if (checked.result == Type::kNone && checked.result_place.valid()) Report(checked.name + ": result without type");
  const bool slice = std::any_of(checked.parameters.begin(), checked.parameters.end(),
                                 [](const Parameter& parameter) { return parameter.name == "slice"; });
  if (checked.sliced && checked.kind != RoutineKind::kSlow) Report(checked.name + ": only a slow routine is sliced");
  if (checked.sliced && !slice) Report(checked.name + ": sliced without parameter slice");
  if (checked.slices < 1 || checked.slices > kMostSlices || (!checked.sliced && checked.slices != 1)) {
    Report(checked.name + ": impossible number of slices");
  }
  if (!checked.body.valid()) Report(checked.name + ": no body");
  for (const RegionId region : {checked.prologue, checked.body, checked.epilogue}) {
    if (!region.valid()) continue;
    if (region.index >= program.regions.size() || region_owned[region.index]) {
      Report(checked.name + ": a region has two owners, or is none");
      continue;
    }
    region_owned[region.index] = true;
    statement = {};
    VerifyRegion(region, now);
  }
}

void Verifier::VerifySchedule() {
  const Schedule& schedule = program.schedule;
  VerifyKind(*this, schedule.init, RoutineKind::kInit, "init");
  VerifyKind(*this, schedule.period, RoutineKind::kSchedule, "period");
  VerifyKind(*this, schedule.fast_only, RoutineKind::kSchedule, "fast_only");
}

void Verifier::VerifyCallGraph() {
  CallGraph graph{.verifier = *this, .marks = std::vector<CallGraph::Mark>(program.routines.size())};
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    if (graph.marks[i] == CallGraph::Mark::kNew) graph.Visit(RoutineId(i));
  }
}

void Verifier::VerifyStatements() {
  for (uint32_t i = 0; i < marked.size(); ++i) {
    if (marked[i]) continue;
    const std::string& subject = program.statements[StatementId(i)].subject;
    Report("statement " + std::to_string(i) + (subject.empty() ? "" : " (" + subject + ")") + " has disappeared");
  }
}

}  // namespace plcxx::ir
