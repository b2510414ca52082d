// Sizes and offsets that follow from the kinds and places alone, whatever a program does with them.

#include <algorithm>

#include "transpiler/emit/layout/layout.h"
#include "transpiler/support/check.h"

namespace plcxx::emit::layout {
bool IsWord(Storage storage) { return storage >= Storage::kWord16 && storage <= Storage::kFloat64; }

const WordMember& WordMemberOf(Storage storage) {
  static constexpr WordMember kMembers[] = {{"word16", ir::Type::kI16},
                                            {"word32", ir::Type::kI32},
                                            {"word64", ir::Type::kI64},
                                            {"float32", ir::Type::kF32},
                                            {"float64", ir::Type::kF64}};
  PLCXX_CHECK(IsWord(storage));
  return kMembers[static_cast<size_t>(storage) - static_cast<size_t>(Storage::kWord16)];
}

Elements ElementsOf(const ir::Place& place) {
  const int64_t stride = place.stride;
  const int64_t size = ir::Bytes(place.type);
  const int64_t before = int64_t{place.offset} - place.low;  // of the element 0, from `low`
  // From the lowest element that does not begin before `low`; floor division, whatever the sign.
  const auto floor = [stride](int64_t value) {
    return value >= 0 ? value / stride : -((-value + stride - 1) / stride);
  };
  Elements elements{.lowest = -floor(before)};
  const int64_t first = before + elements.lowest * stride;
  const int64_t room = int64_t{place.high} - place.low - first - size;
  elements.first = static_cast<uint32_t>(first);
  elements.count = room < 0 ? 0 : static_cast<uint32_t>(room / stride + 1);
  if (elements.count == 0) elements.first = 0;  // no byte that is not there
  return elements;
}

uint32_t FieldOffset(ir::StateKind kind, uint8_t field) {
  const auto fields = ir::Info(kind).fields;
  uint32_t offset = 0;
  for (uint8_t i = 0;; ++i) {
    offset = RoundUp(offset, ir::Bytes(fields[i].type));
    if (i == field) return offset;
    offset += ir::Bytes(fields[i].type) * fields[i].count;
  }
}

uint32_t StructAlignment(ir::StateKind kind) {
  uint32_t alignment = 1;
  for (const ir::FieldInfo& field : ir::Info(kind).fields) alignment = std::max(alignment, ir::Bytes(field.type));
  return alignment;
}

uint32_t StructBytes(ir::StateKind kind) {
  const auto fields = ir::Info(kind).fields;
  const auto last = static_cast<uint8_t>(fields.size() - 1);
  return RoundUp(FieldOffset(kind, last) + ir::Bytes(fields[last].type) * fields[last].count, StructAlignment(kind));
}

}  // namespace plcxx::emit::layout
