#include "transpiler/prove/verify/machine_code/arm_operands.h"

#include <llvm/MC/MCInstrDesc.h>

#include <limits>

#include "transpiler/support/check.h"

namespace plcxx::prove::verify::machine_code {
namespace {

/// In the second operand of an instruction: which shift in the low bits, how far above them (LLVM's encoding).
struct EncodedShift {
  ArmShift shift;
  unsigned count;
  bool extends = false;  // rotates through the carry flag
};

EncodedShift Decode(int64_t encoded) {
  const auto count = static_cast<unsigned>(encoded >> 3);
  switch (encoded & 7) {
    case 1:
      return {ArmShift::kRightSigned, count == 0 ? 32 : count};
    case 2:
      return {ArmShift::kLeft, count};
    case 3:
      return {ArmShift::kRight, count == 0 ? 32 : count};
    case 4:
      return {ArmShift::kRotate, count};
    case 5:
      return {ArmShift::kRotate, 1, true};
    default:  // none
      return {ArmShift::kLeft, 0};
  }
}

}  // namespace

ArmOperands::ArmOperands(FunctionLifter& lifter) : lifter_(lifter), build_(lifter.build()) {
  const llvm::MCInst& inst = lifter.current().inst;
  const llvm::MCInstrDesc& description = lifter.program().machine().Describe(inst);
  bool may_choose = false;
  for (unsigned i = 0; i < inst.getNumOperands(); ++i) {
    const llvm::MCOperand& operand = inst.getOperand(i);
    if (i < description.getNumOperands()) {
      const llvm::MCOperandInfo& info = description.operands()[i];
      if (info.isPredicate()) {
        if (operand.isImm()) condition_ = operand.getImm();
        continue;
      }
      if (info.isOptionalDef()) {
        sets_flags_ = operand.isReg() && operand.getReg() != 0;
        may_choose = true;
        continue;
      }
    }
    operands_.push_back(operand);
  }
  // Those that always do (movs of a register) have no operand that says so.
  for (const llvm::MCPhysReg reg : description.implicit_defs())
    sets_flags_ = sets_flags_ || (!may_choose && lifter.program().machine().RegisterName(reg) == "CPSR");
}

llvm::Value* ArmOperands::Condition() {
  const auto flag = [this](unsigned number) { return lifter_.GetFlag(number); };
  const auto invert = [this](llvm::Value* value) { return build_.CreateNot(value); };
  llvm::Value* condition = nullptr;
  switch (condition_ >> 1) {
    case 0:
      condition = flag(kZero);
      break;
    case 1:
      condition = flag(kCarry);
      break;
    case 2:
      condition = flag(kNegative);
      break;
    case 3:
      condition = flag(kOverflow);
      break;
    case 4:
      condition = build_.CreateAnd(flag(kCarry), invert(flag(kZero)));
      break;
    case 5:
      condition = build_.CreateICmpEQ(flag(kNegative), flag(kOverflow));
      break;
    case 6:
      condition = build_.CreateAnd(build_.CreateICmpEQ(flag(kNegative), flag(kOverflow)), invert(flag(kZero)));
      break;
    default:  // always
      return build_.getTrue();
  }
  return (condition_ & 1) != 0 ? invert(condition) : condition;
}

llvm::Value* ArmOperands::Get(unsigned operand) {
  const unsigned number = RegisterAt(operand);
  if (number != kCounter) return lifter_.Get(number);
  lifter_.Refuse("an address that is relative to the instruction");
  return lifter_.Number(0);
}

Shifted ArmOperands::ShiftBy(llvm::Value* value, ArmShift shift, unsigned count) {
  if (shift == ArmShift::kRotate) count %= 32;
  if ((shift == ArmShift::kRight || shift == ArmShift::kRightSigned) && count == 0) count = 32;
  if (count == 0) return {value, nullptr};
  const auto bit = [&](unsigned number) {
    return build_.CreateTrunc(build_.CreateLShr(value, lifter_.Number(number)), build_.getInt1Ty());
  };
  llvm::Value* by = lifter_.Number(count);
  switch (shift) {
    case ArmShift::kLeft:
      return {build_.CreateShl(value, by), bit(32 - count)};
    case ArmShift::kRight:
      return {count == 32 ? lifter_.Number(0) : build_.CreateLShr(value, by), bit(count - 1)};
    case ArmShift::kRightSigned:
      return {build_.CreateAShr(value, lifter_.Number(count == 32 ? 31 : count)), bit(count - 1)};
    case ArmShift::kRotate:
      return {build_.CreateOr(build_.CreateLShr(value, by), build_.CreateShl(value, lifter_.Number(32 - count))),
              bit(count - 1)};
  }
  PLCXX_UNREACHABLE();
}

/// By the low byte of a register: 32 and more shift everything out.
Shifted ArmOperands::ShiftBy(llvm::Value* value, ArmShift shift, llvm::Value* count) {
  llvm::Type* wide = build_.getInt64Ty();
  llvm::Value* by = build_.CreateZExt(build_.CreateAnd(count, lifter_.Number(0xFF)), wide);
  const auto number = [&](uint64_t n) { return llvm::ConstantInt::get(wide, n); };
  llvm::Value* far = build_.CreateICmpUGT(by, number(32));
  llvm::Value* near = build_.CreateSelect(far, number(33), by);
  llvm::Value* result = nullptr;
  llvm::Value* carry = nullptr;
  if (shift == ArmShift::kLeft) {
    // The last bit that left is bit 32 of the shifted number.
    llvm::Value* shifted = build_.CreateShl(build_.CreateZExt(value, wide), near);
    result = build_.CreateTrunc(shifted, lifter_.Word());
    carry = build_.CreateTrunc(build_.CreateLShr(shifted, 32), build_.getInt1Ty());
  } else if (shift == ArmShift::kRotate) {
    llvm::Value* turn = build_.CreateAnd(by, number(31));
    llvm::Value* twice = build_.CreateZExt(value, wide);
    twice = build_.CreateOr(twice, build_.CreateShl(twice, number(32)));
    result = build_.CreateTrunc(build_.CreateLShr(twice, turn), lifter_.Word());
    carry = build_.CreateTrunc(build_.CreateLShr(result, lifter_.Number(31)), build_.getInt1Ty());
  } else {
    // One bit below: the last one that left.
    llvm::Value* above = shift == ArmShift::kRight ? build_.CreateZExt(value, wide) : build_.CreateSExt(value, wide);
    llvm::Value* doubled = build_.CreateShl(above, number(1));
    llvm::Value* shifted =
        shift == ArmShift::kRight ? build_.CreateLShr(doubled, near) : build_.CreateAShr(doubled, near);
    result = build_.CreateTrunc(build_.CreateLShr(shifted, number(1)), lifter_.Word());
    carry = build_.CreateTrunc(shifted, build_.getInt1Ty());
  }
  llvm::Value* stays = build_.CreateICmpEQ(by, number(0));
  return {result, build_.CreateSelect(stays, lifter_.GetFlag(kCarry), carry)};
}

Shifted ArmOperands::SecondOperand(unsigned operand, unsigned scale) {
  if (IsRegister(operand)) {
    llvm::Value* value = Get(operand);
    if (operand + 1 >= operand_count()) return {value, nullptr};
    const EncodedShift shift = Decode(NumberAt(operand + 1));
    if (!shift.extends) return ShiftBy(value, shift.shift, shift.count);
    llvm::Value* carry = build_.CreateShl(build_.CreateZExt(lifter_.GetFlag(kCarry), lifter_.Word()), 31);
    return {build_.CreateOr(build_.CreateLShr(value, 1), carry), build_.CreateTrunc(value, build_.getInt1Ty())};
  }
  const auto number = static_cast<uint32_t>(NumberAt(operand) * scale);
  // Bytes that are repeated leave the flag; a byte that is moved elsewhere gives its highest bit.
  const uint32_t low = number & 0xFF, second = number >> 8 & 0xFF;
  const bool repeated = number == low || number == (low | low << 16) || number == (second << 8 | second << 24) ||
                        number == (low | low << 8 | low << 16 | low << 24);
  return {lifter_.Number(number), repeated ? nullptr : build_.getInt1((number & 0x80000000) != 0)};
}

llvm::Value* ArmOperands::Offset(unsigned operand, unsigned scale) {
  if (!IsRegister(operand)) {
    constexpr int64_t kMinusZero = std::numeric_limits<int32_t>::min();  // as LLVM says it
    const int64_t number = NumberAt(operand) == kMinusZero ? 0 : NumberAt(operand);
    return lifter_.Number(static_cast<uint64_t>(number * scale));
  }
  llvm::Value* value = Get(operand);
  if (operand + 1 >= operand_count() || NumberAt(operand + 1) == 0) return value;
  return build_.CreateShl(value, lifter_.Number(static_cast<uint64_t>(NumberAt(operand + 1))));
}

void ArmOperands::SetSignAndZero(llvm::Value* result) {
  lifter_.SetFlag(kNegative, build_.CreateICmpSLT(result, lifter_.Number(0)));
  lifter_.SetFlag(kZero, build_.CreateICmpEQ(result, lifter_.Number(0)));
}

/// a + b + carry; a difference is a sum with the complement.
llvm::Value* ArmOperands::AddWithCarry(llvm::Value* a, llvm::Value* b, llvm::Value* carry, bool sets_flags) {
  llvm::Value* sum = build_.CreateAdd(build_.CreateAdd(a, b), build_.CreateZExt(carry, lifter_.Word()));
  if (!sets_flags) return sum;
  llvm::Type* wide = build_.getIntNTy(33);
  llvm::Value* exact = build_.CreateAdd(build_.CreateAdd(build_.CreateZExt(a, wide), build_.CreateZExt(b, wide)),
                                        build_.CreateZExt(carry, wide));
  lifter_.SetFlag(kCarry, build_.CreateTrunc(build_.CreateLShr(exact, 32), build_.getInt1Ty()));
  // Both have one sign, and the sum has the other one.
  llvm::Value* differs = build_.CreateAnd(build_.CreateXor(a, sum), build_.CreateXor(b, sum));
  lifter_.SetFlag(kOverflow, build_.CreateICmpSLT(differs, lifter_.Number(0)));
  SetSignAndZero(sum);
  return sum;
}

llvm::Value* ArmOperands::Combine(ArmOperation operation, llvm::Value* a, const Shifted& b, bool sets_flags) {
  const auto logic = [&](llvm::Value* result) {
    if (sets_flags) {
      SetSignAndZero(result);
      if (b.carry != nullptr) lifter_.SetFlag(kCarry, b.carry);
    }
    return result;
  };
  const auto difference = [&](llvm::Value* from, llvm::Value* less) {
    if (!sets_flags) return build_.CreateSub(from, less);
    // The flags as comparisons, which say the same and read better.
    llvm::Value* result = build_.CreateSub(from, less);
    lifter_.SetFlag(kCarry, build_.CreateICmpUGE(from, less));
    lifter_.SetFlag(kNegative, build_.CreateICmpSLT(result, lifter_.Number(0)));
    lifter_.SetFlag(kZero, build_.CreateICmpEQ(from, less));
    llvm::Value* differs = build_.CreateAnd(build_.CreateXor(from, less), build_.CreateXor(from, result));
    lifter_.SetFlag(kOverflow, build_.CreateICmpSLT(differs, lifter_.Number(0)));
    return result;
  };
  switch (operation) {
    case ArmOperation::kAdd:
      return sets_flags ? AddWithCarry(a, b.value, build_.getFalse(), true) : build_.CreateAdd(a, b.value);
    case ArmOperation::kSub:
      return difference(a, b.value);
    case ArmOperation::kReverseSub:
      return difference(b.value, a);
    case ArmOperation::kAddCarry:
      return AddWithCarry(a, b.value, lifter_.GetFlag(kCarry), sets_flags);
    case ArmOperation::kSubCarry:
      return AddWithCarry(a, build_.CreateNot(b.value), lifter_.GetFlag(kCarry), sets_flags);
    case ArmOperation::kAnd:
      return logic(build_.CreateAnd(a, b.value));
    case ArmOperation::kOr:
      return logic(build_.CreateOr(a, b.value));
    case ArmOperation::kXor:
      return logic(build_.CreateXor(a, b.value));
    case ArmOperation::kAndNot:
      return logic(build_.CreateAnd(a, build_.CreateNot(b.value)));
    case ArmOperation::kOrNot:
      return logic(build_.CreateOr(a, build_.CreateNot(b.value)));
    case ArmOperation::kMove:
      return logic(b.value);
    case ArmOperation::kMoveNot:
      return logic(build_.CreateNot(b.value));
    case ArmOperation::kNegate:
      break;
  }
  PLCXX_UNREACHABLE();
}

}  // namespace plcxx::prove::verify::machine_code
