// The cycle around the parts (specification 4.2): image transfer, due times, power-on, standstill after a fault.

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/lowering_internal.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

namespace {

constexpr uint32_t kLongestPeriod = 65536;  // in base cycles: a period variable has 16 bits
constexpr uint32_t kMirror = 100;           // X[100] and on

}  // namespace

void Lowering::AddScheduleScalars() {
  started_ = AddScalar("started", ir::Type::kBit);
  due_fast_ = AddScalar("due_fast", ir::Type::kBit);
  due_slow_ = AddScalar("due_slow", ir::Type::kBit);
  next_fast_ = AddScalar("next_fast", ir::Type::kI32);
  next_slow_ = AddScalar("next_slow", ir::Type::kI32);
  fast_done_ = AddScalar("fast_done", ir::Type::kI32);
  slow_done_ = AddScalar("slow_done", ir::Type::kI32);
  for (uint32_t i = 0; i < unit_.variables.size(); ++i) {
    const Storage storage = unit_.variables[VariableId(i)].storage;
    const ObjectId object = objects_.OfVariable(VariableId(i));
    if (storage == Storage::kPlc1Time) period1_ = PlaceAt(object, 0, ir::Type::kI16);
    if (storage == Storage::kPlc2Time) period2_ = PlaceAt(object, 0, ir::Type::kI16);
  }
  if (!period1_.valid()) period1_ = AddScalar("plc1_time", ir::Type::kI16);
  if (!period2_.valid()) period2_ = AddScalar("plc2_time", ir::Type::kI16);
  // One after the other, so that an index reaches them.
  for (uint32_t h = 0; h < 4; ++h) handwheels_[h] = AddScalar("handwheel_" + std::to_string(h), ir::Type::kI16);
  for (uint32_t c = 0; c < 4; ++c) modal_[c] = AddScalar("modal_" + std::to_string(c), ir::Type::kI8);
  for (uint32_t k = 0; k < 4; ++k) {
    for (uint32_t c = 0; c < 4; ++c) {
      states_[c][k] = AddScalar("state_" + std::string(1, kHandlerKinds[k]) + std::to_string(c), ir::Type::kI8);
    }
  }
  if (settings_.handler_calls == HandlerCallsOption::kOnce) {
    for (uint32_t k = 0; k < 4; ++k) {
      for (uint32_t c = 0; c < 4; ++c) {
        called_[c][k] = AddScalar("called_" + std::string(1, kHandlerKinds[k]) + std::to_string(c), ir::Type::kI8);
      }
    }
  }
  for (const Registration& registration : facts_.registrations()) {
    if (fixed_handlers_[registration.channel][registration.kind]) continue;
    ir::PlaceId& slot = handler_slots_[registration.channel][registration.kind];
    if (!slot.valid()) {
      slot = AddScalar(
          "handler_" + std::string(1, kHandlerKinds[registration.kind]) + std::to_string(registration.channel),
          ir::Type::kI8);
    }
    if (!registration.function.valid()) continue;
    std::vector<FunctionId>& handlers = handlers_[registration.channel][registration.kind];
    if (std::ranges::find(handlers, registration.function) == handlers.end()) handlers.push_back(registration.function);
  }
}

void Lowering::Exchange(std::string_view name, std::string_view comment, ir::HostAccess access) {
  const ir::HostFunctionId host = Host(std::string(name), {}, ir::Type::kNone, std::string(comment), access);
  const ValueId call = builder_.CallHost(host, {});
  program_.calls[ir::CallId(program_[call].payload)].exchange = true;
}

void Lowering::Parameters() {
  Exchange("parameters", "At power-on and before init(): the host fills P with the parameters of the user.",
           ir::HostAccess::kWritesState);
}

void Lowering::AddScheduleRoutines() {
  builder_.SetRange({});
  statement_id_ = 0;
  init_ = builder_.AddRoutine("init", ir::RoutineKind::kInit,
                              "Power-on: memory as 4.2 says. The program's init() runs in the first cycle.");
  builder_.SetRegion(program_.routines[init_].body);
  Exchange("retentive_load",
           "At power-on: fill the retentive block with the copy saved at power-off; leave it alone if there is none.",
           ir::HostAccess::kWritesRetentive);
  Parameters();
  AddDispatcher();
  fast_ = builder_.AddRoutine("fast", ir::RoutineKind::kFast,
                              "The fast part: requests of M, S, T, B functions, then plc1().");
  builder_.SetRegion(program_.routines[fast_].body);
  for (uint32_t c = 0; c < 4; ++c) builder_.CallRoutine(dispatch_, {Long(c)});
  CallEntry(unit_.plc1);
  EndCritical();
  slow_ = builder_.AddRoutine("slow", ir::RoutineKind::kSlow, "The slow part: plc2().");
  builder_.SetRegion(program_.routines[slow_].body);
  CallEntry(unit_.plc2);
  EndCritical();
  if (stop_.valid()) AddStandstill();
  cycle_ = builder_.AddRoutine("cycle", ir::RoutineKind::kSchedule,
                               "One base cycle: call it every " + std::to_string(settings_.base_cycle_ms) +
                                   " ms with the time in ms, which may wrap.");
  now_ =
      program_.places.Add({.name = "now_ms", .address = {}, .type = ir::Type::kI32, .space = arguments_, .offset = 0});
  argument_bytes_ = 8;
  program_.routines[cycle_].parameters.push_back({.name = "now_ms", .type = ir::Type::kI32, .enumerators = {}});
  program_.routines[cycle_].parameter_places.push_back(now_);
  builder_.SetRegion(program_.routines[cycle_].body);
  Cycle();
  period_ = builder_.AddRoutine("period", ir::RoutineKind::kSchedule, "A base cycle at the simulation's time.");
  program_.routines[period_].simulation_only = true;
  builder_.SetRegion(program_.routines[period_].body);
  const ir::HostFunctionId clock = Host("now_ms", {}, ir::Type::kI32, "Time since power-on in ms.");
  program_.host_functions[clock].routine_exchange = true;
  builder_.CallRoutine(cycle_, {builder_.CallHost(clock, {})});
  FillSchedule();
}

/// A value that init(), plc1() or plc2() gives is ignored.
void Lowering::CallEntry(FunctionId function) { builder_.CallRoutine(routines_[function.index], {}); }

void Lowering::Copy(Area area, uint32_t to, uint32_t from, uint32_t bytes) {
  for (uint32_t at = 0; at < bytes;) {
    const ir::Type width = bytes - at >= 4 ? ir::Type::kI32 : bytes - at >= 2 ? ir::Type::kI16 : ir::Type::kI8;
    const ObjectId object = objects_.OfArea(area);
    builder_.Store(PlaceAt(object, to + at, width), builder_.Load(PlaceAt(object, from + at, width)));
    at += ir::Bytes(width);
  }
}

/// Y and G are 0, and nothing runs any more (D32).
void Lowering::AddStandstill() {
  standstill_ =
      builder_.AddRoutine("stand_still", ir::RoutineKind::kSubroutine,
                          "After a fault with faults=stop: outputs are 0, nothing runs until the next power-on.");
  builder_.SetRegion(program_.routines[standstill_].body);
  for (const Area area : {Area::kY, Area::kG}) {
    const ObjectId object = objects_.OfArea(area);
    for (uint32_t at = 0; at < objects_[object].size; at += 4) {
      builder_.Store(PlaceAt(object, at, ir::Type::kI32), Long(0));
    }
  }
  builder_.Store(stopped_, builder_.Bit(1));
}

void Lowering::WhenRunning(const std::function<void()>& body) {
  if (!stop_.valid()) {
    body();
    return;
  }
  builder_.When(Pure(OpKind::kBitNot, {builder_.Load(stopped_)}), [&] {
    body();
    builder_.When(builder_.Load(stop_), [&] { builder_.CallRoutine(standstill_, {}); });
  });
}

void Lowering::Cycle() {
  const auto now = [&] { return builder_.Load(now_); };
  builder_.When(Pure(OpKind::kBitNot, {builder_.Load(started_)}), [&] {
    builder_.Store(started_, builder_.Bit(1));
    Parameters();
    WhenRunning([&] {
      CallEntry(unit_.init);
      EndCritical();
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
    for (uint32_t c = 0; c < 4; ++c) builder_.CallRoutine(complete_, {Long(c)});
  };
  if (stop_.valid()) {
    builder_.When(Pure(OpKind::kBitNot, {builder_.Load(stopped_)}), complete);
  } else {
    complete();
  }
  Exchange("outputs", "Behind the parts: the host takes Y and G.", ir::HostAccess::kReadsState);
  Exchange("retentive_store", "Behind the parts: the host may keep B for the next power-on.",
           ir::HostAccess::kReadsRetentive);
}

/// The longest time that the program sets between two calls of a part; 0: not known before it runs.
uint32_t Lowering::LongestPeriod(Storage storage) const {
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
    if (!object.valid()) continue;
    for (const FunctionId id : unit_.definitions) {
      if (facts_.PartsOf(id) == 0 || !facts_.WritesOf(id).Has(object)) continue;
      ForEachExprIn(unit_, unit_.functions[id].body, [&](ExprId part) {
        const Expr& expr = ExprAt(part);
        if (!facts_.WritesOf(expr).Has(object)) return;
        if (expr.kind == ExprKind::kCall && expr.function.valid() && unit_.functions[expr.function].body.valid())
          return;
        const bool plain = expr.kind == ExprKind::kAssign && facts_.AddressOf(expr.a) == StaticAddress{object, 0};
        if (plain) take(expr.b);
        known = known && plain;
      });
    }
  }
  return known ? longest : 0;
}

void Lowering::FillSchedule() {
  ir::Schedule& schedule = program_.schedule;
  schedule.init = init_;
  schedule.period = period_;
  schedule.fast_only = period_;
  schedule.period_ms = settings_.base_cycle_ms;
  schedule.slot_ms = settings_.base_cycle_ms;
  schedule.slow_done = slow_done_;
  schedule.fast_done = fast_done_;
  schedule.fast_every_ms = LongestPeriod(Storage::kPlc1Time);
  schedule.slow_every_ms = LongestPeriod(Storage::kPlc2Time);
  schedule.most_periods = kLongestPeriod + 1;
  schedule.now = host_.at("now_ms");
  schedule.retentive_load = host_.at("retentive_load");
  schedule.retentive_store = host_.at("retentive_store");
  schedule.retention = true;
}

}  // namespace plcxx::hnc
