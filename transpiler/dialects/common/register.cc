#include "transpiler/dialects/common/register.h"

namespace plcxx::dialects {

ir::ValueId Register::Get() {
  if (value_.valid()) return value_;
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
