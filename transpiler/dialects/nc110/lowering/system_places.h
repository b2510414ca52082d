// The scheduler's own memory, in space `system`; a place is there when it was asked for.
#pragma once

#include <array>

#include "transpiler/dialects/nc110/lowering/context.h"

namespace plcxx::nc110 {

enum class SystemPlace : uint8_t {
  kNow,
  kSlowCycle,
  kSlowDone,
  kFastCount,
  kSlice,
  kSlowOpen,
  kPowerWas,  // U10K0 at the end of the last period
  kSaveWas,   // U10N4
  kCount
};

class SystemPlaces : Context {
 public:
  explicit SystemPlaces(const Context& context) : Context(context) {}

  ir::PlaceId Of(SystemPlace place);
  bool IsUsed(SystemPlace place) const { return ids_[static_cast<size_t>(place)].valid(); }
  ir::ValueId Load(SystemPlace place) { return builder_.Load(Of(place)); }
  void Store(SystemPlace place, ir::ValueId value) { builder_.Store(Of(place), value); }

 private:
  std::array<ir::PlaceId, static_cast<size_t>(SystemPlace::kCount)> ids_;
};

}  // namespace plcxx::nc110
