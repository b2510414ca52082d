// Names of the program's data for scenarios and reports: every element and member, whether or not a statement names it.

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
        } else if (!member.name.empty() && member.bit_width == 1) {
          program_.symbols.push_back({.name = inner,
                                      .type = ir::Type::kBit,
                                      .space = data_,
                                      .offset = offset + member.offset + member.bit_offset / 8,
                                      .bit = static_cast<uint8_t>(member.bit_offset % 8),
                                      .indices = indices,
                                      .has_sign = false});
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

void Lowering::Document() {
  for (const ir::Place& place : program_.places) {
    if (place.is_field() || place.address.empty() || place.address == place.name) continue;
    const bool area = place.space.index < area_spaces_.size();
    if (!area) continue;
    program_.documentation.push_back(
        {.address = place.address, .symbols = place.name, .predefined = {}, .meaning = {}, .help = {}});
  }
}

}  // namespace plcxx::hnc
