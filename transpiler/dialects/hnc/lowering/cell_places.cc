#include "transpiler/dialects/hnc/lowering/cell_places.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/lowering/memory.h"
#include "transpiler/support/check.h"

namespace plcxx::hnc {

namespace {

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
    case ir::Type::kNone:
    case ir::Type::kBit:
    case ir::Type::kI32:
    case ir::Type::kI64:
    case ir::Type::kF32:
    case ir::Type::kF64:
      return "_ul";
  }
  PLCXX_UNREACHABLE();
}

}  // namespace

void CellPlaces::CollectNames() {
  std::vector<ExprId> whole;
  for (uint32_t i = 0; i < unit_.expressions.size(); ++i) {
    const Expr& expr = unit_.expressions[ExprId(i)];
    if (expr.whole_macro && expr.macro.valid() && expr.is_lvalue) whole.emplace_back(i);
  }
  for (const bool system : {false, true}) {
    for (const ExprId id : whole) {
      const Expr& expr = unit_.expressions[id];
      const MacroUse& use = unit_.macro_uses[expr.macro];
      const Macro& macro = unit_.macros[use.macro];
      if (macro.is_system != system || (!system && macro.has_parameters)) continue;
      // An element of a table of pointers is as far from the table's beginning as its word from the area's.
      const std::optional<StaticAddress> at = facts_.AddressOf(id);
      if (!at || objects_[at->object].kind != ObjectKind::kArea || at->offset < 0) continue;
      const std::string name = macro.has_parameters ? AsName(sources_.Text(use.range)) : macro.name;
      cell_names_.emplace(std::pair(at->object.index, static_cast<uint32_t>(at->offset)), name);
    }
  }
}

/// None: a bit-field without a name has left a gap there.
const Member* CellPlaces::MemberAt(const Record& record, uint32_t offset) const {
  const auto found = std::ranges::find_if(record.members, [&](const Member& member) {
    const bool is_gap = member.name.empty();  // only a bit-field has none
    return !is_gap && member.offset <= offset && offset < member.offset + TypeAt(member.type).size;
  });
  return found == record.members.end() ? nullptr : &*found;
}

/// "R5", "G162", "R_ui_15", "table_3", "axes_speed".
std::string CellPlaces::NameOf(ObjectId id, uint32_t offset, ir::Type type) const {
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
    const Member* const found = MemberAt(unit_.records[part.record], rest);
    if (found == nullptr) break;
    name += "_" + found->name;
    rest -= found->offset;
    at = found->type;
  }
  if (rest != 0) name += "_byte_" + std::to_string(rest);
  return name;
}

ir::PlaceId CellPlaces::At(ObjectId object, uint32_t offset, ir::Type type) {
  ir::PlaceId& place = places_[{object.index, offset, kNoStride, type}];
  if (place.valid()) return place;
  const std::string own = NameOf(object, offset, type);
  const auto named = cell_names_.find({object.index, offset});
  place = program_.places.Add({.name = named == cell_names_.end() ? own : named->second,
                               .address = AddressOf(object, offset, type),
                               .type = type,
                               .space = memory_.SpaceOf(object),
                               .offset = memory_.BeginOf(object) + offset});
  return place;
}

ir::PlaceId CellPlaces::IndexedAt(ObjectId object, uint32_t offset, uint32_t stride, ir::Type type) {
  ir::PlaceId& place = places_[{object.index, offset, stride, type}];
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
      const std::string first = NameOf(object, offset, type), prefix = name + "_0";
      if (first.starts_with(prefix)) name += first.substr(prefix.size());
    } else if (!elements || offset != 0) {
      name += "_from_" + std::to_string(offset) + (elements ? "" : "_by_" + std::to_string(stride));
    }
  }
  const uint32_t begin = memory_.BeginOf(object);
  place = program_.places.Add({.name = name,
                               .address = {},
                               .type = type,
                               .space = memory_.SpaceOf(object),
                               .offset = begin + offset,
                               .bit = ir::kNoBit,
                               .indexed = true,
                               .stride = stride,
                               .low = begin,
                               .high = begin + target.size});
  return place;
}

ir::ValueId CellPlaces::LoadWord(Area area, uint32_t word, ir::Type type) {
  return builder_.Load(At(objects_.OfArea(area), 2 * word, type));
}

/// "R[5]", "R_ui[15]", "axes[2].speed": as scenarios name it (4.4).
std::string CellPlaces::AddressOf(ObjectId id, uint32_t offset, ir::Type type) const {
  const Object& object = objects_[id];
  const uint32_t bytes = ir::Bytes(type);
  const auto element = [](std::string_view name, uint32_t number) {
    return std::string(name) + "[" + std::to_string(number) + "]";
  };
  if (object.kind == ObjectKind::kArea) {
    const bool table = object.name == "F" || object.name == "G";
    const bool words = table || object.name == "P" || object.name == "B";
    const uint32_t stride = table ? 2 : bytes;
    if (offset % stride != 0) return NameOf(id, offset, type);
    if (bytes == (words ? 2 : 1)) return element(object.name, offset / stride);
    const std::string_view suffix = bytes == 1 ? "_uc" : bytes == 2 ? "_ui" : "_ul";
    return element(object.name + std::string(suffix), offset / stride);
  }
  if (object.kind != ObjectKind::kVariable) return NameOf(id, offset, type);
  std::string text = object.name;
  TypeId at = unit_.variables[VariableId(object.index)].type;
  uint32_t rest = offset;
  for (;;) {
    const Type& part = TypeAt(at);
    if (part.kind == TypeKind::kArray) {
      const uint32_t size = std::max(1u, TypeAt(part.element).size);
      text = element(text, rest / size);
      rest %= size;
      at = part.element;
      continue;
    }
    if (part.kind != TypeKind::kRecord) break;
    const Member* const found = MemberAt(unit_.records[part.record], rest);
    if (found == nullptr) break;
    if (!found->name.empty()) text += "." + found->name;
    rest -= found->offset;
    at = found->type;
  }
  return rest == 0 ? text : NameOf(id, offset, type);
}

}  // namespace plcxx::hnc
