// Expressions: operands in the order of 6.2, effects where they stand, short circuits as branches only where the right
// side does more than compute.
#pragma once

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Accesses;
class Addresses;
class Calls;
class Conversions;
class Intervals;
class Locals;
class Operators;
class Pointers;
class StatedFacts;

class Expressions : Context {
 public:
  Expressions(const Context& context, StatedFacts& stated, Locals& locals, Intervals& intervals,
              Conversions& conversions, Operators& operators, Pointers& pointers, Accesses& accesses,
              Addresses& addresses, Calls& calls)
      : Context(context),
        stated_(stated),
        locals_(locals),
        intervals_(intervals),
        conversions_(conversions),
        operators_(operators),
        pointers_(pointers),
        accesses_(accesses),
        addresses_(addresses),
        calls_(calls) {}

  Value Evaluate(ExprId id);
  /// For its effects only.
  void Execute(ExprId id);
  ir::ValueId Condition(ExprId id);
  /// How the source spells a constant: 10 or 16.
  uint32_t BaseOf(const Expr& constant) const;

 private:
  Value EvaluateLeaf(ExprId id);
  ir::ValueId Logical(ExprId id);
  Value Conditional(const Expr& expr);
  Value Assign(ExprId id);
  Value CompoundAssign(ExprId id);
  Value Increment(ExprId id);

  StatedFacts& stated_;
  Locals& locals_;
  Intervals& intervals_;
  Conversions& conversions_;
  Operators& operators_;
  Pointers& pointers_;
  Accesses& accesses_;
  Addresses& addresses_;
  Calls& calls_;
};

}  // namespace plcxx::hnc
