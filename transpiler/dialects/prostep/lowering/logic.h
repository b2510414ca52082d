// Sequences of logic operations with their brackets and OR strings, evaluated while lowering (specification 5.3, 6.1).
#pragma once

#include <optional>
#include <vector>

#include "transpiler/dialects/common/logic_stack.h"
#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class Registers;

class Logic : Context {
 public:
  Logic(const Context& context, Registers& registers) : Context(context), registers_(registers) {}

  /// After the registers have begun.
  void BeginModule();
  /// As 5.3 and 6.1.2: whether the operation is the first is decided by the text, or at run time.
  void Operate(dialects::Join join, ir::ValueId operand);
  void BeginString();
  /// Joins the strings that wait.
  void Fold();
  void Open(dialects::Join join);
  void Close();
  /// What the sequence has computed, or S as it was left.
  ir::ValueId Value() { return stack_->Value(); }
  /// The value of an instruction replaces it.
  void Replace(ir::ValueId value) { stack_->Replace(value); }
  /// The same of a comparison, which is an operation of a sequence.
  void Compare(ir::ValueId value);
  void EndSequence();
  /// What the next operation is: 1 the first one.
  void Decided(uint64_t first);

 private:
  Registers& registers_;
  std::optional<dialects::LogicStack> stack_;
  std::vector<dialects::Join> brackets_;
};

}  // namespace plcxx::prostep
