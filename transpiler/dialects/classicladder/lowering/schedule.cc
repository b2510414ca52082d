#include "transpiler/dialects/classicladder/lowering/schedule.h"

namespace plcxx::classicladder {

void Schedule::AddRoutines() {
  init_ = builder_.AddRoutine("init", ir::RoutineKind::kInit,
                              "Power-on: presets as the project has them, initial steps active, the rest 0.");
  fast_ = builder_.AddRoutine("fast", ir::RoutineKind::kFast, "The main sections, in every period.");
  period_ = builder_.AddRoutine("period", ir::RoutineKind::kSchedule, "One refresh of the engine.");
  periods_ = places_.NewSystemPlace("periods", ir::Type::kI32);
  stopped_ = places_.NewSystemPlace("stopped", ir::Type::kBit);
}

void Schedule::Lower() {
  Init();
  Period();
  Fill();
}

void Schedule::Init() {
  builder_.SetRange({});
  builder_.SetRegion(program_.routines[init_].body);
  edges_.Preset();
}

void Schedule::Period() {
  builder_.SetRange({});
  builder_.SetRegion(program_.routines[period_].body);
  const ir::ValueId runs = builder_.Pure(ir::OpKind::kBitNot, {builder_.Load(stopped_)});
  builder_.When(runs, [&] {
    host_(HostCall::kReadInputs);
    builder_.CallRoutine(fast_, {});
    host_(HostCall::kWriteOutputs);
  });
  builder_.Increment(periods_);
}

void Schedule::Fill() {
  ir::Schedule& schedule = program_.schedule;
  schedule.init = init_;
  schedule.period = period_;
  schedule.fast_only = period_;
  schedule.period_ms = settings_.period_ms;
  schedule.slot_ms = settings_.period_ms;
  schedule.slow_done = periods_;
}

}  // namespace plcxx::classicladder
