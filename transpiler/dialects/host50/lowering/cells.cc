#include "transpiler/dialects/host50/lowering/cells.h"

#include "transpiler/dialects/host50/lowering/names.h"

namespace plcxx::host50 {

ir::PlaceId Cells::PlaceOf(const Address& address) {
  const auto [found, is_new] = places_.try_emplace(KeyOf(address));
  if (!is_new) return found->second;
  used_.push_back(address);
  ir::Place place;
  if (const auto field = FieldOf(address)) {
    place.type = field->type;
    place.state = InstanceOf(address);
    place.field = field->field;
  } else {
    place = MemoryPlace(address);
  }
  place.name = names_.InCode(address);
  if (place.name != NameOf(address)) place.address = NameOf(address);
  const ir::PlaceId id = program_.places.Add(std::move(place));
  places_[KeyOf(address)] = id;
  return id;
}

void Cells::Store(const Address& address, ir::ValueId value) {
  if (address.area == Area::kQ && address.number >= kFirstAlarm && address.number < kFirstAlarm + kAlarmCount) {
    driven_alarms_.set(address.number - kFirstAlarm);
  }
  builder_.Store(PlaceOf(address), value);
}

ir::StateId Cells::InstanceOf(const Address& timer_or_counter) {
  const Address address = WithoutAttribute(timer_or_counter);
  const auto [found, is_new] = instances_.try_emplace(KeyOf(address));
  if (is_new) {
    used_.push_back(address);
    const auto field = FieldOf(address);
    PLCXX_CHECK(field.has_value());
    found->second = program_.states.Add({.kind = field->kind, .name = names_.InCode(address)});
  }
  return found->second;
}

}  // namespace plcxx::host50
