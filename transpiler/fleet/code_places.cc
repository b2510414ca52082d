// Loads and stores as text.

#include "transpiler/fleet/code_writer.h"

namespace plcxx::fleet {
namespace {

bool IsFloat(ir::Type type) { return type == ir::Type::kF32 || type == ir::Type::kF64; }

/// The unsigned type of a value's raw bits.
std::string_view RawName(ir::Type type) {
  if (type == ir::Type::kF32) return ir::CppName(ir::Type::kI32);
  if (type == ir::Type::kF64) return ir::CppName(ir::Type::kI64);
  return ir::CppName(type);
}

std::string Number(uint32_t value) { return std::to_string(value) + "u"; }

}  // namespace

std::string WidthText(ir::Type type) { return std::to_string(8 * ir::Bytes(type)); }

bool PlaceWriter::IsScalar(ir::PlaceId place) const {
  const sim::PlaceAccess access = sim::AccessTo(program_, program_.places[place]);
  return access.kind != sim::AccessKind::kAbsent && access.kind != sim::AccessKind::kField && !access.indexed &&
         layout_.At(access.owner, access.offset).is_scalar();
}

std::string PlaceWriter::StoreScalar(ir::PlaceId place, const std::string& value) const {
  const ir::Type type = program_.places[place].type;
  const sim::PlaceAccess access = sim::AccessTo(program_, program_.places[place]);
  const std::string at = std::to_string(layout_.At(access.owner, access.offset).scalar);
  if (type == ir::Type::kBit)
    return "StoreScalarBit(m, " + at + ", " + std::to_string(access.bit) + ", " + value + ");";
  return "StoreScalar<" + std::string(ir::CppName(type)) + ", " + (access.big_endian ? "true" : "false") + ">(m, " +
         at + ", " + value + ");";
}

bool PlaceWriter::IsPerLane(ir::PlaceId place) const {
  const sim::PlaceAccess access = sim::AccessTo(program_, program_.places[place]);
  if (access.kind == sim::AccessKind::kAbsent || access.kind == sim::AccessKind::kField) return false;
  return access.indexed;
}

std::string PlaceWriter::Bytes(const sim::PlaceAccess& access) const {
  std::string text;
  for (uint32_t i = 0; i < access.bytes; ++i) {
    const ByteHome& home = layout_.At(access.owner, access.offset + (access.big_endian ? access.bytes - 1 - i : i));
    if (i > 0) text += ", ";
    text += "Planes<" + std::to_string(home.planes[0]) + ">";
  }
  return text;
}

std::string PlaceWriter::Element(const sim::PlaceAccess& access) const {
  const bool empty = access.low >= access.high;
  const uint32_t first = empty ? 0 : layout_.At(access.owner, access.low).planes[0];
  return "Element{" + Number(access.offset) + ", " + Number(access.stride) + ", " + Number(access.low) + ", " +
         Number(access.high) + ", " + Number(first) + ", " + (access.big_endian ? "true" : "false") + "}";
}

std::string PlaceWriter::LoadFixed(const sim::PlaceAccess& access, ir::Type type) const {
  if (access.kind == sim::AccessKind::kAbsent)
    return type == ir::Type::kBit ? "Zeros()" : "Bits<" + WidthText(type) + ">{}";
  if (access.kind == sim::AccessKind::kField) {
    const uint32_t first = layout_.fields[access.owner][access.field];
    return type == ir::Type::kBit ? "Plane(m.planes[" + std::to_string(first) + "])"
                                  : "FieldAt<" + WidthText(type) + ">(m, " + std::to_string(first) + ")";
  }
  if (const ByteHome& home = layout_.At(access.owner, access.offset); home.is_scalar()) {
    const std::string at = std::to_string(home.scalar);
    if (type == ir::Type::kBit) return "LoadScalarBit(m, " + at + ", " + std::to_string(access.bit) + ")";
    return "LoadScalar<" + std::string(RawName(type)) + ", " + (access.big_endian ? "true" : "false") + ">(m, " + at +
           ")";
  }
  if (type != ir::Type::kBit) return "LoadBytes<" + Bytes(access) + ">(m)";
  return "Plane(m.planes[" + std::to_string(layout_.At(access.owner, access.offset).planes[access.bit]) + "])";
}

std::string PlaceWriter::Load(ir::PlaceId place, ir::ValueId index, const std::string& mask) const {
  const ir::Place& loaded = program_.places[place];
  const sim::PlaceAccess access = sim::AccessTo(program_, loaded);
  std::string text;
  if (!access.indexed || access.kind == sim::AccessKind::kAbsent) {
    text = LoadFixed(access, loaded.type);
  } else if (loaded.type == ir::Type::kBit) {
    return "LoadElementBit(m, " + Element(access) + ", " + std::to_string(access.bit) + ", AsUniform(" +
           ValueName(index) + "), " + mask + ")";
  } else {
    text = "LoadElement<" + WidthText(loaded.type) + ">(m, " + Element(access) + ", AsUniform(" + ValueName(index) +
           "), " + mask + ")";
  }
  return IsFloat(loaded.type) ? "AsFloat<" + std::string(ir::CppName(loaded.type)) + ">(" + text + ")" : text;
}

std::string PlaceWriter::Store(ir::PlaceId place, ir::ValueId index, const std::string& value,
                               const std::string& mask) const {
  const ir::Place& stored = program_.places[place];
  const sim::PlaceAccess access = sim::AccessTo(program_, stored);
  const std::string end = value + ", " + mask + ");";
  if (access.kind == sim::AccessKind::kAbsent) return "static_cast<void>(" + value + ");";
  if (access.indexed) {
    const std::string start = Element(access) + ", ", at = "AsUniform(" + ValueName(index) + "), ";
    if (stored.type == ir::Type::kBit)
      return "StoreElementBit(m, " + start + std::to_string(access.bit) + ", " + at + end;
    return "StoreElement<" + WidthText(stored.type) + ">(m, " + start + at + end;
  }
  if (access.kind == sim::AccessKind::kField) {
    const std::string first = std::to_string(layout_.fields[access.owner][access.field]);
    return (stored.type == ir::Type::kBit ? "PutPlane(m, " + first
                                          : "PutField<" + WidthText(stored.type) + ">(m, " + first) +
           ", " + end;
  }
  if (stored.type != ir::Type::kBit) return "StoreBytes<" + Bytes(access) + ">(m, " + end;
  return "PutPlane(m, " + std::to_string(layout_.At(access.owner, access.offset).planes[access.bit]) + ", " + end;
}

}  // namespace plcxx::fleet
