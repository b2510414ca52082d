// The scheduler around the modules: power-on, tick, slow passes (specification 4.2 to 4.5, 8.1).

#include "transpiler/dialects/prostep/lowering_internal.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

namespace {

const std::vector<dialects::HostRow<HostCall>>& HostRows() {
  static const std::vector<dialects::HostRow<HostCall>> rows = {
      {.call = HostCall::kNow,
       .name = "now_ms",
       .routine_exchange = true,
       .comment = "Time since power-on in ms.",
       .result = Type::kI32},
      {.call = HostCall::kReadPort,
       .name = "read_port",
       .comment =
           "A byte of direct inputs: 0 to 23 (inputs 8 n + 1 to 8 n + 8), 100 to 131 extra cards (ports 340H to 35FH).",
       .result = Type::kI8,
       .parameters = {{"port", Type::kI32, {}}}},
      {.call = HostCall::kWritePort,
       .name = "write_port",
       .comment = "A byte of direct outputs: 0 to 11, 100 to 131 extra cards.",
       .parameters = {{"port", Type::kI32, {}}, {"value", Type::kI8, {}}}},
      {.call = HostCall::kNcRead,
       .name = "nc_read",
       .comment = "FM 41, 42, 44: a system variable of 1, 2 or 4 bytes; offset is signed. False: there is none.",
       .result = Type::kBit,
       .parameters = {{"width", Type::kI32, {}}, {"index", Type::kI16, {}}, {"offset", Type::kI16, {}}},
       .out = {.name = "value", .type = Type::kI32, .enumerators = {}}},
      {.call = HostCall::kNcWrite,
       .name = "nc_write",
       .comment = "FM 51, 52, 54: as nc_read; the value has no bits above its width.",
       .result = Type::kBit,
       .parameters = {{"width", Type::kI32, {}},
                      {"index", Type::kI16, {}},
                      {"offset", Type::kI16, {}},
                      {"value", Type::kI32, {}}}},
      {.call = HostCall::kNcToPlc,
       .name = "nc_to_plc",
       .access = ir::HostAccess::kWritesState,
       .routine_exchange = true,
       .comment = "In each tick before the interrupt modules: the NC sets its signals in I, F and D."},
      {.call = HostCall::kPlcToNc,
       .name = "plc_to_nc",
       .access = ir::HostAccess::kWritesState,
       .routine_exchange = true,
       .comment = "In each tick behind the output refresh: the NC looks at the signals in O and F, and clears "
                  "handshake bits."},
      {.call = HostCall::kRetentiveLoad,
       .name = "retentive_load",
       .access = ir::HostAccess::kWritesRetentive,
       .routine_exchange = true,
       .comment =
           "At power-on: fill the retentive block with the copy saved at power-off; leave it alone if there is none."},
      {.call = HostCall::kFault,
       .name = "fault",
       .comment = "A fault in module PM pm. It never stops the PLC.",
       .parameters = {{"code", Type::kI8, {"div_zero", "div_overflow", "index", "nc_access", "loop_budget"}},
                      {"pm", Type::kI32, {}}}},
  };
  return rows;
}

constexpr uint32_t kSlices = 8;
constexpr uint32_t kSecond = 1000, kHalfSecond = 500;
constexpr Operand SystemSignal(uint8_t bit) { return {.kind = OperandClass::kI, .bit = bit, .number = 20}; }
constexpr Operand ActivityOf(uint32_t module) {
  const uint32_t bit = module - 1;  // F 250.0 is PM 1, F 251.0 is PM 9
  return {.kind = OperandClass::kF,
          .bit = static_cast<uint8_t>(bit % 8),
          .number = static_cast<uint16_t>(kActivityByte + bit / 8)};
}
constexpr uint32_t kFirstParameter = 16;  // byte of the registers where parameters and locals of routines begin

}  // namespace

ir::PlaceId Lowering::AddLocal(std::string name, Type type) {
  const uint32_t offset = kFirstParameter + 4 * local_count_++;
  return program_.places.Add({.name = std::move(name),
                              .type = type,
                              .space = memory_[SpaceKey::kRegisters],
                              .offset = offset,
                              .bit = type == Type::kBit ? uint8_t{0} : ir::kNoBit});
}

ir::PlaceId Lowering::AddParameter(ir::RoutineId routine, std::string name, Type type) {
  const ir::PlaceId place = AddLocal(name, type);
  program_.routines[routine].parameters.push_back({.name = std::move(name), .type = type, .enumerators = {}});
  program_.routines[routine].parameter_places.push_back(place);
  return place;
}

void Lowering::AddScheduleRoutines() {
  host_.Add(HostRows());
  facts_.Begin(settings_.facts);
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
void Lowering::Enter(ModuleId module) {
  if (IsCalled(module)) {
    StoreScalar(ScalarPlace::kS, builder_.Bit(0));
    StoreScalar(ScalarPlace::kAx, Word(0));
  }
  builder_.CallRoutine(routines_[module.index], {});
}

/// The bit is looked at right before the module's turn (D50).
void Lowering::EnterWhenActive(ModuleId module) {
  builder_.When(builder_.Load(BitPlace(ActivityOf(tree_.modules[module].number))), [&] { Enter(module); });
}

void Lowering::Init() {
  builder_.SetRange({});
  ir::Routine& init = program_.routines[init_];
  const ir::RegionId prologue = builder_.NewRegion();
  init.prologue = prologue;
  builder_.SetRegion(prologue);
  if (memory_[SpaceKey::kDKept].valid()) builder_.AsExchange(host_(HostCall::kRetentiveLoad));
  if (loops_) StoreScalar(ScalarPlace::kRounds, Number(settings_.loop_budget));
  const ModuleId module = ModuleOf(0);
  if (!module.valid() || !IsCalled(module)) return;
  builder_.SetRegion(init.body);
  Enter(module);
}

void Lowering::Fast() {
  builder_.SetRegion(program_.routines[fast_].body);
  if (loops_) StoreScalar(ScalarPlace::kRounds, Number(settings_.loop_budget));
  for (uint32_t number = 1; number < kFirstLoopModule; ++number) {
    if (ModuleOf(number).valid()) EnterWhenActive(ModuleOf(number));
  }
}

/// The loop budget of a slow pass lives in the state, so that its slices share it; slice 0 begins it.
void Lowering::Slow() {
  const ir::PlaceId slice = AddParameter(slow_, "slice", Type::kI8);
  builder_.SetRegion(program_.routines[slow_].body);
  const ValueId selected = builder_.Load(slice);
  if (loops_) {
    builder_.When(builder_.Pure(OpKind::kEqual8, {selected, Byte(0)}),
                  [&] { StoreScalar(ScalarPlace::kSlowRounds, Number(settings_.loop_budget)); });
    StoreScalar(ScalarPlace::kRounds, LoadScalar(ScalarPlace::kSlowRounds));
  }
  ir::Switch arms;
  for (uint32_t k = 0; k < kSlices; ++k) {
    const ModuleId module = ModuleOf(kFirstLoopModule + k);
    if (!module.valid() && k + 1 < kSlices) continue;
    builder_.AddArm(arms, {k}, [&] {
      if (module.valid()) EnterWhenActive(module);
      if (k + 1 == kSlices) builder_.Increment(PlaceOf(ScalarPlace::kSlowDone));
    });
  }
  builder_.AddArm(arms, {}, [] {});
  builder_.SwitchOn(selected, std::move(arms));
  if (loops_) StoreScalar(ScalarPlace::kSlowRounds, LoadScalar(ScalarPlace::kRounds));
}

void Lowering::Advance() {
  const ir::PlaceId elapsed = AddParameter(advance_, "elapsed_ms", Type::kI32);
  builder_.SetRegion(program_.routines[advance_].body);
  const ValueId ms = builder_.Load(elapsed);
  for (const ir::StateId timer : timers_) {
    if (timer.valid()) builder_.Step(OpKind::kPassTime, timer, {ms});
  }
  // Both parts modulo 1000 before they are added: no sum can wrap, however long the machine runs.
  const ValueId rest = builder_.Pure(OpKind::kUnsignedRem32, {ms, Number(kSecond)});
  const ValueId sum = builder_.Pure(OpKind::kAdd32, {LoadScalar(ScalarPlace::kOfSecond), rest});
  StoreScalar(ScalarPlace::kOfSecond, builder_.Pure(OpKind::kUnsignedRem32, {sum, Number(kSecond)}));
}

/// I 20.0 is 0, I 20.1 is 1, I 20.7 changes with 1 Hz (D60).
void Lowering::SystemSignals() {
  builder_.Store(BitPlace(SystemSignal(0)), builder_.Bit(0));
  builder_.Store(BitPlace(SystemSignal(1)), builder_.Bit(1));
  const ValueId second_half =
      builder_.Pure(OpKind::kGreaterEqual32, {LoadScalar(ScalarPlace::kOfSecond), Number(kHalfSecond)});
  builder_.Store(BitPlace(SystemSignal(7)), second_half);
}

void Lowering::Tick() {
  const ir::PlaceId elapsed = AddParameter(tick_, "elapsed_ms", Type::kI32);
  builder_.SetRegion(program_.routines[tick_].body);
  builder_.CallRoutine(advance_, {builder_.Load(elapsed)});
  builder_.CallRoutine(refresh_inputs_, {});
  SystemSignals();
  builder_.AsExchange(host_(HostCall::kNcToPlc));
  builder_.CallRoutine(fast_, {});
  builder_.CallRoutine(refresh_outputs_, {});
  builder_.AsExchange(host_(HostCall::kPlcToNc));
}

void Lowering::SlowPass() {
  builder_.SetRegion(program_.routines[slow_pass_].body);
  for (uint32_t k = 0; k < kSlices; ++k) {
    const bool begins_budget = k == 0 && loops_;
    if (!ModuleOf(kFirstLoopModule + k).valid() && !begins_budget && k + 1 < kSlices) continue;
    builder_.CallRoutine(slow_, {Byte(k)});
  }
}

/// At most eight slices, until one has found its module active.
void Lowering::SlowStep() {
  const ir::RegionId body = program_.routines[slow_step_].body;
  builder_.SetRegion(body);
  const ir::PlaceId tries = AddLocal("tries", Type::kI8), active = AddLocal("active", Type::kBit);
  builder_.Store(tries, Byte(0));
  ir::Loop loop{.kind = ir::LoopBound::kProven,
                .bound = kSlices,
                .budget = {},
                .condition = builder_.NewRegion(),
                .body = builder_.NewRegion(),
                .exhausted = {}};
  builder_.SetRegion(loop.condition);
  builder_.Pure(OpKind::kLess8, {builder_.Load(tries), Byte(kSlices)});
  builder_.SetRegion(body);
  const ir::InstId round = builder_.LoopWith(loop);

  builder_.SetRegion(loop.body);
  builder_.Store(tries, builder_.Pure(OpKind::kAdd8, {builder_.Load(tries), Byte(1)}));
  const ValueId slice = LoadScalar(ScalarPlace::kNextSlice);
  builder_.Store(active, builder_.Bit(0));
  ir::Switch arms;
  for (uint32_t k = 0; k < kSlices; ++k) {
    if (!ModuleOf(kFirstLoopModule + k).valid()) continue;
    builder_.AddArm(arms, {k},
                    [&] { builder_.Store(active, builder_.Load(BitPlace(ActivityOf(kFirstLoopModule + k)))); });
  }
  builder_.AddArm(arms, {}, [] {});
  builder_.SwitchOn(slice, std::move(arms));
  builder_.CallRoutine(slow_, {slice});
  const ValueId next = builder_.Pure(OpKind::kAdd8, {slice, Byte(1)});
  StoreScalar(ScalarPlace::kNextSlice, builder_.Pure(OpKind::kAnd8, {next, Byte(kSlices - 1)}));
  builder_.Exit(round, builder_.Load(active));
}

/// For simulations: what a host does that knows the time.
void Lowering::Periods() {
  const auto elapsed = [&] {
    const ValueId now = host_(HostCall::kNow, {});
    const ValueId passed = builder_.Pure(OpKind::kSub32, {now, LoadScalar(ScalarPlace::kNow)});
    StoreScalar(ScalarPlace::kNow, now);
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

void Lowering::FillSchedule() {
  ir::Schedule& schedule = program_.schedule;
  schedule.init = init_;
  schedule.period = period_;
  schedule.fast_only = fast_only_;
  schedule.elapse = elapse_;
  schedule.elapses_every_ms = settings_.io_refresh == IoRefresh::kMillisecond;
  schedule.period_ends_its_time = true;
  schedule.period_ms = settings_.tick_ms;
  schedule.slot_ms = settings_.tick_ms;
  schedule.slow_done = PlaceOf(ScalarPlace::kSlowDone);
  schedule.now = host_[HostCall::kNow];
  schedule.retention = memory_[SpaceKey::kDKept].valid();
  if (schedule.retention) schedule.retentive_load = host_[HostCall::kRetentiveLoad];
}

}  // namespace plcxx::prostep
