// Compare and operate boxes.
#pragma once

#include "transpiler/dialects/classicladder/lowering/accesses.h"
#include "transpiler/dialects/classicladder/lowering/faults.h"
#include "transpiler/dialects/classicladder/lowering/logic.h"

namespace plcxx::classicladder {

class Expressions : Context {
 public:
  Expressions(const Context& context, Faults& faults, Accesses& accesses)
      : Context(context), faults_(faults), accesses_(accesses) {}

  /// The engine evaluates it whatever comes from the left, which a fault shows.
  Signal Compare(uint32_t number);
  void Operate(uint32_t number);

 private:
  ir::ValueId Evaluate(const Expression& expression, uint32_t node);
  ir::ValueId Divide(ir::OpKind op, ir::ValueId dividend, ir::ValueId divisor);
  ir::ValueId Power(ir::ValueId base, ir::ValueId exponent);

  Faults& faults_;
  Accesses& accesses_;
};

}  // namespace plcxx::classicladder
