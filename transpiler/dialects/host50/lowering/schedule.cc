#include "transpiler/dialects/host50/lowering/schedule.h"

#include "transpiler/dialects/host50/lowering/cells.h"
#include "transpiler/dialects/host50/lowering/own_instances.h"
#include "transpiler/dialects/host50/lowering/own_places.h"
#include "transpiler/dialects/host50/lowering/routines.h"

namespace plcxx::host50 {

using ir::OpKind;
using ir::ValueId;

Schedule::Schedule(const Context& context, HostCalls& host, Cells& cells, OwnPlaces& own_places,
                   OwnInstances& instances, Routines& routines)
    : Context(context),
      host_(host),
      cells_(cells),
      own_places_(own_places),
      instances_(instances),
      routines_(routines) {}

void Schedule::AddPlaces() {
  slow_done_ = own_places_.System("slow_done", ir::Type::kI32);
  if (settings_.slowdiv > 1) tick_ = own_places_.System("tick", ir::Type::kI32);
}

void Schedule::LowerInit() {
  builder_.SetRange({});
  builder_.SetRegion(program_.routines[routines_.init()].body);
  host_(HostCall::kRetentiveLoad);
  host_(HostCall::kReadInputs);
  if (settings_.edgeinit == EdgeInitOption::kOff) return;
  for (const InstructionId edge : instances_.edges()) {
    const ValueId operand = cells_.Load(OperandOf(tree_.instructions[edge], 0).address);
    builder_.Step(OpKind::kPresetEdge, instances_.Of(edge), {operand});
  }
}

/// The slow part in the last tick of each slow cycle, or a slice of it in every one.
void Schedule::RunSlow() {
  const bool sliced = settings_.slices == SlicesOption::kSliced;
  const auto run_whole = [&] {
    if (!sliced) builder_.CallRoutine(routines_.slow(), {});
    builder_.Increment(slow_done_);
  };
  if (sliced) builder_.CallRoutine(routines_.slow(), {tick_.valid() ? builder_.Load(tick_) : Word(0)});
  if (!tick_.valid()) return run_whole();
  const ValueId tick = builder_.Load(tick_), last = Word(settings_.slowdiv - 1);
  const ValueId ends = builder_.Pure(OpKind::kEqual32, {tick, last});
  const ir::RegionId at_end = builder_.RegionOf([&] {
    run_whole();
    builder_.Store(tick_, Word(0));
  });
  builder_.If(ends, at_end, builder_.RegionOf([&] { builder_.Increment(tick_); }));
}

void Schedule::ReportAlarms() {
  for (uint32_t i = 0; i < kAlarmCount; ++i) {
    if (!cells_.driven_alarms()[i]) continue;
    const Address alarm{.area = Area::kQ, .number = static_cast<uint16_t>(kFirstAlarm + i)};
    const ir::PlaceId before = own_places_.System(NameOf(alarm) + "_was", ir::Type::kBit);
    const ValueId is = cells_.Load(alarm), was = builder_.Load(before);
    const ValueId changed = builder_.Pure(OpKind::kBitXor, {is, was});
    builder_.If(changed, builder_.RegionOf([&] {
      const ValueId index = Word(i);
      host_(HostCall::kAlarm, {index, cells_.Load(alarm)});
      builder_.Store(before, cells_.Load(alarm));
    }));
  }
}

void Schedule::LowerPeriod() {
  builder_.SetRegion(program_.routines[routines_.period()].body);
  host_(HostCall::kReadInputs);
  builder_.CallRoutine(routines_.fast(), {});
  RunSlow();
  host_(HostCall::kWriteOutputs);
  ReportAlarms();
}

void Schedule::Lower() {
  LowerInit();
  LowerPeriod();
  ir::Schedule& schedule = program_.schedule;
  schedule.init = routines_.init();
  schedule.period = routines_.period();
  schedule.fast_only = routines_.period();  // `run: {fast: n}` are whole ticks (4.3)
  schedule.period_ms = 1;
  schedule.slot_ms = 1;
  schedule.slow_done = slow_done_;
  schedule.slow_every_ms = settings_.slowdiv;  // ticks of 1 ms
  schedule.retentive_load = host_[HostCall::kRetentiveLoad];
  schedule.retention = true;
}

}  // namespace plcxx::host50
