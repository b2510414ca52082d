// The routines of the subroutines that are called.
#pragma once

#include <map>
#include <vector>

#include "transpiler/dialects/classicladder/lowering/context.h"

namespace plcxx::classicladder {

class Subroutines : Context {
 public:
  explicit Subroutines(const Context& context) : Context(context) {}

  /// Routines for the subroutines that a section's rungs call, and for those that these call.
  void AddCalledBy(const Section& section);
  void Call(const Section& subroutine) { builder_.CallRoutine(routines_.at(subroutine.number), {}); }
  ir::RegionId BodyOf(const Section& subroutine) const {
    return program_.routines[routines_.at(subroutine.number)].body;
  }
  /// In the order of their routines.
  const std::vector<const Section*>& called() const { return called_; }

 private:
  std::map<uint32_t, ir::RoutineId> routines_;  // by section
  std::vector<const Section*> called_;
};

}  // namespace plcxx::classicladder
