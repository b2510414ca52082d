#include "transpiler/dialects/prostep/lowering/schedule.h"

#include <string>
#include <utility>

#include "transpiler/dialects/prostep/lowering/cells.h"
#include "transpiler/dialects/prostep/lowering/instances.h"
#include "transpiler/dialects/prostep/lowering/locals.h"
#include "transpiler/dialects/prostep/lowering/refresh.h"
#include "transpiler/dialects/prostep/lowering/scalars.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

namespace {

constexpr uint32_t kSlices = 8;
constexpr uint32_t kSecond = 1000, kHalfSecond = 500;
constexpr Operand SystemSignal(uint8_t bit) { return {.kind = OperandClass::kI, .bit = bit, .number = 20}; }
constexpr Operand ActivityOf(uint32_t module) {
  const uint32_t bit = module - 1;  // F 250.0 is PM 1, F 251.0 is PM 9
  return {.kind = OperandClass::kF,
          .bit = static_cast<uint8_t>(bit % 8),
          .number = static_cast<uint16_t>(kActivityByte + bit / 8)};
}
}  // namespace

void Schedule::AddRoutines() {
  using Kind = ir::RoutineKind;
  init_ = builder_.AddRoutine("init", Kind::kInit,
                              "Power-on: everything is 0 but the declared data and the retentive block; then PM 0.");
  fast_ = builder_.AddRoutine("fast", Kind::kSchedule, "PM 1 to PM 8, each while its bit of F 250 is 1.");
  slow_ = builder_.AddRoutine("slow", Kind::kSchedule,
                              "One slice of a slow pass, 0 to 7: PM 9 + slice while its bit of F 251 is 1.");
  advance_ = builder_.AddRoutine("advance", Kind::kSchedule, "Time passes for the timers.");
  refresh_inputs_ = builder_.AddRoutine("refresh_inputs", Kind::kSchedule, "DW 496 bytes of direct inputs go into I.");
  refresh_outputs_ =
      builder_.AddRoutine("refresh_outputs", Kind::kSchedule, "DW 498 bytes of O go to the direct outputs.");
  tick_ = builder_.AddRoutine(
      "tick", Kind::kSchedule,
      "The interrupt: call it every " + std::to_string(settings_.tick_ms) +
          " ms with the time that has passed since the last call. Nothing here preempts anything: a "
          "host that calls it while slow runs must protect the state itself.");
  slow_pass_ = builder_.AddRoutine("slow_pass", Kind::kSchedule, "One whole pass of the loop modules.");
  slow_step_ = builder_.AddRoutine("slow_step", Kind::kSchedule, "The next loop module whose bit is 1.");
  period_ = builder_.AddRoutine("period", Kind::kSchedule, "A tick and a whole slow pass.");
  fast_only_ = builder_.AddRoutine("fast_only", Kind::kSchedule, "A tick alone.");
  elapse_ = builder_.AddRoutine("elapse", Kind::kSchedule, "Time passes between two ticks.");
  for (const ir::RoutineId id : {period_, fast_only_, elapse_}) program_.routines[id].simulation_only = true;
}

/// A module that calls enter too shares S and AX with whoever enters it.
void Schedule::Enter(ModuleId module) {
  if (modules_.IsCalled(module)) {
    scalars_.Store(ScalarPlace::kS, builder_.Bit(0));
    scalars_.Store(ScalarPlace::kAx, Word(0));
  }
  builder_.CallRoutine(modules_.RoutineOf(module), {});
}

/// The bit is looked at right before the module's turn (D50).
void Schedule::EnterWhenActive(ModuleId module) {
  builder_.When(builder_.Load(cells_.Bit(ActivityOf(tree_.modules[module].number))), [&] { Enter(module); });
}

void Schedule::LowerPowerOn() {
  builder_.SetRange({});
  ir::Routine& init = program_.routines[init_];
  const ir::RegionId prologue = builder_.NewRegion();
  init.prologue = prologue;
  builder_.SetRegion(prologue);
  if (memory_[SpaceKey::kDKept].valid()) builder_.AsExchange(host_(HostCall::kRetentiveLoad));
  if (modules_.loops()) scalars_.Store(ScalarPlace::kRounds, Number(settings_.loop_budget));
  const ModuleId module = ModuleOf(0);
  if (!module.valid() || !modules_.IsCalled(module)) return;
  builder_.SetRegion(init.body);
  Enter(module);
}

void Schedule::Lower() {
  Fast();
  Slow();
  Advance();
  builder_.SetRegion(program_.routines[refresh_inputs_].body);
  refresh_.Inputs();
  builder_.SetRegion(program_.routines[refresh_outputs_].body);
  refresh_.Outputs();
  Tick();
  SlowPass();
  SlowStep();
  Periods();
  Fill();
}

void Schedule::Fast() {
  builder_.SetRegion(program_.routines[fast_].body);
  if (modules_.loops()) scalars_.Store(ScalarPlace::kRounds, Number(settings_.loop_budget));
  for (uint32_t number = 1; number < kFirstLoopModule; ++number) {
    if (ModuleOf(number).valid()) EnterWhenActive(ModuleOf(number));
  }
}

/// The loop budget of a slow pass lives in the state, so that its slices share it; slice 0 begins it.
void Schedule::Slow() {
  const ir::PlaceId slice = locals_.AddParameter(slow_, "slice", Type::kI8);
  builder_.SetRegion(program_.routines[slow_].body);
  const ValueId selected = builder_.Load(slice);
  if (modules_.loops()) {
    builder_.When(Pure(OpKind::kEqual8, {selected, Byte(0)}),
                  [&] { scalars_.Store(ScalarPlace::kSlowRounds, Number(settings_.loop_budget)); });
    scalars_.Store(ScalarPlace::kRounds, scalars_.Load(ScalarPlace::kSlowRounds));
  }
  ir::Switch arms;
  for (uint32_t k = 0; k < kSlices; ++k) {
    const ModuleId module = ModuleOf(kFirstLoopModule + k);
    if (!module.valid() && k + 1 < kSlices) continue;
    builder_.AddArm(arms, {k}, [&] {
      if (module.valid()) EnterWhenActive(module);
      if (k + 1 == kSlices) builder_.Increment(scalars_.Of(ScalarPlace::kSlowDone));
    });
  }
  builder_.AddArm(arms, {}, [] {});
  builder_.SwitchOn(selected, std::move(arms));
  if (modules_.loops()) scalars_.Store(ScalarPlace::kSlowRounds, scalars_.Load(ScalarPlace::kRounds));
}

void Schedule::Advance() {
  const ir::PlaceId elapsed = locals_.AddParameter(advance_, "elapsed_ms", Type::kI32);
  builder_.SetRegion(program_.routines[advance_].body);
  const ValueId ms = builder_.Load(elapsed);
  for (const ir::StateId timer : instances_.timers()) {
    if (timer.valid()) builder_.Step(OpKind::kPassTime, timer, {ms});
  }
  // Both parts modulo 1000 before they are added: no sum can wrap, however long the machine runs.
  const ValueId rest = Pure(OpKind::kUnsignedRem32, {ms, Number(kSecond)});
  const ValueId sum = Pure(OpKind::kAdd32, {scalars_.Load(ScalarPlace::kOfSecond), rest});
  scalars_.Store(ScalarPlace::kOfSecond, Pure(OpKind::kUnsignedRem32, {sum, Number(kSecond)}));
}

/// I 20.0 is 0, I 20.1 is 1, I 20.7 changes with 1 Hz (D60).
void Schedule::SystemSignals() {
  builder_.Store(cells_.Bit(SystemSignal(0)), builder_.Bit(0));
  builder_.Store(cells_.Bit(SystemSignal(1)), builder_.Bit(1));
  const ValueId second_half =
      Pure(OpKind::kGreaterEqual32, {scalars_.Load(ScalarPlace::kOfSecond), Number(kHalfSecond)});
  builder_.Store(cells_.Bit(SystemSignal(7)), second_half);
}

void Schedule::Tick() {
  const ir::PlaceId elapsed = locals_.AddParameter(tick_, "elapsed_ms", Type::kI32);
  builder_.SetRegion(program_.routines[tick_].body);
  builder_.CallRoutine(advance_, {builder_.Load(elapsed)});
  builder_.CallRoutine(refresh_inputs_, {});
  SystemSignals();
  builder_.AsExchange(host_(HostCall::kNcToPlc));
  builder_.CallRoutine(fast_, {});
  builder_.CallRoutine(refresh_outputs_, {});
  builder_.AsExchange(host_(HostCall::kPlcToNc));
}

void Schedule::SlowPass() {
  builder_.SetRegion(program_.routines[slow_pass_].body);
  for (uint32_t k = 0; k < kSlices; ++k) {
    const bool begins_budget = k == 0 && modules_.loops();
    if (!ModuleOf(kFirstLoopModule + k).valid() && !begins_budget && k + 1 < kSlices) continue;
    builder_.CallRoutine(slow_, {Byte(k)});
  }
}

/// At most eight slices, until one has found its module active.
void Schedule::SlowStep() {
  const ir::RegionId body = program_.routines[slow_step_].body;
  builder_.SetRegion(body);
  const ir::PlaceId tries = locals_.Add("tries", Type::kI8), active = locals_.Add("active", Type::kBit);
  builder_.Store(tries, Byte(0));
  ir::Loop loop{.kind = ir::LoopBound::kProven,
                .bound = kSlices,
                .budget = {},
                .condition = builder_.NewRegion(),
                .body = builder_.NewRegion(),
                .exhausted = {}};
  builder_.SetRegion(loop.condition);
  Pure(OpKind::kLess8, {builder_.Load(tries), Byte(kSlices)});
  builder_.SetRegion(body);
  const ir::InstId tries_loop = builder_.LoopWith(loop);

  builder_.SetRegion(loop.body);
  builder_.Store(tries, Pure(OpKind::kAdd8, {builder_.Load(tries), Byte(1)}));
  const ValueId slice = scalars_.Load(ScalarPlace::kNextSlice);
  builder_.Store(active, builder_.Bit(0));
  ir::Switch arms;
  for (uint32_t k = 0; k < kSlices; ++k) {
    if (!ModuleOf(kFirstLoopModule + k).valid()) continue;
    builder_.AddArm(arms, {k},
                    [&] { builder_.Store(active, builder_.Load(cells_.Bit(ActivityOf(kFirstLoopModule + k)))); });
  }
  builder_.AddArm(arms, {}, [] {});
  builder_.SwitchOn(slice, std::move(arms));
  builder_.CallRoutine(slow_, {slice});
  const ValueId next = Pure(OpKind::kAdd8, {slice, Byte(1)});
  scalars_.Store(ScalarPlace::kNextSlice, Pure(OpKind::kAnd8, {next, Byte(kSlices - 1)}));
  builder_.Exit(tries_loop, builder_.Load(active));
}

/// For simulations: what a host does that knows the time.
void Schedule::Periods() {
  const auto elapsed = [&] {
    const ValueId now = host_(HostCall::kNow, {});
    const ValueId passed = Pure(OpKind::kSub32, {now, scalars_.Load(ScalarPlace::kNow)});
    scalars_.Store(ScalarPlace::kNow, now);
    return passed;
  };
  for (const ir::RoutineId id : {period_, fast_only_}) {
    builder_.SetRegion(program_.routines[id].body);
    builder_.CallRoutine(tick_, {elapsed()});
    if (id == period_) builder_.CallRoutine(slow_pass_, {});
  }
  builder_.SetRegion(program_.routines[elapse_].body);
  builder_.CallRoutine(advance_, {elapsed()});
  if (settings_.io_refresh == IoRefresh::kTick) return;
  builder_.CallRoutine(refresh_inputs_, {});
  builder_.CallRoutine(refresh_outputs_, {});
}

void Schedule::Fill() {
  ir::Schedule& schedule = program_.schedule;
  schedule.init = init_;
  schedule.period = period_;
  schedule.fast_only = fast_only_;
  schedule.elapse = elapse_;
  schedule.elapses_every_ms = settings_.io_refresh == IoRefresh::kMillisecond;
  schedule.period_ends_its_time = true;
  schedule.period_ms = settings_.tick_ms;
  schedule.slot_ms = settings_.tick_ms;
  schedule.slow_done = scalars_.Of(ScalarPlace::kSlowDone);
  schedule.now = host_[HostCall::kNow];
  schedule.retention = memory_[SpaceKey::kDKept].valid();
  if (schedule.retention) schedule.retentive_load = host_[HostCall::kRetentiveLoad];
}

}  // namespace plcxx::prostep
