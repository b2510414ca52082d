// Signal and word expressions.
#pragma once

#include "transpiler/dialects/nc110/lowering/context.h"

namespace plcxx::nc110 {

class LatchedInputs;
class Texts;

class Expressions : Context {
 public:
  Expressions(const Context& context, LatchedInputs& inputs, Texts& texts)
      : Context(context), inputs_(inputs), texts_(texts) {}

  /// Of another type than is wanted it is poison: reported by the parser.
  ir::ValueId Evaluate(ExprId id, ir::Type wanted);

 private:
  ir::ValueId EvaluateExpr(const Expr& expr);
  ir::ValueId Two(ir::OpKind bits, ir::OpKind words, const Expr& expr);
  ir::ValueId Constant(const Expr& expr);

  LatchedInputs& inputs_;
  Texts& texts_;
};

}  // namespace plcxx::nc110
