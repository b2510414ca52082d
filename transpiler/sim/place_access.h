// Places made ready for execution: what a load or store has to know, without names, in 32 bytes.
//
// In: ir::Place, also one that is in no program. Out: which bytes of which space, in which order, or which field.
#pragma once

#include <cstdint>

#include "transpiler/ir/program.h"

namespace plcxx::sim {

/// kAbsent: not in memory at all (an offset beyond the space, an instance that is not there): reads 0, writes nothing.
enum class AccessKind : uint8_t { kAbsent, kBit, kByte, kWide, kField };

struct PlaceAccess {
  AccessKind kind = AccessKind::kAbsent;
  bool indexed = false;
  bool big_endian = false;
  uint8_t bytes = 1;    // of kWide
  uint8_t bit = 0;      // of kBit
  uint8_t field = 0;    // of kField
  uint32_t owner = 0;   // index of the space or the instance
  uint32_t offset = 0;  // first byte
  uint32_t stride = 1;  // of an indexed place, which lies in [low, high) or nowhere
  uint32_t low = 0, high = 0;
};

PlaceAccess AccessTo(const ir::Program& program, const ir::Place& place);

/// The bits of each of its bytes that a place in memory is.
inline uint8_t MaskOf(const PlaceAccess& access) {
  return access.kind == AccessKind::kBit ? static_cast<uint8_t>(1U << access.bit) : uint8_t{0xFF};
}

/// Calls visit(space, offset, bit, bit of the value) for each bit of a place in memory that is not indexed.
template <class Visit>
void ForEachBitOf(const ir::Program& program, const ir::Place& place, Visit&& visit) {
  const PlaceAccess access = AccessTo(program, place);
  if (access.kind == AccessKind::kAbsent) return;
  if (access.kind == AccessKind::kBit) return visit(place.space, access.offset, access.bit, 0U);
  for (uint32_t i = 0; i < access.bytes; ++i) {
    const uint32_t significance = access.big_endian ? access.bytes - 1 - i : i;
    for (uint8_t bit = 0; bit < 8; ++bit) visit(place.space, access.offset + i, bit, 8 * significance + bit);
  }
}

/// The offset of the element `index` (read as signed) of an indexed place; false: it is not wholly inside the bounds.
inline bool ElementOffset(const PlaceAccess& access, uint64_t index, uint32_t& offset) {
  const int64_t at = int64_t{access.offset} + int64_t{static_cast<int32_t>(index)} * int64_t{access.stride};
  if (at < int64_t{access.low} || at + access.bytes > int64_t{access.high}) return false;
  offset = static_cast<uint32_t>(at);
  return true;
}

}  // namespace plcxx::sim
