#include "transpiler/dialects/common/register.h"

namespace plcxx::dialects {

void Register::CheckKnown() {
  if (!facts_.on() || !known_ || value_.valid() || !in_place_) return;
  const ir::Type type = builder_.program().places[place_].type;
  const ir::OpKind equal = type == ir::Type::kI8    ? ir::OpKind::kEqual8
                           : type == ir::Type::kI16 ? ir::OpKind::kEqual16
                                                    : ir::OpKind::kEqual32;
  const ir::ValueId kept = builder_.Load(place_);
  ir::ValueId holds = kept;
  if (type != ir::Type::kBit) {
    holds = builder_.Pure(equal, {kept, builder_.Constant(type, *known_)});
  } else if (*known_ == 0) {
    holds = builder_.Pure(ir::OpKind::kBitNot, {kept});
  }
  facts_.Check(ir::FactKind::kRegister, holds, kept);
}

std::optional<uint64_t> Register::Known() {
  CheckKnown();
  return known_;
}

ir::ValueId Register::Get() {
  if (value_.valid()) return value_;
  CheckKnown();
  value_ = known_ ? builder_.Constant(builder_.program().places[place_].type, *known_) : builder_.Load(place_);
  return value_;
}

void Register::Set(ir::ValueId value) {
  const ir::Inst& inst = builder_.program()[value];
  PLCXX_CHECK(inst.type == builder_.program().places[place_].type);
  value_ = value;
  known_.reset();
  if (inst.op == ir::OpKind::kConst) known_ = ir::ConstantValue(inst);
  in_place_ = false;
}

void Register::Know(uint64_t value) {
  value_ = {};
  known_ = value;
  in_place_ = true;
}

void Register::Spill() {
  if (in_place_) return;
  builder_.Store(place_, Get());
  in_place_ = true;
}

void Register::Forget() {
  value_ = {};
  known_.reset();
  in_place_ = true;
}

void Register::EndStatement() {
  Spill();
  value_ = {};
}

}  // namespace plcxx::dialects
