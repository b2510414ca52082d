// Functional modules FM 0 to FM 14, and what all functional modules have in common (specification 6.6, 6.9).

#include "transpiler/dialects/prostep/lowering_internal.h"

namespace plcxx::prostep {
namespace {

using ir::OpKind;
using ir::ValueId;

enum class Registers : uint8_t { kNone, kUsesAx, kSetsAx, kSetsS, kSetsBoth };

/// What a functional module does to S and AX.
Registers RegistersOf(Function function) {
  switch (function) {
    case Function::kAdd:
    case Function::kSubtract:
    case Function::kMultiply:
    case Function::kDivide:
    case Function::kNcReadByte:
    case Function::kNcReadWord:
    case Function::kNcReadLong:
    case Function::kNcWriteByte:
    case Function::kNcWriteWord:
    case Function::kNcWriteLong:
      return Registers::kNone;
    case Function::kWriteByte:
    case Function::kWriteWord:
      return Registers::kUsesAx;
    case Function::kFromBcd:
    case Function::kShiftLeft:
    case Function::kShiftRight:
    case Function::kBitAnd:
    case Function::kBitOr:
    case Function::kBitXor:
    case Function::kNegate:
    case Function::kComplement:
    case Function::kIncrement:
    case Function::kDecrement:
    case Function::kReadByte:
    case Function::kReadWord:
      return Registers::kSetsAx;
    case Function::kToBcd:
      return Registers::kSetsBoth;
    case Function::kAddLong:
    case Function::kSubtractLong:
    case Function::kMultiplyLong:
    case Function::kDivideLong:
    case Function::kAndLong:
    case Function::kOrLong:
    case Function::kXorLong:
    case Function::kMoveLong:
    case Function::kNegateLong:
    case Function::kComplementLong:
    case Function::kIncrementLong:
    case Function::kDecrementLong:
    case Function::kEqualLong:
    case Function::kGreaterEqualUnsigned:
    case Function::kGreaterUnsigned:
    case Function::kLessEqualUnsigned:
    case Function::kLessUnsigned:
    case Function::kGreaterEqualSigned:
    case Function::kGreaterSigned:
    case Function::kLessEqualSigned:
    case Function::kLessSigned:
      return Registers::kSetsS;
  }
  PLCXX_UNREACHABLE();
}

constexpr uint32_t kHighestBcd = 9999;

}  // namespace

void Lowering::Perform(const Instruction& instruction, bool conditional) {
  if (!conditional) return PerformNow(instruction);
  const Registers registers = RegistersOf(*instruction.function);
  const bool sets_s = registers == Registers::kSetsS || registers == Registers::kSetsBoth;
  const bool sets_ax = registers == Registers::kSetsAx || registers == Registers::kSetsBoth;
  const ValueId condition = logic_->Value();
  // What is loaded inside would not be known behind; what is set inside goes through its place.
  if (registers != Registers::kNone) ax_->Get();
  if (sets_s) s_->Spill();
  if (sets_ax) ax_->Spill();
  builder_.When(condition, [&] {
    PerformNow(instruction);
    if (sets_s) s_->Spill();
    if (sets_ax) ax_->Spill();
  });
  if (sets_s) s_->Forget();
  if (sets_ax) ax_->Forget();
}

void Lowering::PerformNow(const Instruction& instruction) {
  const Function function = *instruction.function;
  const FunctionInfo& info = Info(function);
  for (uint32_t i = 0; i < info.count; ++i) {
    const bool constant = tree_.Argument(instruction, i).shape() == Shape::kConstant;
    if (constant && Info(info.arguments[i]).constant == Constant::kDisables) return s_->Set(builder_.Bit(1));
  }
  const auto on_ax = [&](OpKind op, ValueId right) { ax_->Set(builder_.Pure(op, {ax_->Get(), right})); };
  switch (function) {
    case Function::kAdd:
    case Function::kSubtract:
      return AddOrSubtract(instruction, function);
    case Function::kMultiply:
      return Multiply(instruction);
    case Function::kDivide:
      return Divide(instruction);
    case Function::kToBcd:
      return ToBcd();
    case Function::kFromBcd:
      return ax_->Set(builder_.Pure(OpKind::kFromBcd16, {ax_->Get()}));
    case Function::kShiftLeft:
      return Shift(instruction, OpKind::kShiftLeft16);
    case Function::kShiftRight:
      return Shift(instruction, OpKind::kShiftRight16);
    case Function::kBitAnd:
      return Bitwise(instruction, OpKind::kAnd8, OpKind::kAnd16);
    case Function::kBitOr:
      return Bitwise(instruction, OpKind::kOr8, OpKind::kOr16);
    case Function::kBitXor:
      return Bitwise(instruction, OpKind::kXor8, OpKind::kXor16);
    case Function::kNegate:
      return ax_->Set(builder_.Pure(OpKind::kSub16, {Word(0), ax_->Get()}));
    case Function::kComplement:
      return ax_->Set(builder_.Pure(OpKind::kNot16, {ax_->Get()}));
    case Function::kIncrement:
      return on_ax(OpKind::kAdd16, Word(1));
    case Function::kDecrement:
      return on_ax(OpKind::kSub16, Word(1));
    case Function::kReadByte:
      return ReadIndirect(instruction, ir::Type::kI8);
    case Function::kReadWord:
      return ReadIndirect(instruction, ir::Type::kI16);
    case Function::kWriteByte:
      return WriteIndirect(instruction, ir::Type::kI8);
    case Function::kWriteWord:
      return WriteIndirect(instruction, ir::Type::kI16);
    case Function::kNcReadByte:
      return NcRead(instruction, ir::Type::kI8);
    case Function::kNcReadWord:
      return NcRead(instruction, ir::Type::kI16);
    case Function::kNcReadLong:
      return NcRead(instruction, ir::Type::kI32);
    case Function::kNcWriteByte:
      return NcWrite(instruction, ir::Type::kI8);
    case Function::kNcWriteWord:
      return NcWrite(instruction, ir::Type::kI16);
    case Function::kNcWriteLong:
      return NcWrite(instruction, ir::Type::kI32);
    case Function::kAddLong:
      return LongOperation(instruction, OpKind::kAdd32);
    case Function::kSubtractLong:
      return LongOperation(instruction, OpKind::kSub32);
    case Function::kMultiplyLong:
      return MultiplyLong(instruction);
    case Function::kDivideLong:
      return DivideLong(instruction);
    case Function::kAndLong:
      return LongOperation(instruction, OpKind::kAnd32);
    case Function::kOrLong:
      return LongOperation(instruction, OpKind::kOr32);
    case Function::kXorLong:
      return LongOperation(instruction, OpKind::kXor32);
    case Function::kMoveLong:
      return MoveLong(instruction);
    case Function::kNegateLong:
      return LongChange(instruction, &Lowering::Negated);
    case Function::kComplementLong:
      return LongChange(instruction, &Lowering::Complemented);
    case Function::kIncrementLong:
      return LongChange(instruction, &Lowering::Incremented);
    case Function::kDecrementLong:
      return LongChange(instruction, &Lowering::Decremented);
    case Function::kEqualLong:
      return LongCompare(instruction, OpKind::kEqual32);
    case Function::kGreaterEqualUnsigned:
      return LongCompare(instruction, OpKind::kGreaterEqual32);
    case Function::kGreaterUnsigned:
      return LongCompare(instruction, OpKind::kGreater32);
    case Function::kLessEqualUnsigned:
      return LongCompare(instruction, OpKind::kLessEqual32);
    case Function::kLessUnsigned:
      return LongCompare(instruction, OpKind::kLess32);
    case Function::kGreaterEqualSigned:
      return LongCompare(instruction, OpKind::kSignedGreaterEqual32);
    case Function::kGreaterSigned:
      return LongCompare(instruction, OpKind::kSignedGreater32);
    case Function::kLessEqualSigned:
      return LongCompare(instruction, OpKind::kSignedLessEqual32);
    case Function::kLessSigned:
      return LongCompare(instruction, OpKind::kSignedLess32);
  }
}

ValueId Lowering::Value32(const Operand& operand) {
  const bool zero = settings_.muldiv == MulDiv::kUnsigned;
  if (operand.shape() == Shape::kConstant) {
    return Number(zero ? operand.value : static_cast<uint32_t>(static_cast<int16_t>(operand.value)));
  }
  const ValueId value = ReadData(operand);
  if (operand.shape() == Shape::kByte) return builder_.Pure(OpKind::kWiden8To32, {value});
  return builder_.Pure(zero ? OpKind::kWiden16To32 : OpKind::kSignExtend16To32, {value});
}

ValueId Lowering::Value16(const Operand& operand) {
  const ValueId value = ReadData(operand);
  return operand.shape() == Shape::kByte ? builder_.Pure(OpKind::kWiden8To16, {value}) : value;
}

ValueId Lowering::Value8(const Operand& operand) {
  if (operand.shape() == Shape::kConstant) return Byte(operand.value);
  const ValueId value = ReadData(operand);
  return operand.shape() == Shape::kByte ? value : builder_.Pure(OpKind::kLowByte16, {value});
}

/// A byte destination gets the low byte, which depends on the low bytes alone.
void Lowering::AddOrSubtract(const Instruction& instruction, Function function) {
  const Operand &left = tree_.Argument(instruction, 0), &right = tree_.Argument(instruction, 1);
  const Operand& result = tree_.Argument(instruction, 2);
  const bool add = function == Function::kAdd;
  if (result.shape() == Shape::kByte) {
    const ValueId a = Value8(left), b = Value8(right);
    return WriteData(result, builder_.Pure(add ? OpKind::kAdd8 : OpKind::kSub8, {a, b}));
  }
  const ValueId a = Value16(left), b = Value16(right);
  WriteData(result, builder_.Pure(add ? OpKind::kAdd16 : OpKind::kSub16, {a, b}));
}

void Lowering::Multiply(const Instruction& instruction) {
  const ValueId a = Value32(tree_.Argument(instruction, 0)), b = Value32(tree_.Argument(instruction, 1));
  StoreField(tree_.Argument(instruction, 2), ir::Type::kI32, builder_.Pure(OpKind::kMul32, {a, b}));
}

void Lowering::Divide(const Instruction& instruction) {
  const bool is_signed = settings_.muldiv == MulDiv::kSigned;
  const Operand &first = tree_.Argument(instruction, 0), &second = tree_.Argument(instruction, 1);
  const Operand& result = tree_.Argument(instruction, 2);
  const ValueId dividend = first.shape() == Shape::kConstant ? Value32(first) : LoadField(first, ir::Type::kI32);
  const ValueId divisor = Value32(second);
  const auto divide = [&] {
    const ValueId quotient =
        builder_.Pure(is_signed ? OpKind::kSignedDiv32 : OpKind::kUnsignedDiv32, {dividend, divisor});
    const ValueId remainder =
        builder_.Pure(is_signed ? OpKind::kSignedRem32 : OpKind::kUnsignedRem32, {dividend, divisor});
    ValueId overflow;
    if (is_signed) {
      const ValueId below = builder_.Pure(OpKind::kSignedLess32, {quotient, Number(0xFFFF8000U)});
      const ValueId above = builder_.Pure(OpKind::kSignedGreater32, {quotient, Number(0x7FFF)});
      overflow = dialects::Joined(builder_, dialects::Join::kOr, below, above);
    } else {
      overflow = builder_.Pure(OpKind::kGreater32, {quotient, Number(0xFFFF)});
    }
    builder_.Choose(
        overflow, [&] { CallFault(Fault::kDivOverflow); },
        [&] {
          StoreField(result, ir::Type::kI16, builder_.Pure(OpKind::kLowHalf32, {quotient}));
          StoreField(result, ir::Type::kI16, builder_.Pure(OpKind::kLowHalf32, {remainder}), 2);
        });
  };
  if (second.shape() == Shape::kConstant) {
    if (second.value == 0) return CallFault(Fault::kDivZero);
    return divide();
  }
  builder_.Choose(builder_.Pure(OpKind::kEqual32, {divisor, Number(0)}), [&] { CallFault(Fault::kDivZero); }, divide);
}

/// FM 4: S tells that AX has more than four digits, and is left as it is.
void Lowering::ToBcd() {
  const ValueId word = ax_->Get();
  const ValueId too_large = builder_.Pure(OpKind::kGreater16, {word, Word(kHighestBcd)});
  s_->Set(too_large);
  ax_->Spill();
  builder_.When(dialects::Inverted(builder_, too_large), [&] {
    ax_->Set(builder_.Pure(OpKind::kToBcd16, {word}));
    ax_->Spill();
  });
  ax_->Forget();
}

void Lowering::Shift(const Instruction& instruction, OpKind op) {
  const ValueId count = Value16(tree_.Argument(instruction, 0));
  ax_->Set(builder_.Pure(op, {ax_->Get(), count}));
}

void Lowering::Bitwise(const Instruction& instruction, OpKind bytes, OpKind words) {
  const Operand& operand = tree_.Argument(instruction, 0);
  const ValueId value = ReadData(operand);
  if (operand.shape() == Shape::kByte) return SetLowByte(builder_.Pure(bytes, {LowByte(), value}));
  ax_->Set(builder_.Pure(words, {ax_->Get(), value}));
}

}  // namespace plcxx::prostep
