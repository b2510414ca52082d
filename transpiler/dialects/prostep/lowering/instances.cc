#include "transpiler/dialects/prostep/lowering/instances.h"

#include <utility>

namespace plcxx::prostep {

ir::StateId Instances::Timer(uint32_t number) {
  ir::StateId& timer = timers_[number];
  if (!timer.valid()) {
    timer = program_.states.Add({.kind = ir::StateKind::kTimeWordTimer, .name = "T" + std::to_string(number)});
  }
  return timer;
}

ir::StateId Instances::Counter(uint32_t number) {
  ir::StateId& counter = counters_[number];
  if (!counter.valid()) {
    counter = program_.states.Add({.kind = ir::StateKind::kDecadeCounter, .name = "C" + std::to_string(number)});
  }
  return counter;
}

ir::PlaceId Instances::OutputOf(uint32_t timer) {
  ir::PlaceId& output = outputs_[timer];
  if (!output.valid()) {
    const std::string number = std::to_string(timer);
    ir::Place place{.name = "T" + number + "_out", .address = "T " + number, .type = ir::Type::kBit};
    place.state = Timer(timer);
    place.field = ir::FieldIndex(ir::StateKind::kTimeWordTimer, "output");
    output = program_.places.Add(std::move(place));
  }
  return output;
}

ir::PlaceId Instances::ValueOf(uint32_t counter) {
  ir::PlaceId& value = values_[counter];
  if (!value.valid()) {
    const std::string number = std::to_string(counter);
    ir::Place place{.name = "C" + number + "_count", .address = "C " + number, .type = ir::Type::kI16};
    place.state = Counter(counter);
    place.field = ir::FieldIndex(ir::StateKind::kDecadeCounter, "value");
    value = program_.places.Add(std::move(place));
  }
  return value;
}

ir::PlaceId Instances::FieldOf(ir::StateId state, std::string_view field, std::string name) {
  const auto [found, is_new] = fields_.try_emplace(name);
  if (is_new) {
    ir::Place place{.name = std::move(name), .address = {}, .type = ir::Type::kBit};
    place.state = state;
    place.field = ir::FieldIndex(program_.states[state].kind, field);
    found->second = program_.places.Add(std::move(place));
  }
  return found->second;
}

}  // namespace plcxx::prostep
