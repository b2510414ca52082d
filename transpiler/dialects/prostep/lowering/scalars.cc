#include "transpiler/dialects/prostep/lowering/scalars.h"

#include <string>
#include <string_view>

#include "transpiler/support/check.h"

namespace plcxx::prostep {

using ir::Type;

namespace {

struct ScalarRow {
  ScalarPlace scalar;
  SpaceKey space;
  std::string_view name;
  Type type;
  uint32_t offset;
};
constexpr ScalarRow kScalars[] = {
    {ScalarPlace::kNow, SpaceKey::kSystem, "now", Type::kI32, 0},
    {ScalarPlace::kOfSecond, SpaceKey::kSystem, "ms_of_second", Type::kI32, 4},
    {ScalarPlace::kSlowDone, SpaceKey::kSystem, "slow_done", Type::kI32, 8},
    {ScalarPlace::kSlowRounds, SpaceKey::kSystem, "slow_rounds", Type::kI32, 12},
    {ScalarPlace::kRounds, SpaceKey::kSystem, "rounds_left", Type::kI32, 16},
    {ScalarPlace::kNextSlice, SpaceKey::kSystem, "next_slice", Type::kI8, 20},
    {ScalarPlace::kS, SpaceKey::kRegisters, "s", Type::kBit, 0},
    {ScalarPlace::kAx, SpaceKey::kRegisters, "ax", Type::kI16, 2},
    {ScalarPlace::kFirst, SpaceKey::kRegisters, "first", Type::kBit, 4},
    {ScalarPlace::kNcValue, SpaceKey::kRegisters, "nc_value", Type::kI32, 8},
    {ScalarPlace::kPortWord, SpaceKey::kRegisters, "port_word", Type::kI16, 12},
};

}  // namespace

ir::PlaceId Scalars::Of(ScalarPlace scalar) {
  ir::PlaceId& id = places_[static_cast<size_t>(scalar)];
  if (!id.valid()) {
    const ScalarRow& row = kScalars[static_cast<size_t>(scalar)];
    PLCXX_CHECK(row.scalar == scalar);
    id = program_.places.Add({.name = std::string(row.name),
                              .type = row.type,
                              .space = memory_[row.space],
                              .offset = row.offset,
                              .bit = row.type == Type::kBit ? uint8_t{0} : ir::kNoBit});
  }
  return id;
}

}  // namespace plcxx::prostep
