#include "transpiler/dialects/nc110/lowering/system_places.h"

#include <string>
#include <string_view>

namespace plcxx::nc110 {
namespace {

struct SystemRow {
  SystemPlace place;
  std::string_view name;
  ir::Type type;
  uint32_t offset;
  uint8_t bit;
};
constexpr SystemRow kSystem[] = {
    {SystemPlace::kNow, "now", ir::Type::kI32, 0, ir::kNoBit},
    {SystemPlace::kSlowCycle, "slow_cycle", ir::Type::kI32, 4, ir::kNoBit},
    {SystemPlace::kSlowDone, "slow_done", ir::Type::kI32, 8, ir::kNoBit},
    {SystemPlace::kFastCount, "fast_count", ir::Type::kI32, 12, ir::kNoBit},
    {SystemPlace::kSlice, "next_slice", ir::Type::kI8, 16, ir::kNoBit},
    {SystemPlace::kSlowOpen, "slow_open", ir::Type::kI8, 17, ir::kNoBit},
    {SystemPlace::kPowerWas, "u10k0_was", ir::Type::kBit, 18, 0},
    {SystemPlace::kSaveWas, "u10n4_was", ir::Type::kBit, 18, 1},
};

}  // namespace

ir::PlaceId SystemPlaces::Of(SystemPlace place) {
  ir::PlaceId& id = ids_[static_cast<size_t>(place)];
  if (!id.valid()) {
    const SystemRow& row = kSystem[static_cast<size_t>(place)];
    PLCXX_CHECK(row.place == place);
    id = program_.places.Add({.name = std::string(row.name),
                              .type = row.type,
                              .space = SpaceOf(SpaceIndex::kSystem),
                              .offset = row.offset,
                              .bit = row.bit});
  }
  return id;
}

}  // namespace plcxx::nc110
