// The memory map: register areas, variables, what automatic variables need in memory, places and their names.

#include <algorithm>
#include <bit>
#include <utility>

#include "transpiler/dialects/hnc/lowering_internal.h"
#include "transpiler/dialects/hnc/machine.h"

namespace plcxx::hnc {

namespace {

constexpr uint32_t kMostData = 60000;  // 5.6
constexpr uint32_t kLocalBytes = 8;    // of a local of a routine, which is no place of memory

bool IsNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// "ch_ctrl(0)" -> "ch_ctrl_0"
std::string AsName(std::string_view text) {
  std::string name;
  for (const char c : text) {
    if (IsNameCharacter(c)) {
      name += c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name;
}

std::string_view SuffixOf(ir::Type type) {
  switch (type) {
    case ir::Type::kI8:
      return "_uc";
    case ir::Type::kI16:
      return "_ui";
    default:
      return "_ul";
  }
}

ir::Zone ZoneOf(Area area, uint32_t bytes) {
  switch (area) {
    case Area::kX:
    case Area::kF:
    case Area::kP:
      return {0, bytes, ir::Direction::kInput};
    case Area::kY:
    case Area::kG:
      return {0, bytes, ir::Direction::kOutput};
    case Area::kR:
    case Area::kB:
      break;
  }
  return {0, bytes, ir::Direction::kInternal};
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

void Lowering::AddSpaces() {
  for (const AreaRow& row : Areas()) {
    ir::Space space{.name = std::string(row.name),
                    .title = std::string(TitleOf(row.area)),
                    .bytes = row.bytes,
                    .lifetime = row.area == Area::kB ? ir::Lifetime::kRetentive : ir::Lifetime::kVolatile,
                    .order = ir::ByteOrder::kLittle,
                    .host_visible = true};
    space.zones.push_back(ZoneOf(row.area, row.bytes));
    if (row.area == Area::kG) {  // completed, D22
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

void Lowering::PutBytes(ir::SpaceId space, uint32_t offset, uint64_t value, uint32_t bytes) {
  std::vector<ir::InitialByte>& initial = program_.spaces[space].initial;
  for (uint32_t i = 0; i < bytes; ++i) {
    const auto byte = static_cast<uint8_t>(value >> (8 * i));
    const auto at = std::ranges::lower_bound(initial, offset + i, {}, &ir::InitialByte::offset);
    if (at != initial.end() && at->offset == offset + i) {
      at->value = byte;
    } else if (byte != 0) {
      initial.insert(at, {.offset = offset + i, .value = byte});
    }
  }
}

void Lowering::InitialBytesOf(const InitialValue& initial, uint32_t begin) {
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
  uint64_t unit = 0;
  for (const ir::InitialByte& byte : program_.spaces[data_].initial) {
    if (byte.offset >= at && byte.offset < at + type.size) unit |= uint64_t{byte.value} << (8 * (byte.offset - at));
  }
  PutBytes(data_, at, unit | (number & mask) << initial.bit_offset, type.size);
}

void Lowering::AddPointerPlaces(VariableId id) {
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
  pointer_places_[id.index] = places;
}

void Lowering::AddVariables() {
  object_begin_.resize(objects_.size());
  object_space_.resize(objects_.size());
  local_places_.resize(unit_.variables.size());
  uint32_t data = 0, automatic = 0, strings = 0;
  for (uint32_t i = 0; i < objects_.size(); ++i) {
    const Object& object = objects_[ObjectId(i)];
    const auto put = [&](ir::SpaceId space, uint32_t& bytes) {
      object_space_[i] = space;
      object_begin_[i] = bytes;
      bytes += object.size;
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
    for (const InitialValue& initial : unit_.variables[VariableId(object.index)].initial) {
      InitialBytesOf(initial, object_begin_[i]);
    }
  }
}

ir::PlaceId Lowering::AddLocal(std::string name, ir::Type type) {
  const uint32_t offset = local_bytes_;
  local_bytes_ += kLocalBytes;
  program_.spaces[locals_].bytes = local_bytes_;
  return program_.places.Add({.name = std::move(name),
                              .address = {},
                              .type = type,
                              .space = locals_,
                              .offset = offset,
                              .bit = type == ir::Type::kBit ? uint8_t{0} : ir::kNoBit});
}

ir::PlaceId Lowering::AddScalar(std::string name, ir::Type type, uint64_t initial) {
  const uint32_t offset = system_bytes_;
  system_bytes_ += ir::Bytes(type);
  if (initial != 0) PutBytes(system_, offset, initial, ir::Bytes(type));
  return program_.places.Add({.name = std::move(name),
                              .address = {},
                              .type = type,
                              .space = system_,
                              .offset = offset,
                              .bit = type == ir::Type::kBit ? uint8_t{0} : ir::kNoBit});
}

/// Names that the program's macros give to cells: `#define mode_sel R[0]`; those of the control come second.
void Lowering::CollectCellNames() {
  for (const bool system : {false, true}) {
    for (uint32_t i = 0; i < unit_.expressions.size(); ++i) {
      const Expr& expr = unit_.expressions[ExprId(i)];
      if (!expr.whole_macro || !expr.macro.valid()) continue;
      const MacroUse& use = unit_.macro_uses[expr.macro];
      const Macro& macro = unit_.macros[use.macro];
      if (macro.is_system != system || (!system && macro.has_parameters)) continue;
      const bool table = expr.kind == ExprKind::kLoad && TypeAt(expr.type).kind == TypeKind::kPointer;
      if (!expr.is_lvalue && !table) continue;
      const std::optional<StaticAddress> at = table ? facts_.PointeeOf(ExprId(i)) : facts_.AddressOf(ExprId(i));
      if (!at || objects_[at->object].kind != ObjectKind::kArea || at->offset < 0) continue;
      const std::string name = macro.has_parameters ? AsName(sources_.Text(use.range)) : macro.name;
      cell_names_.emplace(std::pair(at->object.index, static_cast<uint32_t>(at->offset)), name);
    }
  }
}

/// "R5", "G162", "R_ui_15", "table_3", "axes_speed".
std::string Lowering::NameOfCell(ObjectId id, uint32_t offset, ir::Type type) const {
  const Object& object = objects_[id];
  const uint32_t bytes = ir::Bytes(type);
  if (object.kind == ObjectKind::kArea) {
    const bool words = object.name != "X" && object.name != "Y" && object.name != "R";
    if (bytes == (words ? 2 : 1) && offset % bytes == 0) return object.name + std::to_string(offset / bytes);
    if (offset % bytes == 0) return object.name + std::string(SuffixOf(type)) + "_" + std::to_string(offset / bytes);
    return object.name + std::string(SuffixOf(type)) + "_at_" + std::to_string(offset);
  }
  if (object.kind != ObjectKind::kVariable) return AsName(object.name) + "_" + std::to_string(offset);
  const Variable& variable = unit_.variables[VariableId(object.index)];
  std::string name = variable.storage == Storage::kStaticLocal ? AsName(object.name) : variable.name;
  TypeId at = variable.type;
  uint32_t rest = offset;
  for (;;) {
    const Type& part = TypeAt(at);
    if (part.kind == TypeKind::kArray) {
      const uint32_t size = std::max(1u, TypeAt(part.element).size);
      name += "_" + std::to_string(rest / size);
      rest %= size;
      at = part.element;
      continue;
    }
    if (part.kind != TypeKind::kRecord) break;
    const Record& record = unit_.records[part.record];
    const Member* found = nullptr;
    for (const Member& member : record.members) {
      if (member.offset <= rest && rest < member.offset + TypeAt(member.type).size) {
        found = &member;
        break;
      }
    }
    if (found == nullptr) break;
    if (!found->name.empty()) name += "_" + found->name;
    rest -= found->offset;
    at = found->type;
  }
  if (rest != 0) name += "_byte_" + std::to_string(rest);
  return name;
}

ir::PlaceId Lowering::PlaceAt(ObjectId object, uint32_t offset, ir::Type type) {
  const std::string key =
      std::to_string(object.index) + "." + std::to_string(offset) + "." + std::to_string(static_cast<int>(type));
  ir::PlaceId& place = places_[key];
  if (place.valid()) return place;
  const std::string own = NameOfCell(object, offset, type);
  const auto named = cell_names_.find({object.index, offset});
  place = program_.places.Add({.name = named == cell_names_.end() ? own : named->second,
                               .address = AddressText(object, offset, type),
                               .type = type,
                               .space = object_space_[object.index],
                               .offset = object_begin_[object.index] + offset});
  return place;
}

ir::PlaceId Lowering::IndexedPlaceAt(ObjectId object, uint32_t offset, uint32_t stride, ir::Type type) {
  const std::string key = std::to_string(object.index) + "." + std::to_string(offset) + "x" + std::to_string(stride) +
                          "." + std::to_string(static_cast<int>(type));
  ir::PlaceId& place = places_[key];
  if (place.valid()) return place;
  const Object& target = objects_[object];
  std::string name = AsName(target.name);
  if (target.kind == ObjectKind::kArea) {
    const bool words = target.name != "X" && target.name != "Y" && target.name != "R";
    if (ir::Bytes(type) != (words ? 2 : 1)) name += SuffixOf(type);
    if (offset != 0) name += "_from_" + std::to_string(offset / stride);
    if (stride != ir::Bytes(type)) name += "_by_" + std::to_string(stride);
  } else if (target.kind == ObjectKind::kVariable) {
    const Variable& variable = unit_.variables[VariableId(target.index)];
    if (variable.storage != Storage::kStaticLocal) name = variable.name;
    const Type& whole = TypeAt(variable.type);
    const bool elements = whole.kind == TypeKind::kArray && stride == TypeAt(whole.element).size;
    if (elements && TypeAt(whole.element).kind == TypeKind::kRecord && offset < stride) {
      // "axes_speed": the name of element 0 without its number.
      const std::string first = NameOfCell(object, offset, type), prefix = name + "_0";
      if (first.starts_with(prefix)) name += first.substr(prefix.size());
    } else if (!elements || offset != 0) {
      name += "_from_" + std::to_string(offset) + (elements ? "" : "_by_" + std::to_string(stride));
    }
  }
  const uint32_t begin = object_begin_[object.index];
  place = program_.places.Add({.name = name,
                               .address = {},
                               .type = type,
                               .space = object_space_[object.index],
                               .offset = begin + offset,
                               .bit = ir::kNoBit,
                               .indexed = true,
                               .stride = stride,
                               .low = begin,
                               .high = begin + target.size});
  return place;
}

ir::ValueId Lowering::LoadWord(Area area, uint32_t word, ir::Type type) {
  return builder_.Load(PlaceAt(objects_.OfArea(area), 2 * word, type));
}

void Lowering::StoreWord(Area area, uint32_t word, ir::ValueId value, ir::Type type) {
  builder_.Store(PlaceAt(objects_.OfArea(area), 2 * word, type), value);
}

}  // namespace plcxx::hnc
