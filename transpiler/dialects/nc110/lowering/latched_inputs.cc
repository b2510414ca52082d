#include "transpiler/dialects/nc110/lowering/latched_inputs.h"

#include <utility>

#include "transpiler/dialects/nc110/lowering/cells.h"

namespace plcxx::nc110 {

bool LatchedInputs::HasCopy(const Operand& operand) const {
  return settings_.latch_slow_inputs && sliced() && IsMemory(operand) &&
         DirectionOf(operand.package, operand.number, settings_.processes) == ir::Direction::kInput;
}

ir::PlaceId LatchedInputs::CopyOf(const Operand& spelled) {
  const Operand operand = cells_.AsNamed(spelled);
  const auto [found, is_new] = latched_.try_emplace(KeyOf(operand));
  if (is_new) {
    ir::Place place = program_.places[cells_.PlaceOf(operand)];
    place.name += "_latched";
    place.address = ToText(operand);
    place.space = SpaceOf(SpaceIndex::kLatched);
    place.offset += PackageBase(operand.package);
    found->second = program_.places.Add(std::move(place));
    order_.push_back(operand);
  }
  return found->second;
}

void LatchedInputs::Latch() {
  for (const Operand& operand : order_) {
    builder_.Store(latched_.at(KeyOf(operand)), builder_.Load(cells_.PlaceOf(operand)));
  }
}

ir::PlaceId LatchedInputs::ReadPlaceOf(const Operand& operand) {
  return part_ == Part::kSlow && HasCopy(operand) ? CopyOf(operand) : cells_.PlaceOf(operand);
}

}  // namespace plcxx::nc110
