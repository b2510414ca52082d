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
  Build(signature.routine,
        {.places = program_.routines[id].parameter_places, .result = program_.routines[id].result_place});
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

ValueId SystemRoutines::Parameter(const Parameters& p, size_t index) { return builder_.Load(p.places[index]); }

ValueId SystemRoutines::Axis(const Parameters& p) { return Pure(OpKind::kWiden16To32, {Parameter(p, 0)}); }

ValueId SystemRoutines::PicA(const Parameters& p) { return AxisWord(Area::kG, 1, ir::Type::kI32, Axis(p)); }

ValueId SystemRoutines::Speed(const Parameters& p) { return AxisWord(Area::kG, 3, ir::Type::kI16, Axis(p)); }

ValueId SystemRoutines::Iip() { return Pure(OpKind::kWiden16To32, {places_.LoadWord(Area::kF, kIipWord)}); }

ir::PlaceId SystemRoutines::Local(std::string name, ir::Type type, ValueId value) {
  const ir::PlaceId place = locals_.Add(std::move(name), type);
  builder_.Store(place, value);
  return place;
}

void SystemRoutines::SetAxisHome(const Parameters& p) {
  builder_.Choose(
      Pure(OpKind::kNotEqual16, {Parameter(p, 1), Word(0)}),
      [&] {
        const ValueId word = AxisWord(Area::kG, 0, ir::Type::kI16, Axis(p));
        const ValueId index = Axis(p);
        const ValueId changed = Pure(OpKind::kOr16, {word, builder_.Constant(ir::Type::kI16, 0x40, 16)});
        SetAxisWord(0, ir::Type::kI16, changed, index);
      },
      [&] {
        const ValueId word = AxisWord(Area::kG, 0, ir::Type::kI16, Axis(p));
        const ValueId index = Axis(p);
        const ValueId changed = Pure(OpKind::kAnd16, {word, builder_.Constant(ir::Type::kI16, 0xFFBF, 16)});
        SetAxisWord(0, ir::Type::kI16, changed, index);
      });
}

void SystemRoutines::SetAxisJog(const Parameters& p) {
  const ValueId index = Axis(p);
  const ValueId direction = Parameter(p, 1);
  SetAxisWord(4, ir::Type::kI16, direction, index);
}

void SystemRoutines::SetAxisStep(const Parameters& p) {
  builder_.When(Pure(OpKind::kNotEqual32, {Parameter(p, 1), Long(0)}), [&] {
    const ir::PlaceId l = Local("l", ir::Type::kI32, Pure(OpKind::kAdd32, {PicA(p), Parameter(p, 1)}));
    const ValueId parts = Pure(OpKind::kSignedDiv32, {Pure(OpKind::kAbs32, {builder_.Load(l)}), Long(200)});
    const ir::PlaceId v = Local("v", ir::Type::kI32, Pure(OpKind::kMul32, {parts, Iip()}));
    const auto vmax = [&] { return Pure(OpKind::kSignExtend16To32, {AxisWord(Area::kF, 7, ir::Type::kI16, Axis(p))}); };
    builder_.When(Pure(OpKind::kSignedGreater32, {builder_.Load(v), vmax()}), [&] { builder_.Store(v, vmax()); });
    builder_.When(Pure(OpKind::kSignedLess32, {builder_.Load(v), Long(2)}), [&] { builder_.Store(v, Long(2)); });
    const ValueId index_of_way = Axis(p);
    const ValueId way = builder_.Load(l);
    SetAxisWord(1, ir::Type::kI32, way, index_of_way);
    const ValueId index_of_speed = Axis(p);
    const ValueId new_speed = Pure(OpKind::kLowHalf32, {builder_.Load(v)});
    SetAxisWord(3, ir::Type::kI16, new_speed, index_of_speed);
  });
}

void SystemRoutines::SetAxisMove(const Parameters& p) {
  builder_.When(Pure(OpKind::kNotEqual32, {Parameter(p, 1), Long(0)}), [&] {
    const auto magnitude16 = [&](ValueId value) {
      return Pure(OpKind::kSignExtend16To32, {Pure(OpKind::kAbs16, {value})});
    };
    const ir::PlaceId l1 = Local("l1", ir::Type::kI32, Pure(OpKind::kAbs32, {PicA(p)}));
    const ir::PlaceId l2 = Local("l2", ir::Type::kI32, Pure(OpKind::kAbs32, {Parameter(p, 1)}));
    const ValueId first = Pure(OpKind::kMul32, {builder_.Load(l1), magnitude16(Speed(p))});
    const ValueId second = Pure(OpKind::kMul32, {builder_.Load(l2), magnitude16(Parameter(p, 2))});
    const ir::PlaceId product = Local("product", ir::Type::kI32, Pure(OpKind::kAdd32, {first, second}));
    const ir::PlaceId sum = Local("sum", ir::Type::kI32, Pure(OpKind::kAdd32, {builder_.Load(l1), builder_.Load(l2)}));
    const ValueId mean = Pure(OpKind::kSignedDiv32, {builder_.Load(product), builder_.Load(sum)});
    const ValueId index_of_speed = Axis(p);
    const ValueId new_speed = Pure(OpKind::kLowHalf32, {mean});
    SetAxisWord(3, ir::Type::kI16, new_speed, index_of_speed);
    const ValueId index_of_way = Axis(p);
    const ValueId way = Pure(OpKind::kAdd32, {PicA(p), Parameter(p, 1)});
    SetAxisWord(1, ir::Type::kI32, way, index_of_way);
  });
}

void SystemRoutines::SetAxisMoveto(const Parameters& p) {
  const FunctionId own = Replacement(SystemFunction::kGetAxisPos);
  const ir::RoutineId get = own.valid() && placement_.routines[own.index].valid()
                                ? placement_.routines[own.index]
                                : Routine(SystemFunction::kGetAxisPos);
  const ir::PlaceId position = Local("position", ir::Type::kI32, builder_.CallRoutine(get, {Parameter(p, 0)}));
  const ValueId way = Pure(OpKind::kSub32, {Parameter(p, 1), builder_.Load(position)});
  CallAgain(SystemFunction::kSetAxisMove, {Parameter(p, 0), way, Parameter(p, 2)});
}

void SystemRoutines::SetAxisStop(const Parameters& p) {
  const ir::PlaceId l = Local("l", ir::Type::kI32, PicA(p));
  const ValueId product = Pure(OpKind::kMul32, {Pure(OpKind::kSignExtend16To32, {Speed(p)}), Iip()});
  const ir::PlaceId b = Local("b", ir::Type::kI32, Pure(OpKind::kSignedDiv32, {product, Long(200)}));
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
  const ValueId index = Axis(p);
  const ValueId way = builder_.Load(l);
  SetAxisWord(1, ir::Type::kI32, way, index);
  CallAgain(SystemFunction::kSetAxisJog, {Parameter(p, 0), Word(0)});
  CallAgain(SystemFunction::kSetAxisHome, {Parameter(p, 0), Word(0)});
}

void SystemRoutines::GetAxisPos(const Parameters& p) {
  builder_.Store(p.result, Pure(OpKind::kAdd32, {AxisWord(Area::kF, 1, ir::Type::kI32, Axis(p)), PicA(p)}));
}

void SystemRoutines::GetAxisDen(const Parameters& p) {
  const ValueId rests = Pure(OpKind::kEqual32, {PicA(p), Long(0)});
  const ValueId jogs = Pure(OpKind::kNotEqual16, {AxisWord(Area::kG, 4, ir::Type::kI16, Axis(p)), Word(0)});
  const ValueId done = Pure(OpKind::kBitAnd, {rests, Pure(OpKind::kBitNot, {jogs})});
  builder_.Store(p.result, Pure(OpKind::kWiden1To16, {done}));
}

void SystemRoutines::GetHandwheel(const Parameters& p) {
  const auto wheel = [&] { return Pure(OpKind::kWiden16To32, {Parameter(p, 0)}); };
  const ValueId index_of_counts = wheel();
  const ir::PlaceId handwheels = HandwheelPlace();
  builder_.Store(p.result, builder_.Load(handwheels, index_of_counts));
  const ValueId index_to_clear = wheel();
  const ValueId zero = Word(0);
  builder_.Store(handwheels, zero, index_to_clear);
}

void SystemRoutines::Handwheel(const Parameters& p) {
  const ValueId wheel = Parameter(p, 0);
  const ir::RoutineId get = Routine(SystemFunction::kGetHandwheel);
  const ValueId counts = builder_.CallRoutine(get, {wheel});
  const ir::PlaceId n = Local("n", ir::Type::kI16, counts);
  const ValueId way = Pure(OpKind::kMul32, {Pure(OpKind::kSignExtend16To32, {builder_.Load(n)}),
                                            Pure(OpKind::kSignExtend16To32, {Parameter(p, 2)})});
  CallAgain(SystemFunction::kSetAxisStep, {Parameter(p, 1), way});
}

void SystemRoutines::Build(SystemRoutine routine, const Parameters& p) {
  switch (routine) {
    case SystemRoutine::kSetAxisHome:
      return SetAxisHome(p);
    case SystemRoutine::kSetAxisJog:
      return SetAxisJog(p);
    case SystemRoutine::kSetAxisStep:
      return SetAxisStep(p);
    case SystemRoutine::kSetAxisMove:
      return SetAxisMove(p);
    case SystemRoutine::kSetAxisMoveto:
      return SetAxisMoveto(p);
    case SystemRoutine::kSetAxisStop:
      return SetAxisStop(p);
    case SystemRoutine::kGetAxisPos:
      return GetAxisPos(p);
    case SystemRoutine::kGetAxisDen:
      return GetAxisDen(p);
    case SystemRoutine::kGetHandwheel:
      return GetHandwheel(p);
    case SystemRoutine::kHandwheel:
      return Handwheel(p);
  }
}

void SystemRoutines::AddHandwheels() {
  // One after the other, so that an index reaches them.
  handwheels_ = memory_.AddInputs("handwheel", "HW", ir::Type::kI16);
}

}  // namespace plcxx::hnc
