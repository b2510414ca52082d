#include "transpiler/dialects/technol/lowering/schedule.h"

#include <string>

#include "transpiler/dialects/technol/lowering/cell_places.h"
#include "transpiler/dialects/technol/lowering/mechanisms.h"
#include "transpiler/dialects/technol/lowering/requests.h"

namespace plcxx::technol {

void Schedule::AddRoutines() {
  using Kind = ir::RoutineKind;
  const std::string slow_ms = std::to_string(settings_.slow_ms), fast_ms = std::to_string(settings_.fast_ms);
  init_ = builder_.AddRoutine(
      "init", Kind::kInit,
      "Power-on: everything is 0 but the declared data and the retentive memory; then MODULE_INIT.");
  fast_ = builder_.AddRoutine("fast", Kind::kFast, "A fast pass: call it every " + fast_ms + " ms, before a slow one.");
  slow_ = builder_.AddRoutine("slow", Kind::kSlow, "The modules of a slow pass, from the annulment to MODULE_HALT.");
  requests_ = builder_.AddRoutine("requests", Kind::kSchedule, "The control looks at the requests of the program.");
  period_ = builder_.AddRoutine("period", Kind::kSchedule,
                                "A slow pass with its exchange of signals: call it every " + slow_ms + " ms.");
  fast_only_ = builder_.AddRoutine("fast_only", Kind::kSchedule, "A fast pass alone.");
  program_.routines[fast_only_].simulation_only = true;
}

bool Schedule::IsUsed(Area area) const {
  for (const Operand& operand : tree_.operands) {
    if (operand.address.area == area) return true;  // what is no cell has no area
  }
  return false;
}

void Schedule::Lower() {
  frame_.routine = nullptr;
  Slow();
  builder_.SetRegion(program_.routines[requests_].body);
  served_.Serve();
  Period();
  Fill();
}

void Schedule::LowerPowerOn() {
  builder_.SetRange({});
  const ir::RegionId prologue = builder_.NewRegion();
  program_.routines[init_].prologue = prologue;
  builder_.SetRegion(prologue);
  host_(HostCall::kRestore);
  if (!IsUsed(Area::kBukon)) return;
  const ir::HostFunctionId constants = host_[HostCall::kMachineConstants];
  program_.host_functions[constants].only_space = memory_[Area::kBukon];
  host_(HostCall::kMachineConstants);
}

/// A module of functions runs while its bit is 1; else it begins anew the next time (7.4).
void Schedule::RunFunctions(ModuleKind kind, std::string_view bit) {
  const Routine* routine = routines_.OfModule(kind);
  const ir::PlaceId active = cells_.System(bit);
  if (routine == nullptr) return builder_.Store(active, builder_.Bit(0));  // nothing to do is done at once
  const auto run = [&] { builder_.CallRoutine(routine->id, {}); };
  if (mechanisms_.Keeps(*routine)) {
    builder_.Choose(builder_.Load(active), run, [&] { mechanisms_.Rewind(routine->unit); });
  } else {
    builder_.When(builder_.Load(active), run);
  }
}

void Schedule::BeginFast() { mechanisms_.RewindCleared(); }

void Schedule::Slow() {
  builder_.SetRange({});
  builder_.SetRegion(program_.routines[slow_].body);
  mechanisms_.RewindCleared();
  const ir::PlaceId annulment = cells_.System("NC_CLEAR");
  const Routine* clear = routines_.OfModule(ModuleKind::kClear);
  if (clear != nullptr) {
    builder_.When(builder_.Load(annulment), [&] {
      builder_.CallRoutine(clear->id, {});
      builder_.Store(annulment, builder_.Bit(0));
    });
  } else {
    builder_.Store(annulment, builder_.Bit(0));
  }
  RunFunctions(ModuleKind::kPripravne, "NC_PRIPRAVNE");
  if (const Routine* main = routines_.OfModule(ModuleKind::kMain)) builder_.CallRoutine(main->id, {});
  for (const Routine& routine : routines_.all()) {
    if (IsMechanism(routine) && !tree_.units[routine.unit].parent.valid()) mechanisms_.Enter(routine);
  }
  RunFunctions(ModuleKind::kZaverecne, "NC_ZAVERECNE");
  const Routine* halt = routines_.OfModule(ModuleKind::kHalt);
  if (halt == nullptr) return;
  builder_.When(builder_.Load(cells_.System("REQ_PIS_HALT")), [&] {
    builder_.CallRoutine(halt->id, {});
    host_(HostCall::kHaltPass);
  });
}

void Schedule::Period() {
  builder_.SetRegion(program_.routines[period_].body);
  host_(HostCall::kReadInputs);
  builder_.CallRoutine(slow_, {});
  host_(HostCall::kWriteOutputs);
  builder_.CallRoutine(requests_, {});
  builder_.SetRegion(program_.routines[fast_only_].body);
  builder_.CallRoutine(fast_, {});
}

void Schedule::Fill() {
  ir::Schedule& schedule = program_.schedule;
  schedule.init = init_;
  schedule.period = period_;
  schedule.fast_only = fast_only_;
  schedule.period_ms = settings_.slow_ms;
  schedule.slot_ms = settings_.slow_ms;
  schedule.fast_ms = settings_.fast_ms;
  schedule.retention = true;
  schedule.retentive_load = host_[HostCall::kRestore];
  // With battery-backed memory the host keeps whatever power-off finds, else what was backed up (8.3).
  if (settings_.retain == Retain::kDual) schedule.retain_at_power_off = NeverPlace();
}

ir::PlaceId Schedule::NeverPlace() {
  return program_.places.Add({.name = "keeps_at_power_off",
                              .type = ir::Type::kBit,
                              .space = memory_[SpaceKey::kSteps],
                              .offset = program_.spaces[memory_[SpaceKey::kSteps]].bytes - 1,
                              .bit = 0});
}

}  // namespace plcxx::technol
