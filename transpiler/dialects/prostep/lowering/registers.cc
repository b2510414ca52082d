#include "transpiler/dialects/prostep/lowering/registers.h"

#include "transpiler/dialects/prostep/lowering/scalars.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::ValueId;

void Registers::BeginModule() {
  s_.emplace(builder_, scalars_.Of(ScalarPlace::kS), facts_);
  ax_.emplace(builder_, scalars_.Of(ScalarPlace::kAx), facts_);
  first_.reset();
  if (settings_.first_check == FirstCheck::kDynamic) {
    first_.emplace(builder_, scalars_.Of(ScalarPlace::kFirst), facts_);
  }
}

void Registers::Spill() {
  s_->Spill();
  ax_->Spill();
  if (first_) first_->Spill();
}

void Registers::Forget() {
  s_->Forget();
  ax_->Forget();
  if (first_) first_->Forget();
}

void Registers::EndStatement() {
  s_->EndStatement();
  ax_->EndStatement();
  if (first_) first_->EndStatement();
}

ValueId Registers::LowByte() {
  const ValueId word = ax_->Get();
  const ir::Inst& inst = program_[word];
  if (inst.op == OpKind::kWiden8To16) return ValueId(inst.a);
  if (inst.op == OpKind::kWithLowByte16) return ValueId(inst.b);
  if (inst.op == OpKind::kConst) return builder_.Constant(ir::Type::kI8, ir::ConstantValue(inst) & 0xFF, inst.c);
  return Pure(OpKind::kLowByte16, {word});
}

void Registers::SetLowByte(ValueId byte) {
  const auto widened = [&] { ax_->Set(Pure(OpKind::kWiden8To16, {byte})); };
  const std::optional<uint64_t> known = ax_->Known();
  if (known && *known <= 0xFF) return widened();
  ValueId word = ax_->Get();
  const ir::Inst& inst = program_[word];
  if (inst.op == OpKind::kWiden8To16) return widened();
  if (inst.op == OpKind::kWithLowByte16) word = ValueId(inst.a);
  ax_->Set(Pure(OpKind::kWithLowByte16, {word, byte}));
}

}  // namespace plcxx::prostep
