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

/// The offset of the element `index` (read as signed) of an indexed place; false: it is not wholly inside the bounds.
inline bool ElementOffset(const PlaceAccess& access, uint64_t index, uint32_t& offset) {
  const int64_t at = int64_t{access.offset} + int64_t{static_cast<int32_t>(index)} * int64_t{access.stride};
  if (at < int64_t{access.low} || at + access.bytes > int64_t{access.high}) return false;
  offset = static_cast<uint32_t>(at);
  return true;
}

}  // namespace plcxx::sim
