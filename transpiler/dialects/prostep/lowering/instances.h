// The timers and counters that a program uses, with the places of what can be read of them (specification 7).
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <unordered_map>

#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class Instances : Context {
 public:
  explicit Instances(const Context& context) : Context(context) {}

  ir::StateId Timer(uint32_t number);
  ir::StateId Counter(uint32_t number);
  ir::PlaceId OutputOf(uint32_t timer);
  ir::PlaceId ValueOf(uint32_t counter);
  /// A bit of an instance that has no name in the language.
  ir::PlaceId FieldOf(ir::StateId state, std::string_view field, std::string name);
  /// By number; none: the program does not use it.
  const std::array<ir::StateId, kTimers>& timers() const { return timers_; }
  const std::array<ir::StateId, kCounters>& counters() const { return counters_; }

 private:
  std::array<ir::StateId, kTimers> timers_;
  std::array<ir::StateId, kCounters> counters_;
  std::array<ir::PlaceId, kTimers> outputs_;
  std::array<ir::PlaceId, kCounters> values_;
  std::unordered_map<std::string, ir::PlaceId> fields_;  // by name
};

}  // namespace plcxx::prostep
