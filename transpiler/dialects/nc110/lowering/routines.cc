#include "transpiler/dialects/nc110/lowering/routines.h"

namespace plcxx::nc110 {

void Routines::Add() {
  init_ = builder_.AddRoutine("init", ir::RoutineKind::kInit,
                              "Power-on: everything is 0 but package T, which gets its values.");
  fast_ = builder_.AddRoutine("fast", ir::RoutineKind::kFast, "The fast part: all of it in every period.");
  slow_ = builder_.AddRoutine("slow", ir::RoutineKind::kSlow, "The slow part: one slice in every period.");
  period_ = builder_.AddRoutine("period", ir::RoutineKind::kSchedule, "One period of the control.");
  fast_only_ = builder_.AddRoutine("fast_only", ir::RoutineKind::kSchedule, "A period without the slow part.");

  ir::Routine& slow = program_.routines[slow_];
  slow.sliced = true;
  slow.slices = settings_.slices;
  slow.parameters = {{.name = "slice", .type = ir::Type::kI8, .enumerators = {}}};
  slow.parameter_places = {
      program_.places.Add({.name = "slice", .type = ir::Type::kI8, .space = SpaceOf(SpaceIndex::kArguments)})};
  program_.routines[fast_only_].simulation_only = true;
}

}  // namespace plcxx::nc110
