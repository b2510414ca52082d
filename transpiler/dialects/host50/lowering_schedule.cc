// What stands around the program's statements: routines, init and the tick, host calls, alarms (4.3, 8, 9).

#include "transpiler/dialects/host50/lowering_internal.h"

namespace plcxx::host50 {
namespace {

using ir::OpKind;
using ir::ValueId;

const std::vector<dialects::HostRow<HostCall>>& HostRows() {
  static const std::vector<dialects::HostRow<HostCall>> rows = {
      {.call = HostCall::kReadInputs,
       .name = "read_inputs",
       .access = ir::HostAccess::kWritesState,
       .routine_exchange = true,
       .comment = "In init and at the start of each tick: fill %I, %IW and %IF, all at once."},
      {.call = HostCall::kWriteOutputs,
       .name = "write_outputs",
       .access = ir::HostAccess::kReadsState,
       .routine_exchange = true,
       .comment = "At the end of each tick: deliver %Q, %QW and %QF."},
      {.call = HostCall::kRetentiveLoad,
       .name = "retentive_load",
       .access = ir::HostAccess::kWritesRetentive,
       .routine_exchange = true,
       .comment =
           "In init: fill %B0 to %B500, %W0 to %W100 and %F0 to %F100 as stored last; leave them alone if nothing is "
           "stored."},
      {.call = HostCall::kAlarm,
       .name = "alarm",
       .comment = "After write_outputs: an alarm bit, %Q400 + index, has changed.",
       .parameters = {{.name = "index", .type = ir::Type::kI32, .enumerators = {}},
                      {.name = "on", .type = ir::Type::kBit, .enumerators = {}}}},
      {.call = HostCall::kAxisCommand,
       .name = "axis_command",
       .comment =
           "An axis block starts, changes (active 1) or withdraws (active 0) its request. Axis: 0 to 9; position in mm "
           "or degrees; speed of HOME, POSA and POSM in units/min, of VELP and VELN in rev/min; 0 where the kind has "
           "none.",
       .parameters = {{.name = "axis", .type = ir::Type::kI32, .enumerators = {}},
                      {.name = "kind", .type = ir::Type::kI8, .enumerators = {"HOME", "POSA", "POSM", "VELP", "VELN"}},
                      {.name = "active", .type = ir::Type::kBit, .enumerators = {}},
                      {.name = "method", .type = ir::Type::kI32, .enumerators = {}},
                      {.name = "position", .type = ir::Type::kF32, .enumerators = {}},
                      {.name = "speed", .type = ir::Type::kF32, .enumerators = {}}}},
      {.call = HostCall::kFault,
       .name = "fault",
       .comment =
           "A diagnostic that does not stop the program. Section: -2 FAST, -1 SLOW, else the number of the subroutine.",
       .parameters = {{.name = "code", .type = ir::Type::kI8, .enumerators = {"JUMP_LOOP", "ROT_RANGE", "AXIS_RANGE"}},
                      {.name = "section", .type = ir::Type::kI32, .enumerators = {}},
                      {.name = "network", .type = ir::Type::kI32, .enumerators = {}}}},
  };
  return rows;
}

std::string WithName(const std::string& comment, const std::string& name) {
  return name.empty() ? comment : comment + ": " + name;
}

}  // namespace

void Lowering::AddRoutines() {
  host_.Add(HostRows());
  facts_.Begin(settings_.facts);
  const SectionId fast = FindSection(tree_, SectionKind::kFast), slow = FindSection(tree_, SectionKind::kSlow);
  const auto name_of = [this](SectionId id) { return id.valid() ? tree_.sections[id].name : std::string(); };
  init_ = builder_.AddRoutine("init", ir::RoutineKind::kInit,
                              "Power-on: everything is 0 but the retentive memory; edges know the inputs as they are.");
  fast_ = builder_.AddRoutine("fast", ir::RoutineKind::kFast, WithName("FAST, in every tick", name_of(fast)));
  const bool sliced = settings_.slices == SlicesOption::kSliced;
  slow_ = builder_.AddRoutine(
      "slow", ir::RoutineKind::kSlow,
      WithName(sliced ? "SLOW, one slice in every tick" : "SLOW, once in every slow cycle", name_of(slow)));
  if (fast.valid()) routines_[fast.index] = fast_;
  if (slow.valid()) routines_[slow.index] = slow_;
  for (uint32_t i = 0; i < tree_.sections.size(); ++i) {
    const Section& section = tree_.sections[SectionId(i)];
    if (section.kind != SectionKind::kSubroutine) continue;
    const std::string name = SubroutineName(section.number);
    routines_[i] = builder_.AddRoutine(name, ir::RoutineKind::kSubroutine, WithName("SUB " + name, section.name));
  }
  period_ = builder_.AddRoutine("period", ir::RoutineKind::kSchedule, "One tick of the control.");
  if (sliced) {
    slice_ = NewLocal("slice");
    program_.routines[slow_].parameters = {{.name = "slice", .type = ir::Type::kI32, .enumerators = {}}};
    program_.routines[slow_].parameter_places = {slice_};
  }
  slow_done_ = NewSystemPlace("slow_done", ir::Type::kI32);
  if (settings_.slowdiv > 1) tick_ = NewSystemPlace("tick", ir::Type::kI32);
}

void Lowering::Init() {
  builder_.SetRange({});
  builder_.SetRegion(program_.routines[init_].body);
  host_(HostCall::kRetentiveLoad);
  host_(HostCall::kReadInputs);
  if (settings_.edgeinit == EdgeInitOption::kOff) return;
  for (const InstructionId edge : edges_) {
    const ValueId operand = Load(OperandOf(tree_, tree_.instructions[edge], 0).address);
    builder_.Step(OpKind::kPresetEdge, own_instances_[edge.index], {operand});
  }
}

/// The slow part in the last tick of each slow cycle, or a slice of it in every one.
void Lowering::RunSlow() {
  const auto number = [this](uint32_t value) { return builder_.Constant(ir::Type::kI32, value); };
  const bool sliced = settings_.slices == SlicesOption::kSliced;
  const auto run_whole = [&] {
    if (!sliced) builder_.CallRoutine(slow_, {});
    builder_.Increment(slow_done_);
  };
  if (sliced) builder_.CallRoutine(slow_, {tick_.valid() ? builder_.Load(tick_) : number(0)});
  if (!tick_.valid()) return run_whole();
  const ValueId tick = builder_.Load(tick_), last = number(settings_.slowdiv - 1);
  const ValueId ends = builder_.Pure(OpKind::kEqual32, {tick, last});
  const ir::RegionId at_end = builder_.RegionOf([&] {
    run_whole();
    builder_.Store(tick_, number(0));
  });
  builder_.If(ends, at_end, builder_.RegionOf([&] { builder_.Increment(tick_); }));
}

void Lowering::ReportAlarms() {
  for (uint32_t i = 0; i < kAlarmCount; ++i) {
    if (!driven_alarms_[i]) continue;
    const Address alarm{.area = Area::kQ, .number = static_cast<uint16_t>(kFirstAlarm + i)};
    const ir::PlaceId before = NewSystemPlace(NameOf(alarm) + "_was", ir::Type::kBit);
    const ValueId is = Load(alarm), was = builder_.Load(before);
    const ValueId changed = builder_.Pure(OpKind::kBitXor, {is, was});
    builder_.If(changed, builder_.RegionOf([&] {
      const ValueId index = builder_.Constant(ir::Type::kI32, i);
      host_(HostCall::kAlarm, {index, Load(alarm)});
      builder_.Store(before, Load(alarm));
    }));
  }
}

void Lowering::Period() {
  builder_.SetRegion(program_.routines[period_].body);
  host_(HostCall::kReadInputs);
  builder_.CallRoutine(fast_, {});
  RunSlow();
  host_(HostCall::kWriteOutputs);
  ReportAlarms();
}

void Lowering::Schedule() {
  ir::Schedule& schedule = program_.schedule;
  schedule.init = init_;
  schedule.period = period_;
  schedule.fast_only = period_;  // `run: {fast: n}` are whole ticks (4.3)
  schedule.period_ms = 1;
  schedule.slot_ms = 1;
  schedule.slow_done = slow_done_;
  schedule.retentive_load = host_[HostCall::kRetentiveLoad];
  schedule.retention = true;
}

}  // namespace plcxx::host50
