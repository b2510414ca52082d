#include "transpiler/dialects/hnc/lowering/system_routines.h"

#include <utility>

#include "transpiler/dialects/hnc/lowering/cell_places.h"
#include "transpiler/dialects/hnc/lowering/locals.h"
#include "transpiler/dialects/hnc/lowering/memory.h"
#include "transpiler/dialects/hnc/lowering/system_functions.h"
#include "transpiler/dialects/hnc/machine/machine.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

namespace {

constexpr uint32_t kAxisWords = 10;
constexpr uint32_t kIipWord = 251;
constexpr uint32_t kMostNegative = 0x80000000;  // its magnitude is itself

}  // namespace

FunctionId SystemRoutines::Replacement(SystemFunction function) const {
  const std::string_view name = SystemFunctions()[static_cast<size_t>(function)].name;
  for (const FunctionId id : unit_.definitions) {
    if (unit_.functions[id].name == name) return id;
  }
  return {};
}

/// A cell of the axis that an index names, in F or G.
ValueId SystemRoutines::AxisWord(Area area, uint32_t word, ir::Type type, ValueId axis) {
  return builder_.Load(places_.IndexedAt(objects_.OfArea(area), 2 * word, 2 * kAxisWords, type), axis);
}

void SystemRoutines::SetAxisWord(uint32_t word, ir::Type type, ValueId value, ValueId axis) {
  builder_.Store(places_.IndexedAt(objects_.OfArea(Area::kG), 2 * word, 2 * kAxisWords, type), value, axis);
}

ir::PlaceId SystemRoutines::HandwheelPlace() {
  if (handwheel_place_.valid()) return handwheel_place_;
  const uint32_t begin = program_.places[handwheels_[0]].offset;
  handwheel_place_ = program_.places.Add({.name = "handwheels",
                                          .address = {},
                                          .type = ir::Type::kI16,
                                          .space = program_.places[handwheels_[0]].space,
                                          .offset = begin,
                                          .bit = ir::kNoBit,
                                          .indexed = true,
                                          .stride = 2,
                                          .low = begin,
                                          .high = begin + 2 * kHandwheels});
  return handwheel_place_;
}

ir::RoutineId SystemRoutines::Routine(SystemFunction function) {
  const auto found = made_.find(static_cast<uint32_t>(function));
  if (found != made_.end()) return found->second;
  const std::string name(SystemFunctions()[static_cast<size_t>(function)].name);
  const ir::RoutineId id = builder_.AddRoutine(name, ir::RoutineKind::kSubroutine, "The control's own " + name + ".");
  made_[static_cast<uint32_t>(function)] = id;
  const ir::RegionId outside = builder_.region();
  const Locals::Position outer = locals_.Begin(name);
  const SystemSignature& signature = *SignatureOf(function);
  for (size_t i = 0; i < signature.count(); ++i) {
    const SystemParameter& parameter = signature.parameters[i];
    const ir::PlaceId place = locals_.Add(std::string(parameter.name), parameter.type);
    program_.routines[id].parameters.push_back(
        {.name = std::string(parameter.name), .type = parameter.type, .enumerators = {}});
    program_.routines[id].parameter_places.push_back(place);
  }
  if (const ir::Type type = signature.result_type(); type != ir::Type::kNone) {
    const ir::PlaceId result = locals_.Add("result", type);
    program_.routines[id].result = type;
    program_.routines[id].result_place = result;
  }
  builder_.SetRegion(program_.routines[id].body);
  Build(signature.routine, id);
  builder_.SetRegion(outside);
  locals_.Resume(outer);
  return id;
}

void SystemRoutines::CallAgain(SystemFunction function, std::vector<ValueId> arguments) {
  const FunctionId own = Replacement(function);
  builder_.CallRoutine(
      own.valid() && placement_.routines[own.index].valid() ? placement_.routines[own.index] : Routine(function),
      std::move(arguments));
}

// set_axis_move divides by |pic_a| + |d|, where d is not 0: two magnitudes of at most 2^31 make 2^32 or 0 only when
// both are 2^31.
ValueId SystemRoutines::DividesByZero(SystemFunction function, const std::vector<ValueId>& arguments) {
  const SystemRoutine routine = SignatureOf(function)->routine;
  const bool move = routine == SystemRoutine::kSetAxisMove, moveto = routine == SystemRoutine::kSetAxisMoveto;
  if (!move && !moveto) return {};
  // What the program has in the place of either is its own, and so is what it divides.
  if (moveto && (Replacement(SystemFunction::kSetAxisMove).valid() || Replacement(SystemFunction::kGetAxisPos).valid()))
    return {};
  const ValueId axis = Pure(OpKind::kWiden16To32, {arguments[0]});
  // The way of set_axis_moveto is p - pout - pic_a: with pic_a = -2^31 it is -2^31 too when p is pout.
  const ValueId far = Pure(OpKind::kEqual32, {arguments[1], move ? builder_.Constant(ir::Type::kI32, kMostNegative, 16)
                                                                 : AxisWord(Area::kF, 1, ir::Type::kI32, axis)});
  const ValueId rest = AxisWord(Area::kG, 1, ir::Type::kI32, axis);
  return Pure(OpKind::kBitAnd,
              {far, Pure(OpKind::kEqual32, {rest, builder_.Constant(ir::Type::kI32, kMostNegative, 16)})});
}

void SystemRoutines::Build(SystemRoutine routine, ir::RoutineId id) {
  const std::vector<ir::PlaceId> places = program_.routines[id].parameter_places;
  const auto parameter = [&](size_t i) { return builder_.Load(places[i]); };
  const auto axis = [&] { return Pure(OpKind::kWiden16To32, {parameter(0)}); };
  const auto pic_a = [&] { return AxisWord(Area::kG, 1, ir::Type::kI32, axis()); };
  const auto speed = [&] { return AxisWord(Area::kG, 3, ir::Type::kI16, axis()); };
  const auto iip = [&] { return Pure(OpKind::kWiden16To32, {places_.LoadWord(Area::kF, kIipWord)}); };
  const auto local = [&](std::string name, ir::Type type, ValueId value) {
    const ir::PlaceId place = locals_.Add(std::move(name), type);
    builder_.Store(place, value);
    return place;
  };
  const ir::PlaceId result = program_.routines[id].result_place;
  switch (routine) {
    case SystemRoutine::kSetAxisHome:
      builder_.Choose(
          Pure(OpKind::kNotEqual16, {parameter(1), Word(0)}),
          [&] {
            const ValueId word = AxisWord(Area::kG, 0, ir::Type::kI16, axis());
            const ValueId index = axis();
            const ValueId changed = Pure(OpKind::kOr16, {word, builder_.Constant(ir::Type::kI16, 0x40, 16)});
            SetAxisWord(0, ir::Type::kI16, changed, index);
          },
          [&] {
            const ValueId word = AxisWord(Area::kG, 0, ir::Type::kI16, axis());
            const ValueId index = axis();
            const ValueId changed = Pure(OpKind::kAnd16, {word, builder_.Constant(ir::Type::kI16, 0xFFBF, 16)});
            SetAxisWord(0, ir::Type::kI16, changed, index);
          });
      return;
    case SystemRoutine::kSetAxisJog: {
      const ValueId index = axis();
      const ValueId direction = parameter(1);
      SetAxisWord(4, ir::Type::kI16, direction, index);
      return;
    }
    case SystemRoutine::kSetAxisStep:
      builder_.When(Pure(OpKind::kNotEqual32, {parameter(1), Long(0)}), [&] {
        const ir::PlaceId l = local("l", ir::Type::kI32, Pure(OpKind::kAdd32, {pic_a(), parameter(1)}));
        const ValueId parts = Pure(OpKind::kSignedDiv32, {Pure(OpKind::kAbs32, {builder_.Load(l)}), Long(200)});
        const ir::PlaceId v = local("v", ir::Type::kI32, Pure(OpKind::kMul32, {parts, iip()}));
        const auto vmax = [&] {
          return Pure(OpKind::kSignExtend16To32, {AxisWord(Area::kF, 7, ir::Type::kI16, axis())});
        };
        builder_.When(Pure(OpKind::kSignedGreater32, {builder_.Load(v), vmax()}), [&] { builder_.Store(v, vmax()); });
        builder_.When(Pure(OpKind::kSignedLess32, {builder_.Load(v), Long(2)}), [&] { builder_.Store(v, Long(2)); });
        const ValueId index_of_way = axis();
        const ValueId way = builder_.Load(l);
        SetAxisWord(1, ir::Type::kI32, way, index_of_way);
        const ValueId index_of_speed = axis();
        const ValueId new_speed = Pure(OpKind::kLowHalf32, {builder_.Load(v)});
        SetAxisWord(3, ir::Type::kI16, new_speed, index_of_speed);
      });
      return;
    case SystemRoutine::kSetAxisMove:
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
        const ValueId index_of_speed = axis();
        const ValueId new_speed = Pure(OpKind::kLowHalf32, {mean});
        SetAxisWord(3, ir::Type::kI16, new_speed, index_of_speed);
        const ValueId index_of_way = axis();
        const ValueId way = Pure(OpKind::kAdd32, {pic_a(), parameter(1)});
        SetAxisWord(1, ir::Type::kI32, way, index_of_way);
      });
      return;
    case SystemRoutine::kSetAxisMoveto: {
      const FunctionId own = Replacement(SystemFunction::kGetAxisPos);
      const ir::RoutineId get = own.valid() && placement_.routines[own.index].valid()
                                    ? placement_.routines[own.index]
                                    : Routine(SystemFunction::kGetAxisPos);
      const ir::PlaceId position = local("position", ir::Type::kI32, builder_.CallRoutine(get, {parameter(0)}));
      const ValueId way = Pure(OpKind::kSub32, {parameter(1), builder_.Load(position)});
      CallAgain(SystemFunction::kSetAxisMove, {parameter(0), way, parameter(2)});
      return;
    }
    case SystemRoutine::kSetAxisStop: {
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
      const ValueId index = axis();
      const ValueId way = builder_.Load(l);
      SetAxisWord(1, ir::Type::kI32, way, index);
      CallAgain(SystemFunction::kSetAxisJog, {parameter(0), Word(0)});
      CallAgain(SystemFunction::kSetAxisHome, {parameter(0), Word(0)});
      return;
    }
    case SystemRoutine::kGetAxisPos:
      builder_.Store(result, Pure(OpKind::kAdd32, {AxisWord(Area::kF, 1, ir::Type::kI32, axis()), pic_a()}));
      return;
    case SystemRoutine::kGetAxisDen: {
      const ValueId rests = Pure(OpKind::kEqual32, {pic_a(), Long(0)});
      const ValueId jogs = Pure(OpKind::kNotEqual16, {AxisWord(Area::kG, 4, ir::Type::kI16, axis()), Word(0)});
      const ValueId done = Pure(OpKind::kBitAnd, {rests, Pure(OpKind::kBitNot, {jogs})});
      builder_.Store(result, Pure(OpKind::kWiden1To16, {done}));
      return;
    }
    case SystemRoutine::kGetHandwheel: {
      const auto wheel = [&] { return Pure(OpKind::kWiden16To32, {parameter(0)}); };
      const ValueId index_of_counts = wheel();
      const ir::PlaceId handwheels = HandwheelPlace();
      builder_.Store(result, builder_.Load(handwheels, index_of_counts));
      const ValueId index_to_clear = wheel();
      const ValueId zero = Word(0);
      builder_.Store(handwheels, zero, index_to_clear);
      return;
    }
    case SystemRoutine::kHandwheel: {
      const ValueId wheel = parameter(0);
      const ir::RoutineId get = Routine(SystemFunction::kGetHandwheel);
      const ValueId counts = builder_.CallRoutine(get, {wheel});
      const ir::PlaceId n = local("n", ir::Type::kI16, counts);
      const ValueId way = Pure(OpKind::kMul32, {Pure(OpKind::kSignExtend16To32, {builder_.Load(n)}),
                                                Pure(OpKind::kSignExtend16To32, {parameter(2)})});
      CallAgain(SystemFunction::kSetAxisStep, {parameter(1), way});
      return;
    }
  }
}

void SystemRoutines::AddHandwheels() {
  // One after the other, so that an index reaches them.
  handwheels_ = memory_.AddInputs("handwheel", "HW", ir::Type::kI16);
}

}  // namespace plcxx::hnc
