// Inline assembler: products, quotients, sign extension, decimal adjustment (specification 6.9).

#include "transpiler/dialects/technol/lowering_internal.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

void Lowering::MultiplyRegister(const Instruction& instruction) {
  const Operand& factor = tree_.OperandOf(instruction, 0);
  const bool is_signed = instruction.op == Op::kImul;
  const ValueId right = Read(factor);
  const auto fits = [&](ValueId low, ValueId high, uint32_t width) {  // is the upper half nothing but the sign?
    const ValueId sign = Pure(OpKind::kArithmeticShiftRight32, {SignedTo32(low), Number(31)});
    return Pure(OpKind::kEqual32, {ToWidth(high, 32), ToWidth(ToWidth(sign, width), 32)});
  };
  ValueId low, high;
  if (factor.width == 32) {
    const auto wide = [&](ValueId value) {
      return Pure(is_signed ? OpKind::kSignExtend32To64 : OpKind::kWiden32To64, {value});
    };
    const ValueId left = wide(ReadRegister(Register::kEax));
    const ValueId product = Pure(OpKind::kMul64, {left, wide(right)});
    low = Pure(OpKind::kLowHalf64, {product});
    high = Pure(OpKind::kHighHalf64, {product});
    WriteRegister(Register::kEax, low);
    WriteRegister(Register::kEdx, high);
  } else {
    const auto wide = [&](ValueId value) { return is_signed ? SignedTo32(value) : ToWidth(value, 32); };
    const ValueId left = wide(ReadRegister(factor.width == 8 ? Register::kAl : Register::kAx));
    const ValueId product = Pure(OpKind::kMul32, {left, wide(right)});
    const ValueId word = Low16(product);
    if (factor.width == 8) {
      low = Low8(word);
      high = High8(word);
      WriteRegister(Register::kAx, word);
    } else {
      low = word;
      high = High16(product);
      WriteRegister(Register::kAx, low);
      WriteRegister(Register::kDx, high);
    }
  }
  const auto overflows = [&] { return Not(is_signed ? fits(low, high, factor.width) : IsZero(high, factor.width)); };
  Flag(kCf, overflows);
  Flag(kOf, overflows);
}

/// A quotient that does not fit, and a division by zero: all ones or 80...0h, the remainder is 0, and a fault.
void Lowering::DivideRegister(const Instruction& instruction) {
  const Operand& operand = tree_.OperandOf(instruction, 0);
  const uint32_t width = operand.width;
  const bool is_signed = instruction.op == Op::kIdiv;
  const ValueId divisor = Read(operand);
  const auto store = [&](ValueId quotient, ValueId remainder) {
    WriteRegister(width == 8 ? Register::kAl : width == 16 ? Register::kAx : Register::kEax, quotient);
    WriteRegister(width == 8 ? Register::kAh : width == 16 ? Register::kDx : Register::kEdx, remainder);
  };
  ValueId quotient, remainder, possible;
  if (width == 32) {
    const ValueId low = ReadRegister(Register::kEax), high = ReadRegister(Register::kEdx);
    const ValueId dividend = Pure(OpKind::kPair64, {low, high});
    const ValueId by = Pure(is_signed ? OpKind::kSignExtend32To64 : OpKind::kWiden32To64, {divisor});
    const ValueId whole = Pure(is_signed ? OpKind::kSignedDiv64 : OpKind::kUnsignedDiv64, {dividend, by});
    quotient = Pure(OpKind::kLowHalf64, {whole});
    remainder =
        Pure(OpKind::kLowHalf64, {Pure(is_signed ? OpKind::kSignedRem64 : OpKind::kUnsignedRem64, {dividend, by})});
    if (is_signed) {
      possible = Pure(OpKind::kBitAnd, {Pure(OpKind::kNotEqual32, {divisor, Number(0)}),
                                        Pure(OpKind::kEqual64, {Pure(OpKind::kSignExtend32To64, {quotient}), whole})});
    } else {
      possible = Pure(OpKind::kLess32, {high, divisor});
    }
  } else {
    const ValueId low = ReadRegister(Register::kAx);
    const ValueId high = width == 8 ? ReadRegister(Register::kAh) : ReadRegister(Register::kDx);
    ValueId dividend =
        width == 8 ? (is_signed ? SignedTo32(low) : ToWidth(low, 32)) : Pure(OpKind::kPair32, {low, high});
    if (KnownValue(high) == 0) dividend = ToWidth(low, 32);
    const ValueId by = is_signed ? SignedTo32(divisor) : ToWidth(divisor, 32);
    const ValueId whole = Pure(is_signed ? OpKind::kSignedDiv32 : OpKind::kUnsignedDiv32, {dividend, by});
    quotient = ToWidth(whole, width);
    remainder = ToWidth(Pure(is_signed ? OpKind::kSignedRem32 : OpKind::kUnsignedRem32, {dividend, by}), width);
    if (is_signed) {
      possible = Pure(OpKind::kBitAnd, {Pure(OpKind::kNotEqual32, {by, Number(0)}),
                                        Pure(OpKind::kEqual32, {SignedTo32(quotient), whole})});
    } else {  // the quotient fits when the upper half is less than the divisor, which then is not 0
      possible = Pure(OpKind::kLess32, {ToWidth(high, 32), ToWidth(divisor, 32)});
    }
  }
  const uint64_t least = uint64_t{1} << (width - 1), ones = (uint64_t{1} << width) - 1;
  SplitRegisters(
      possible, [&] { store(quotient, remainder); },
      [&] {
        store(Constant(is_signed ? least : ones, width, 16), Constant(0, width));
        CallFault(Fault::kDivide);
      });
}

void Lowering::Decimal(const Instruction& instruction) {
  const ValueId al = ReadRegister(Register::kAl), carry = FlagValue(kCf), half = FlagValue(kAf);
  const ValueId digit = Pure(OpKind::kLowNibble8, {al});
  const ValueId low = Pure(OpKind::kBitOr, {Pure(OpKind::kGreater8, {digit, Byte(9)}), half});
  const ValueId high =
      Pure(OpKind::kBitOr, {Pure(OpKind::kGreater8, {al, builder_.Constant(Type::kI8, 0x99, 16)}), carry});
  const bool adds = instruction.op == Op::kDaa;
  const ValueId result = Pure(adds ? OpKind::kAdjustAfterAdd8 : OpKind::kAdjustAfterSub8, {al, low, high});
  WriteRegister(Register::kAl, result);
  Flag(kCf, [&] {
    if (adds) return high;
    const ValueId borrows = Pure(OpKind::kBitAnd, {low, Pure(OpKind::kLess8, {al, Byte(6)})});
    return Pure(OpKind::kBitOr, {high, borrows});
  });
  Flag(kAf, [&] { return low; });
  ResultFlags(result, 8);
}

void Lowering::Unpack(const Instruction& instruction) {
  constexpr uint64_t kTen = 10;
  const ValueId al = ToWidth(ReadRegister(Register::kAl), 32);
  ValueId result;
  if (instruction.op == Op::kAam) {
    const ValueId tens = ToWidth(Pure(OpKind::kUnsignedDiv32, {al, Number(kTen)}), 8);
    result = ToWidth(Pure(OpKind::kUnsignedRem32, {al, Number(kTen)}), 8);
    WriteRegister(Register::kAx, Pure(OpKind::kPair16, {result, tens}));
  } else {
    const ValueId ah = ToWidth(ReadRegister(Register::kAh), 32);
    result = ToWidth(Pure(OpKind::kAdd32, {al, Pure(OpKind::kMul32, {ah, Number(kTen)})}), 8);
    WriteRegister(Register::kAx, ToWidth(result, 16));
  }
  ResultFlags(result, 8);
}

}  // namespace plcxx::technol
