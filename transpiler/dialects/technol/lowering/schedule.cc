// The scheduler around the modules: power-on, slow and fast passes (specification 4.2 to 4.4).

#include <utility>

#include "transpiler/dialects/technol/lowering/internal.h"

namespace plcxx::technol {

using ir::ValueId;

void Lowering::AddScheduleRoutines() {
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

/// Does the program, or its host by the program's requests, touch the area?
bool Lowering::IsUsed(Area area) const {
  for (const Operand& operand : tree_.operands) {
    if (operand.address.area == area) return true;  // what is no cell has no area
  }
  return false;
}

void Lowering::Init() {
  builder_.SetRange({});
  const ir::RegionId prologue = builder_.NewRegion();
  program_.routines[init_].prologue = prologue;
  builder_.SetRegion(prologue);
  host_(HostCall::kRestore);
  if (IsUsed(Area::kBukon)) host_(HostCall::kMachineConstants);
}

/// A module of functions runs while its bit is 1; else it begins anew the next time (7.4).
void Lowering::RunFunctions(ModuleKind kind, std::string_view bit) {
  const Body* body = BodyOfModule(kind);
  const ir::PlaceId active = SystemPlace(bit);
  if (body == nullptr) return builder_.Store(active, builder_.Bit(0));  // nothing to do is done at once
  const auto run = [&] { builder_.CallRoutine(body->routine, {}); };
  const bool keeps = !body->entries.empty() || tree_.units[body->unit].timers > 0;
  if (keeps) {
    builder_.Choose(builder_.Load(active), run, [&] { Rewind(body->unit); });
  } else {
    builder_.When(builder_.Load(active), run);
  }
}

/// With mech-clear=abort: what the host has cleared begins anew, though its MECH_BEGIN may not be reached before the
/// bit is set again. What the program clears is rewound where it does.
void Lowering::RewindCleared() {
  if (settings_.mech_clear != MechClear::kAbort) return;
  for (const Body& body : bodies_) {
    if (body.unit.valid() && tree_.units[body.unit].kind == UnitKind::kMechanism) RewindIfCleared(body.unit);
  }
}

void Lowering::Slow() {
  body_ = nullptr;
  builder_.SetRange({});
  builder_.SetRegion(program_.routines[slow_].body);
  RewindCleared();
  const ir::PlaceId annulment = SystemPlace("NC_CLEAR");
  const Body* clear = BodyOfModule(ModuleKind::kClear);
  if (clear != nullptr) {
    builder_.When(builder_.Load(annulment), [&] {
      builder_.CallRoutine(clear->routine, {});
      builder_.Store(annulment, builder_.Bit(0));
    });
  } else {
    builder_.Store(annulment, builder_.Bit(0));
  }
  RunFunctions(ModuleKind::kPripravne, "NC_PRIPRAVNE");
  if (const Body* main = BodyOfModule(ModuleKind::kMain)) builder_.CallRoutine(main->routine, {});
  for (const Body& body : bodies_) {
    if (!body.unit.valid()) continue;
    const Unit& unit = tree_.units[body.unit];
    if (unit.kind == UnitKind::kMechanism && !unit.parent.valid()) CallMechanism(body);
  }
  RunFunctions(ModuleKind::kZaverecne, "NC_ZAVERECNE");
  const Body* halt = BodyOfModule(ModuleKind::kHalt);
  if (halt == nullptr) return;
  builder_.When(builder_.Load(SystemPlace("REQ_PIS_HALT")), [&] {
    builder_.CallRoutine(halt->routine, {});
    host_(HostCall::kHaltPass);
  });
}

void Lowering::Period() {
  builder_.SetRegion(program_.routines[period_].body);
  host_(HostCall::kReadInputs);
  builder_.CallRoutine(slow_, {});
  host_(HostCall::kWriteOutputs);
  builder_.CallRoutine(requests_, {});
  builder_.SetRegion(program_.routines[fast_only_].body);
  builder_.CallRoutine(fast_, {});
}

void Lowering::FillSchedule() {
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

/// A bit that is always 0.
ir::PlaceId Lowering::NeverPlace() {
  return program_.places.Add({.name = "keeps_at_power_off",
                              .type = ir::Type::kBit,
                              .space = memory_[SpaceKey::kSteps],
                              .offset = program_.spaces[memory_[SpaceKey::kSteps]].bytes - 1,
                              .bit = 0});
}

}  // namespace plcxx::technol
