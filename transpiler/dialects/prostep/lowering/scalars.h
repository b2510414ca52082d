// The scalars of the scheduler and of the registers: places that the program does not name.
#pragma once

#include <array>

#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

enum class ScalarPlace : uint8_t {
  // space `system`, as long as the machine has power
  kNow,         // time of the last period in ms, simulation only
  kOfSecond,    // t modulo 1000
  kSlowDone,    // complete slow passes
  kSlowRounds,  // what is left of the loop budget of the slow pass that is going on
  kRounds,      // the same of the partition that is running
  kNextSlice,
  // space `registers`, as long as a partition runs
  kS,
  kAx,
  kFirst,  // with --set first-check=dynamic
  kNcValue,
  kPortWord,  // a time or preset that comes from a port
  kCount
};

class Scalars : Context {
 public:
  explicit Scalars(const Context& context) : Context(context) {}

  ir::PlaceId Of(ScalarPlace scalar);
  ir::ValueId Load(ScalarPlace scalar) { return builder_.Load(Of(scalar)); }
  void Store(ScalarPlace scalar, ir::ValueId value) { builder_.Store(Of(scalar), value); }

 private:
  std::array<ir::PlaceId, static_cast<size_t>(ScalarPlace::kCount)> places_;
};

}  // namespace plcxx::prostep
