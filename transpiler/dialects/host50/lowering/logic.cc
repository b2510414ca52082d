#include "transpiler/dialects/host50/lowering/logic.h"

namespace plcxx::host50 {

using ir::OpKind;
using ir::ValueId;

bool Logic::IsConstant(ValueId value, uint64_t constant) const {
  const ir::Inst& inst = program_[value];
  return inst.op == OpKind::kConst && ir::ConstantValue(inst) == constant;
}

ValueId Logic::And(ValueId a, ValueId b) {
  if (IsConstant(a, 1)) return b;
  if (IsConstant(b, 1)) return a;
  return builder_.Pure(OpKind::kBitAnd, {a, b});
}

ValueId Logic::Or(ValueId a, ValueId b) {
  if (IsConstant(a, 0)) return b;
  if (IsConstant(b, 0)) return a;
  return builder_.Pure(OpKind::kBitOr, {a, b});
}

ValueId Logic::Not(ValueId a) {
  if (IsConstant(a, 0) || IsConstant(a, 1)) return builder_.Bit(IsConstant(a, 0) ? 1 : 0);
  return builder_.Pure(OpKind::kBitNot, {a});
}

}  // namespace plcxx::host50
