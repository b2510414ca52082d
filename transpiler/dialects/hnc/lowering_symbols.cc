// Names of the program's data for scenarios and reports: every element and member, whether or not a statement names it.

#include <algorithm>
#include <map>
#include <utility>

#include "transpiler/dialects/hnc/lowering_internal.h"

namespace plcxx::hnc {

void Lowering::AddSymbol(const std::string& name, TypeId type_id, uint32_t offset,
                         const std::vector<ir::Symbol::Index>& indices) {
  const Type& type = TypeAt(type_id);
  switch (type.kind) {
    case TypeKind::kInteger:
    case TypeKind::kReal:
      program_.symbols.push_back({.name = name,
                                  .type = IrType(type_id),
                                  .space = data_,
                                  .offset = offset,
                                  .bit = ir::kNoBit,
                                  .indices = indices,
                                  .has_sign = type.kind == TypeKind::kInteger && type.is_signed});
      return;
    case TypeKind::kArray: {
      std::vector<ir::Symbol::Index> inner = indices;
      inner.push_back({.count = type.count, .stride = TypeAt(type.element).size});
      AddSymbol(name + "[]", type.element, offset, inner);
      return;
    }
    case TypeKind::kRecord:
      for (const Member& member : unit_.records[type.record].members) {
        const std::string inner = member.name.empty() ? name : name + "." + member.name;
        if (!member.is_bit_field) {
          AddSymbol(inner, member.type, offset + member.offset, indices);
          continue;
        }
        // A bit-field is one symbol for each bit, the lowest first: what several symbols name is one number.
        for (uint32_t i = 0; i < member.bit_width && !member.name.empty(); ++i) {
          const uint32_t bit = member.bit_offset + i;
          program_.symbols.push_back({.name = inner,
                                      .type = ir::Type::kBit,
                                      .space = data_,
                                      .offset = offset + member.offset + bit / 8,
                                      .bit = static_cast<uint8_t>(bit % 8),
                                      .indices = indices,
                                      .has_sign = TypeAt(member.type).is_signed});
        }
      }
      return;
    default:
      return;
  }
}

void Lowering::AddSymbols() {
  for (uint32_t i = 0; i < objects_.size(); ++i) {
    const Object& object = objects_[ObjectId(i)];
    if (object.kind != ObjectKind::kVariable || object_space_[i] != data_) continue;
    AddSymbol(object.name, unit_.variables[VariableId(object.index)].type, object_begin_[i], {});
  }
}

/// "R[5]", "R_ui[15]", "axes[2].speed": as scenarios name it (4.4).
std::string Lowering::AddressText(ObjectId id, uint32_t offset, ir::Type type) const {
  const Object& object = objects_[id];
  const uint32_t bytes = ir::Bytes(type);
  const auto element = [](std::string_view name, uint32_t number) {
    return std::string(name) + "[" + std::to_string(number) + "]";
  };
  if (object.kind == ObjectKind::kArea) {
    const bool table = object.name == "F" || object.name == "G";
    const bool words = table || object.name == "P" || object.name == "B";
    const uint32_t stride = table ? 2 : bytes;
    if (offset % stride != 0) return NameOfCell(id, offset, type);
    if (bytes == (words ? 2 : 1)) return element(object.name, offset / stride);
    const std::string_view suffix = bytes == 1 ? "_uc" : bytes == 2 ? "_ui" : "_ul";
    return element(object.name + std::string(suffix), offset / stride);
  }
  if (object.kind != ObjectKind::kVariable) return NameOfCell(id, offset, type);
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
    const Member* found = nullptr;
    for (const Member& member : unit_.records[part.record].members) {
      if (found == nullptr && member.offset <= rest && rest < member.offset + TypeAt(member.type).size) found = &member;
    }
    if (found == nullptr) break;
    if (!found->name.empty()) text += "." + found->name;
    rest -= found->offset;
    at = found->type;
  }
  return rest == 0 ? text : NameOfCell(id, offset, type);
}

/// Type, initial value and the comment of a variable.
std::string Lowering::MeaningOf(const Variable& variable) const {
  std::string text = TypeAt(variable.type).text;
  if (variable.initialised && variable.initial.size() == 1 && variable.initial.front().value.valid()) {
    const Expr& value = ExprAt(variable.initial.front().value);
    if (value.constant && IsInteger(TypeAt(value.type))) text += " = " + std::to_string(value.constant->integer);
  }
  if (const Comment* comment = CommentBehind(unit_, sources_, variable.range.end)) {
    text += "; ";
    for (const char c : comment->text) text += c == '\n' || c == '\r' ? ' ' : c;
  }
  return text;
}

/// Register cells that statements name, and all variables, by address.
void Lowering::Document() {
  std::map<std::pair<uint32_t, uint32_t>, ir::Documentation> cells;  // by space and byte
  for (const ir::Place& place : program_.places) {
    const bool memory = !place.is_field() && (place.space.index < area_spaces_.size() || place.space == data_);
    if (!memory || place.address.empty()) continue;  // an indexed place has no address
    ir::Documentation& known = cells[{place.space.index, place.offset}];
    if (!known.address.empty()) continue;
    known.address = place.address;
    known.symbols = place.space == data_ ? place.address : place.name;
  }
  for (uint32_t i = 0; i < objects_.size(); ++i) {
    const Object& object = objects_[ObjectId(i)];
    if (object.kind != ObjectKind::kVariable || object_space_[i] != data_) continue;
    const Variable& variable = unit_.variables[VariableId(object.index)];
    ir::Documentation& known = cells[{data_.index, object_begin_[i]}];
    if (known.address.empty()) known.address = object.name;
    known.symbols = object.name;
    known.meaning = MeaningOf(variable);
  }
  for (auto& [place, known] : cells) program_.documentation.push_back(std::move(known));
}

}  // namespace plcxx::hnc
