// Library functions (specification 6.11): arithmetic, and memory with lengths clipped to the objects.
#pragma once

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Accesses;
class Addresses;
class Conversions;
class Expressions;
class Faults;
class Intervals;
class Locals;
class Pointers;

class LibraryCalls : Context {
 public:
  LibraryCalls(const Context& context, Faults& faults, Locals& locals, Intervals& intervals, Conversions& conversions,
               Pointers& pointers, Accesses& accesses, Addresses& addresses, Expressions& expressions)
      : Context(context),
        faults_(faults),
        locals_(locals),
        intervals_(intervals),
        conversions_(conversions),
        pointers_(pointers),
        accesses_(accesses),
        addresses_(addresses),
        expressions_(expressions) {}

  CallResult Call(const Expr& expr);

 private:
  ir::ValueId RoomBehind(const Address& address);
  Address At(const Address& address, ir::ValueId counter);
  CallResult MemoryFunction(const Expr& expr);

  Faults& faults_;
  Locals& locals_;
  Intervals& intervals_;
  Conversions& conversions_;
  Pointers& pointers_;
  Accesses& accesses_;
  Addresses& addresses_;
  Expressions& expressions_;
};

}  // namespace plcxx::hnc
