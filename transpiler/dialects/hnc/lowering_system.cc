// System functions (specification 6.10), as routines on the image of G or as calls of the host, and set_mst_func.

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/lowering_internal.h"
#include "transpiler/dialects/hnc/machine.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

namespace {

constexpr uint32_t kAxes = 16, kHandwheels = 4, kAxisWords = 10;
constexpr uint32_t kIipWord = 251;

struct HostRow {
  SystemFunction function;
  std::string_view name;
  std::string_view comment;
};

constexpr HostRow kHostRows[] = {
    {SystemFunction::kSetAxisHome, "axis_home", "Reference return of an axis on or off."},
    {SystemFunction::kSetAxisJog, "axis_jog", "Speed of an axis in jog, pulses per interpolation period."},
    {SystemFunction::kSetAxisStep, "axis_step", "An axis goes d pulses further."},
    {SystemFunction::kSetAxisMove, "axis_move", "An axis goes d pulses further with speed s."},
    {SystemFunction::kSetAxisMoveto, "axis_moveto", "An axis goes to position p with speed s."},
    {SystemFunction::kSetAxisStop, "axis_stop", "An axis stops."},
    {SystemFunction::kGetAxisPos, "axis_pos", "Position of an axis in pulses."},
    {SystemFunction::kGetAxisDen, "axis_done", "1: an axis has nothing left to go."},
    {SystemFunction::kHandwheel, "handwheel", "Handwheel h moves an axis, mul pulses per count."},
    {SystemFunction::kGetHandwheel, "handwheel_take", "Counts of handwheel h since the last call."},
};

/// Names of parameters of 8.2.
std::vector<std::string_view> ParameterNames(SystemFunction function) {
  switch (function) {
    case SystemFunction::kSetAxisHome:
      return {"a", "on"};
    case SystemFunction::kSetAxisJog:
      return {"a", "v"};
    case SystemFunction::kSetAxisStep:
      return {"a", "d"};
    case SystemFunction::kSetAxisMove:
      return {"a", "d", "s"};
    case SystemFunction::kSetAxisMoveto:
      return {"a", "p", "s"};
    case SystemFunction::kHandwheel:
      return {"h", "a", "mul"};
    case SystemFunction::kGetHandwheel:
      return {"h"};
    default:
      return {"a"};
  }
}

std::vector<ir::Type> ParameterTypes(SystemFunction function) {
  switch (function) {
    case SystemFunction::kSetAxisHome:
    case SystemFunction::kSetAxisJog:
      return {ir::Type::kI16, ir::Type::kI16};
    case SystemFunction::kSetAxisStep:
      return {ir::Type::kI16, ir::Type::kI32};
    case SystemFunction::kSetAxisMove:
    case SystemFunction::kSetAxisMoveto:
      return {ir::Type::kI16, ir::Type::kI32, ir::Type::kI16};
    case SystemFunction::kHandwheel:
      return {ir::Type::kI16, ir::Type::kI16, ir::Type::kI16};
    default:
      return {ir::Type::kI16};
  }
}

ir::Type ResultType(SystemFunction function) {
  if (function == SystemFunction::kGetAxisPos) return ir::Type::kI32;
  const bool gives = function == SystemFunction::kGetAxisDen || function == SystemFunction::kGetHandwheel;
  return gives ? ir::Type::kI16 : ir::Type::kNone;
}

}  // namespace

std::string_view HostNameOf(SystemFunction function) {
  const auto* const row = std::ranges::find(kHostRows, function, &HostRow::function);
  return row == std::end(kHostRows) ? std::string_view() : row->name;
}

FunctionId Lowering::Replacement(SystemFunction function) const {
  const std::string_view name = SystemFunctions()[static_cast<size_t>(function)].name;
  for (const FunctionId id : unit_.definitions) {
    if (unit_.functions[id].name == name) return id;
  }
  return {};
}

/// A cell of the axis that an index names, in F or G.
ValueId Lowering::AxisWord(Area area, uint32_t word, ir::Type type, ValueId axis) {
  return builder_.Load(IndexedPlaceAt(objects_.OfArea(area), 2 * word, 2 * kAxisWords, type), axis);
}
void Lowering::SetAxisWord(uint32_t word, ir::Type type, ValueId value, ValueId axis) {
  builder_.Store(IndexedPlaceAt(objects_.OfArea(Area::kG), 2 * word, 2 * kAxisWords, type), value, axis);
}

ir::PlaceId Lowering::HandwheelPlace() {
  if (handwheel_place_.valid()) return handwheel_place_;
  const uint32_t begin = program_.places[handwheels_[0]].offset;
  handwheel_place_ = program_.places.Add({.name = "handwheels",
                                          .address = {},
                                          .type = ir::Type::kI16,
                                          .space = system_,
                                          .offset = begin,
                                          .bit = ir::kNoBit,
                                          .indexed = true,
                                          .stride = 2,
                                          .low = begin,
                                          .high = begin + 2 * kHandwheels});
  return handwheel_place_;
}

/// What a system function does, as a routine that is there when something calls it.
ir::RoutineId Lowering::SystemRoutine(SystemFunction function) {
  const auto found = system_routines_.find(static_cast<uint32_t>(function));
  if (found != system_routines_.end()) return found->second;
  const std::string name(SystemFunctions()[static_cast<size_t>(function)].name);
  const ir::RoutineId id = builder_.AddRoutine(name, ir::RoutineKind::kSubroutine, "The control's own " + name + ".");
  system_routines_[static_cast<uint32_t>(function)] = id;
  const ir::RegionId outside = builder_.region();
  const ir::SpaceId outer_locals = std::exchange(
      locals_,
      program_.spaces.Add({.name = name, .title = "", .bytes = 0, .lifetime = ir::Lifetime::kRoutine, .own = true}));
  const uint32_t outer_bytes = std::exchange(local_bytes_, 0);
  const std::vector<std::string_view> names = ParameterNames(function);
  const std::vector<ir::Type> types = ParameterTypes(function);
  for (size_t i = 0; i < names.size(); ++i) {
    const ir::PlaceId place = AddLocal(std::string(names[i]), types[i]);
    program_.routines[id].parameters.push_back({.name = std::string(names[i]), .type = types[i], .enumerators = {}});
    program_.routines[id].parameter_places.push_back(place);
  }
  if (ResultType(function) != ir::Type::kNone) {
    const ir::PlaceId result = AddLocal("result", ResultType(function));
    program_.routines[id].result = ResultType(function);
    program_.routines[id].result_place = result;
  }
  const uint32_t outer_statement = statement_id_;
  builder_.SetRegion(program_.routines[id].body);
  BuildSystemRoutine(function, id);
  statement_id_ = outer_statement;
  builder_.SetRegion(outside);
  locals_ = outer_locals;
  local_bytes_ = outer_bytes;
  return id;
}

void Lowering::CallAgain(SystemFunction function, std::vector<ValueId> arguments) {
  const FunctionId own = Replacement(function);
  builder_.CallRoutine(own.valid() && routines_[own.index].valid() ? routines_[own.index] : SystemRoutine(function),
                       std::move(arguments));
}

void Lowering::BuildSystemRoutine(SystemFunction function, ir::RoutineId id) {
  const std::vector<ir::PlaceId> places = program_.routines[id].parameter_places;
  const auto parameter = [&](size_t i) { return builder_.Load(places[i]); };
  const auto axis = [&] { return Pure(OpKind::kWiden16To32, {parameter(0)}); };
  const auto pic_a = [&] { return AxisWord(Area::kG, 1, ir::Type::kI32, axis()); };
  const auto speed = [&] { return AxisWord(Area::kG, 3, ir::Type::kI16, axis()); };
  const auto iip = [&] { return Pure(OpKind::kWiden16To32, {LoadWord(Area::kF, kIipWord)}); };
  const auto local = [&](std::string name, ir::Type type, ValueId value) {
    const ir::PlaceId place = AddLocal(std::move(name), type);
    builder_.Store(place, value);
    return place;
  };
  const ir::PlaceId result = program_.routines[id].result_place;
  switch (function) {
    case SystemFunction::kSetAxisHome:
      builder_.Choose(
          Pure(OpKind::kNotEqual16, {parameter(1), Word(0)}),
          [&] {
            const ValueId word = AxisWord(Area::kG, 0, ir::Type::kI16, axis());
            SetAxisWord(0, ir::Type::kI16, Pure(OpKind::kOr16, {word, builder_.Constant(ir::Type::kI16, 0x40, 16)}),
                        axis());
          },
          [&] {
            const ValueId word = AxisWord(Area::kG, 0, ir::Type::kI16, axis());
            SetAxisWord(0, ir::Type::kI16, Pure(OpKind::kAnd16, {word, builder_.Constant(ir::Type::kI16, 0xFFBF, 16)}),
                        axis());
          });
      return;
    case SystemFunction::kSetAxisJog:
      SetAxisWord(4, ir::Type::kI16, parameter(1), axis());
      return;
    case SystemFunction::kSetAxisStep:
      builder_.When(Pure(OpKind::kNotEqual32, {parameter(1), Long(0)}), [&] {
        const ir::PlaceId l = local("l", ir::Type::kI32, Pure(OpKind::kAdd32, {pic_a(), parameter(1)}));
        const ValueId parts = Pure(OpKind::kSignedDiv32, {Pure(OpKind::kAbs32, {builder_.Load(l)}), Long(200)});
        const ir::PlaceId v = local("v", ir::Type::kI32, Pure(OpKind::kMul32, {parts, iip()}));
        const auto vmax = [&] {
          return Pure(OpKind::kSignExtend16To32, {AxisWord(Area::kF, 7, ir::Type::kI16, axis())});
        };
        builder_.When(Pure(OpKind::kSignedGreater32, {builder_.Load(v), vmax()}), [&] { builder_.Store(v, vmax()); });
        builder_.When(Pure(OpKind::kSignedLess32, {builder_.Load(v), Long(2)}), [&] { builder_.Store(v, Long(2)); });
        SetAxisWord(1, ir::Type::kI32, builder_.Load(l), axis());
        SetAxisWord(3, ir::Type::kI16, Pure(OpKind::kLowHalf32, {builder_.Load(v)}), axis());
      });
      return;
    case SystemFunction::kSetAxisMove:
      builder_.When(Pure(OpKind::kNotEqual32, {parameter(1), Long(0)}), [&] {
        const auto magnitude16 = [&](ValueId value) {
          return Pure(OpKind::kSignExtend16To32, {Pure(OpKind::kAbs16, {value})});
        };
        const ir::PlaceId l1 = local("l1", ir::Type::kI32, Pure(OpKind::kAbs32, {pic_a()}));
        const ir::PlaceId l2 = local("l2", ir::Type::kI32, Pure(OpKind::kAbs32, {parameter(1)}));
        const ValueId first = Pure(OpKind::kMul32, {builder_.Load(l1), magnitude16(speed())});
        const ValueId second = Pure(OpKind::kMul32, {builder_.Load(l2), magnitude16(parameter(2))});
        const ir::PlaceId product = local("product", ir::Type::kI32, Pure(OpKind::kAdd32, {first, second}));
        const ir::PlaceId sum =
            local("sum", ir::Type::kI32, Pure(OpKind::kAdd32, {builder_.Load(l1), builder_.Load(l2)}));
        const ValueId mean = Pure(OpKind::kSignedDiv32, {builder_.Load(product), builder_.Load(sum)});
        SetAxisWord(3, ir::Type::kI16, Pure(OpKind::kLowHalf32, {mean}), axis());
        SetAxisWord(1, ir::Type::kI32, Pure(OpKind::kAdd32, {pic_a(), parameter(1)}), axis());
      });
      return;
    case SystemFunction::kSetAxisMoveto: {
      const FunctionId own = Replacement(SystemFunction::kGetAxisPos);
      const ir::RoutineId get = own.valid() && routines_[own.index].valid()
                                    ? routines_[own.index]
                                    : SystemRoutine(SystemFunction::kGetAxisPos);
      const ir::PlaceId position = local("position", ir::Type::kI32, builder_.CallRoutine(get, {parameter(0)}));
      const ValueId way = Pure(OpKind::kSub32, {parameter(1), builder_.Load(position)});
      CallAgain(SystemFunction::kSetAxisMove, {parameter(0), way, parameter(2)});
      return;
    }
    case SystemFunction::kSetAxisStop: {
      const ir::PlaceId l = local("l", ir::Type::kI32, pic_a());
      const ValueId product = Pure(OpKind::kMul32, {Pure(OpKind::kSignExtend16To32, {speed()}), iip()});
      const ir::PlaceId b = local("b", ir::Type::kI32, Pure(OpKind::kSignedDiv32, {product, Long(200)}));
      builder_.Choose(
          Pure(OpKind::kSignedGreater32, {builder_.Load(l), Long(0)}),
          [&] {
            builder_.When(Pure(OpKind::kSignedGreater32, {builder_.Load(l), builder_.Load(b)}),
                          [&] { builder_.Store(l, builder_.Load(b)); });
          },
          [&] {
            const ValueId rest = Pure(OpKind::kMinus32, {builder_.Load(l)});
            builder_.When(Pure(OpKind::kSignedGreater32, {rest, builder_.Load(b)}), [&] {
              // As printed, the axis would go back by all that is left of its way (D14).
              const ir::PlaceId way = settings_.stop == StopOption::kPrinted ? l : b;
              builder_.Store(l, Pure(OpKind::kMinus32, {builder_.Load(way)}));
            });
          });
      SetAxisWord(1, ir::Type::kI32, builder_.Load(l), axis());
      CallAgain(SystemFunction::kSetAxisJog, {parameter(0), Word(0)});
      CallAgain(SystemFunction::kSetAxisHome, {parameter(0), Word(0)});
      return;
    }
    case SystemFunction::kGetAxisPos:
      builder_.Store(result, Pure(OpKind::kAdd32, {AxisWord(Area::kF, 1, ir::Type::kI32, axis()), pic_a()}));
      return;
    case SystemFunction::kGetAxisDen: {
      const ValueId rests = Pure(OpKind::kEqual32, {pic_a(), Long(0)});
      const ValueId jogs = Pure(OpKind::kNotEqual16, {AxisWord(Area::kG, 4, ir::Type::kI16, axis()), Word(0)});
      const ValueId done = Pure(OpKind::kBitAnd, {rests, Pure(OpKind::kBitNot, {jogs})});
      builder_.Store(result, Pure(OpKind::kWiden1To16, {done}));
      return;
    }
    case SystemFunction::kGetHandwheel: {
      const auto wheel = [&] { return Pure(OpKind::kWiden16To32, {parameter(0)}); };
      builder_.Store(result, builder_.Load(HandwheelPlace(), wheel()));
      builder_.Store(HandwheelPlace(), Word(0), wheel());
      return;
    }
    case SystemFunction::kHandwheel: {
      const ValueId counts = builder_.CallRoutine(SystemRoutine(SystemFunction::kGetHandwheel), {parameter(0)});
      const ir::PlaceId n = local("n", ir::Type::kI16, counts);
      const ValueId way = Pure(OpKind::kMul32, {Pure(OpKind::kSignExtend16To32, {builder_.Load(n)}),
                                                Pure(OpKind::kSignExtend16To32, {parameter(2)})});
      CallAgain(SystemFunction::kSetAxisStep, {parameter(1), way});
      return;
    }
    default:
      return;
  }
}

/// The condition under which a number of an axis or handwheel is none; none: it is one, or that has been reported.
ValueId Lowering::NumberIsOutside(const Value& number, uint32_t count, const Expr& call, size_t argument, bool& bad) {
  const bool axis = count == kAxes;
  const std::optional<int64_t> known = KnownInteger(number);
  if (known) {
    if (*known >= 0 && *known < count) return {};
    const source::Range range = ExprAt(call.arguments[argument]).range;
    if (axis) {
      diagnostics_.Report(range, diag::HncAxisNumber, *known);
    } else {
      diagnostics_.Report(range, diag::HncIndexOf, "handwheel number " + std::to_string(*known) + " is outside 0 to 3");
    }
    bad = true;
    return {};
  }
  if (number.bounds.Within({0, static_cast<int64_t>(count) - 1})) {
    CheckBounds(ir::FactKind::kIndex, number);
    return {};
  }
  return Pure(OpKind::kGreater16, {number.id, Word(count - 1)});
}

Lowering::CallResult Lowering::CallSystem(const Expr& expr) {
  const SystemFunction function = *unit_.functions[expr.function].system;
  if (function == SystemFunction::kSetMstFunc) {
    Register(expr);
    return {};
  }
  if (function >= SystemFunction::kAbs) return CallLibrary(expr);
  const std::vector<ir::Type> types = ParameterTypes(function);
  if (expr.arguments.size() != types.size()) return {};
  std::vector<Value> values(types.size());
  for (size_t i = types.size(); i-- > 0;) {
    values[i] = Convert(Evaluate(expr.arguments[i]), types[i] == ir::Type::kI32 ? long_ : int_);
  }
  bool bad = false;
  ValueId outside;
  const bool wheel = function == SystemFunction::kHandwheel || function == SystemFunction::kGetHandwheel;
  outside = NumberIsOutside(values[0], wheel ? kHandwheels : kAxes, expr, 0, bad);
  if (function == SystemFunction::kHandwheel) {
    const ValueId axis = NumberIsOutside(values[1], kAxes, expr, 1, bad);
    if (axis.valid()) outside = outside.valid() ? Pure(OpKind::kBitOr, {outside, axis}) : axis;
  }
  if (bad) return {};
  const ir::Type type = ResultType(function);
  ir::PlaceId kept;
  const auto call = [&] {
    std::vector<ValueId> arguments;
    for (const Value& value : values) arguments.push_back(value.id);
    ValueId called;
    if (settings_.sysfunc == SysfuncOption::kHost) {
      const HostRow& row = *std::ranges::find(kHostRows, function, &HostRow::function);
      std::vector<ir::Parameter> parameters;
      const std::vector<std::string_view> names = ParameterNames(function);
      for (size_t i = 0; i < names.size(); ++i) {
        parameters.push_back({.name = std::string(names[i]), .type = types[i], .enumerators = {}});
      }
      const ir::HostFunctionId host = Host(std::string(row.name), std::move(parameters), type, std::string(row.comment),
                                           ir::HostAccess::kWritesState);
      program_.host_functions[host].routine_exchange = false;
      called = builder_.CallHost(host, std::move(arguments));
    } else {
      called = builder_.CallRoutine(SystemRoutine(function), std::move(arguments));
    }
    if (kept.valid()) builder_.Store(kept, called);
    return called;
  };
  ValueId called;
  if (outside.valid()) {
    if (type != ir::Type::kNone) {
      kept = AddLocal("answer", type);
      const bool den = function == SystemFunction::kGetAxisDen;
      builder_.Store(kept, builder_.Constant(type, den ? 1 : 0));
    }
    builder_.Choose(outside, [&] { RecordFault(Fault::kIndex); }, call);
    if (kept.valid()) called = builder_.Load(kept);
  } else {
    called = call();
  }
  ForgetAfterCall(expr);
  CallResult result;
  if (type != ir::Type::kNone) result.value = Make(called, type == ir::Type::kI32 ? long_ : int_);
  if (function == SystemFunction::kGetAxisDen) result.value->bounds = {0, 1};
  return result;
}

/// A handler goes into its slot, as a number among the functions that are registered anywhere for it. One that is fixed
/// has no slot: the dispatcher calls it.
void Lowering::Register(const Expr& call) {
  for (const Registration& registration : facts_.registrations()) {
    if (&ExprAt(registration.call) != &call) continue;
    uint32_t number = 0;
    if (registration.function.valid()) {
      const std::vector<FunctionId>& handlers = handlers_[registration.channel][registration.kind];
      number = static_cast<uint32_t>(std::ranges::find(handlers, registration.function) - handlers.begin()) + 1;
    }
    const ir::PlaceId slot = handler_slots_[registration.channel][registration.kind];
    if (slot.valid()) builder_.Store(slot, builder_.Constant(ir::Type::kI8, number));
    return;
  }
}

}  // namespace plcxx::hnc
