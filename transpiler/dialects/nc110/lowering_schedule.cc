// What stands around the program's statements: routines, the period, host calls, slices, retentive memory
// (specification 4.2 to 4.5, 8.1).

#include "transpiler/dialects/nc110/lowering_internal.h"

namespace plcxx::nc110 {
namespace {

const std::vector<dialects::HostRow<HostCall>>& HostRows() {
  static const std::vector<dialects::HostRow<HostCall>> rows = {
      {.call = HostCall::kNow,
       .name = "now_ms",
       .routine_exchange = true,
       .comment = "Monotonic time in ms; it may wrap. Latched once at the start of each period.",
       .result = ir::Type::kI32},
      {.call = HostCall::kReadInputs,
       .name = "read_inputs",
       .access = ir::HostAccess::kWritesState,
       .routine_exchange = true,
       .comment =
           "Start of each period: fill the input connectors of package A, the NC -> PLC signals of packages K and N, "
           "and what else the control writes."},
      {.call = HostCall::kWriteOutputs,
       .name = "write_outputs",
       .access = ir::HostAccess::kReadsState,
       .routine_exchange = true,
       .comment =
           "End of each period: deliver the output connectors of package A and the PLC -> NC signals of packages K "
           "and N."},
      {.call = HostCall::kRetentiveLoad,
       .name = "retentive_load",
       .access = ir::HostAccess::kWritesRetentive,
       .routine_exchange = true,
       .comment = "At power-on: fill package T with the image stored last; leave it alone if there is none."},
      {.call = HostCall::kRetentiveStore,
       .name = "retentive_store",
       .access = ir::HostAccess::kReadsRetentive,
       .comment = "Store package T: U10K0 (machine off, retention enabled) or U10N4 (request of the program) rose."},
      {.call = HostCall::kFault,
       .name = "fault",
       .comment = "A diagnostic that never stops the logic. Index: the counter's number (PARAM_RANGE), otherwise the "
                  "statement's id as the map lists it.",
       .parameters = {{.name = "kind",
                       .type = ir::Type::kI8,
                       .enumerators = {"PARAM_RANGE", "LOOP_LIMIT", "BCD_RANGE", "BIN_DIGIT"}},
                      {.name = "index", .type = ir::Type::kI32, .enumerators = {}}}},
  };
  return rows;
}

constexpr Operand Output(Package package, uint16_t connector, uint8_t bit) {
  return {.kind = OperandKind::kOutput, .package = package, .number = connector, .index = bit};
}
constexpr Operand kMachineOff = Output(Package::kK, 10, 0);   // MUSPE
constexpr Operand kSaveRequest = Output(Package::kN, 10, 4);  // SAVET
constexpr Operand kMessageNumber{.kind = OperandKind::kWord, .package = Package::kK, .number = 17, .index = 3};
constexpr Operand kFirstMessage = Output(Package::kK, 21, 0);
constexpr uint32_t kMessageBits = 64;

}  // namespace

void Lowering::AddRoutines() {
  host_.Add(HostRows());
  facts_.Begin(settings_.facts);
  init_ = builder_.AddRoutine("init", ir::RoutineKind::kInit,
                              "Power-on: everything is 0 but package T, which gets its values.");
  fast_ = builder_.AddRoutine("fast", ir::RoutineKind::kFast, "The fast part: all of it in every period.");
  slow_ = builder_.AddRoutine("slow", ir::RoutineKind::kSlow, "The slow part: one slice in every period.");
  period_ = builder_.AddRoutine("period", ir::RoutineKind::kSchedule, "One period of the control.");
  fast_only_ = builder_.AddRoutine("fast_only", ir::RoutineKind::kSchedule, "A period without the slow part.");
  fast_body_ = program_.routines[fast_].body;
  slow_body_ = program_.routines[slow_].body;

  ir::Routine& slow = program_.routines[slow_];
  slow.sliced = true;
  slow.slices = settings_.slices;
  slow.parameters = {{.name = "slice", .type = ir::Type::kI8, .enumerators = {}}};
  slow.parameter_places = {
      program_.places.Add({.name = "slice", .type = ir::Type::kI8, .space = SpaceOf(SpaceIndex::kArguments)})};
  program_.routines[fast_only_].simulation_only = true;

  ir::Schedule& schedule = program_.schedule;
  schedule.init = init_;
  schedule.period = period_;
  schedule.fast_only = fast_only_;
  schedule.period_ms = settings_.period_ms;
  schedule.slot_ms = settings_.slot_ms;
  schedule.slices_by_cost = settings_.slices_by_cost;
  schedule.slow_done = SystemPlaceOf(SystemPlace::kSlowDone);
  schedule.now = host_[HostCall::kNow];
  schedule.retentive_load = host_[HostCall::kRetentiveLoad];
  schedule.retentive_store = host_[HostCall::kRetentiveStore];
  schedule.retention = settings_.retention;
  if (settings_.retention) schedule.retain_at_power_off = PlaceOf(kMachineOff);
}

void Lowering::FastFrame() {
  builder_.SetRange({});
  const std::vector<ir::StateId>& driven = driven_[static_cast<size_t>(Part::kFast)].order;
  if (driven.empty()) return;
  // The number goes on before the statements stamp with it, so that at the end an equal stamp means "in this one".
  if (system_[static_cast<size_t>(SystemPlace::kFastCount)].valid()) {
    program_.routines[fast_].prologue = builder_.NewRegion();
    builder_.SetRegion(program_.routines[fast_].prologue);
    builder_.Increment(SystemPlaceOf(SystemPlace::kFastCount));
  }
  program_.routines[fast_].epilogue = builder_.NewRegion();
  builder_.SetRegion(program_.routines[fast_].epilogue);
  for (const ir::StateId state : driven) {
    if (program_.states[state].kind == ir::StateKind::kRingCounter) {
      builder_.Step(ir::OpKind::kExpireCounterFast, state, {LoadSystem(SystemPlace::kFastCount)});
    } else {
      builder_.Step(ir::OpKind::kExpirePulseFast, state, {LoadSystem(SystemPlace::kSlowDone)});
    }
  }
}

void Lowering::SlowFrame() {
  builder_.SetRange({});
  const std::vector<ir::StateId>& driven = driven_[static_cast<size_t>(Part::kSlow)].order;
  const ir::RegionId prologue = builder_.NewRegion();
  builder_.SetRegion(prologue);
  const bool counts_cycles = system_[static_cast<size_t>(SystemPlace::kSlowCycle)].valid();
  if (counts_cycles) builder_.Increment(SystemPlaceOf(SystemPlace::kSlowCycle));
  if (sliced()) StoreSystem(SystemPlace::kSlowOpen, builder_.Constant(ir::Type::kI8, 1));
  for (uint32_t i = 0; i < flags_.size(); ++i) {
    if (!flags_[i].valid()) continue;
    const std::string_view text = sources_.Text(tree_.literals[LiteralId(i)].range);
    const ir::TextId id = program_.texts.Add(std::string(text));
    builder_.UpdateText(program_.places[flags_[i]].state, program_.text_inbox, id);
  }
  if (program_.text_inbox.valid()) builder_.Step(ir::OpKind::kClearText, program_.text_inbox, {});
  for (const Operand& operand : latch_order_) {
    builder_.Store(latched_.at(KeyOf(operand)), builder_.Load(PlaceOf(operand)));
  }
  if (!program_.regions[prologue].insts.empty()) program_.routines[slow_].prologue = prologue;

  const ir::RegionId epilogue = builder_.NewRegion();
  builder_.SetRegion(epilogue);
  if (sliced()) StoreSystem(SystemPlace::kSlowOpen, builder_.Constant(ir::Type::kI8, 0));
  builder_.Increment(SystemPlaceOf(SystemPlace::kSlowDone));
  for (const ir::StateId state : driven) {
    const bool counter = program_.states[state].kind == ir::StateKind::kRingCounter;
    builder_.Step(counter ? ir::OpKind::kExpireCounterSlow : ir::OpKind::kExpirePulseSlow, state,
                  {LoadSystem(SystemPlace::kSlowCycle)});
  }
  program_.routines[slow_].epilogue = epilogue;
}

void Lowering::Init() {
  builder_.SetRegion(program_.routines[init_].body);
  if (settings_.retention) host_(HostCall::kRetentiveLoad);
}

void Lowering::BeginPeriod() {
  if (system_[static_cast<size_t>(SystemPlace::kNow)].valid()) {
    StoreSystem(SystemPlace::kNow, host_(HostCall::kNow));
  }
  host_(HostCall::kReadInputs);
  builder_.CallRoutine(fast_, {});
}

void Lowering::AdvanceSlice() {
  const ir::ValueId zero = builder_.Constant(ir::Type::kI8, 0);
  const ir::ValueId done = builder_.Pure(ir::OpKind::kEqual8, {LoadSystem(SystemPlace::kSlowOpen), zero});
  builder_.Choose(
      done, [&] { StoreSystem(SystemPlace::kSlice, builder_.Constant(ir::Type::kI8, 0)); },
      [&] {
        const ir::ValueId slice = LoadSystem(SystemPlace::kSlice), one = builder_.Constant(ir::Type::kI8, 1);
        StoreSystem(SystemPlace::kSlice, builder_.Pure(ir::OpKind::kAdd8, {slice, one}));
      });
}

/// 1 in the period in which `signal` has risen; remembers it for the next one.
ir::ValueId Lowering::Rose(const Operand& signal, SystemPlace before) {
  const ir::ValueId is = builder_.Load(PlaceOf(signal));
  const ir::ValueId was = LoadSystem(before);
  const ir::ValueId rose = builder_.Pure(ir::OpKind::kBitAnd, {is, builder_.Pure(ir::OpKind::kBitNot, {was})});
  StoreSystem(before, is);
  return rose;
}

void Lowering::StoreRetentive() {
  ir::ValueId store = Rose(kSaveRequest, SystemPlace::kSaveWas);
  if (settings_.retention) {
    const ir::ValueId off = Rose(kMachineOff, SystemPlace::kPowerWas);
    store = builder_.Pure(ir::OpKind::kBitOr, {store, off});
  }
  builder_.When(store, [&] { host_(HostCall::kRetentiveStore); });
}

void Lowering::Period() {
  builder_.SetRegion(program_.routines[period_].body);
  BeginPeriod();
  builder_.CallRoutine(slow_, {sliced() ? LoadSystem(SystemPlace::kSlice) : builder_.Constant(ir::Type::kI8, 0)});
  if (sliced()) AdvanceSlice();
  host_(HostCall::kWriteOutputs);
  StoreRetentive();
}

void Lowering::FastOnly() {
  builder_.SetRegion(program_.routines[fast_only_].body);
  BeginPeriod();
  host_(HostCall::kWriteOutputs);
}

void Lowering::MessagePlaces() {
  program_.message_bits.push_back({.space = SpaceOf(kFirstMessage.package),
                                   .offset = ByteOf(kFirstMessage),
                                   .first_number = 1,
                                   .count = kMessageBits});
  program_.message_words.push_back({.place = PlaceOf(kMessageNumber)});
}

}  // namespace plcxx::nc110
