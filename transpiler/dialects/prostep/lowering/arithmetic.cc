#include "transpiler/dialects/prostep/lowering/arithmetic.h"

#include "transpiler/dialects/common/logic_stack.h"
#include "transpiler/dialects/prostep/lowering/cells.h"
#include "transpiler/dialects/prostep/lowering/faults.h"
#include "transpiler/dialects/prostep/lowering/operands.h"
#include "transpiler/dialects/prostep/lowering/registers.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::ValueId;

namespace {

constexpr uint32_t kHighestBcd = 9999;

}  // namespace

void Arithmetic::AddOrSubtract(const Instruction& instruction, OpKind bytes, OpKind words) {
  const Operand &left = Argument(instruction, 0), &right = Argument(instruction, 1);
  const Operand& result = Argument(instruction, 2);
  if (result.shape() == Shape::kByte) {
    const ValueId a = operands_.Value8(left), b = operands_.Value8(right);
    return operands_.Write(result, Pure(bytes, {a, b}));
  }
  const ValueId a = operands_.Value16(left), b = operands_.Value16(right);
  operands_.Write(result, Pure(words, {a, b}));
}

void Arithmetic::Multiply(const Instruction& instruction) {
  const ValueId a = operands_.Value32(Argument(instruction, 0)), b = operands_.Value32(Argument(instruction, 1));
  cells_.StoreField(Argument(instruction, 2), ir::Type::kI32, Pure(OpKind::kMul32, {a, b}));
}

ValueId Arithmetic::DoesNotFit(ValueId quotient) {
  if (settings_.muldiv != MulDiv::kSigned) return Pure(OpKind::kGreater32, {quotient, Number(0xFFFF)});
  const ValueId below = Pure(OpKind::kSignedLess32, {quotient, Number(0xFFFF8000U)});
  const ValueId above = Pure(OpKind::kSignedGreater32, {quotient, Number(0x7FFF)});
  return dialects::Joined(builder_, dialects::Join::kOr, below, above);
}

void Arithmetic::Divide(const Instruction& instruction) {
  const bool is_signed = settings_.muldiv == MulDiv::kSigned;
  const Operand &first = Argument(instruction, 0), &second = Argument(instruction, 1);
  const Operand& result = Argument(instruction, 2);
  const ValueId dividend =
      first.shape() == Shape::kConstant ? operands_.Value32(first) : cells_.LoadField(first, ir::Type::kI32);
  const ValueId divisor = operands_.Value32(second);
  const auto divide = [&] {
    const ValueId quotient = Pure(is_signed ? OpKind::kSignedDiv32 : OpKind::kUnsignedDiv32, {dividend, divisor});
    const ValueId remainder = Pure(is_signed ? OpKind::kSignedRem32 : OpKind::kUnsignedRem32, {dividend, divisor});
    builder_.Choose(
        DoesNotFit(quotient), [&] { faults_.Report(Fault::kDivOverflow); },
        [&] {
          cells_.StoreField(result, ir::Type::kI16, Pure(OpKind::kLowHalf32, {quotient}));
          cells_.StoreField(result, ir::Type::kI16, Pure(OpKind::kLowHalf32, {remainder}), 2);
        });
  };
  if (second.shape() == Shape::kConstant) {
    if (second.value == 0) return faults_.Report(Fault::kDivZero);
    return divide();
  }
  builder_.Choose(Pure(OpKind::kEqual32, {divisor, Number(0)}), [&] { faults_.Report(Fault::kDivZero); }, divide);
}

void Arithmetic::ToBcd() {
  const ValueId word = registers_.ax().Get();
  const ValueId too_large = Pure(OpKind::kGreater16, {word, Word(kHighestBcd)});
  registers_.s().Set(too_large);
  registers_.ax().Spill();
  builder_.When(dialects::Inverted(builder_, too_large), [&] {
    registers_.ax().Set(Pure(OpKind::kToBcd16, {word}));
    registers_.ax().Spill();
  });
  registers_.ax().Forget();
}

void Arithmetic::Shift(const Instruction& instruction, OpKind op) {
  const ValueId count = operands_.Value16(Argument(instruction, 0));
  registers_.ax().Set(Pure(op, {registers_.ax().Get(), count}));
}

void Arithmetic::Bitwise(const Instruction& instruction, OpKind bytes, OpKind words) {
  const Operand& operand = Argument(instruction, 0);
  const ValueId value = operands_.Read(operand);
  if (operand.shape() == Shape::kByte) return registers_.SetLowByte(Pure(bytes, {registers_.LowByte(), value}));
  registers_.ax().Set(Pure(words, {registers_.ax().Get(), value}));
}

}  // namespace plcxx::prostep
