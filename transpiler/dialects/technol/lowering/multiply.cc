// Inline assembler: products, quotients, sign extension, decimal adjustment (specification 6.9).

#include "transpiler/dialects/technol/lowering/internal.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

void Lowering::MultiplyRegister(const Instruction& instruction) {
  const Operand& factor = tree_.OperandOf(instruction, 0);
  const bool is_signed = instruction.op == Op::kImul;
  const ValueId right = Read(factor);
  const auto fits = [&](ValueId low, ValueId high, uint32_t width) {  // is the upper half nothing but the sign?
    const ValueId sign =
        builder_.Pure(OpKind::kArithmeticShiftRight32, {builder_.SignedTo32(low), builder_.Number(31)});
    return builder_.Pure(OpKind::kEqual32,
                         {builder_.ToWidth(high, 32), builder_.ToWidth(builder_.ToWidth(sign, width), 32)});
  };
  ValueId low, high;
  if (factor.width == 32) {
    const auto wide = [&](ValueId value) {
      return builder_.Pure(is_signed ? OpKind::kSignExtend32To64 : OpKind::kWiden32To64, {value});
    };
    const ValueId left = wide(registers_.Read(Register::kEax));
    const ValueId product = builder_.Pure(OpKind::kMul64, {left, wide(right)});
    low = builder_.Pure(OpKind::kLowHalf64, {product});
    high = builder_.Pure(OpKind::kHighHalf64, {product});
    registers_.Write(Register::kEax, low);
    registers_.Write(Register::kEdx, high);
  } else {
    const auto wide = [&](ValueId value) {
      return is_signed ? builder_.SignedTo32(value) : builder_.ToWidth(value, 32);
    };
    const ValueId left = wide(registers_.Read(factor.width == 8 ? Register::kAl : Register::kAx));
    const ValueId product = builder_.Pure(OpKind::kMul32, {left, wide(right)});
    const ValueId word = builder_.Low16(product);
    if (factor.width == 8) {
      low = builder_.Low8(word);
      high = builder_.High8(word);
      registers_.Write(Register::kAx, word);
    } else {
      low = word;
      high = builder_.High16(product);
      registers_.Write(Register::kAx, low);
      registers_.Write(Register::kDx, high);
    }
  }
  const auto overflows = [&] {
    return builder_.Not(is_signed ? fits(low, high, factor.width) : IsZero(high, factor.width));
  };
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
    registers_.Write(width == 8 ? Register::kAl : width == 16 ? Register::kAx : Register::kEax, quotient);
    registers_.Write(width == 8 ? Register::kAh : width == 16 ? Register::kDx : Register::kEdx, remainder);
  };
  ValueId quotient, remainder, possible;
  if (width == 32) {
    const ValueId low = registers_.Read(Register::kEax), high = registers_.Read(Register::kEdx);
    const ValueId dividend = builder_.Pure(OpKind::kPair64, {low, high});
    const ValueId by = builder_.Pure(is_signed ? OpKind::kSignExtend32To64 : OpKind::kWiden32To64, {divisor});
    const ValueId whole = builder_.Pure(is_signed ? OpKind::kSignedDiv64 : OpKind::kUnsignedDiv64, {dividend, by});
    quotient = builder_.Pure(OpKind::kLowHalf64, {whole});
    remainder = builder_.Pure(
        OpKind::kLowHalf64, {builder_.Pure(is_signed ? OpKind::kSignedRem64 : OpKind::kUnsignedRem64, {dividend, by})});
    if (is_signed) {
      possible = builder_.Pure(
          OpKind::kBitAnd,
          {builder_.Pure(OpKind::kNotEqual32, {divisor, builder_.Number(0)}),
           builder_.Pure(OpKind::kEqual64, {builder_.Pure(OpKind::kSignExtend32To64, {quotient}), whole})});
    } else {
      possible = builder_.Pure(OpKind::kLess32, {high, divisor});
    }
  } else {
    const ValueId low = registers_.Read(Register::kAx);
    const ValueId high = width == 8 ? registers_.Read(Register::kAh) : registers_.Read(Register::kDx);
    ValueId dividend = width == 8 ? (is_signed ? builder_.SignedTo32(low) : builder_.ToWidth(low, 32))
                                  : builder_.Pure(OpKind::kPair32, {low, high});
    if (builder_.KnownValue(high) == 0) dividend = builder_.ToWidth(low, 32);
    const ValueId by = is_signed ? builder_.SignedTo32(divisor) : builder_.ToWidth(divisor, 32);
    const ValueId whole = builder_.Pure(is_signed ? OpKind::kSignedDiv32 : OpKind::kUnsignedDiv32, {dividend, by});
    quotient = builder_.ToWidth(whole, width);
    remainder = builder_.ToWidth(
        builder_.Pure(is_signed ? OpKind::kSignedRem32 : OpKind::kUnsignedRem32, {dividend, by}), width);
    if (is_signed) {
      possible =
          builder_.Pure(OpKind::kBitAnd, {builder_.Pure(OpKind::kNotEqual32, {by, builder_.Number(0)}),
                                          builder_.Pure(OpKind::kEqual32, {builder_.SignedTo32(quotient), whole})});
    } else {  // the quotient fits when the upper half is less than the divisor, which then is not 0
      possible = builder_.Pure(OpKind::kLess32, {builder_.ToWidth(high, 32), builder_.ToWidth(divisor, 32)});
    }
  }
  const uint64_t least = uint64_t{1} << (width - 1), ones = (uint64_t{1} << width) - 1;
  registers_.Split(
      possible, [&] { store(quotient, remainder); },
      [&] {
        store(builder_.Constant(is_signed ? least : ones, width, 16), builder_.Constant(0, width));
        CallFault(Fault::kDivide);
      });
}

void Lowering::Decimal(const Instruction& instruction) {
  const ValueId al = registers_.Read(Register::kAl), carry = FlagValue(kCf), half = FlagValue(kAf);
  const ValueId digit = builder_.Pure(OpKind::kLowNibble8, {al});
  const ValueId low =
      builder_.Pure(OpKind::kBitOr, {builder_.Pure(OpKind::kGreater8, {digit, builder_.Byte(9)}), half});
  const ValueId high = builder_.Pure(
      OpKind::kBitOr, {builder_.Pure(OpKind::kGreater8, {al, builder_.Constant(Type::kI8, 0x99, 16)}), carry});
  const bool adds = instruction.op == Op::kDaa;
  const ValueId result = builder_.Pure(adds ? OpKind::kAdjustAfterAdd8 : OpKind::kAdjustAfterSub8, {al, low, high});
  registers_.Write(Register::kAl, result);
  Flag(kCf, [&] {
    if (adds) return high;
    const ValueId borrows =
        builder_.Pure(OpKind::kBitAnd, {low, builder_.Pure(OpKind::kLess8, {al, builder_.Byte(6)})});
    return builder_.Pure(OpKind::kBitOr, {high, borrows});
  });
  Flag(kAf, [&] { return low; });
  ResultFlags(result, 8);
}

void Lowering::Unpack(const Instruction& instruction) {
  constexpr uint64_t kTen = 10;
  const ValueId al = builder_.ToWidth(registers_.Read(Register::kAl), 32);
  ValueId result;
  if (instruction.op == Op::kAam) {
    const ValueId tens = builder_.ToWidth(builder_.Pure(OpKind::kUnsignedDiv32, {al, builder_.Number(kTen)}), 8);
    result = builder_.ToWidth(builder_.Pure(OpKind::kUnsignedRem32, {al, builder_.Number(kTen)}), 8);
    registers_.Write(Register::kAx, builder_.Pure(OpKind::kPair16, {result, tens}));
  } else {
    const ValueId ah = builder_.ToWidth(registers_.Read(Register::kAh), 32);
    result = builder_.ToWidth(
        builder_.Pure(OpKind::kAdd32, {al, builder_.Pure(OpKind::kMul32, {ah, builder_.Number(kTen)})}), 8);
    registers_.Write(Register::kAx, builder_.ToWidth(result, 16));
  }
  ResultFlags(result, 8);
}

}  // namespace plcxx::technol
