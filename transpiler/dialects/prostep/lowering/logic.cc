#include "transpiler/dialects/prostep/lowering/logic.h"

#include "transpiler/dialects/prostep/lowering/registers.h"

namespace plcxx::prostep {

using dialects::Inverted;
using dialects::Join;
using ir::ValueId;

void Logic::BeginModule() { stack_.emplace(builder_, registers_.s()); }

void Logic::Decided(uint64_t first) {
  if (registers_.first() != nullptr) registers_.first()->Set(builder_.Bit(first));
}

void Logic::Operate(Join join, ValueId operand) {
  // Inside brackets and OR strings the text decides in both readings.
  if (registers_.first() != nullptr && stack_->depth() == 0 && !stack_->has_alternative()) {
    const std::optional<uint64_t> first = registers_.first()->Known();
    if (!first) {
      stack_->OperateUnless(registers_.first()->Get(), join, operand);
      Decided(0);
      return;
    }
    if (*first != 0) {
      stack_->EndSequence();
    } else {
      stack_->ContinueSequence();
    }
  }
  stack_->Operate(join, operand);
  if (stack_->depth() == 0) Decided(0);
}

void Logic::Fold() {
  if (stack_->JoinAlternatives() && stack_->depth() == 0) Decided(0);
}

void Logic::BeginString() {
  Fold();
  if (registers_.first() == nullptr || stack_->depth() > 0) return stack_->BeginAlternative();
  const std::optional<uint64_t> first = registers_.first()->Known();
  if (!first) {
    const ValueId is_first = registers_.first()->Get();
    const ValueId is_continued = Inverted(builder_, is_first);
    const ValueId status = stack_->Value();
    const ValueId before = dialects::Joined(builder_, Join::kAnd, status, is_continued);
    return stack_->BeginAlternative(before);
  }
  stack_->BeginAlternative(*first != 0 ? builder_.Bit(0) : stack_->Value());
}

void Logic::Open(Join join) {
  if (join == Join::kOr) Fold();
  brackets_.push_back(join);
  stack_->Push();
}

void Logic::Close() {
  const Join join = brackets_.back();
  brackets_.pop_back();
  Operate(join, stack_->Pop());
}

void Logic::Compare(ValueId value) {
  stack_->Replace(value);
  if (stack_->depth() == 0) Decided(0);
}

void Logic::EndSequence() {
  stack_->EndSequence();
  Decided(1);
}

}  // namespace plcxx::prostep
