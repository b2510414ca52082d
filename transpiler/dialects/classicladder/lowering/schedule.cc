// What is around the program's rungs: routines, init, the period, host calls.

#include "transpiler/dialects/classicladder/lowering/internal.h"
#include "transpiler/ir/host_functions.h"

namespace plcxx::classicladder {
namespace {

const std::vector<dialects::HostRow<HostCall>>& HostRows() {
  static const std::vector<dialects::HostRow<HostCall>> rows = {
      {.call = HostCall::kReadInputs,
       .name = "read_inputs",
       .access = ir::HostAccess::kWritesState,
       .routine_exchange = true,
       .comment = "At the start of each period: fill %I, %IW and %IF. Floats lose what is behind the point."},
      {.call = HostCall::kWriteOutputs,
       .name = "write_outputs",
       .access = ir::HostAccess::kReadsState,
       .routine_exchange = true,
       .comment = "At the end of each period: deliver %Q, %QW and %QF."},
      {.call = HostCall::kFault,
       .name = ir::kFaultFunction,
       .comment = "JUMP_LOOP: a section has jumped 99999 times, and the program stands still from the next period on. "
                  "INDEX: an indexed variable leads out of its memory. DIVISION: by 0. The last two end the process of "
                  "LinuxCNC's engine, or spoil its memory; here what is read is 0, and nothing is written.",
       .parameters = {{.name = "code", .type = ir::Type::kI8, .enumerators = {"JUMP_LOOP", "INDEX", "DIVISION"}}}},
  };
  return rows;
}

}  // namespace

void Lowering::AddRoutines() {
  host_.Add(HostRows());
  init_ = builder_.AddRoutine("init", ir::RoutineKind::kInit,
                              "Power-on: presets as the project has them, initial steps active, the rest 0.");
  fast_ = builder_.AddRoutine("fast", ir::RoutineKind::kFast, "The main sections, in every period.");
  period_ = builder_.AddRoutine("period", ir::RoutineKind::kSchedule, "One refresh of the engine.");
  periods_ = NewSystemPlace("periods", ir::Type::kI32);
  stopped_ = NewSystemPlace("stopped", ir::Type::kBit);
}

void Lowering::CallFault(Fault fault) {
  host_(HostCall::kFault, {builder_.Constant(ir::Type::kI8, static_cast<uint64_t>(fault))});
}

/// Edges know their variables as they are at power-on: bits in memory are 0, presets need not be.
void Lowering::Init() {
  builder_.SetRange({});
  builder_.SetRegion(program_.routines[init_].body);
  for (const Element* element : edge_elements_) {
    const bool zero = !element->variable.index && Info(element->variable.address.kind).group == Group::kBits;
    if (zero) continue;
    const ir::ValueId operand = ReadBit(element->variable);
    builder_.Step(ir::OpKind::kPresetEdge, EdgeOf(*element), {operand});
  }
}

void Lowering::Period() {
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

void Lowering::Schedule() {
  ir::Schedule& schedule = program_.schedule;
  schedule.init = init_;
  schedule.period = period_;
  schedule.fast_only = period_;
  schedule.period_ms = settings_.period_ms;
  schedule.slot_ms = settings_.period_ms;
  schedule.slow_done = periods_;
}

}  // namespace plcxx::classicladder
