// What the program keeps of a mechanism between passes: its activation bit, its step, its automatic timers
// (specification 6.7, 7.1).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class CellPlaces;

class MechanismPlaces : Context {
 public:
  MechanismPlaces(const Context& context, CellPlaces& cells) : Context(context), cells_(cells) {}

  /// Of a mechanism, or the NC's of a function module.
  ir::PlaceId Activation(UnitId unit);
  ir::PlaceId Step(UnitId unit);
  ir::PlaceId Timer(UnitId unit, uint32_t number);

 private:
  ir::PlaceId AddWord(std::string name);

  CellPlaces& cells_;
  std::map<uint32_t, ir::PlaceId> steps_, activations_;          // by UnitId
  std::map<std::pair<uint32_t, uint32_t>, ir::PlaceId> timers_;  // by UnitId and number
  std::vector<uint32_t> mechanisms_before_;                      // in the source, by UnitId
  uint32_t bytes_ = 0;                                           // of steps and timers
};

}  // namespace plcxx::technol
