// Places that no address of the language names: of the schedule, of jumps and slices.
#pragma once

#include <string>

#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class OwnPlaces : Context {
 public:
  explicit OwnPlaces(const Context& context) : Context(context) {}

  /// Keeps its value from tick to tick.
  ir::PlaceId System(std::string name, ir::Type type);
  /// A number that a routine uses while it runs.
  ir::PlaceId Local(std::string name);
};

}  // namespace plcxx::host50
