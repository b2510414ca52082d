// What instructions of ARM's Thumb do (ARMv7-M Architecture Reference Manual, A7.7): those that compute in integers.
#include "transpiler/prove/verify/machine_code/arm_lifter.h"

#include <optional>
#include <string_view>
#include <vector>

namespace plcxx::prove::verify::machine_code {
namespace {

constexpr ArmRow kArmRows[] = {
#define PLCXX_ARM_COMPUTE(NAME, OPERATION, SCALE) \
  {.name = #NAME, .form = ArmForm::kCompute, .operation = ArmOperation::OPERATION, .scale = SCALE},
#define PLCXX_ARM_MOVE(NAME, OPERATION) {.name = #NAME, .form = ArmForm::kMoveTo, .operation = ArmOperation::OPERATION},
#define PLCXX_ARM_COMPARE(NAME, OPERATION) \
  {.name = #NAME, .form = ArmForm::kCompare, .operation = ArmOperation::OPERATION},
#define PLCXX_ARM_SHIFT(NAME, SHIFT) {.name = #NAME, .form = ArmForm::kShift, .shift = ArmShift::SHIFT},
#define PLCXX_ARM_ACCESS(NAME, FORM, BITS, SIGN, SCALE) \
  {.name = #NAME, .form = ArmForm::FORM, .bits = BITS, .has_sign = SIGN, .scale = SCALE},
#define PLCXX_ARM_WIDEN(NAME, FORM, BITS, SIGN) {.name = #NAME, .form = ArmForm::FORM, .bits = BITS, .has_sign = SIGN},
#define PLCXX_ARM_MANY(NAME, FORM) {.name = #NAME, .form = ArmForm::FORM},
#define PLCXX_ARM_OTHER(NAME, FORM) {.name = #NAME, .form = ArmForm::FORM},
#include "transpiler/prove/verify/machine_code/arm.def"
};

const ArmRow* ArmRowOf(std::string_view name) {
  for (const ArmRow& row : kArmRows) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

}  // namespace

/// A write of the program counter is the way back.
void ArmLifter::SetRegister(unsigned number, llvm::Value* value) {
  if (number == kCounter) {
    lifter_.ReturnTo(value);
  } else {
    lifter_.Set(number, value);
  }
}

void ArmLifter::Compute() {
  const bool writes = row_.form == ArmForm::kCompute;
  const unsigned first = writes ? 1 : 0;
  llvm::Value* a = Get(first);
  const Shifted b = SecondOperand(first + 1, row_.scale);
  llvm::Value* result = Combine(row_.operation, a, b, sets_flags() || !writes);
  if (writes) SetRegister(RegisterAt(0), result);
}

void ArmLifter::Move() {
  if (const Link* link = lifter_.LinkAt({llvm::ELF::R_ARM_THM_MOVW_ABS_NC})) {
    const std::optional<Place> place = PlaceOf(*link, static_cast<int16_t>(NumberAt(1)));
    if (!place) return lifter_.Refuse("the address of " + link->symbol);
    return lifter_.Set(RegisterAt(0), lifter_.PartOf(AddressPart::kLow, *place));
  }
  const Shifted b = SecondOperand(1, 1);
  llvm::Value* zero = lifter_.Number(0);
  llvm::Value* result = row_.operation == ArmOperation::kNegate
                            ? Combine(ArmOperation::kReverseSub, b.value, {zero, nullptr}, sets_flags())
                            : Combine(row_.operation, zero, b, sets_flags());
  SetRegister(RegisterAt(0), result);
}

std::optional<Place> ArmLifter::PlaceOf(const Link& link, int64_t addend) {
  if (!link.defined) return std::nullopt;
  return Place{link.defined->section, link.defined->offset + static_cast<uint64_t>(addend)};
}

/// The register must hold the lower half of the same address.
void ArmLifter::MoveTopOf(const Link& link) {
  Link symbol = link;
  symbol.addend = static_cast<int16_t>(NumberAt(2));
  const std::optional<Place> place = PlaceOf(link, symbol.addend);
  llvm::Value* address = place ? lifter_.AddressOf(symbol) : nullptr;
  if (address == nullptr) return lifter_.Refuse("the address of " + link.symbol);
  lifter_.Demand(build_.CreateICmpEQ(Get(1), lifter_.PartOf(AddressPart::kLow, *place)));
  lifter_.Set(RegisterAt(0), address);
}

void ArmLifter::Shift() {
  const Shifted shifted = IsRegister(2) ? ShiftBy(Get(1), row_.shift, Get(2))
                                        : ShiftBy(Get(1), row_.shift, static_cast<unsigned>(NumberAt(2)));
  if (sets_flags()) {
    SetSignAndZero(shifted.value);
    if (shifted.carry != nullptr) lifter_.SetFlag(kCarry, shifted.carry);
  }
  lifter_.Set(RegisterAt(0), shifted.value);
}

/// Into the bits that the instruction's mask leaves out.
void ArmLifter::Insert(llvm::Value* bits) {
  const auto mask = static_cast<uint32_t>(NumberAt(operand_count() - 1));
  const unsigned low = static_cast<unsigned>(__builtin_ctz(~mask));
  llvm::Value* others = build_.CreateAnd(Get(1), lifter_.Number(mask));
  llvm::Value* moved = build_.CreateAnd(build_.CreateShl(bits, lifter_.Number(low)), lifter_.Number(uint32_t(~mask)));
  lifter_.Set(RegisterAt(0), build_.CreateOr(others, moved));
}

llvm::Value* ArmLifter::Widened(llvm::Value* value, llvm::Type* type) {
  return row_.has_sign ? build_.CreateSExt(value, type) : build_.CreateZExt(value, type);
}

void ArmLifter::TakeBits() {
  const auto low = static_cast<unsigned>(NumberAt(2)), width = static_cast<unsigned>(NumberAt(3)) + 1;
  llvm::Value* top = build_.CreateShl(Get(1), lifter_.Number(32 - low - width));
  llvm::Value* count = lifter_.Number(32 - width);
  lifter_.Set(RegisterAt(0), row_.has_sign ? build_.CreateAShr(top, count) : build_.CreateLShr(top, count));
}

llvm::Value* ArmLifter::Extended(unsigned operand) {
  llvm::Value* value = Get(operand);
  if (operand_count() > operand + 1 && NumberAt(operand + 1) != 0)
    value = ShiftBy(value, ArmShift::kRotate, static_cast<unsigned>(8 * NumberAt(operand + 1))).value;
  return Widened(build_.CreateTrunc(value, build_.getIntNTy(row_.bits)), lifter_.Word());
}

void ArmLifter::MultiplyLong() {
  llvm::Type* wide = build_.getInt64Ty();
  llvm::Value* a = Widened(Get(2), wide);
  llvm::Value* product = build_.CreateMul(a, Widened(Get(3), wide));
  lifter_.Set(RegisterAt(0), build_.CreateTrunc(product, lifter_.Word()));
  lifter_.Set(RegisterAt(1), build_.CreateTrunc(build_.CreateLShr(product, 32), lifter_.Word()));
}

void ArmLifter::MultiplyHalves() {
  const auto half = [&](unsigned operand) {
    return build_.CreateSExt(build_.CreateTrunc(Get(operand), build_.getInt16Ty()), lifter_.Word());
  };
  llvm::Value* a = half(1);
  lifter_.Set(RegisterAt(0), build_.CreateMul(a, half(2)));
}

void ArmLifter::MoveTop() {
  if (const Link* link = lifter_.LinkAt({llvm::ELF::R_ARM_THM_MOVT_ABS})) return MoveTopOf(*link);
  lifter_.Set(RegisterAt(0), build_.CreateOr(build_.CreateAnd(Get(1), lifter_.Number(0xFFFF)),
                                             lifter_.Number(static_cast<uint64_t>(NumberAt(2)) << 16)));
}

/// A function of LLVM's, of the first operand and of what else it takes.
void ArmLifter::Apply(llvm::Intrinsic::ID id, std::vector<llvm::Value*> more) {
  std::vector<llvm::Value*> arguments = {Get(1)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  llvm::Function* function = llvm::Intrinsic::getDeclaration(&lifter_.program().module(), id, {lifter_.Word()});
  lifter_.Set(RegisterAt(0), build_.CreateCall(function, arguments));
}

const Link* ArmLifter::Callee(const Link* link) {
  // Without a note's own addend it is in the instruction: one that leads to the instruction itself adds nothing.
  const bool whole = lifter_.current().target == lifter_.current().address && link->addend == 0;
  if (!whole) lifter_.Refuse("a jump into the middle of a function");
  return whole ? link : nullptr;
}

void ArmLifter::Jump() {
  const Link* link = lifter_.LinkAt({llvm::ELF::R_ARM_THM_JUMP24, llvm::ELF::R_ARM_THM_JUMP11});
  if (link != nullptr) {
    if (const Link* callee = Callee(link)) lifter_.TailCall(*callee);
  } else if (lifter_.current().target) {
    lifter_.JumpTo(*lifter_.current().target);
  } else {
    lifter_.Refuse("a jump that does not say where");
  }
}

void ArmLifter::Branch(llvm::Value* condition) {
  if (const Link* link = lifter_.LinkAt({llvm::ELF::R_ARM_THM_JUMP19})) {
    lifter_.BeginGuard(condition);
    if (const Link* callee = Callee(link)) lifter_.TailCall(*callee);
    lifter_.EndGuard();
  } else if (lifter_.current().target) {
    lifter_.BranchIf(condition, *lifter_.current().target);
  } else {
    lifter_.Refuse("a branch that does not say where");
  }
}

void ArmLifter::Run() {
  switch (row_.form) {
    case ArmForm::kCompute:
    case ArmForm::kCompare:
      return Compute();
    case ArmForm::kMoveTo:
      return Move();
    case ArmForm::kShift:
      return Shift();
    case ArmForm::kLoad:
    case ArmForm::kStore:
    case ArmForm::kLoadPre:
    case ArmForm::kLoadPost:
    case ArmForm::kStorePre:
    case ArmForm::kStorePost:
      return Access();
    case ArmForm::kLoadPair:
    case ArmForm::kLoadPairPre:
    case ArmForm::kLoadPairPost:
    case ArmForm::kStorePair:
    case ArmForm::kStorePairPre:
    case ArmForm::kStorePairPost:
      return AccessPair();
    case ArmForm::kPush:
    case ArmForm::kPop:
    case ArmForm::kStoreDown:
    case ArmForm::kLoadUp:
    case ArmForm::kStoreUp:
    case ArmForm::kStoreFrom:
    case ArmForm::kLoadFrom:
    case ArmForm::kLoadUpNarrow:
      return AccessMany();
    case ArmForm::kLoadConstant:
      return LoadConstant();
    case ArmForm::kMoveTop:
      return MoveTop();
    case ArmForm::kBits:
      return TakeBits();
    case ArmForm::kInsert:
      return Insert(Get(2));
    case ArmForm::kClear:
      return Insert(lifter_.Number(0));
    case ArmForm::kExtend:
      return lifter_.Set(RegisterAt(0), Extended(1));
    case ArmForm::kAddExtended: {
      llvm::Value* extended = Extended(2);
      return lifter_.Set(RegisterAt(0), build_.CreateAdd(Get(1), extended));
    }
    case ArmForm::kLeadingZeros:
      return Apply(llvm::Intrinsic::ctlz, {build_.getFalse()});
    case ArmForm::kReverse:
      return Apply(llvm::Intrinsic::bswap, {});
    case ArmForm::kMul: {
      llvm::Value* product = build_.CreateMul(Get(1), Get(2));
      if (sets_flags()) SetSignAndZero(product);
      lifter_.Set(RegisterAt(0), product);
      return;
    }
    case ArmForm::kMulAdd:
      lifter_.Set(RegisterAt(0), build_.CreateAdd(Get(3), build_.CreateMul(Get(1), Get(2))));
      return;
    case ArmForm::kMulSub:
      lifter_.Set(RegisterAt(0), build_.CreateSub(Get(3), build_.CreateMul(Get(1), Get(2))));
      return;
    case ArmForm::kMulLong:
      return MultiplyLong();
    case ArmForm::kMulHalves:
      return MultiplyHalves();
    // By 0 it is 0, where the processor does not trap.
    case ArmForm::kDiv:
      return lifter_.Set(RegisterAt(0), lifter_.Divide(Get(1), Get(2), llvm::Instruction::UDiv, lifter_.Number(0)));
    case ArmForm::kDivSigned:
      return lifter_.Set(RegisterAt(0), lifter_.Divide(Get(1), Get(2), llvm::Instruction::SDiv, lifter_.Number(0)));
    case ArmForm::kJump:
      return Jump();
    case ArmForm::kBranch:
      return Branch(Condition());
    case ArmForm::kBranchZero:
      return Branch(build_.CreateICmpEQ(Get(0), lifter_.Number(0)));
    case ArmForm::kBranchNotZero:
      return Branch(build_.CreateICmpNE(Get(0), lifter_.Number(0)));
    case ArmForm::kCall:
      if (const Link* link = lifter_.LinkAt({llvm::ELF::R_ARM_THM_CALL})) {
        if (const Link* callee = Callee(link)) lifter_.Call(*callee);
        return;
      }
      return lifter_.Refuse("a call that no note of the linker tells of");
    case ArmForm::kReturn:
      return lifter_.ReturnTo(Get(0));
    case ArmForm::kHint:
      if (NumberAt(0) != 0) lifter_.Refuse("an instruction that waits or signals");
      return;
    case ArmForm::kNothing:
      return;
  }
}

void LiftArm(FunctionLifter& lifter) {
  const llvm::StringRef name = lifter.program().machine().OpcodeName(lifter.current().inst);
  const ArmRow* row = ArmRowOf(std::string_view(name));
  if (row == nullptr) {
    lifter.Refuse("instruction '" + name.str() + "'");
    return;
  }
  ArmLifter arm(lifter, *row);
  const bool guarded = row->form != ArmForm::kBranch && arm.is_conditional();
  // Who jumps into the instructions under an IT executes them without a condition.
  if (guarded && lifter.IsBranchTarget()) lifter.Refuse("a jump into instructions under a condition");
  if (guarded) lifter.BeginGuard(arm.Condition());
  arm.Run();
  if (guarded) lifter.EndGuard();
}

}  // namespace plcxx::prove::verify::machine_code
