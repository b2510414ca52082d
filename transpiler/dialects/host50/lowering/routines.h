// The routines of the program: power-on, the parts, the subroutines, and the tick of the control (4.3).
#pragma once

#include <vector>

#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class OwnPlaces;

class Routines : Context {
 public:
  Routines(const Context& context, OwnPlaces& own_places) : Context(context), own_places_(own_places) {}

  void Add();
  /// None: a section that nobody executes.
  ir::RoutineId Of(SectionId section) const { return of_[section.index]; }
  ir::RoutineId init() const { return init_; }
  ir::RoutineId fast() const { return fast_; }
  ir::RoutineId slow() const { return slow_; }
  ir::RoutineId period() const { return period_; }
  /// SLICES=SLICED: which one is executed.
  ir::PlaceId slice() const { return slice_; }

 private:
  OwnPlaces& own_places_;
  std::vector<ir::RoutineId> of_;  // by SectionId; FAST and SLOW too
  ir::RoutineId init_, fast_, slow_, period_;
  ir::PlaceId slice_;
};

}  // namespace plcxx::host50
