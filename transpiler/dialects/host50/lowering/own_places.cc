#include "transpiler/dialects/host50/lowering/own_places.h"

#include <utility>

namespace plcxx::host50 {

ir::PlaceId OwnPlaces::System(std::string name, ir::Type type) {
  ir::Space& space = program_.spaces[SystemSpace()];
  ir::Place place{.name = std::move(name), .type = type, .space = SystemSpace(), .offset = space.bytes};
  if (type == ir::Type::kBit) place.bit = 0;
  space.bytes += ir::Bytes(type);
  return program_.places.Add(std::move(place));
}

ir::PlaceId OwnPlaces::Local(std::string name) {
  ir::Space& space = program_.spaces[RoutineSpace()];
  const ir::Place place{
      .name = std::move(name), .type = ir::Type::kI32, .space = RoutineSpace(), .offset = space.bytes};
  space.bytes += ir::Bytes(place.type);
  return program_.places.Add(place);
}

}  // namespace plcxx::host50
