// Lvalues, pointers and structures of the tree (specification 5.3, 6.5): which object, which byte of it.
#pragma once

#include <optional>

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Accesses;
class Calls;
class Conversions;
class Expressions;
class Intervals;
class Locals;
class Pointers;
class Records;

class Addresses : Context {
 public:
  Addresses(const Context& context, Locals& locals, Intervals& intervals, Conversions& conversions, Pointers& pointers,
            Accesses& accesses, Records& records, Expressions& expressions, Calls& calls)
      : Context(context),
        locals_(locals),
        intervals_(intervals),
        conversions_(conversions),
        pointers_(pointers),
        accesses_(accesses),
        records_(records),
        expressions_(expressions),
        calls_(calls) {}

  Lvalue EvaluateLvalue(ExprId id);
  Address EvaluatePointer(ExprId id);
  Value ComparePointers(const Expr& expr);
  Value PointerDifference(const Expr& expr);
  /// The address of a record value.
  Address RecordAddress(ExprId id);

 private:
  bool IsPointerToPointer(const Expr& expr) const;
  Address RefusedPointer(const Expr& expr, std::string_view why);
  Address TableElement(const Expr& load);
  std::optional<Address> LoadedPointer(const Expr& load);
  Address MovedPointer(const Expr& expr);
  Address ConditionalAddress(const Expr& expr, Address (Addresses::*evaluate)(ExprId));

  Locals& locals_;
  Intervals& intervals_;
  Conversions& conversions_;
  Pointers& pointers_;
  Accesses& accesses_;
  Records& records_;
  Expressions& expressions_;
  Calls& calls_;
};

}  // namespace plcxx::hnc
