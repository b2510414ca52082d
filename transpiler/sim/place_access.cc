#include "transpiler/sim/place_access.h"

#include <algorithm>

namespace plcxx::sim {

PlaceAccess AccessTo(const ir::Program& program, const ir::Place& place) {
  PlaceAccess access;
  if (place.is_field()) {
    if (place.state.index >= program.states.size()) return access;
    const auto fields = ir::Info(program.states[place.state].kind).fields;
    // An array is the kind's own business; no value holds it.
    if (place.field >= fields.size() || fields[place.field].count != 1) return access;
    access.kind = AccessKind::kField;
    access.owner = place.state.index;
    access.field = place.field;
    return access;
  }
  if (!place.space.valid() || place.space.index >= program.spaces.size()) return access;
  const ir::Space& space = program.spaces[place.space];
  const uint32_t bytes = ir::Bytes(place.type);
  const uint32_t high = place.indexed ? std::min(place.high, space.bytes) : space.bytes;
  const bool fits = place.indexed || (place.offset < high && bytes <= high - place.offset);
  const bool has_bit = place.type != ir::Type::kBit || place.bit < 8;
  if (bytes == 0 || !fits || !has_bit) return access;
  access.kind = place.type == ir::Type::kBit ? AccessKind::kBit : bytes == 1 ? AccessKind::kByte : AccessKind::kWide;
  access.indexed = place.indexed;
  access.big_endian = space.order == ir::ByteOrder::kBig;
  access.bytes = static_cast<uint8_t>(bytes);
  access.bit = place.type == ir::Type::kBit ? place.bit : uint8_t{0};
  access.owner = place.space.index;
  access.offset = place.offset;
  access.stride = place.stride;
  access.low = place.low;
  access.high = high;
  return access;
}

}  // namespace plcxx::sim
