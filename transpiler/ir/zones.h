// Whose a bit of memory is: zones are ranges of bits, bit 0 of byte 0 first.
#pragma once

#include <cstdint>

#include "transpiler/ir/memory.h"

namespace plcxx::ir {

/// Of whole bytes.
constexpr Zone ZoneOfBytes(uint32_t begin, uint32_t end, Direction direction) {
  return {.begin = 8 * begin, .end = 8 * end, .direction = direction};
}
/// Whether it can be said in bytes.
constexpr bool IsOfBytes(const Zone& zone) { return zone.begin % 8 == 0 && zone.end % 8 == 0; }
/// The bits of a byte that a zone has.
uint8_t BitsOfZone(const Zone& zone, uint32_t offset);
/// Of several zones that have the bit the first one says whose it is; what is in no zone is internal.
Direction DirectionOf(const Space& space, uint32_t offset, uint8_t bit);
/// The bits of a byte whose direction is this one; bits in no zone are not among them.
uint8_t BitsOf(const Space& space, uint32_t offset, Direction direction);
/// The bits of a byte that any zone of this direction has, the first one or not.
uint8_t BitsInZones(const Space& space, uint32_t offset, Direction direction);

/// Whether a byte is of a constant table.
bool IsConstant(const Space& space, uint32_t offset);

}  // namespace plcxx::ir
