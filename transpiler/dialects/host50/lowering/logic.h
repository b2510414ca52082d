// Bits: what is known while lowering is not computed by the program.
#pragma once

#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class Logic : Context {
 public:
  explicit Logic(const Context& context) : Context(context) {}

  ir::ValueId And(ir::ValueId a, ir::ValueId b);
  ir::ValueId Or(ir::ValueId a, ir::ValueId b);
  ir::ValueId Not(ir::ValueId a);
  bool IsConstant(ir::ValueId value, uint64_t constant) const;
};

}  // namespace plcxx::host50
