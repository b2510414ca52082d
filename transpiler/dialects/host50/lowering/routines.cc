#include "transpiler/dialects/host50/lowering/routines.h"

#include "transpiler/dialects/host50/lowering/own_places.h"

namespace plcxx::host50 {
namespace {

std::string WithName(const std::string& comment, const std::string& name) {
  return name.empty() ? comment : comment + ": " + name;
}

}  // namespace

void Routines::Add() {
  of_.resize(tree_.sections.size());
  const SectionId fast = FindSection(tree_, SectionKind::kFast), slow = FindSection(tree_, SectionKind::kSlow);
  const auto name_of = [this](SectionId id) { return id.valid() ? tree_.sections[id].name : std::string(); };
  init_ = builder_.AddRoutine("init", ir::RoutineKind::kInit,
                              "Power-on: everything is 0 but the retentive memory; edges know the inputs as they are.");
  fast_ = builder_.AddRoutine("fast", ir::RoutineKind::kFast, WithName("FAST, in every tick", name_of(fast)));
  const bool sliced = settings_.slices == SlicesOption::kSliced;
  slow_ = builder_.AddRoutine(
      "slow", ir::RoutineKind::kSlow,
      WithName(sliced ? "SLOW, one slice in every tick" : "SLOW, once in every slow cycle", name_of(slow)));
  if (fast.valid()) of_[fast.index] = fast_;
  if (slow.valid()) of_[slow.index] = slow_;
  for (uint32_t i = 0; i < tree_.sections.size(); ++i) {
    const Section& section = tree_.sections[SectionId(i)];
    if (section.kind != SectionKind::kSubroutine) continue;
    const std::string name = SubroutineName(section.number);
    of_[i] = builder_.AddRoutine(name, ir::RoutineKind::kSubroutine, WithName("SUB " + name, section.name));
  }
  period_ = builder_.AddRoutine("period", ir::RoutineKind::kSchedule, "One tick of the control.");
  if (sliced) {
    slice_ = own_places_.Local("slice");
    program_.routines[slow_].parameters = {{.name = "slice", .type = ir::Type::kI32, .enumerators = {}}};
    program_.routines[slow_].parameter_places = {slice_};
  }
}

}  // namespace plcxx::host50
