#include "transpiler/dialects/hnc/lowering/memory.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/ir/zones.h"

namespace plcxx::hnc {

namespace {

constexpr uint32_t kMostData = 60000;       // 5.6
constexpr uint32_t kMostSummed = 1U << 30;  // far beyond what is accepted, and the sum of two still fits
constexpr uint32_t kArgumentBytes = 8;

ir::Zone ZoneOf(Area area, uint32_t bytes) {
  switch (area) {
    case Area::kX:
    case Area::kF:
    case Area::kP:
      return ir::ZoneOfBytes(0, bytes, ir::Direction::kInput);
    case Area::kY:
    case Area::kG:
      return ir::ZoneOfBytes(0, bytes, ir::Direction::kOutput);
    case Area::kR:
    case Area::kB:
      break;
  }
  return ir::ZoneOfBytes(0, bytes, ir::Direction::kInternal);
}

/// What the control writes in G beside the program: it takes from the way of an axis what it has executed (7.4), and
/// does what system functions ask for where they are its own.
void AddAxisZones(ir::Space& space, SysfuncOption sysfunc) {
  constexpr uint32_t kAxes = 16, kAxisBytes = 20, kWay = 2, kWayBytes = 4, kWrittenBytes = 10;
  const bool is_host = sysfunc == SysfuncOption::kHost;
  for (uint32_t axis = 0; axis < kAxes; ++axis) {
    const uint32_t begin = kAxisBytes * axis + (is_host ? 0 : kWay);
    space.zones.push_back(ir::ZoneOfBytes(begin, begin + (is_host ? kWrittenBytes : kWayBytes), ir::Direction::kInput));
  }
}

std::string_view TitleOf(Area area) {
  switch (area) {
    case Area::kX:
      return "X: inputs of the machine; 100 to 127 are a copy for the slow part";
    case Area::kY:
      return "Y: outputs to the machine";
    case Area::kR:
      return "R: the program's own registers";
    case Area::kF:
      return "F: from the NC, words";
    case Area::kG:
      return "G: to the NC, words";
    case Area::kP:
      return "P: parameters of the user, words";
    case Area::kB:
      return "B: kept at power-off, words";
  }
  PLCXX_UNREACHABLE();
}

}  // namespace

void Memory::AddSpaces() {
  for (const AreaRow& row : Areas()) {
    ir::Space space{.name = std::string(row.name),
                    .title = std::string(TitleOf(row.area)),
                    .bytes = row.bytes,
                    .lifetime = row.area == Area::kB ? ir::Lifetime::kRetentive : ir::Lifetime::kVolatile,
                    .order = ir::ByteOrder::kLittle,
                    .host_visible = true};
    space.zones.push_back(ZoneOf(row.area, row.bytes));
    if (row.area == Area::kG) {  // completed, D22
      AddAxisZones(space, settings_.sysfunc);
      for (uint32_t channel = 0; channel < 4; ++channel) {
        for (uint32_t byte = 0; byte < 8; ++byte) {
          space.initial.push_back({.offset = 2 * (170 + 20 * channel) + byte, .value = 0xFF});
        }
      }
    }
    area_spaces_[static_cast<size_t>(row.area)] = program_.spaces.Add(std::move(space));
  }
  const auto add = [this](std::string_view name, std::string_view title, bool visible) {
    return program_.spaces.Add({.name = std::string(name),
                                .title = std::string(title),
                                .bytes = 0,
                                .lifetime = ir::Lifetime::kVolatile,
                                .order = ir::ByteOrder::kLittle,
                                .host_visible = visible});
  };
  data_ = add("data", "variables of the program", true);
  automatic_ = add("automatic", "automatic arrays, structures and what has its address taken", false);
  strings_ = add("strings", "string literals", false);
  pointers_ = add("pointers", "pointers in memory", false);
  system_ = add("system", "the runtime's own", true);
  arguments_ = program_.spaces.Add({.name = "arguments",
                                    .title = "what routines of the runtime hand over",
                                    .bytes = 0,
                                    .lifetime = ir::Lifetime::kRoutine});
}

/// No bit has two initial values, but a byte may have several fields.
void Memory::PutBytes(ir::SpaceId space, uint32_t offset, uint64_t value, uint32_t bytes) {
  std::vector<ir::InitialByte>& initial = program_.spaces[space].initial;
  for (uint32_t i = 0; i < bytes; ++i) {
    const auto byte = static_cast<uint8_t>(value >> (8 * i));
    const auto at = std::ranges::lower_bound(initial, offset + i, {}, &ir::InitialByte::offset);
    if (at != initial.end() && at->offset == offset + i) {
      at->value |= byte;
    } else if (byte != 0) {
      initial.insert(at, {.offset = offset + i, .value = byte});
    }
  }
}

void Memory::InitialBytesOf(const InitialValue& initial, uint32_t begin) {
  if (!initial.value.valid()) return;
  const Type& type = TypeAt(initial.type);
  const Expr& value = ExprAt(initial.value);
  const uint32_t at = begin + initial.offset;
  if (type.kind == TypeKind::kArray) {
    if (value.kind != ExprKind::kString) return;
    const std::string& bytes = unit_.strings[value.string];
    for (uint32_t i = 0; i < type.size && i < bytes.size(); ++i) {
      PutBytes(data_, at + i, static_cast<uint8_t>(bytes[i]), 1);
    }
    return;
  }
  if (type.kind == TypeKind::kPointer) {  // of a table of strings: the number of the string
    if (const std::optional<StaticAddress> target = facts_.PointeeOf(initial.value)) {
      PutBytes(data_, at, NumberOf(target->object), 2);
    }
    return;
  }
  if (!value.constant) return;
  if (type.kind == TypeKind::kReal) {
    const bool narrow = type.bits == 32;
    PutBytes(data_, at,
             narrow ? std::bit_cast<uint32_t>(static_cast<float>(value.constant->real))
                    : std::bit_cast<uint64_t>(value.constant->real),
             type.bits / 8);
    return;
  }
  const auto number = static_cast<uint64_t>(value.constant->integer);
  if (!initial.is_bit_field) {
    PutBytes(data_, at, number, type.bits / 8);
    return;
  }
  const uint64_t mask = (uint64_t{1} << initial.bit_width) - 1;
  PutBytes(data_, at, (number & mask) << initial.bit_offset, type.size);
}

void Memory::AddPointerPlaces(VariableId id) {
  const Variable& variable = unit_.variables[id];
  const bool several = facts_.TargetsOf(id).objects.size() > 1;
  const bool local = variable.storage == Storage::kAutomatic || variable.storage == Storage::kParameter;
  if (local) return;  // with its function
  PointerPlaces places;
  const auto add = [&](std::string name, ir::Type type) {
    const uint32_t offset = pointer_bytes_;
    pointer_bytes_ += ir::Bytes(type);
    return program_.places.Add(
        {.name = std::move(name), .address = {}, .type = type, .space = pointers_, .offset = offset});
  };
  places.offset = add(variable.name, ir::Type::kI32);
  if (several) places.object = add(variable.name + "_object", ir::Type::kI16);
  StaticAddress start{{}, static_cast<int64_t>(kNullOffset)};
  if (!variable.initial.empty()) {
    if (const auto target = facts_.PointeeOf(variable.initial.front().value)) start = *target;
  }
  PutBytes(pointers_, program_.places[places.offset].offset, static_cast<uint32_t>(start.offset), 4);
  if (several && start.object.valid()) {
    PutBytes(pointers_, program_.places[places.object].offset, NumberOf(start.object), 2);
  }
  placement_.pointers[id.index] = places;
}

void Memory::AddVariables() {
  object_begin_.resize(objects_.size());
  object_space_.resize(objects_.size());
  placement_.locals.resize(unit_.variables.size());
  uint32_t data = 0, automatic = 0, strings = 0;
  for (uint32_t i = 0; i < objects_.size(); ++i) {
    const Object& object = objects_[ObjectId(i)];
    const auto put = [&](ir::SpaceId space, uint32_t& bytes) {
      object_space_[i] = space;
      object_begin_[i] = bytes;
      bytes = static_cast<uint32_t>(std::min<uint64_t>(kMostSummed, uint64_t{bytes} + object.size));
    };
    switch (object.kind) {
      case ObjectKind::kArea:
        object_space_[i] = area_spaces_[object.index];
        break;
      case ObjectKind::kString:
        put(strings_, strings);
        for (uint32_t b = 0; b < object.size; ++b) {
          PutBytes(strings_, object_begin_[i] + b, static_cast<uint8_t>(unit_.strings[object.index][b]), 1);
        }
        break;
      case ObjectKind::kResult:
        if (unit_.functions[FunctionId(object.index)].is_defined &&
            types_[unit_.functions[FunctionId(object.index)].result].kind == TypeKind::kRecord) {
          put(automatic_, automatic);
        }
        break;
      case ObjectKind::kVariable: {
        const VariableId id(object.index);
        const Variable& variable = unit_.variables[id];
        if (TypeAt(variable.type).kind == TypeKind::kPointer) {
          AddPointerPlaces(id);
          break;
        }
        const bool local = variable.storage == Storage::kAutomatic || variable.storage == Storage::kParameter;
        if (local) {
          if (facts_.IsInMemory(id)) put(automatic_, automatic);
          break;
        }
        put(data_, data);
        break;
      }
    }
  }
  program_.spaces[data_].bytes = data;
  program_.spaces[automatic_].bytes = automatic;
  program_.spaces[strings_].bytes = strings;
  uint32_t own = data + automatic;
  for (uint32_t i = 0; i < unit_.variables.size(); ++i) {
    const Storage storage = unit_.variables[VariableId(i)].storage;
    if (storage == Storage::kPlc1Time || storage == Storage::kPlc2Time) own -= 2;  // the header's
  }
  if (own > kMostData) {
    const Variable* largest = nullptr;
    for (const Variable& variable : unit_.variables) {
      const bool counts = variable.storage == Storage::kGlobal || variable.storage == Storage::kStaticLocal;
      if (counts && (largest == nullptr || TypeAt(variable.type).size > TypeAt(largest->type).size))
        largest = &variable;
    }
    const source::Range range = largest != nullptr ? largest->range : unit_.last_token;
    diagnostics_.Report(range, diag::HncDataSize, own, kMostData);
    return;
  }
  for (uint32_t i = 0; i < objects_.size(); ++i) {
    const Object& object = objects_[ObjectId(i)];
    if (object.kind != ObjectKind::kVariable || object_space_[i] != data_) continue;
    if (unit_.variables[VariableId(object.index)].is_const) {
      program_.spaces[data_].constants.push_back({.begin = object_begin_[i], .end = object_begin_[i] + object.size});
    }
    for (const InitialValue& initial : unit_.variables[VariableId(object.index)].initial) {
      InitialBytesOf(initial, object_begin_[i]);
    }
  }
}

ir::PlaceId Memory::AddScalar(std::string name, ir::Type type) {
  const uint32_t offset = system_bytes_;
  system_bytes_ += ir::Bytes(type);
  return program_.places.Add({.name = std::move(name),
                              .address = {},
                              .type = type,
                              .space = system_,
                              .offset = offset,
                              .bit = type == ir::Type::kBit ? uint8_t{0} : ir::kNoBit});
}

std::array<ir::PlaceId, 4> Memory::AddInputs(const std::string& name, const std::string& address, ir::Type type) {
  const uint32_t begin = system_bytes_;
  std::array<ir::PlaceId, 4> places;
  for (size_t i = 0; i < places.size(); ++i) {
    const std::string number = std::to_string(i);
    places[i] = AddScalar(name + "_" + number, type);
    program_.places[places[i]].address = address + "[" + number + "]";
  }
  program_.spaces[system_].zones.push_back(ir::ZoneOfBytes(begin, system_bytes_, ir::Direction::kInput));
  return places;
}

ir::PlaceId Memory::AddArgument(std::string name, ir::Type type) {
  const uint32_t offset = argument_bytes_;
  argument_bytes_ += kArgumentBytes;
  return program_.places.Add(
      {.name = std::move(name), .address = {}, .type = type, .space = arguments_, .offset = offset});
}

void Memory::Finish() {
  program_.spaces[system_].bytes = system_bytes_;
  program_.spaces[pointers_].bytes = pointer_bytes_;
  program_.spaces[arguments_].bytes = argument_bytes_;
}

}  // namespace plcxx::hnc
