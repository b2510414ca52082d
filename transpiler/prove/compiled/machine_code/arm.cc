// What instructions of ARM's Thumb do (ARMv7-M Architecture Reference Manual, A7.7): those that compute in integers.
#include "transpiler/prove/compiled/machine_code/arm_operands.h"
#include "transpiler/support/check.h"

#include <llvm/IR/Intrinsics.h>

#include <string_view>
#include <utility>

namespace plcxx::prove::compiled::machine_code {
namespace {

enum class ArmForm : uint8_t {
  kCompute,
  kMoveTo,
  kCompare,
  kShift,
  kLoad,
  kStore,
  kLoadPre,
  kLoadPost,
  kStorePre,
  kStorePost,
  kLoadPair,
  kLoadPairPre,
  kLoadPairPost,
  kStorePair,
  kStorePairPre,
  kStorePairPost,
  kPush,
  kPop,
  kStoreDown,
  kLoadUp,
  kStoreUp,
  kStoreFrom,
  kLoadFrom,
  kLoadUpNarrow,
  kLoadConstant,
  kMoveTop,
  kBits,
  kBitsSigned,
  kInsert,
  kClear,
  kUnsignedByte,
  kUnsignedHalf,
  kSignedByte,
  kSignedHalf,
  kAddUnsignedByte,
  kAddUnsignedHalf,
  kAddSignedByte,
  kAddSignedHalf,
  kLeadingZeros,
  kReverse,
  kMul,
  kMulAdd,
  kMulSub,
  kMulLong,
  kMulLongSigned,
  kMulHalves,
  kDiv,
  kDivSigned,
  kJump,
  kBranch,
  kBranchZero,
  kBranchNotZero,
  kCall,
  kReturn,
  kNothing
};

struct ArmRow {
  std::string_view name;
  ArmForm form{};
  ArmOperation operation{};
  ArmShift shift{};
  unsigned bits = 32;
  bool has_sign = false;
  unsigned scale = 1;
};

constexpr ArmRow kArmRows[] = {
#define PLCXX_ARM_COMPUTE(NAME, OPERATION, SCALE) \
  {.name = #NAME, .form = ArmForm::kCompute, .operation = ArmOperation::OPERATION, .scale = SCALE},
#define PLCXX_ARM_MOVE(NAME, OPERATION) {.name = #NAME, .form = ArmForm::kMoveTo, .operation = ArmOperation::OPERATION},
#define PLCXX_ARM_COMPARE(NAME, OPERATION) \
  {.name = #NAME, .form = ArmForm::kCompare, .operation = ArmOperation::OPERATION},
#define PLCXX_ARM_SHIFT(NAME, SHIFT) {.name = #NAME, .form = ArmForm::kShift, .shift = ArmShift::SHIFT},
#define PLCXX_ARM_ACCESS(NAME, FORM, BITS, SIGN, SCALE) \
  {.name = #NAME, .form = ArmForm::FORM, .bits = BITS, .has_sign = SIGN, .scale = SCALE},
#define PLCXX_ARM_MANY(NAME, FORM) {.name = #NAME, .form = ArmForm::FORM},
#define PLCXX_ARM_OTHER(NAME, FORM) {.name = #NAME, .form = ArmForm::FORM},
#include "transpiler/prove/compiled/machine_code/arm.def"
};

const ArmRow* ArmRowOf(std::string_view name) {
  for (const ArmRow& row : kArmRows) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

class ArmLifter : public ArmOperands {
 public:
  ArmLifter(FunctionLifter& lifter, const ArmRow& row) : ArmOperands(lifter), row_(row) {}

  void Run();

 private:
  void Compute();
  void Move();
  void Shift();
  void Access();
  void AccessPair();
  void AccessMany();
  void LoadConstant();
  void Insert(llvm::Value* bits);
  void Extend(bool has_sign, unsigned bits, bool adds);
  void MultiplyLong(bool has_sign);
  void Divide(bool has_sign);
  void Jump();
  void Branch(llvm::Value* condition);
  void SetRegister(unsigned number, llvm::Value* value);

  const ArmRow& row_;
};

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
  const Link* link = lifter_.LinkAt({llvm::ELF::R_ARM_THM_MOVW_ABS_NC});
  if (link != nullptr) {
    Link symbol = *link;
    symbol.addend = NumberAt(1);
    llvm::Value* address = lifter_.AddressOf(symbol);
    if (address == nullptr) lifter_.Refuse("the address of " + link->symbol);
    lifter_.Set(RegisterAt(0), address != nullptr ? address : lifter_.Number(0));
    return;
  }
  const Shifted b = SecondOperand(1, 1);
  llvm::Value* zero = lifter_.Number(0);
  llvm::Value* result = row_.operation == ArmOperation::kNegate
                            ? Combine(ArmOperation::kReverseSub, b.value, {zero, nullptr}, sets_flags())
                            : Combine(row_.operation, zero, b, sets_flags());
  SetRegister(RegisterAt(0), result);
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

void ArmLifter::Access() {
  const bool loads = row_.form == ArmForm::kLoad || row_.form == ArmForm::kLoadPre || row_.form == ArmForm::kLoadPost;
  const bool pre = row_.form == ArmForm::kLoadPre || row_.form == ArmForm::kStorePre;
  const bool post = row_.form == ArmForm::kLoadPost || row_.form == ArmForm::kStorePost;
  const unsigned reg = (pre || post) && !loads ? 1 : 0;
  const unsigned base = pre || post ? 2 : 1;
  const unsigned back = loads ? 1 : 0;
  llvm::Value* before = Get(base);
  llvm::Value* moved = build_.CreateAdd(before, Offset(base + 1, row_.scale));
  llvm::Value* address = post ? before : moved;
  if (loads) {
    llvm::Value* value = lifter_.Load(address, row_.bits, 1);
    if (row_.bits < 32)
      value = row_.has_sign ? build_.CreateSExt(value, lifter_.Word()) : build_.CreateZExt(value, lifter_.Word());
    if (pre || post) lifter_.Set(RegisterAt(back), moved);
    SetRegister(RegisterAt(reg), value);
    return;
  }
  llvm::Value* value = Get(reg);
  if (row_.bits < 32) value = build_.CreateTrunc(value, build_.getIntNTy(row_.bits));
  lifter_.Store(address, value, 1);
  if (pre || post) lifter_.Set(RegisterAt(back), moved);
}

void ArmLifter::AccessPair() {
  const bool pre = row_.form == ArmForm::kLoadPairPre || row_.form == ArmForm::kStorePairPre;
  const bool post = row_.form == ArmForm::kLoadPairPost || row_.form == ArmForm::kStorePairPost;
  const bool loads =
      row_.form == ArmForm::kLoadPair || row_.form == ArmForm::kLoadPairPre || row_.form == ArmForm::kLoadPairPost;
  const unsigned first = (pre || post) && !loads ? 1 : 0;
  const unsigned base = pre || post ? 3 : 2;
  const unsigned back = loads ? 2 : 0;
  llvm::Value* before = Get(base);
  llvm::Value* moved = build_.CreateAdd(before, Offset(base + 1, 1));
  llvm::Value* address = post ? before : moved;
  llvm::Value* next = build_.CreateAdd(address, lifter_.Number(4));
  if (loads) {
    llvm::Value* low = lifter_.Load(address, 32, 4);
    llvm::Value* high = lifter_.Load(next, 32, 4);
    lifter_.Set(RegisterAt(first), low);
    lifter_.Set(RegisterAt(first + 1), high);
  } else {
    lifter_.Store(address, Get(first), 4);
    lifter_.Store(next, Get(first + 1), 4);
  }
  if (pre || post) lifter_.Set(RegisterAt(back), moved);
}

/// A list of registers, the lowest at the lowest address.
void ArmLifter::AccessMany() {
  const bool stack = row_.form == ArmForm::kPush || row_.form == ArmForm::kPop;
  const bool stores = row_.form == ArmForm::kPush || row_.form == ArmForm::kStoreDown ||
                      row_.form == ArmForm::kStoreUp || row_.form == ArmForm::kStoreFrom;
  const bool moves = row_.form != ArmForm::kStoreFrom && row_.form != ArmForm::kLoadFrom;
  const bool twice =
      row_.form == ArmForm::kStoreDown || row_.form == ArmForm::kLoadUp || row_.form == ArmForm::kStoreUp;
  const unsigned base = stack ? kStackPointer : RegisterAt(0);
  const unsigned first = stack ? 0 : twice ? 2 : 1;
  std::vector<unsigned> list;
  for (unsigned i = first; i < operand_count(); ++i) list.push_back(RegisterAt(i));
  const auto bytes = static_cast<uint64_t>(4 * list.size());
  llvm::Value* before = lifter_.Get(base);
  const bool down = row_.form == ArmForm::kPush || row_.form == ArmForm::kStoreDown;
  llvm::Value* from = down ? build_.CreateSub(before, lifter_.Number(bytes)) : before;
  llvm::Value* after = down ? from : build_.CreateAdd(before, lifter_.Number(bytes));
  bool base_is_loaded = false;
  std::vector<std::pair<unsigned, llvm::Value*>> loaded;
  for (size_t i = 0; i < list.size(); ++i) {
    llvm::Value* address = build_.CreateAdd(from, lifter_.Number(4 * i));
    if (stores) {
      lifter_.Store(address, lifter_.Get(list[i]), 4);
    } else {
      loaded.emplace_back(list[i], lifter_.Load(address, 32, 4));
      base_is_loaded = base_is_loaded || list[i] == base;
    }
  }
  if (moves && !(row_.form == ArmForm::kLoadUpNarrow && base_is_loaded)) lifter_.Set(base, after);
  for (const auto& [number, value] : loaded) SetRegister(number, value);
}

void ArmLifter::LoadConstant() {
  const uint64_t at = ((lifter_.current().address + 4) & ~uint64_t{3}) + static_cast<uint64_t>(NumberAt(1));
  const Section& section = lifter_.section();
  uint32_t word = 0;
  if (at + 4 > section.bytes.size()) {
    lifter_.Refuse("a constant outside of the section");
    return;
  }
  for (unsigned i = 0; i < 4; ++i) word |= uint32_t{static_cast<uint8_t>(section.bytes[at + i])} << (8 * i);
  const auto link = section.links.find(at);
  if (link == section.links.end()) {
    lifter_.Set(RegisterAt(0), lifter_.Number(word));
    return;
  }
  Link symbol = link->second;
  symbol.addend = static_cast<int32_t>(word);
  llvm::Value* address = symbol.type == llvm::ELF::R_ARM_ABS32 ? lifter_.AddressOf(symbol) : nullptr;
  if (address == nullptr) lifter_.Refuse("the address of " + symbol.symbol);
  lifter_.Set(RegisterAt(0), address != nullptr ? address : lifter_.Number(0));
}

/// Into the bits that the instruction's mask leaves out.
void ArmLifter::Insert(llvm::Value* bits) {
  const auto mask = static_cast<uint32_t>(NumberAt(operand_count() - 1));
  const unsigned low = static_cast<unsigned>(__builtin_ctz(~mask));
  llvm::Value* others = build_.CreateAnd(Get(1), lifter_.Number(mask));
  llvm::Value* moved = build_.CreateAnd(build_.CreateShl(bits, lifter_.Number(low)), lifter_.Number(uint32_t(~mask)));
  lifter_.Set(RegisterAt(0), build_.CreateOr(others, moved));
}

void ArmLifter::Extend(bool has_sign, unsigned bits, bool adds) {
  const unsigned from = adds ? 2 : 1;
  llvm::Value* value = Get(from);
  if (operand_count() > from + 1 && NumberAt(from + 1) != 0)
    value = ShiftBy(value, ArmShift::kRotate, static_cast<unsigned>(8 * NumberAt(from + 1))).value;
  value = build_.CreateTrunc(value, build_.getIntNTy(bits));
  value = has_sign ? build_.CreateSExt(value, lifter_.Word()) : build_.CreateZExt(value, lifter_.Word());
  lifter_.Set(RegisterAt(0), adds ? build_.CreateAdd(Get(1), value) : value);
}

void ArmLifter::MultiplyLong(bool has_sign) {
  llvm::Type* wide = build_.getInt64Ty();
  const auto widen = [&](llvm::Value* value) {
    return has_sign ? build_.CreateSExt(value, wide) : build_.CreateZExt(value, wide);
  };
  llvm::Value* product = build_.CreateMul(widen(Get(2)), widen(Get(3)));
  lifter_.Set(RegisterAt(0), build_.CreateTrunc(product, lifter_.Word()));
  lifter_.Set(RegisterAt(1), build_.CreateTrunc(build_.CreateLShr(product, 32), lifter_.Word()));
}

/// By 0 it is 0, where the processor does not trap; the least number by -1 is itself.
void ArmLifter::Divide(bool has_sign) {
  llvm::Value* a = Get(1);
  llvm::Value* b = Get(2);
  llvm::Value* by_zero = build_.CreateICmpEQ(b, lifter_.Number(0));
  llvm::Value* by = build_.CreateSelect(by_zero, lifter_.Number(1), b);
  if (has_sign) {
    llvm::Value* overflows = build_.CreateAnd(build_.CreateICmpEQ(a, lifter_.Number(0x80000000)),
                                              build_.CreateICmpEQ(b, lifter_.Number(0xFFFFFFFF)));
    by = build_.CreateSelect(overflows, lifter_.Number(1), by);
  }
  llvm::Value* result = has_sign ? build_.CreateSDiv(a, by) : build_.CreateUDiv(a, by);
  lifter_.Set(RegisterAt(0), build_.CreateSelect(by_zero, lifter_.Number(0), result));
}

void ArmLifter::Jump() {
  const Link* link = lifter_.LinkAt({llvm::ELF::R_ARM_THM_JUMP24, llvm::ELF::R_ARM_THM_JUMP11});
  if (link != nullptr) {
    lifter_.TailCall(*link);
  } else if (lifter_.current().target) {
    lifter_.JumpTo(*lifter_.current().target);
  } else {
    lifter_.Refuse("a jump that does not say where");
  }
}

void ArmLifter::Branch(llvm::Value* condition) {
  if (const Link* link = lifter_.LinkAt({llvm::ELF::R_ARM_THM_JUMP19})) {
    lifter_.BeginGuard(condition);
    lifter_.TailCall(*link);
    lifter_.EndGuard();
  } else if (lifter_.current().target) {
    lifter_.BranchIf(condition, *lifter_.current().target);
  } else {
    lifter_.Refuse("a branch that does not say where");
  }
}

void ArmLifter::Run() {
  const auto unary = [this](llvm::Intrinsic::ID id, std::vector<llvm::Value*> more) {
    std::vector<llvm::Value*> arguments = {Get(1)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    llvm::Function* function = llvm::Intrinsic::getDeclaration(&lifter_.program().module(), id, {lifter_.Word()});
    lifter_.Set(RegisterAt(0), build_.CreateCall(function, arguments));
  };
  const auto zero = [this](unsigned operand, bool is) {
    llvm::Value* none = lifter_.Number(0);
    return is ? build_.CreateICmpEQ(Get(operand), none) : build_.CreateICmpNE(Get(operand), none);
  };
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
      // With the linker's note the whole address is there already.
      if (lifter_.LinkAt({llvm::ELF::R_ARM_THM_MOVT_ABS}) != nullptr) return;
      lifter_.Set(RegisterAt(0), build_.CreateOr(build_.CreateAnd(Get(1), lifter_.Number(0xFFFF)),
                                                 lifter_.Number(static_cast<uint64_t>(NumberAt(2)) << 16)));
      return;
    case ArmForm::kBits:
    case ArmForm::kBitsSigned: {
      const auto low = static_cast<unsigned>(NumberAt(2)), width = static_cast<unsigned>(NumberAt(3)) + 1;
      llvm::Value* top = build_.CreateShl(Get(1), lifter_.Number(32 - low - width));
      llvm::Value* count = lifter_.Number(32 - width);
      lifter_.Set(RegisterAt(0),
                  row_.form == ArmForm::kBits ? build_.CreateLShr(top, count) : build_.CreateAShr(top, count));
      return;
    }
    case ArmForm::kInsert:
      return Insert(Get(2));
    case ArmForm::kClear:
      return Insert(lifter_.Number(0));
    case ArmForm::kUnsignedByte:
      return Extend(false, 8, false);
    case ArmForm::kUnsignedHalf:
      return Extend(false, 16, false);
    case ArmForm::kSignedByte:
      return Extend(true, 8, false);
    case ArmForm::kSignedHalf:
      return Extend(true, 16, false);
    case ArmForm::kAddUnsignedByte:
      return Extend(false, 8, true);
    case ArmForm::kAddUnsignedHalf:
      return Extend(false, 16, true);
    case ArmForm::kAddSignedByte:
      return Extend(true, 8, true);
    case ArmForm::kAddSignedHalf:
      return Extend(true, 16, true);
    case ArmForm::kLeadingZeros:
      return unary(llvm::Intrinsic::ctlz, {build_.getFalse()});
    case ArmForm::kReverse:
      return unary(llvm::Intrinsic::bswap, {});
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
      return MultiplyLong(false);
    case ArmForm::kMulLongSigned:
      return MultiplyLong(true);
    case ArmForm::kMulHalves: {
      const auto half = [&](unsigned operand) {
        return build_.CreateSExt(build_.CreateTrunc(Get(operand), build_.getInt16Ty()), lifter_.Word());
      };
      lifter_.Set(RegisterAt(0), build_.CreateMul(half(1), half(2)));
      return;
    }
    case ArmForm::kDiv:
      return Divide(false);
    case ArmForm::kDivSigned:
      return Divide(true);
    case ArmForm::kJump:
      return Jump();
    case ArmForm::kBranch:
      return Branch(Condition());
    case ArmForm::kBranchZero:
      return Branch(zero(0, true));
    case ArmForm::kBranchNotZero:
      return Branch(zero(0, false));
    case ArmForm::kCall:
      if (const Link* link = lifter_.LinkAt({llvm::ELF::R_ARM_THM_CALL})) return lifter_.Call(*link);
      return lifter_.Refuse("a call that no note of the linker tells of");
    case ArmForm::kReturn:
      return lifter_.ReturnTo(Get(0));
    case ArmForm::kNothing:
      return;
  }
}

}  // namespace

void LiftArm(FunctionLifter& lifter) {
  const llvm::StringRef name = lifter.program().machine().OpcodeName(lifter.current().inst);
  const ArmRow* row = ArmRowOf(std::string_view(name));
  if (row == nullptr) {
    lifter.Refuse("instruction '" + name.str() + "'");
    return;
  }
  ArmLifter arm(lifter, *row);
  const bool guarded = row->form != ArmForm::kBranch && arm.is_conditional();
  if (guarded) lifter.BeginGuard(arm.Condition());
  arm.Run();
  if (guarded) lifter.EndGuard();
}

}  // namespace plcxx::prove::compiled::machine_code
