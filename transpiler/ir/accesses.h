// What an instruction itself reads and writes of the program's state, for everybody who asks what depends on what.
#pragma once

#include "transpiler/ir/program.h"

namespace plcxx::ir {

enum class Access : uint8_t { kRead, kWrite, kReadAndWrite };

/// Calls `on_place(PlaceId, Access)` and `on_instance(StateId)`, which is read and written. Regions that the
/// instruction owns, the routine that it calls, and what a host function does beside its second result are not looked
/// at.
template <class OnPlace, class OnInstance>
void ForEachAccess(const Program& program, const Inst& inst, OnPlace&& on_place, OnInstance&& on_instance) {
  const auto budget_of = [&](LoopId loop) {
    if (program.loops[loop].budget.valid()) on_place(program.loops[loop].budget, Access::kReadAndWrite);
  };
  switch (Info(inst.op).shape) {
    case Shape::kLoad:
      on_place(PlaceId(inst.payload), Access::kRead);
      break;
    case Shape::kStore:
      on_place(PlaceId(inst.payload), Access::kWrite);
      break;
    case Shape::kStep:
      on_instance(StateId(inst.payload));
      break;
    case Shape::kText:
      on_instance(StateId(inst.payload));
      on_instance(StateId(inst.a));
      break;
    case Shape::kLoop:
      budget_of(LoopId(inst.payload));
      break;
    case Shape::kRepeat:
      budget_of(LoopId(program[InstId(inst.payload)].payload));
      break;
    case Shape::kHostCall:
      if (const PlaceId out = program.calls[CallId(inst.payload)].out; out.valid()) on_place(out, Access::kWrite);
      break;
    case Shape::kPure:
    case Shape::kConst:
    case Shape::kStatement:
    case Shape::kIf:
    case Shape::kSwitch:
    case Shape::kBlock:
    case Shape::kExit:
    case Shape::kCall:
    case Shape::kJump:
    case Shape::kLabel:
      break;
  }
}

}  // namespace plcxx::ir
