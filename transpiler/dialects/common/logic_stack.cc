#include "transpiler/dialects/common/logic_stack.h"

namespace plcxx::dialects {

using ir::OpKind;
using ir::ValueId;

ValueId Joined(ir::Builder& builder, Join join, ValueId left, ValueId right) {
  switch (join) {
    case Join::kAnd:
      return builder.Pure(OpKind::kBitAnd, {left, right});
    case Join::kOr:
      return builder.Pure(OpKind::kBitOr, {left, right});
    case Join::kXor:
      return builder.Pure(OpKind::kBitXor, {left, right});
  }
  PLCXX_UNREACHABLE();
}

ValueId Inverted(ir::Builder& builder, ValueId value) { return builder.Pure(OpKind::kBitNot, {value}); }

ValueId LogicStack::Value() {
  if (depth() == 0) return status_.Get();
  PLCXX_CHECK(top().value.valid());
  return top().value;
}

void LogicStack::SetValue(ValueId value) {
  if (depth() == 0) {
    status_.Set(value);
  } else {
    top().value = value;
  }
  top().first = false;
  top().empty_string = false;
}

void LogicStack::Operate(Join join, ValueId operand) {
  if (join == Join::kOr) JoinAlternatives();
  SetValue(top().first ? operand : Joined(builder_, join, Value(), operand));
}

/// first ? operand : status AND operand = operand AND (status OR first); OR accordingly: no branch.
void LogicStack::OperateUnless(ValueId is_first, Join join, ValueId operand) {
  PLCXX_CHECK(depth() == 0 && !has_alternative());
  const bool is_and = join == Join::kAnd;
  const ValueId other = is_and ? is_first : Inverted(builder_, is_first);
  const ValueId before = Joined(builder_, is_and ? Join::kOr : Join::kAnd, Value(), other);
  SetValue(Joined(builder_, join, before, operand));
}

void LogicStack::Replace(ValueId value) {
  top().alternative = {};
  SetValue(value);
}

void LogicStack::BeginAlternative() {
  JoinAlternatives();
  BeginAlternative(top().first ? builder_.Bit(0) : Value());
}

void LogicStack::BeginAlternative(ValueId before) {
  top().alternative = before;
  top().first = true;
  top().empty_string = true;
}

bool LogicStack::JoinAlternatives() {
  if (!has_alternative()) return false;
  const ValueId alternative = top().alternative;
  top().alternative = {};
  SetValue(top().empty_string ? alternative : Joined(builder_, Join::kOr, alternative, Value()));
  return true;
}

void LogicStack::Push() { levels_.emplace_back(); }

ValueId LogicStack::Pop() {
  JoinAlternatives();
  const ValueId value = Value();
  PLCXX_CHECK(depth() > 0);
  levels_.pop_back();
  return value;
}

void LogicStack::Pop(Join join) { Operate(join, Pop()); }

}  // namespace plcxx::dialects
