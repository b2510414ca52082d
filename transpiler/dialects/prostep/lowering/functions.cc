#include "transpiler/dialects/prostep/lowering/functions.h"

#include "transpiler/dialects/common/register.h"
#include "transpiler/dialects/prostep/lowering/arithmetic.h"
#include "transpiler/dialects/prostep/lowering/indirect_access.h"
#include "transpiler/dialects/prostep/lowering/logic.h"
#include "transpiler/dialects/prostep/lowering/long_words.h"
#include "transpiler/dialects/prostep/lowering/nc_variables.h"
#include "transpiler/dialects/prostep/lowering/registers.h"
#include "transpiler/support/check.h"

namespace plcxx::prostep {

namespace {

using ir::OpKind;
using ir::ValueId;

enum class Changes : uint8_t { kNone, kUsesAx, kSetsAx, kSetsS, kSetsBoth };

/// What a functional module does to S and AX.
Changes ChangesOf(Function function) {
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
      return Changes::kNone;
    case Function::kWriteByte:
    case Function::kWriteWord:
      return Changes::kUsesAx;
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
      return Changes::kSetsAx;
    case Function::kToBcd:
      return Changes::kSetsBoth;
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
      return Changes::kSetsS;
  }
  PLCXX_UNREACHABLE();
}

}  // namespace

/// What is loaded inside would not be known after it; what is set inside goes through its place.
void Functions::PerformIf(const Instruction& instruction) {
  const Changes changes = ChangesOf(*instruction.function);
  const bool sets_s = changes == Changes::kSetsS || changes == Changes::kSetsBoth;
  const bool sets_ax = changes == Changes::kSetsAx || changes == Changes::kSetsBoth;
  const ir::ValueId condition = logic_.Value();
  dialects::Register &s = registers_.s(), &ax = registers_.ax();
  if (changes != Changes::kNone) ax.Get();
  if (sets_s) s.Spill();
  if (sets_ax) ax.Spill();
  builder_.When(condition, [&] {
    Perform(instruction);
    if (sets_s) s.Spill();
    if (sets_ax) ax.Spill();
  });
  if (sets_s) s.Forget();
  if (sets_ax) ax.Forget();
}

bool Functions::IsDisabled(const Instruction& instruction) const {
  const FunctionInfo& info = Info(*instruction.function);
  for (uint32_t i = 0; i < info.count; ++i) {
    const bool constant = Argument(instruction, i).shape() == Shape::kConstant;
    if (constant && Info(info.arguments[i]).constant == Constant::kDisables) return true;
  }
  return false;
}

void Functions::Perform(const Instruction& instruction) {
  if (IsDisabled(instruction)) return registers_.s().Set(builder_.Bit(1));
  dialects::Register& ax = registers_.ax();
  const auto on_ax = [&](OpKind op, ValueId right) { ax.Set(Pure(op, {ax.Get(), right})); };
  switch (*instruction.function) {
    case Function::kAdd:
      return arithmetic_.AddOrSubtract(instruction, OpKind::kAdd8, OpKind::kAdd16);
    case Function::kSubtract:
      return arithmetic_.AddOrSubtract(instruction, OpKind::kSub8, OpKind::kSub16);
    case Function::kMultiply:
      return arithmetic_.Multiply(instruction);
    case Function::kDivide:
      return arithmetic_.Divide(instruction);
    case Function::kToBcd:
      return arithmetic_.ToBcd();
    case Function::kFromBcd:
      return ax.Set(Pure(OpKind::kFromBcd16, {ax.Get()}));
    case Function::kShiftLeft:
      return arithmetic_.Shift(instruction, OpKind::kShiftLeft16);
    case Function::kShiftRight:
      return arithmetic_.Shift(instruction, OpKind::kShiftRight16);
    case Function::kBitAnd:
      return arithmetic_.Bitwise(instruction, OpKind::kAnd8, OpKind::kAnd16);
    case Function::kBitOr:
      return arithmetic_.Bitwise(instruction, OpKind::kOr8, OpKind::kOr16);
    case Function::kBitXor:
      return arithmetic_.Bitwise(instruction, OpKind::kXor8, OpKind::kXor16);
    case Function::kNegate:
      return ax.Set(Pure(OpKind::kSub16, {Word(0), ax.Get()}));
    case Function::kComplement:
      return ax.Set(Pure(OpKind::kNot16, {ax.Get()}));
    case Function::kIncrement:
      return on_ax(OpKind::kAdd16, Word(1));
    case Function::kDecrement:
      return on_ax(OpKind::kSub16, Word(1));
    case Function::kReadByte:
      return indirect_.Read(instruction, ir::Type::kI8);
    case Function::kReadWord:
      return indirect_.Read(instruction, ir::Type::kI16);
    case Function::kWriteByte:
      return indirect_.Write(instruction, ir::Type::kI8);
    case Function::kWriteWord:
      return indirect_.Write(instruction, ir::Type::kI16);
    case Function::kNcReadByte:
      return nc_.Read(instruction, ir::Type::kI8);
    case Function::kNcReadWord:
      return nc_.Read(instruction, ir::Type::kI16);
    case Function::kNcReadLong:
      return nc_.Read(instruction, ir::Type::kI32);
    case Function::kNcWriteByte:
      return nc_.Write(instruction, ir::Type::kI8);
    case Function::kNcWriteWord:
      return nc_.Write(instruction, ir::Type::kI16);
    case Function::kNcWriteLong:
      return nc_.Write(instruction, ir::Type::kI32);
    case Function::kAddLong:
      return long_words_.Combine(instruction, OpKind::kAdd32);
    case Function::kSubtractLong:
      return long_words_.Combine(instruction, OpKind::kSub32);
    case Function::kMultiplyLong:
      return long_words_.Multiply(instruction);
    case Function::kDivideLong:
      return long_words_.Divide(instruction);
    case Function::kAndLong:
      return long_words_.Combine(instruction, OpKind::kAnd32);
    case Function::kOrLong:
      return long_words_.Combine(instruction, OpKind::kOr32);
    case Function::kXorLong:
      return long_words_.Combine(instruction, OpKind::kXor32);
    case Function::kMoveLong:
      return long_words_.Move(instruction);
    case Function::kNegateLong:
      return long_words_.Negate(instruction);
    case Function::kComplementLong:
      return long_words_.Complement(instruction);
    case Function::kIncrementLong:
      return long_words_.Increment(instruction);
    case Function::kDecrementLong:
      return long_words_.Decrement(instruction);
    case Function::kEqualLong:
      return long_words_.Compare(instruction, OpKind::kEqual32);
    case Function::kGreaterEqualUnsigned:
      return long_words_.Compare(instruction, OpKind::kGreaterEqual32);
    case Function::kGreaterUnsigned:
      return long_words_.Compare(instruction, OpKind::kGreater32);
    case Function::kLessEqualUnsigned:
      return long_words_.Compare(instruction, OpKind::kLessEqual32);
    case Function::kLessUnsigned:
      return long_words_.Compare(instruction, OpKind::kLess32);
    case Function::kGreaterEqualSigned:
      return long_words_.Compare(instruction, OpKind::kSignedGreaterEqual32);
    case Function::kGreaterSigned:
      return long_words_.Compare(instruction, OpKind::kSignedGreater32);
    case Function::kLessEqualSigned:
      return long_words_.Compare(instruction, OpKind::kSignedLessEqual32);
    case Function::kLessSigned:
      return long_words_.Compare(instruction, OpKind::kSignedLess32);
  }
}

}  // namespace plcxx::prostep
