// Operators on numbers (specification 6.2), with what is known of the bounds of their results.
#pragma once

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Conversions;
class Faults;
class StatedFacts;

class Operators : Context {
 public:
  Operators(const Context& context, StatedFacts& stated, Faults& faults, Conversions& conversions)
      : Context(context), stated_(stated), faults_(faults), conversions_(conversions) {}

  Value BinaryReal(BinaryOp op, const Value& left, const Value& right);
  Value BinaryInteger(BinaryOp op, const Value& left, const Value& right, const Expr& at);
  Value Binary(BinaryOp op, const Value& a, const Value& b, const Expr& at);
  Value Unary(UnaryOp op, const Value& a);
  Value SelectValue(ir::ValueId condition, const Value& a, const Value& b, TypeId type);

 private:
  Value Compare(BinaryOp op, const Value& a, const Value& b);
  Value Divide(BinaryOp op, const Value& a, const Value& b, const Expr& at);
  Value Shift(BinaryOp op, const Value& a, const Value& b, const Expr& at);
  Value AsMask(const Value& value);

  StatedFacts& stated_;
  Faults& faults_;
  Conversions& conversions_;
};

}  // namespace plcxx::hnc
