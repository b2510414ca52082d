// The routines: power-on, the two parts, the period with and without the slow part.
#pragma once

#include "transpiler/dialects/nc110/lowering/context.h"

namespace plcxx::nc110 {

class Routines : Context {
 public:
  explicit Routines(const Context& context) : Context(context) {}

  void Add();
  ir::RoutineId init() const { return init_; }
  ir::RoutineId fast() const { return fast_; }
  ir::RoutineId slow() const { return slow_; }
  ir::RoutineId period() const { return period_; }
  ir::RoutineId fast_only() const { return fast_only_; }

 private:
  ir::RoutineId init_, fast_, slow_, period_, fast_only_;
};

}  // namespace plcxx::nc110
