#include "transpiler/dialects/prostep/lowering/locals.h"

#include <utility>

namespace plcxx::prostep {

using ir::Type;

namespace {

constexpr uint32_t kFirstParameter = 16;  // byte of the registers where parameters and locals of routines begin

}  // namespace

ir::PlaceId Locals::Add(std::string name, Type type) {
  const uint32_t offset = kFirstParameter + 4 * count_++;
  return program_.places.Add({.name = std::move(name),
                              .type = type,
                              .space = memory_[SpaceKey::kRegisters],
                              .offset = offset,
                              .bit = type == Type::kBit ? uint8_t{0} : ir::kNoBit});
}

ir::PlaceId Locals::AddParameter(ir::RoutineId routine, std::string name, Type type) {
  const ir::PlaceId place = Add(name, type);
  program_.routines[routine].parameters.push_back({.name = std::move(name), .type = type, .enumerators = {}});
  program_.routines[routine].parameter_places.push_back(place);
  return place;
}

}  // namespace plcxx::prostep
