// The functional modules of dialect prostep (6.9).
#include <cstdint>
#include <limits>

#include "tests/reference/prostep.h"

namespace plcxx::reference {

using prostep::Function;
using prostep::OperandClass;
using prostep::Shape;
using prostep::Space;

namespace {

int64_t Signed(uint32_t value) { return static_cast<int32_t>(value); }

struct LongResult {
  Function function;
  uint32_t (*of)(uint32_t a, uint32_t b);
};
constexpr LongResult kLongResults[] = {
    {Function::kAddLong, [](uint32_t a, uint32_t b) { return a + b; }},
    {Function::kSubtractLong, [](uint32_t a, uint32_t b) { return a - b; }},
    {Function::kAndLong, [](uint32_t a, uint32_t b) { return a & b; }},
    {Function::kOrLong, [](uint32_t a, uint32_t b) { return a | b; }},
    {Function::kXorLong, [](uint32_t a, uint32_t b) { return a ^ b; }},
    {Function::kMoveLong, [](uint32_t a, uint32_t) { return a; }},
    {Function::kNegateLong, [](uint32_t a, uint32_t) { return 0 - a; }},
    {Function::kComplementLong, [](uint32_t a, uint32_t) { return ~a; }},
    {Function::kIncrementLong, [](uint32_t a, uint32_t) { return a + 1; }},
    {Function::kDecrementLong, [](uint32_t a, uint32_t) { return a - 1; }},
};

struct LongComparison {
  Function function;
  bool (*holds)(uint32_t a, uint32_t b);
};
constexpr LongComparison kLongComparisons[] = {
    {Function::kEqualLong, [](uint32_t a, uint32_t b) { return a == b; }},
    {Function::kGreaterEqualUnsigned, [](uint32_t a, uint32_t b) { return a >= b; }},
    {Function::kGreaterUnsigned, [](uint32_t a, uint32_t b) { return a > b; }},
    {Function::kLessEqualUnsigned, [](uint32_t a, uint32_t b) { return a <= b; }},
    {Function::kLessUnsigned, [](uint32_t a, uint32_t b) { return a < b; }},
    {Function::kGreaterEqualSigned, [](uint32_t a, uint32_t b) { return Signed(a) >= Signed(b); }},
    {Function::kGreaterSigned, [](uint32_t a, uint32_t b) { return Signed(a) > Signed(b); }},
    {Function::kLessEqualSigned, [](uint32_t a, uint32_t b) { return Signed(a) <= Signed(b); }},
    {Function::kLessSigned, [](uint32_t a, uint32_t b) { return Signed(a) < Signed(b); }},
};

}  // namespace

/// byte class: zero-extended; word class and K: signed (D34).
int32_t ProstepReference::Val(const prostep::Operand& operand) {
  const uint16_t raw = ReadData(operand);
  return operand.shape() == Shape::kByte ? raw : static_cast<int16_t>(raw);
}

uint64_t ProstepReference::ReadField(const prostep::Operand& operand, uint32_t bytes) {
  uint64_t value = 0;
  for (uint32_t k = 0; k < bytes; ++k) {
    value |= static_cast<uint64_t>(Byte(operand.space(), operand.number + k)) << (8 * k);
  }
  return value;
}

void ProstepReference::WriteField(const prostep::Operand& operand, uint32_t offset, uint32_t bytes, uint64_t value) {
  for (uint32_t k = 0; k < bytes; ++k) {
    PutByte(operand.space(), operand.number + offset + k, static_cast<uint8_t>(value >> (8 * k)));
  }
}

void ProstepReference::Perform(const prostep::Instruction& instruction) {
  const Function function = *instruction.function;
  if (function <= Function::kDecrement) {
    PerformWord(instruction);
  } else if (function <= Function::kWriteWord) {
    PerformIndirect(instruction);
  } else if (function <= Function::kNcWriteLong) {
    PerformNc(instruction);
  } else {
    PerformLong(instruction);
  }
}

/// FM 0 to FM 14.
void ProstepReference::PerformWord(const prostep::Instruction& instruction) {
  const auto argument = [&](uint32_t index) -> const prostep::Operand& {
    return program_.Argument(instruction, index);
  };
  const bool is_unsigned = settings_.muldiv == prostep::MulDiv::kUnsigned;
  // FM 2 and 3: words and constants by muldiv, bytes always zero-extended.
  const auto factor = [&](const prostep::Operand& operand) -> int64_t {
    return is_unsigned ? static_cast<int64_t>(ReadData(operand)) : Val(operand);
  };
  const Function function = *instruction.function;
  if (function == Function::kAdd || function == Function::kSubtract) {
    const int32_t a = Val(argument(0));
    const int32_t b = Val(argument(1));
    WriteData(argument(2), static_cast<uint16_t>(function == Function::kAdd ? a + b : a - b));
  } else if (function == Function::kMultiply) {
    const int64_t a = factor(argument(0));
    const int64_t b = factor(argument(1));
    WriteField(argument(2), 0, 4, static_cast<uint64_t>(a * b));
  } else if (function == Function::kDivide) {
    int64_t a = 0;
    if (argument(0).kind == OperandClass::kK) {
      a = factor(argument(0));
    } else {
      const uint32_t raw = static_cast<uint32_t>(ReadField(argument(0), 4));
      a = is_unsigned ? static_cast<int64_t>(raw) : static_cast<int32_t>(raw);
    }
    const int64_t b = factor(argument(1));
    if (b == 0) {
      Fault(ProstepFault::kDivZero);
      return;
    }
    const int64_t least = is_unsigned ? 0 : -32'768;
    const int64_t greatest = is_unsigned ? 65'535 : 32'767;
    if (a / b < least || a / b > greatest) {
      Fault(ProstepFault::kDivOverflow);
      return;
    }
    WriteField(argument(2), 0, 2, static_cast<uint64_t>(a / b));
    WriteField(argument(2), 2, 2, static_cast<uint64_t>(a % b));
  } else if (function == Function::kToBcd) {
    s_ = ax_ > 9999;
    if (!s_) ax_ = static_cast<uint16_t>(ax_ / 1000 << 12 | ax_ / 100 % 10 << 8 | ax_ / 10 % 10 << 4 | ax_ % 10);
  } else if (function == Function::kFromBcd) {
    ax_ = static_cast<uint16_t>((ax_ >> 12) * 1000 + (ax_ >> 8 & 15) * 100 + (ax_ >> 4 & 15) * 10 + (ax_ & 15));
  } else if (function == Function::kShiftLeft || function == Function::kShiftRight) {
    const uint32_t n = ReadData(argument(0));
    const uint32_t shifted = n >= 16 ? 0 : function == Function::kShiftLeft ? uint32_t{ax_} << n : uint32_t{ax_} >> n;
    ax_ = static_cast<uint16_t>(shifted);
  } else if (function == Function::kBitAnd || function == Function::kBitOr || function == Function::kBitXor) {
    uint32_t value = ReadData(argument(0));
    const bool narrow = argument(0).shape() == Shape::kByte;  // AL only (D39)
    if (narrow && function == Function::kBitAnd) value |= 0xFF00;
    ax_ = static_cast<uint16_t>(function == Function::kBitAnd  ? ax_ & value
                                : function == Function::kBitOr ? ax_ | value
                                                               : ax_ ^ value);
  } else if (function == Function::kNegate) {
    ax_ = static_cast<uint16_t>(-ax_);
  } else if (function == Function::kComplement) {
    ax_ = static_cast<uint16_t>(~ax_);
  } else {
    ax_ = static_cast<uint16_t>(function == Function::kIncrement ? ax_ + 1 : ax_ - 1);
  }
}

/// FM 15 to FM 18.
void ProstepReference::PerformIndirect(const prostep::Instruction& instruction) {
  const prostep::Operand& base = program_.Argument(instruction, 0);
  const int32_t at = base.number + Val(program_.Argument(instruction, 1));
  const Function function = *instruction.function;
  const bool word = function == Function::kReadWord || function == Function::kWriteWord;
  const bool reads = function == Function::kReadByte || function == Function::kReadWord;
  const int32_t last = (base.space() == Space::kD ? 999 : 255) - (word ? 1 : 0);
  const bool inside = at >= 0 && at <= last;
  if (!inside) Fault(ProstepFault::kIndex);
  if (reads) {
    uint32_t value = 0;
    if (inside) value = ReadByte(base.space(), static_cast<uint32_t>(at));
    if (inside && word) value |= static_cast<uint32_t>(ReadByte(base.space(), static_cast<uint32_t>(at) + 1)) << 8;
    ax_ = static_cast<uint16_t>(word ? value : (ax_ & 0xFF00U) | value);
  } else if (inside) {
    WriteByte(base.space(), static_cast<uint32_t>(at), static_cast<uint8_t>(ax_));
    if (word) WriteByte(base.space(), static_cast<uint32_t>(at) + 1, static_cast<uint8_t>(ax_ >> 8));
  }
}

/// FM 41, 42, 44, 51, 52, 54.
void ProstepReference::PerformNc(const prostep::Instruction& instruction) {
  const Function function = *instruction.function;
  const bool reads = function <= Function::kNcReadLong;
  const uint32_t width = function == Function::kNcReadByte || function == Function::kNcWriteByte   ? 1
                         : function == Function::kNcReadWord || function == Function::kNcWriteWord ? 2
                                                                                                   : 4;
  const prostep::Operand& field = program_.Argument(instruction, reads ? 2 : 0);
  const uint64_t source = reads ? 0 : ReadField(field, width);
  const uint64_t index = ReadData(program_.Argument(instruction, reads ? 0 : 1));
  const uint64_t offset = ReadData(program_.Argument(instruction, reads ? 1 : 2));
  const Answer answer =
      reads ? Call("nc_read", {width, index, offset}) : Call("nc_write", {width, index, offset, source});
  if (answer.result == 0) {
    Fault(ProstepFault::kNcAccess);
  } else if (reads) {
    WriteField(field, 0, width, answer.out.value_or(0));
  }
}

/// FM 60 to FM 88, FM 30 to FM 34.
void ProstepReference::PerformLong(const prostep::Instruction& instruction) {
  const uint32_t count = instruction.arguments.count;
  for (uint32_t k = 0; k < count; ++k) {
    if (program_.Argument(instruction, k).kind != OperandClass::kK) continue;
    s_ = true;  // D44
    return;
  }
  const Function function = *instruction.function;
  const bool is_unsigned = settings_.muldiv == prostep::MulDiv::kUnsigned;
  const prostep::Operand& last = program_.Argument(instruction, count - 1);
  const uint32_t a = static_cast<uint32_t>(ReadField(program_.Argument(instruction, 0), 4));
  const uint32_t b = count < 2 ? 0 : static_cast<uint32_t>(ReadField(program_.Argument(instruction, 1), 4));
  if (function == Function::kMultiplyLong) {
    const uint64_t product = is_unsigned ? uint64_t{a} * b : static_cast<uint64_t>(Signed(a) * Signed(b));
    WriteField(last, 0, 8, product);
    s_ = product == 0;  // D76
    return;
  }
  if (function == Function::kDivideLong) {
    const int64_t x = is_unsigned ? int64_t{a} : Signed(a);
    const int64_t y = is_unsigned ? int64_t{b} : Signed(b);
    s_ = y == 0 || (!is_unsigned && x / y > std::numeric_limits<int32_t>::max());
    if (s_) return;
    WriteField(last, 0, 4, static_cast<uint64_t>(x / y));
    WriteField(last, 4, 4, static_cast<uint64_t>(x % y));
    return;
  }
  for (const LongComparison& row : kLongComparisons) {
    if (row.function == function) s_ = row.holds(a, b);
  }
  for (const LongResult& row : kLongResults) {
    if (row.function != function) continue;
    const uint32_t result = row.of(a, b);
    WriteField(last, 0, 4, result);
    s_ = result == 0;
  }
}

}  // namespace plcxx::reference
