// Numbers: constants, conversions, comparisons, COMP and OPRT (6.4 to 6.6).
#pragma once

#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class Cells;

class Numbers : Context {
 public:
  Numbers(const Context& context, Cells& cells) : Context(context), cells_(cells) {}

  /// An operand's value, converted to the type that is wanted.
  ir::ValueId Of(const Operand& operand, Type wanted);
  ir::ValueId Evaluate(ExprId id, Type wanted);
  /// The relation of a compare block or of COMP, without the block's input.
  ir::ValueId Comparison(const Instruction& instruction);

 private:
  ir::ValueId Constant(uint32_t bits, Type type, Type wanted, source::Range spelled);
  ir::ValueId Convert(ir::ValueId value, Type from, Type to);
  ir::ValueId EvaluateExpr(const Expr& expr);

  Cells& cells_;
};

}  // namespace plcxx::host50
