#include "transpiler/dialects/nc110/lowering/schedule.h"

#include "transpiler/dialects/nc110/lowering/cells.h"
#include "transpiler/dialects/nc110/lowering/routines.h"

namespace plcxx::nc110 {
namespace {

constexpr Operand Output(Package package, uint16_t connector, uint8_t bit) {
  return {.kind = OperandKind::kOutput, .package = package, .number = connector, .index = bit};
}
constexpr Operand kMachineOff = Output(Package::kK, 10, 0);   // MUSPE
constexpr Operand kSaveRequest = Output(Package::kN, 10, 4);  // SAVET
constexpr Operand kMessageNumber{.kind = OperandKind::kWord, .package = Package::kK, .number = 17, .index = 3};
constexpr Operand kFirstMessage = Output(Package::kK, 21, 0);
constexpr uint32_t kMessageBits = 64;

}  // namespace

Schedule::Schedule(const Context& context, HostCalls& host, Cells& cells, SystemPlaces& system,
                   const Routines& routines)
    : Context(context), host_(host), cells_(cells), system_(system), routines_(routines) {}

void Schedule::Declare() {
  ir::Schedule& schedule = program_.schedule;
  schedule.init = routines_.init();
  schedule.period = routines_.period();
  schedule.fast_only = routines_.fast_only();
  schedule.period_ms = settings_.period_ms;
  schedule.slot_ms = settings_.slot_ms;
  schedule.slices_by_cost = settings_.slices_by_cost;
  schedule.slow_done = system_.Of(SystemPlace::kSlowDone);
  schedule.now = host_[HostCall::kNow];
  schedule.retentive_load = host_[HostCall::kRetentiveLoad];
  schedule.retentive_store = host_[HostCall::kRetentiveStore];
  schedule.retention = settings_.retention;
  if (settings_.retention) schedule.retain_at_power_off = cells_.PlaceOf(kMachineOff);
}

void Schedule::BeginPeriod() {
  if (system_.IsUsed(SystemPlace::kNow)) {
    system_.Store(SystemPlace::kNow, host_(HostCall::kNow));
  }
  host_(HostCall::kReadInputs);
  builder_.CallRoutine(routines_.fast(), {});
}

void Schedule::AdvanceSlice() {
  const ir::ValueId zero = Byte(0);
  const ir::ValueId done = builder_.Pure(ir::OpKind::kEqual8, {system_.Load(SystemPlace::kSlowOpen), zero});
  builder_.Choose(
      done, [&] { system_.Store(SystemPlace::kSlice, Byte(0)); },
      [&] {
        const ir::ValueId slice = system_.Load(SystemPlace::kSlice), one = Byte(1);
        system_.Store(SystemPlace::kSlice, builder_.Pure(ir::OpKind::kAdd8, {slice, one}));
      });
}

/// 1 in the period in which `signal` has risen; remembers it for the next one.
ir::ValueId Schedule::Rose(const Operand& signal, SystemPlace before) {
  const ir::ValueId is = builder_.Load(cells_.PlaceOf(signal));
  const ir::ValueId was = system_.Load(before);
  const ir::ValueId rose = builder_.Pure(ir::OpKind::kBitAnd, {is, builder_.Pure(ir::OpKind::kBitNot, {was})});
  system_.Store(before, is);
  return rose;
}

void Schedule::StoreRetentive() {
  ir::ValueId store = Rose(kSaveRequest, SystemPlace::kSaveWas);
  if (settings_.retention) {
    const ir::ValueId off = Rose(kMachineOff, SystemPlace::kPowerWas);
    store = builder_.Pure(ir::OpKind::kBitOr, {store, off});
  }
  builder_.When(store, [&] { host_(HostCall::kRetentiveStore); });
}

void Schedule::LowerPeriod() {
  builder_.SetRegion(program_.routines[routines_.period()].body);
  BeginPeriod();
  builder_.CallRoutine(routines_.slow(), {sliced() ? system_.Load(SystemPlace::kSlice) : Byte(0)});
  if (sliced()) AdvanceSlice();
  host_(HostCall::kWriteOutputs);
  StoreRetentive();
}

void Schedule::LowerFastOnly() {
  builder_.SetRegion(program_.routines[routines_.fast_only()].body);
  BeginPeriod();
  host_(HostCall::kWriteOutputs);
}

void Schedule::Lower() {
  builder_.SetRegion(program_.routines[routines_.init()].body);
  if (settings_.retention) host_(HostCall::kRetentiveLoad);
  LowerPeriod();
  LowerFastOnly();
}

void Schedule::AddMessagePlaces() {
  program_.message_bits.push_back({.space = SpaceOf(kFirstMessage.package),
                                   .offset = ByteOf(kFirstMessage),
                                   .first_number = 1,
                                   .count = kMessageBits});
  program_.message_words.push_back({.place = cells_.PlaceOf(kMessageNumber)});
}

}  // namespace plcxx::nc110
