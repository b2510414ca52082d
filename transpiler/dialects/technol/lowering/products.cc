#include "transpiler/dialects/technol/lowering/products.h"

#include "transpiler/dialects/technol/lowering/faults.h"
#include "transpiler/dialects/technol/lowering/flags.h"
#include "transpiler/dialects/technol/lowering/operands.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

namespace {

constexpr uint64_t kTen = 10;

}  // namespace

Products::Pair Products::MultiplyWide(ValueId right, Signedness signedness) {
  const auto wide = [&](ValueId value) {
    return Pure(signedness == Signedness::kSigned ? OpKind::kSignExtend32To64 : OpKind::kWiden32To64, {value});
  };
  const ValueId left = wide(registers_.Read(Register::kEax));
  const ValueId product = Pure(OpKind::kMul64, {left, wide(right)});
  const ValueId low = Pure(OpKind::kLowHalf64, {product});
  const ValueId high = Pure(OpKind::kHighHalf64, {product});
  registers_.Write(Register::kEax, low);
  registers_.Write(Register::kEdx, high);
  return {low, high};
}

Products::Pair Products::MultiplyNarrow(ValueId right, uint32_t width, Signedness signedness) {
  const auto wide = [&](ValueId value) {
    return signedness == Signedness::kSigned ? builder_.SignedTo32(value) : builder_.ToWidth(value, 32);
  };
  const ValueId left = wide(registers_.Read(width == 8 ? Register::kAl : Register::kAx));
  const ValueId product = Pure(OpKind::kMul32, {left, wide(right)});
  const ValueId word = builder_.Low16(product);
  if (width == 8) {
    const ValueId low = builder_.Low8(word);
    const ValueId high = builder_.High8(word);
    registers_.Write(Register::kAx, word);
    return {low, high};
  }
  const ValueId high = builder_.High16(product);
  registers_.Write(Register::kAx, word);
  registers_.Write(Register::kDx, high);
  return {word, high};
}

void Products::Multiply(const Instruction& instruction, Signedness signedness) {
  const Operand& factor = OperandOf(instruction, 0);
  const uint32_t width = factor.width;
  const ValueId right = operands_.Read(factor);
  const Pair product = width == 32 ? MultiplyWide(right, signedness) : MultiplyNarrow(right, width, signedness);
  const auto is_sign = [&](ValueId upper, ValueId lower) {  // is the upper half nothing but the sign?
    const ValueId sign = Pure(OpKind::kArithmeticShiftRight32, {builder_.SignedTo32(lower), builder_.Number(31)});
    return Pure(OpKind::kEqual32, {builder_.ToWidth(upper, 32), builder_.ToWidth(builder_.ToWidth(sign, width), 32)});
  };
  const auto overflows = [&] {
    const bool is_signed = signedness == Signedness::kSigned;
    return builder_.Not(is_signed ? is_sign(product.high, product.low) : flags_.IsZero(product.high, width));
  };
  flags_.Set(kCf, overflows);
  flags_.Set(kOf, overflows);
}

Products::Quotient Products::DivideWide(ValueId divisor, Signedness signedness) {
  const bool is_signed = signedness == Signedness::kSigned;
  const ValueId low = registers_.Read(Register::kEax), high = registers_.Read(Register::kEdx);
  const ValueId dividend = Pure(OpKind::kPair64, {low, high});
  const ValueId by = Pure(is_signed ? OpKind::kSignExtend32To64 : OpKind::kWiden32To64, {divisor});
  const ValueId whole = Pure(is_signed ? OpKind::kSignedDiv64 : OpKind::kUnsignedDiv64, {dividend, by});
  const ValueId quotient = Pure(OpKind::kLowHalf64, {whole});
  const ValueId remainder =
      Pure(OpKind::kLowHalf64, {Pure(is_signed ? OpKind::kSignedRem64 : OpKind::kUnsignedRem64, {dividend, by})});
  if (!is_signed) return {quotient, remainder, Pure(OpKind::kLess32, {high, divisor})};
  const ValueId fits =
      Pure(OpKind::kBitAnd, {Pure(OpKind::kNotEqual32, {divisor, builder_.Number(0)}),
                             Pure(OpKind::kEqual64, {Pure(OpKind::kSignExtend32To64, {quotient}), whole})});
  return {quotient, remainder, fits};
}

Products::Quotient Products::DivideNarrow(ValueId divisor, uint32_t width, Signedness signedness) {
  const bool is_signed = signedness == Signedness::kSigned;
  const ValueId low = registers_.Read(Register::kAx);
  const ValueId high = width == 8 ? registers_.Read(Register::kAh) : registers_.Read(Register::kDx);
  ValueId dividend = width == 8 ? (is_signed ? builder_.SignedTo32(low) : builder_.ToWidth(low, 32))
                                : Pure(OpKind::kPair32, {low, high});
  if (builder_.KnownValue(high) == 0) dividend = builder_.ToWidth(low, 32);
  const ValueId by = is_signed ? builder_.SignedTo32(divisor) : builder_.ToWidth(divisor, 32);
  const ValueId whole = Pure(is_signed ? OpKind::kSignedDiv32 : OpKind::kUnsignedDiv32, {dividend, by});
  const ValueId quotient = builder_.ToWidth(whole, width);
  const ValueId remainder =
      builder_.ToWidth(Pure(is_signed ? OpKind::kSignedRem32 : OpKind::kUnsignedRem32, {dividend, by}), width);
  if (!is_signed) {  // the quotient fits when the upper half is less than the divisor, which then is not 0
    return {quotient, remainder, Pure(OpKind::kLess32, {builder_.ToWidth(high, 32), builder_.ToWidth(divisor, 32)})};
  }
  const ValueId fits = Pure(OpKind::kBitAnd, {Pure(OpKind::kNotEqual32, {by, builder_.Number(0)}),
                                              Pure(OpKind::kEqual32, {builder_.SignedTo32(quotient), whole})});
  return {quotient, remainder, fits};
}

void Products::Divide(const Instruction& instruction, Signedness signedness) {
  const Operand& operand = OperandOf(instruction, 0);
  const uint32_t width = operand.width;
  const ValueId divisor = operands_.Read(operand);
  const Quotient quotient = width == 32 ? DivideWide(divisor, signedness) : DivideNarrow(divisor, width, signedness);
  const auto store = [&](ValueId whole, ValueId remainder) {
    registers_.Write(width == 8 ? Register::kAl : width == 16 ? Register::kAx : Register::kEax, whole);
    registers_.Write(width == 8 ? Register::kAh : width == 16 ? Register::kDx : Register::kEdx, remainder);
  };
  const uint64_t lowest = uint64_t{1} << (width - 1), ones = (uint64_t{1} << width) - 1;
  registers_.Split(
      quotient.fits, [&] { store(quotient.whole, quotient.remainder); },
      [&] {
        const ValueId no_remainder = builder_.Constant(0, width);
        const ValueId no_quotient = builder_.Constant(signedness == Signedness::kSigned ? lowest : ones, width, 16);
        store(no_quotient, no_remainder);
        faults_.Report(Fault::kDivide);
      });
}

void Products::AdjustDecimal(Adjusted adjusted) {
  const ValueId al = registers_.Read(Register::kAl), carry = flags_.Value(kCf), half = flags_.Value(kAf);
  const ValueId digit = Pure(OpKind::kLowNibble8, {al});
  const ValueId low = Pure(OpKind::kBitOr, {Pure(OpKind::kGreater8, {digit, builder_.Byte(9)}), half});
  const ValueId high =
      Pure(OpKind::kBitOr, {Pure(OpKind::kGreater8, {al, builder_.Constant(Type::kI8, 0x99, 16)}), carry});
  const bool adds = adjusted == Adjusted::kSum;
  const ValueId result = Pure(adds ? OpKind::kAdjustAfterAdd8 : OpKind::kAdjustAfterSub8, {al, low, high});
  registers_.Write(Register::kAl, result);
  flags_.Set(kCf, [&] {
    if (adds) return high;
    const ValueId borrows = Pure(OpKind::kBitAnd, {low, Pure(OpKind::kLess8, {al, builder_.Byte(6)})});
    return Pure(OpKind::kBitOr, {high, borrows});
  });
  flags_.Set(kAf, [&] { return low; });
  flags_.SetResult(result, 8);
}

void Products::SplitDigits() {
  const ValueId al = builder_.ToWidth(registers_.Read(Register::kAl), 32);
  const ValueId tens = builder_.ToWidth(Pure(OpKind::kUnsignedDiv32, {al, builder_.Number(kTen)}), 8);
  const ValueId ones = builder_.ToWidth(Pure(OpKind::kUnsignedRem32, {al, builder_.Number(kTen)}), 8);
  registers_.Write(Register::kAx, Pure(OpKind::kPair16, {ones, tens}));
  flags_.SetResult(ones, 8);
}

void Products::JoinDigits() {
  const ValueId al = builder_.ToWidth(registers_.Read(Register::kAl), 32);
  const ValueId ah = builder_.ToWidth(registers_.Read(Register::kAh), 32);
  const ValueId tens = Pure(OpKind::kMul32, {ah, builder_.Number(kTen)});
  const ValueId result = builder_.ToWidth(Pure(OpKind::kAdd32, {al, tens}), 8);
  registers_.Write(Register::kAx, builder_.ToWidth(result, 16));
  flags_.SetResult(result, 8);
}

}  // namespace plcxx::technol
