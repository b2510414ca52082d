// FM 60 to FM 88: double words; S tells of the result (specification 6.9). All sources are read before anything is
// written, so that fields may overlap.

#include "transpiler/dialects/prostep/lowering_internal.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

void Lowering::LongOperation(const Instruction& instruction, OpKind op) {
  const ValueId a = LoadField(tree_.Argument(instruction, 0), Type::kI32);
  const ValueId b = LoadField(tree_.Argument(instruction, 1), Type::kI32);
  const ValueId result = builder_.Pure(op, {a, b});
  StoreField(tree_.Argument(instruction, 2), Type::kI32, result);
  s_->Set(builder_.Pure(OpKind::kEqual32, {result, Number(0)}));
}

void Lowering::LongChange(const Instruction& instruction, ValueId (Lowering::*change)(ValueId)) {
  const Operand& field = tree_.Argument(instruction, 0);
  const ValueId result = (this->*change)(LoadField(field, Type::kI32));
  StoreField(field, Type::kI32, result);
  s_->Set(builder_.Pure(OpKind::kEqual32, {result, Number(0)}));
}

void Lowering::LongCompare(const Instruction& instruction, OpKind op) {
  const ValueId a = LoadField(tree_.Argument(instruction, 0), Type::kI32);
  const ValueId b = LoadField(tree_.Argument(instruction, 1), Type::kI32);
  s_->Set(builder_.Pure(op, {a, b}));
}

void Lowering::MoveLong(const Instruction& instruction) {
  const ValueId value = LoadField(tree_.Argument(instruction, 0), Type::kI32);
  StoreField(tree_.Argument(instruction, 1), Type::kI32, value);
  s_->Set(builder_.Pure(OpKind::kEqual32, {value, Number(0)}));
}

void Lowering::MultiplyLong(const Instruction& instruction) {
  const OpKind extend = settings_.muldiv == MulDiv::kSigned ? OpKind::kSignExtend32To64 : OpKind::kWiden32To64;
  const ValueId a = builder_.Pure(extend, {LoadField(tree_.Argument(instruction, 0), Type::kI32)});
  const ValueId b = builder_.Pure(extend, {LoadField(tree_.Argument(instruction, 1), Type::kI32)});
  const ValueId product = builder_.Pure(OpKind::kMul64, {a, b});
  const Operand& result = tree_.Argument(instruction, 2);
  StoreField(result, Type::kI32, builder_.Pure(OpKind::kLowHalf64, {product}));
  StoreField(result, Type::kI32, builder_.Pure(OpKind::kHighHalf64, {product}), 4);
  s_->Set(builder_.Pure(OpKind::kIsZero64, {product}));
}

/// S tells that nothing was done: by 0, or the one quotient that does not fit.
void Lowering::DivideLong(const Instruction& instruction) {
  const bool is_signed = settings_.muldiv == MulDiv::kSigned;
  const ValueId a = LoadField(tree_.Argument(instruction, 0), Type::kI32);
  const ValueId b = LoadField(tree_.Argument(instruction, 1), Type::kI32);
  ValueId refused = builder_.Pure(OpKind::kEqual32, {b, Number(0)});
  if (is_signed) {
    const ValueId lowest = builder_.Pure(OpKind::kEqual32, {a, Number(0x80000000U)});
    const ValueId minus_one = builder_.Pure(OpKind::kEqual32, {b, Number(0xFFFFFFFFU)});
    refused = dialects::Joined(builder_, dialects::Join::kOr, refused,
                               dialects::Joined(builder_, dialects::Join::kAnd, lowest, minus_one));
  }
  const Operand& result = tree_.Argument(instruction, 2);
  builder_.When(dialects::Inverted(builder_, refused), [&] {
    const ValueId quotient = builder_.Pure(is_signed ? OpKind::kSignedDiv32 : OpKind::kUnsignedDiv32, {a, b});
    const ValueId remainder = builder_.Pure(is_signed ? OpKind::kSignedRem32 : OpKind::kUnsignedRem32, {a, b});
    StoreField(result, Type::kI32, quotient);
    StoreField(result, Type::kI32, remainder, 4);
  });
  s_->Set(refused);
}

}  // namespace plcxx::prostep
