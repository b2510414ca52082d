#include "transpiler/dialects/classicladder/lowering/places.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace plcxx::classicladder {

ir::PlaceId Places::Named(std::string name, ir::Place place) {
  const auto [found, is_new] = places_.try_emplace(name);
  if (is_new) {
    place.name = std::move(name);
    found->second = program_.places.Add(std::move(place));
  }
  return found->second;
}

ir::PlaceId Places::Of(const Address& address) {
  const VariableInfo& info = Info(address.kind);
  used_.insert(KeyOf(address));
  ir::Place place = PlaceAt(info.group, info.part, IndexOf(address, tree_.sizes));
  std::string name = names_.Of(address);
  if (name != NameOf(address)) place.address = NameOf(address);
  return Named(std::move(name), std::move(place));
}

ir::PlaceId Places::FieldOf(Group group, Part part, uint32_t number) {
  for (const VariableInfo& info : Variables()) {
    if (info.group == group && info.part == part) return Of({info.kind, number});
  }
  PLCXX_UNREACHABLE();
}

ir::PlaceId Places::HiddenOf(Group group, Hidden part, uint32_t number) {
  constexpr std::string_view kNames[] = {"base", "input_was", "before", "up_was", "down_was", "part_ms", "started"};
  const auto shown = std::ranges::find(Variables(), group, &VariableInfo::group);  // all of a group have its name
  std::string name = NameOf({shown->kind, number});
  name = name.substr(0, name.find('.')) + "." + std::string(kNames[static_cast<size_t>(part)]);
  return Named(std::move(name), HiddenPlace(group, part, number));
}

ir::PlaceId Places::New(std::string name, ir::Type type, ir::SpaceId space_id) {
  ir::Space& space = program_.spaces[space_id];
  ir::Place place{.name = std::move(name), .type = type, .space = space_id, .offset = space.bytes};
  if (type == ir::Type::kBit) place.bit = 0;
  space.bytes += ir::Bytes(ir::Type::kI32);
  return program_.places.Add(std::move(place));
}

ir::PlaceId Places::ActiveOf(uint32_t step) {
  return Named("step" + std::to_string(step) + "_active", StepActive(step));
}

}  // namespace plcxx::classicladder
