#include "transpiler/dialects/prostep/lowering/long_words.h"

#include "transpiler/dialects/common/logic_stack.h"
#include "transpiler/dialects/prostep/lowering/cells.h"
#include "transpiler/dialects/prostep/lowering/registers.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

ValueId LongWords::Load(const Instruction& instruction, uint32_t argument) {
  return cells_.LoadField(Argument(instruction, argument), Type::kI32);
}

void LongWords::Finish(const Operand& target, ValueId result) {
  cells_.StoreField(target, Type::kI32, result);
  registers_.s().Set(Pure(OpKind::kEqual32, {result, Number(0)}));
}

void LongWords::Change(const Instruction& instruction, ValueId result) { Finish(Argument(instruction, 0), result); }

void LongWords::Combine(const Instruction& instruction, OpKind op) {
  const ValueId a = Load(instruction, 0), b = Load(instruction, 1);
  Finish(Argument(instruction, 2), Pure(op, {a, b}));
}

void LongWords::Negate(const Instruction& instruction) {
  const ValueId value = Load(instruction, 0);
  Change(instruction, Pure(OpKind::kSub32, {Number(0), value}));
}

void LongWords::Complement(const Instruction& instruction) {
  Change(instruction, Pure(OpKind::kNot32, {Load(instruction, 0)}));
}

void LongWords::Increment(const Instruction& instruction) {
  Change(instruction, Pure(OpKind::kAdd32, {Load(instruction, 0), Number(1)}));
}

void LongWords::Decrement(const Instruction& instruction) {
  Change(instruction, Pure(OpKind::kSub32, {Load(instruction, 0), Number(1)}));
}

void LongWords::Compare(const Instruction& instruction, OpKind op) {
  const ValueId a = Load(instruction, 0), b = Load(instruction, 1);
  registers_.s().Set(Pure(op, {a, b}));
}

void LongWords::Move(const Instruction& instruction) { Finish(Argument(instruction, 1), Load(instruction, 0)); }

void LongWords::Multiply(const Instruction& instruction) {
  const OpKind extend = settings_.muldiv == MulDiv::kSigned ? OpKind::kSignExtend32To64 : OpKind::kWiden32To64;
  const ValueId a = Pure(extend, {Load(instruction, 0)});
  const ValueId b = Pure(extend, {Load(instruction, 1)});
  const ValueId product = Pure(OpKind::kMul64, {a, b});
  const Operand& result = Argument(instruction, 2);
  cells_.StoreField(result, Type::kI32, Pure(OpKind::kLowHalf64, {product}));
  cells_.StoreField(result, Type::kI32, Pure(OpKind::kHighHalf64, {product}), 4);
  registers_.s().Set(Pure(OpKind::kIsZero64, {product}));
}

void LongWords::Divide(const Instruction& instruction) {
  const bool is_signed = settings_.muldiv == MulDiv::kSigned;
  const ValueId a = Load(instruction, 0);
  const ValueId b = Load(instruction, 1);
  ValueId refused = Pure(OpKind::kEqual32, {b, Number(0)});
  if (is_signed) {
    const ValueId lowest = Pure(OpKind::kEqual32, {a, Number(0x80000000U)});
    const ValueId minus_one = Pure(OpKind::kEqual32, {b, Number(0xFFFFFFFFU)});
    refused = dialects::Joined(builder_, dialects::Join::kOr, refused,
                               dialects::Joined(builder_, dialects::Join::kAnd, lowest, minus_one));
  }
  const Operand& result = Argument(instruction, 2);
  builder_.When(dialects::Inverted(builder_, refused), [&] {
    const ValueId quotient = Pure(is_signed ? OpKind::kSignedDiv32 : OpKind::kUnsignedDiv32, {a, b});
    const ValueId remainder = Pure(is_signed ? OpKind::kSignedRem32 : OpKind::kUnsignedRem32, {a, b});
    cells_.StoreField(result, Type::kI32, quotient);
    cells_.StoreField(result, Type::kI32, remainder, 4);
  });
  registers_.s().Set(refused);
}

}  // namespace plcxx::prostep
