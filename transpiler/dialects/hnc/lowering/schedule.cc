#include "transpiler/dialects/hnc/lowering/schedule.h"

#include <algorithm>

#include "transpiler/dialects/hnc/lowering/cell_places.h"
#include "transpiler/dialects/hnc/lowering/critical_sections.h"
#include "transpiler/dialects/hnc/lowering/dispatcher.h"
#include "transpiler/dialects/hnc/lowering/faults.h"
#include "transpiler/dialects/hnc/lowering/handlers.h"
#include "transpiler/dialects/hnc/lowering/host_calls.h"
#include "transpiler/dialects/hnc/lowering/memory.h"
#include "transpiler/dialects/hnc/lowering/system_routines.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

namespace {

constexpr uint32_t kLongestPeriod = 65536;  // in base cycles: a period variable has 16 bits
constexpr uint32_t kMirror = 100;           // X[100] and on

}  // namespace

void Schedule::AddScalars() {
  started_ = memory_.AddScalar("started", ir::Type::kBit);
  due_fast_ = memory_.AddScalar("due_fast", ir::Type::kBit);
  due_slow_ = memory_.AddScalar("due_slow", ir::Type::kBit);
  next_fast_ = memory_.AddScalar("next_fast", ir::Type::kI32);
  next_slow_ = memory_.AddScalar("next_slow", ir::Type::kI32);
  fast_done_ = memory_.AddScalar("fast_done", ir::Type::kI32);
  slow_done_ = memory_.AddScalar("slow_done", ir::Type::kI32);
  for (uint32_t i = 0; i < unit_.variables.size(); ++i) {
    const Storage storage = unit_.variables[VariableId(i)].storage;
    const ObjectId object = objects_.OfVariable(VariableId(i));
    if (storage == Storage::kPlc1Time) period1_ = places_.At(object, 0, ir::Type::kI16);
    if (storage == Storage::kPlc2Time) period2_ = places_.At(object, 0, ir::Type::kI16);
  }
  if (!period1_.valid()) period1_ = memory_.AddScalar("plc1_time", ir::Type::kI16);
  if (!period2_.valid()) period2_ = memory_.AddScalar("plc2_time", ir::Type::kI16);
  system_routines_.AddHandwheels();
  dispatcher_.AddScalars();
  handlers_.AddSlots();
}

void Schedule::Exchange(std::string_view name, std::string_view comment, ir::HostAccess access) {
  const ir::HostFunctionId host =
      host_calls_.Function(std::string(name), {}, ir::Type::kNone, std::string(comment), access);
  const ValueId call = builder_.CallHost(host, {});
  program_.calls[ir::CallId(program_[call].payload)].exchange = true;
}

void Schedule::Parameters() {
  Exchange("parameters", "At power-on and before init(): the host fills P with the parameters of the user.",
           ir::HostAccess::kWritesState);
}

void Schedule::AddRoutines() {
  builder_.SetRange({});
  statement_.id = 0;
  init_ = builder_.AddRoutine("init", ir::RoutineKind::kInit,
                              "Power-on: memory as 4.2 says. The program's init() runs in the first cycle.");
  builder_.SetRegion(program_.routines[init_].body);
  Exchange("retentive_load",
           "At power-on: fill the retentive block with the copy saved at power-off; leave it alone if there is none.",
           ir::HostAccess::kWritesRetentive);
  Parameters();
  dispatcher_.AddRoutines();
  fast_ = builder_.AddRoutine("fast", ir::RoutineKind::kFast,
                              "The fast part: requests of M, S, T, B functions, then plc1().");
  builder_.SetRegion(program_.routines[fast_].body);
  for (uint32_t c = 0; c < 4; ++c) builder_.CallRoutine(dispatcher_.dispatch(), {Long(c)});
  CallEntry(unit_.plc1);
  critical_.End();
  slow_ = builder_.AddRoutine("slow", ir::RoutineKind::kSlow, "The slow part: plc2().");
  builder_.SetRegion(program_.routines[slow_].body);
  CallEntry(unit_.plc2);
  critical_.End();
  if (faults_.stop().valid()) AddStandstill();
  cycle_ = builder_.AddRoutine("cycle", ir::RoutineKind::kSchedule,
                               "One base cycle: call it every " + std::to_string(settings_.base_cycle_ms) +
                                   " ms with the time in ms, which may wrap.");
  now_ = memory_.AddArgument("now_ms", ir::Type::kI32);
  program_.routines[cycle_].parameters.push_back({.name = "now_ms", .type = ir::Type::kI32, .enumerators = {}});
  program_.routines[cycle_].parameter_places.push_back(now_);
  builder_.SetRegion(program_.routines[cycle_].body);
  Cycle();
  period_routine_ = builder_.AddRoutine("period", ir::RoutineKind::kSchedule, "A base cycle at the simulation's time.");
  program_.routines[period_routine_].simulation_only = true;
  builder_.SetRegion(program_.routines[period_routine_].body);
  const ir::HostFunctionId clock = host_calls_.Function("now_ms", {}, ir::Type::kI32, "Time since power-on in ms.");
  program_.host_functions[clock].routine_exchange = true;
  builder_.CallRoutine(cycle_, {builder_.CallHost(clock, {})});
  Fill();
}

/// A value that init(), plc1() or plc2() gives is ignored.
void Schedule::CallEntry(FunctionId function) { builder_.CallRoutine(placement_.routines[function.index], {}); }

void Schedule::Copy(Area area, uint32_t to, uint32_t from, uint32_t bytes) {
  for (uint32_t at = 0; at < bytes;) {
    const ir::Type width = bytes - at >= 4 ? ir::Type::kI32 : bytes - at >= 2 ? ir::Type::kI16 : ir::Type::kI8;
    const ObjectId object = objects_.OfArea(area);
    const ValueId copied = builder_.Load(places_.At(object, from + at, width));
    const ir::PlaceId target = places_.At(object, to + at, width);
    builder_.Store(target, copied);
    at += ir::Bytes(width);
  }
}

/// Y and G are 0, and nothing runs any more (D32).
void Schedule::AddStandstill() {
  standstill_ =
      builder_.AddRoutine("stand_still", ir::RoutineKind::kSubroutine,
                          "After a fault with faults=stop: outputs are 0, nothing runs until the next power-on.");
  builder_.SetRegion(program_.routines[standstill_].body);
  for (const Area area : {Area::kY, Area::kG}) {
    const ObjectId object = objects_.OfArea(area);
    for (uint32_t at = 0; at < objects_[object].size; at += 4) {
      const ValueId zero = Long(0);
      const ir::PlaceId output = places_.At(object, at, ir::Type::kI32);
      builder_.Store(output, zero);
    }
  }
  builder_.Store(faults_.stopped(), builder_.Bit(1));
}

void Schedule::WhenRunning(const std::function<void()>& body) {
  if (!faults_.stop().valid()) {
    body();
    return;
  }
  builder_.When(Pure(OpKind::kBitNot, {builder_.Load(faults_.stopped())}), [&] {
    body();
    builder_.When(builder_.Load(faults_.stop()), [&] { builder_.CallRoutine(standstill_, {}); });
  });
}

void Schedule::Cycle() {
  const auto now = [&] { return builder_.Load(now_); };
  builder_.When(Pure(OpKind::kBitNot, {builder_.Load(started_)}), [&] {
    builder_.Store(started_, builder_.Bit(1));
    Parameters();
    WhenRunning([&] {
      CallEntry(unit_.init);
      critical_.End();
    });
    builder_.Store(next_fast_, now());
    builder_.Store(next_slow_, now());
  });
  const auto is_due = [&](ir::PlaceId next) {
    return Pure(OpKind::kSignedGreaterEqual32, {Pure(OpKind::kSub32, {now(), builder_.Load(next)}), Long(0)});
  };
  builder_.Store(due_fast_, is_due(next_fast_));
  builder_.Store(due_slow_, is_due(next_slow_));
  Exchange("inputs", "Before the parts: the host fills X[0] to X[99], F and P.", ir::HostAccess::kWritesState);
  if (settings_.x_mirror > 0) {
    builder_.When(builder_.Load(due_slow_), [&] { Copy(Area::kX, kMirror, 0, settings_.x_mirror); });
  }
  const auto part = [&](ir::PlaceId due, ir::RoutineId routine, ir::PlaceId next, ir::PlaceId period,
                        ir::PlaceId done) {
    builder_.When(builder_.Load(due), [&] {
      WhenRunning([&] {
        builder_.CallRoutine(routine, {});
        const ValueId after = Pure(OpKind::kWiden16To32, {builder_.Load(period)});
        builder_.Store(next, Pure(OpKind::kAdd32, {now(), after}));
      });
      builder_.Store(done, Pure(OpKind::kAdd32, {builder_.Load(done), Long(1)}));
    });
  };
  part(due_fast_, fast_, next_fast_, period1_, fast_done_);
  part(due_slow_, slow_, next_slow_, period2_, slow_done_);
  const auto complete = [&] {
    for (uint32_t c = 0; c < 4; ++c) builder_.CallRoutine(dispatcher_.complete(), {Long(c)});
  };
  if (faults_.stop().valid()) {
    builder_.When(Pure(OpKind::kBitNot, {builder_.Load(faults_.stopped())}), complete);
  } else {
    complete();
  }
  Exchange("outputs", "Behind the parts: the host takes Y and G.", ir::HostAccess::kReadsState);
  Exchange("retentive_store", "Behind the parts: the host may keep B for the next power-on.",
           ir::HostAccess::kReadsRetentive);
}

/// The longest time that the program sets between two calls of a part; 0: not known before it runs.
uint32_t Schedule::LongestPeriod(Storage storage) const {
  uint32_t longest = 0;
  bool known = true;
  const auto take = [&](ExprId value) {
    const std::optional<Constant>& ms = ExprAt(value).constant;
    known = known && ms && IsInteger(TypeAt(ExprAt(value).type));
    // Without a time between them the calls come in each base cycle.
    if (known) longest = std::max({longest, settings_.base_cycle_ms, static_cast<uint32_t>(ms->integer & 0xFFFF)});
  };
  for (uint32_t i = 0; i < unit_.variables.size(); ++i) {
    const Variable& variable = unit_.variables[VariableId(i)];
    if (variable.storage != storage) continue;
    for (const InitialValue& initial : variable.initial) take(initial.value);
    const ObjectId object = objects_.OfVariable(VariableId(i));
    for (const FunctionId id : unit_.definitions) {
      if (facts_.PartsOf(id) == 0 || !facts_.WritesOf(id).Has(object)) continue;
      for (const ExprId part : facts_.effects().Of(id)) {
        const Expr& expr = ExprAt(part);
        if (!facts_.WritesOf(expr).Has(object)) continue;
        if (expr.kind == ExprKind::kCall && expr.function.valid() && unit_.functions[expr.function].body.valid())
          continue;
        const bool plain = expr.kind == ExprKind::kAssign && facts_.AddressOf(expr.a) == StaticAddress{object, 0};
        if (plain) take(expr.b);
        known = known && plain;
      }
    }
  }
  return known ? longest : 0;
}

void Schedule::Fill() {
  ir::Schedule& schedule = program_.schedule;
  schedule.init = init_;
  schedule.period = period_routine_;
  schedule.fast_only = period_routine_;
  schedule.period_ms = settings_.base_cycle_ms;
  schedule.slot_ms = settings_.base_cycle_ms;
  schedule.slow_done = slow_done_;
  schedule.fast_done = fast_done_;
  schedule.fast_every_ms = LongestPeriod(Storage::kPlc1Time);
  schedule.slow_every_ms = LongestPeriod(Storage::kPlc2Time);
  schedule.most_periods = kLongestPeriod + 1;
  schedule.now = *host_calls_.Find("now_ms");
  schedule.retentive_load = *host_calls_.Find("retentive_load");
  schedule.retentive_store = *host_calls_.Find("retentive_store");
  schedule.retention = true;
}

}  // namespace plcxx::hnc
