#include "transpiler/dialects/technol/lowering/assembler.h"

#include "transpiler/dialects/technol/lowering/arithmetic.h"
#include "transpiler/dialects/technol/lowering/flags.h"
#include "transpiler/dialects/technol/lowering/jumps.h"
#include "transpiler/dialects/technol/lowering/moves.h"
#include "transpiler/dialects/technol/lowering/products.h"
#include "transpiler/dialects/technol/lowering/shifts.h"
#include "transpiler/support/check.h"

namespace plcxx::technol {

void Assembler::Lower(const Instruction& instruction) {
  using Sum = Arithmetic::Sum;
  using Logic = Arithmetic::Logic;
  using Step = Arithmetic::Step;
  using Kind = Shifts::Kind;
  using Signedness = Products::Signedness;
  using Adjusted = Products::Adjusted;
  switch (instruction.op) {
    case Op::kMov:
      return moves_.Move(instruction);
    case Op::kAdd:
      return arithmetic_.AddOrSubtract(instruction, Sum::kAdd);
    case Op::kAdc:
      return arithmetic_.AddOrSubtract(instruction, Sum::kAddWithCarry);
    case Op::kSub:
      return arithmetic_.AddOrSubtract(instruction, Sum::kSubtract);
    case Op::kSbb:
      return arithmetic_.AddOrSubtract(instruction, Sum::kSubtractWithBorrow);
    case Op::kCmp:
      return arithmetic_.AddOrSubtract(instruction, Sum::kCompare);
    case Op::kAsmAnd:
      return arithmetic_.Combine(instruction, Logic::kAnd);
    case Op::kAsmOr:
      return arithmetic_.Combine(instruction, Logic::kOr);
    case Op::kAsmXor:
      return arithmetic_.Combine(instruction, Logic::kXor);
    case Op::kTest:
      return arithmetic_.Combine(instruction, Logic::kTest);
    case Op::kInc:
      return arithmetic_.Count(instruction, Step::kUp);
    case Op::kDec:
      return arithmetic_.Count(instruction, Step::kDown);
    case Op::kNeg:
      return arithmetic_.Negate(instruction);
    case Op::kNot:
      return arithmetic_.Invert(instruction);
    case Op::kShl:
      return shifts_.Shift(instruction, Kind::kLeft);
    case Op::kShr:
      return shifts_.Shift(instruction, Kind::kRight);
    case Op::kSar:
      return shifts_.Shift(instruction, Kind::kArithmeticRight);
    case Op::kRol:
      return shifts_.Rotate(instruction, Turn::kLeft);
    case Op::kRor:
      return shifts_.Rotate(instruction, Turn::kRight);
    case Op::kRcl:
      return shifts_.RotateWithCarry(instruction, Turn::kLeft);
    case Op::kRcr:
      return shifts_.RotateWithCarry(instruction, Turn::kRight);
    case Op::kMul:
      return products_.Multiply(instruction, Signedness::kUnsigned);
    case Op::kImul:
      return products_.Multiply(instruction, Signedness::kSigned);
    case Op::kDiv:
      return products_.Divide(instruction, Signedness::kUnsigned);
    case Op::kIdiv:
      return products_.Divide(instruction, Signedness::kSigned);
    case Op::kDaa:
      return products_.AdjustDecimal(Adjusted::kSum);
    case Op::kDas:
      return products_.AdjustDecimal(Adjusted::kDifference);
    case Op::kAam:
      return products_.SplitDigits();
    case Op::kAad:
      return products_.JoinDigits();
    case Op::kPush:
      return moves_.Push(instruction);
    case Op::kPop:
      return moves_.Pop(instruction);
    case Op::kMovzx:
      return moves_.ZeroExtend(instruction);
    case Op::kMovsx:
      return moves_.SignExtend(instruction);
    case Op::kXchg:
      return moves_.Exchange(instruction);
    case Op::kCbw:
      return moves_.ByteToWord();
    case Op::kCwd:
      return moves_.WordToPair();
    case Op::kCwde:
      return moves_.WordToDouble();
    case Op::kCdq:
      return moves_.DoubleToPair();
    case Op::kClc:
      return flags_.Set(kCf, [&] { return builder_.Bit(0); });
    case Op::kStc:
      return flags_.Set(kCf, [&] { return builder_.Bit(1); });
    case Op::kCmc: {
      const ir::ValueId carry = flags_.Value(kCf);
      return flags_.Set(kCf, [&] { return builder_.Not(carry); });
    }
    case Op::kNop:
      return;
    case Op::kJmp:
      registers_.Spill();
      return jumps_.Always(instruction);
    case Op::kLoop:
      return jumps_.IfCounting(instruction);
    case Op::kJcxz:
      return jumps_.IfCxIsZero(instruction);
    case Op::kJe:
      return jumps_.If(instruction, Relation::kEqual);
    case Op::kJne:
      return jumps_.If(instruction, Relation::kNotEqual);
    case Op::kJc:
      return jumps_.If(instruction, Relation::kBelow);
    case Op::kJnc:
      return jumps_.If(instruction, Relation::kNotBelow);
    case Op::kJa:
      return jumps_.If(instruction, Relation::kAbove);
    case Op::kJbe:
      return jumps_.If(instruction, Relation::kBelowOrEqual);
    case Op::kJg:
      return jumps_.If(instruction, Relation::kGreater);
    case Op::kJge:
      return jumps_.If(instruction, Relation::kNotLess);
    case Op::kJl:
      return jumps_.If(instruction, Relation::kLess);
    case Op::kJle:
      return jumps_.If(instruction, Relation::kLessOrEqual);
    case Op::kJs:
      return jumps_.IfFlag(instruction, kSf);
    case Op::kJns:
      return jumps_.IfNotFlag(instruction, kSf);
    case Op::kJo:
      return jumps_.IfFlag(instruction, kOf);
    case Op::kJno:
      return jumps_.IfNotFlag(instruction, kOf);
      // TECHNOL's own instructions, and marks
#define TECHNOL_ASSEMBLER(...)
#define TECHNOL_INSTRUCTION(Key, ...) case Op::k##Key:
#include "transpiler/dialects/technol/machine/machine.def"
    case Op::kMechanismBegin:
    case Op::kMechanismEnd:
    case Op::kModuleEnd:
    case Op::kAreaEnd:
    case Op::kUnknown:
      PLCXX_UNREACHABLE();
  }
}

}  // namespace plcxx::technol
