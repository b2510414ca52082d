#include "transpiler/dialects/technol/lowering/mechanism_places.h"

#include "transpiler/dialects/technol/lowering/cell_places.h"

namespace plcxx::technol {

using ir::Type;

ir::PlaceId MechanismPlaces::AddWord(std::string name) {
  return program_.places.Add({.name = std::move(name),
                              .type = Type::kI16,
                              .space = memory_[SpaceKey::kSteps],
                              .offset = std::exchange(bytes_, bytes_ + 2)});
}

ir::PlaceId MechanismPlaces::Step(UnitId unit) {
  const auto [found, is_new] = steps_.try_emplace(unit.index);
  if (is_new) found->second = AddWord(tree_.units[unit].name + "_step");
  return found->second;
}

ir::PlaceId MechanismPlaces::Timer(UnitId unit, uint32_t number) {
  const auto [found, is_new] = timers_.try_emplace(std::pair(unit.index, number));
  if (is_new) {
    found->second = AddWord(tree_.units[unit].name + "_timer" + (number == 0 ? "" : std::to_string(number + 1)));
  }
  return found->second;
}

ir::PlaceId MechanismPlaces::Activation(UnitId unit) {
  const Unit& mechanism = tree_.units[unit];
  if (mechanism.kind == UnitKind::kModule) {
    return cells_.System(mechanism.module == ModuleKind::kPripravne ? "NC_PRIPRAVNE" : "NC_ZAVERECNE");
  }
  const auto [found, is_new] = activations_.try_emplace(unit.index);
  if (is_new) {
    if (mechanisms_before_.empty()) {
      uint32_t number = 0;
      for (uint32_t i = 0; i < tree_.units.size(); ++i) {
        mechanisms_before_.push_back(number);
        if (tree_.units[UnitId(i)].kind == UnitKind::kMechanism) ++number;
      }
    }
    found->second = program_.places.Add({.name = mechanism.name,
                                         .type = Type::kBit,
                                         .space = memory_[SpaceKey::kMechanisms],
                                         .offset = mechanisms_before_[unit.index],
                                         .bit = 0});
  }
  return found->second;
}

}  // namespace plcxx::technol
