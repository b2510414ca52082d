#include "transpiler/ir/zones.h"

#include <algorithm>
#include <iterator>

namespace plcxx::ir {

uint8_t BitsOfZone(const Zone& zone, uint32_t offset) {
  const uint64_t first = uint64_t{8} * offset;
  const uint64_t begin = std::max<uint64_t>(zone.begin, first), end = std::min<uint64_t>(zone.end, first + 8);
  if (begin >= end) return 0;
  return static_cast<uint8_t>((0xFFU << (begin - first)) & (0xFFU >> (first + 8 - end)));
}

Direction DirectionOf(const Space& space, uint32_t offset, uint8_t bit) {
  for (const Zone& zone : space.zones) {
    if ((BitsOfZone(zone, offset) >> bit & 1) != 0) return zone.direction;
  }
  return Direction::kInternal;
}

uint8_t BitsOf(const Space& space, uint32_t offset, Direction direction) {
  uint8_t bits = 0, earlier = 0;
  for (const Zone& zone : space.zones) {
    const uint8_t own = BitsOfZone(zone, offset);
    if (zone.direction == direction) bits = static_cast<uint8_t>(bits | (own & ~earlier));
    earlier = static_cast<uint8_t>(earlier | own);
  }
  return bits;
}

uint8_t BitsInZones(const Space& space, uint32_t offset, Direction direction) {
  uint8_t bits = 0;
  for (const Zone& zone : space.zones) {
    if (zone.direction == direction) bits = static_cast<uint8_t>(bits | BitsOfZone(zone, offset));
  }
  return bits;
}

bool IsConstant(const Space& space, uint32_t offset) {
  const auto behind = std::ranges::upper_bound(space.constants, offset, {}, &ByteRange::begin);
  return behind != space.constants.begin() && offset < std::prev(behind)->end;
}

}  // namespace plcxx::ir
