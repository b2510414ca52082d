// Calls of system functions (specification 6.10), as routines on the image of G or as calls of the host, and
// set_mst_func.
#pragma once

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Conversions;
class Expressions;
class Faults;
class Handlers;
class HostCalls;
class Intervals;
class LibraryCalls;
class Locals;
class StatedFacts;
class SystemRoutines;

class SystemCalls : Context {
 public:
  SystemCalls(const Context& context, StatedFacts& stated, HostCalls& host_calls, Faults& faults, Locals& locals,
              Intervals& intervals, Conversions& conversions, Expressions& expressions, SystemRoutines& system_routines,
              LibraryCalls& library, Handlers& handlers)
      : Context(context),
        stated_(stated),
        host_calls_(host_calls),
        faults_(faults),
        locals_(locals),
        intervals_(intervals),
        conversions_(conversions),
        expressions_(expressions),
        system_routines_(system_routines),
        library_(library),
        handlers_(handlers) {}

  CallResult Call(const Expr& expr);

 private:
  ir::ValueId NumberIsOutside(const Value& number, uint32_t count, const Expr& call, size_t argument, bool& bad);

  StatedFacts& stated_;
  HostCalls& host_calls_;
  Faults& faults_;
  Locals& locals_;
  Intervals& intervals_;
  Conversions& conversions_;
  Expressions& expressions_;
  SystemRoutines& system_routines_;
  LibraryCalls& library_;
  Handlers& handlers_;
};

}  // namespace plcxx::hnc
