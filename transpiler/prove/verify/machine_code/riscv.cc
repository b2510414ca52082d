// What instructions of RISC-V do (RV32IMAC without atomics; the unprivileged specification, volume I).
#include <llvm/BinaryFormat/ELF.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "transpiler/prove/verify/machine_code/lifter.h"
#include "transpiler/support/check.h"

namespace plcxx::prove::verify::machine_code {
namespace {

enum class Form : uint8_t {
  kRegisters,     // rd, rs1, rs2
  kNumber,        // rd, rs1, number
  kSetRegisters,  // as kRegisters
  kSetNumber,     // as kNumber
  kLoad,          // rd, base, offset
  kStore,         // rs, base, offset
  kMove,          // rd, rs1
  kConstant,      // rd, number
  kUpper,         // rd, number of the upper 20 bits
  kUpperOfCounter,
  kBranch,        // rs1, rs2, target
  kBranchZero,    // rs1, target
  kJump,          // target
  kLink,          // rd, target; compressed the target alone
  kIndirect,      // rs1
  kIndirectLink,  // rd, rs1, offset; compressed rs1 alone
  kNothing
};

enum class Operation : uint8_t {
  kAdd,
  kSub,
  kAnd,
  kOr,
  kXor,
  kShiftLeft,
  kShiftRight,
  kShiftRightSigned,
  kMul,
  kMulHighSigned,
  kMulHigh,
  kMulHighMixed,
  kDivSigned,
  kDiv,
  kRemSigned,
  kRem
};

struct Row {
  std::string_view name;
  Form form{};
  Operation operation{};
  llvm::CmpInst::Predicate predicate = llvm::CmpInst::BAD_ICMP_PREDICATE;
  unsigned bits = 0;
  bool has_sign = false;
};

constexpr Row kRows[] = {
#define PLCXX_RISCV_OPERATION(NAME, FORM, OPERATION) \
  {.name = #NAME, .form = Form::FORM, .operation = Operation::OPERATION},
#define PLCXX_RISCV_COMPARE(NAME, FORM, PREDICATE) \
  {.name = #NAME, .form = Form::FORM, .predicate = llvm::CmpInst::PREDICATE},
#define PLCXX_RISCV_ACCESS(NAME, FORM, BITS, SIGN) {.name = #NAME, .form = Form::FORM, .bits = BITS, .has_sign = SIGN},
#define PLCXX_RISCV_OTHER(NAME, FORM) {.name = #NAME, .form = Form::FORM},
#include "transpiler/prove/verify/machine_code/riscv.def"
};

const Row* RowOf(std::string_view name) {
  if (name.starts_with("C_")) name.remove_prefix(2);
  for (const Row& row : kRows) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

class RiscvLifter {
 public:
  RiscvLifter(FunctionLifter& lifter, const Row& row)
      : lifter_(lifter), build_(lifter.build()), row_(row), inst_(lifter.current().inst) {}

  void Run();

 private:
  unsigned RegisterAt(unsigned operand) const {
    return lifter_.program().machine().registers().getEncodingValue(inst_.getOperand(operand).getReg());
  }
  llvm::Value* Get(unsigned operand) {
    const unsigned number = RegisterAt(operand);
    return number == 0 ? lifter_.Number(0) : lifter_.Get(number);
  }
  void Set(unsigned operand, llvm::Value* value) {
    const unsigned number = RegisterAt(operand);
    if (number != 0) lifter_.Set(number, value);
  }
  int64_t NumberAt(unsigned operand) const { return inst_.getOperand(operand).getImm(); }
  /// A base register and an offset, or the two parts of a symbol's address.
  llvm::Value* Address(uint64_t pc_note, uint64_t absolute_note);
  llvm::Value* Compute(llvm::Value* a, llvm::Value* b);
  enum class Sign : uint8_t { kNone, kHas };
  /// The upper half of a product.
  llvm::Value* High(llvm::Value* a, Sign of_a, llvm::Value* b, Sign of_b);
  llvm::Value* Compare(llvm::Value* a, llvm::Value* b) { return build_.CreateICmp(row_.predicate, a, b); }
  void SetConstant();
  void SetUpper(const Link& link);
  std::optional<Place> UpperOf(const Link& link) const;
  /// Else it is refused.
  bool IsOfWholeFunction(const Link& link);
  void LoadIt();
  void StoreIt();
  void Branch(llvm::Value* condition, unsigned operand);
  void JumpBy(unsigned operand);
  void JumpIndirect();
  bool IsFarCallHere() const;
  /// The note of the far call that begins with the auipc in front.
  const Link* FarCall() const;
  FunctionLifter& lifter_;
  Builder& build_;
  const Row& row_;
  const llvm::MCInst& inst_;
};

llvm::Value* RiscvLifter::High(llvm::Value* a, Sign of_a, llvm::Value* b, Sign of_b) {
  const unsigned bits = lifter_.Word()->getBitWidth();
  llvm::Type* wide = build_.getIntNTy(2 * bits);
  const auto widen = [&](llvm::Value* value, Sign sign) {
    return sign == Sign::kHas ? build_.CreateSExt(value, wide) : build_.CreateZExt(value, wide);
  };
  llvm::Value* product = build_.CreateMul(widen(a, of_a), widen(b, of_b));
  return build_.CreateTrunc(build_.CreateLShr(product, bits), lifter_.Word());
}

llvm::Value* RiscvLifter::Compute(llvm::Value* a, llvm::Value* b) {
  const auto count = [&] { return build_.CreateAnd(b, lifter_.Number(lifter_.Word()->getBitWidth() - 1)); };
  switch (row_.operation) {
    case Operation::kAdd:
      return build_.CreateAdd(a, b);
    case Operation::kSub:
      return build_.CreateSub(a, b);
    case Operation::kAnd:
      return build_.CreateAnd(a, b);
    case Operation::kOr:
      return build_.CreateOr(a, b);
    case Operation::kXor:
      return build_.CreateXor(a, b);
    case Operation::kShiftLeft:
      return build_.CreateShl(a, count());
    case Operation::kShiftRight:
      return build_.CreateLShr(a, count());
    case Operation::kShiftRightSigned:
      return build_.CreateAShr(a, count());
    case Operation::kMul:
      return build_.CreateMul(a, b);
    case Operation::kMulHighSigned:
      return High(a, Sign::kHas, b, Sign::kHas);
    case Operation::kMulHigh:
      return High(a, Sign::kNone, b, Sign::kNone);
    case Operation::kMulHighMixed:
      return High(a, Sign::kHas, b, Sign::kNone);
    // By 0 all ones, and as rest the dividend.
    case Operation::kDiv:
      return lifter_.Divide(a, b, llvm::Instruction::UDiv, lifter_.Number(~uint64_t{0}));
    case Operation::kDivSigned:
      return lifter_.Divide(a, b, llvm::Instruction::SDiv, lifter_.Number(~uint64_t{0}));
    case Operation::kRem:
      return lifter_.Divide(a, b, llvm::Instruction::URem, a);
    case Operation::kRemSigned:
      return lifter_.Divide(a, b, llvm::Instruction::SRem, a);
  }
  PLCXX_UNREACHABLE();
}

/// What `lui` makes of a symbol's address is the same for all places of its section in one aligned block.
std::optional<Place> RiscvLifter::UpperOf(const Link& link) const {
  if (!link.defined) return std::nullopt;
  constexpr uint64_t kLargest = 0x800;  // of blocks that have one upper part wherever they are
  const Section& section = lifter_.program().objects().sections()[link.defined->section];
  uint64_t align = std::min(std::max<uint64_t>(section.align, 1), kLargest);
  if (section.merges != 0) align = section.has_texts ? 1 : std::min(align, section.merges & (~section.merges + 1));
  const uint64_t at = link.defined->offset + static_cast<uint64_t>(link.addend);
  return Place{link.defined->section, at / align * align};
}

/// The register must hold the upper part of that address, and of no other one.
llvm::Value* RiscvLifter::Address(uint64_t pc_note, uint64_t absolute_note) {
  const Link* symbol = lifter_.LinkAt({absolute_note});
  AddressPart part = AddressPart::kUpper, relaxed = AddressPart::kRelaxedUpper;
  std::optional<Place> upper = symbol != nullptr ? UpperOf(*symbol) : std::nullopt;
  if (const Link* counter = lifter_.LinkAt({pc_note})) {
    // It names the place of the `auipc`, whose own note has the symbol.
    part = AddressPart::kCounterUpper;
    relaxed = AddressPart::kRelaxedCounterUpper;
    upper = counter->defined;
    const bool here = upper && upper->section == lifter_.function().place.section && counter->addend == 0;
    const auto [first, last] = lifter_.section().links.equal_range(here ? upper->offset : ~uint64_t{0});
    for (auto link = first; link != last; ++link) {
      if (link->second.type == llvm::ELF::R_RISCV_PCREL_HI20) symbol = &link->second;
    }
    if (symbol == nullptr) upper.reset();
    if (!upper) lifter_.Refuse("half of an address");
  }
  const auto offset = static_cast<uint64_t>(NumberAt(2));
  if (symbol == nullptr) {
    const bool below_stack = RegisterAt(1) == lifter_.program().convention().stack && row_.form != Form::kNumber;
    if (below_stack && NumberAt(2) < 0) lifter_.Refuse("an access below the stack pointer");
    return build_.CreateAdd(Get(1), lifter_.Number(offset));
  }
  llvm::Value* address = upper ? lifter_.AddressOf(*symbol) : nullptr;
  if (address == nullptr) {
    lifter_.Refuse("the address of " + symbol->symbol);
    return lifter_.Number(0);
  }
  llvm::Value* fits = build_.CreateICmpEQ(Get(1), lifter_.PartOf(part, *upper));
  // Where the linker has left out the upper half it has changed this one, if it may.
  if (lifter_.MayBeRelaxed())
    fits = build_.CreateOr(fits, build_.CreateICmpEQ(Get(1), lifter_.PartOf(relaxed, *upper)));
  lifter_.Demand(fits);
  return address;
}

void RiscvLifter::SetUpper(const Link& link) {
  const bool counter = row_.form == Form::kUpperOfCounter;
  const Place here{lifter_.function().place.section, lifter_.current().address};
  const std::optional<Place> place = counter ? std::optional(here) : UpperOf(link);
  if (!place) {
    lifter_.Refuse("the address of " + link.symbol);
    return;
  }
  const AddressPart whole = counter ? AddressPart::kCounterUpper : AddressPart::kUpper;
  const AddressPart relaxed = counter ? AddressPart::kRelaxedCounterUpper : AddressPart::kRelaxedUpper;
  Set(0, lifter_.PartOf(lifter_.MayBeRelaxed() ? relaxed : whole, *place));
}

void RiscvLifter::SetConstant() {
  const auto number = static_cast<uint64_t>(NumberAt(1));
  if (row_.form == Form::kConstant) {
    Set(0, lifter_.Number(number));
    return;
  }
  const bool counter = row_.form == Form::kUpperOfCounter;
  if (counter && lifter_.LinkAt({llvm::ELF::R_RISCV_CALL, llvm::ELF::R_RISCV_CALL_PLT}) != nullptr) {
    Set(0, lifter_.Unknown());  // a part of the function's address; the call is at the jump
    if (!IsFarCallHere()) lifter_.Refuse("a call whose two halves do not fit together");
    return;
  }
  const Link* link =
      counter ? lifter_.LinkAt({llvm::ELF::R_RISCV_PCREL_HI20}) : lifter_.LinkAt({llvm::ELF::R_RISCV_HI20});
  if (link != nullptr) {
    SetUpper(*link);
  } else if (counter) {
    lifter_.Refuse("an address that is relative to the instruction");
  } else {
    Set(0, lifter_.Number(number << 12 & 0xFFFFFFFF));
  }
}

void RiscvLifter::LoadIt() {
  llvm::Value* value =
      lifter_.Load(Address(llvm::ELF::R_RISCV_PCREL_LO12_I, llvm::ELF::R_RISCV_LO12_I), row_.bits, row_.bits / 8);
  if (row_.bits < lifter_.Word()->getBitWidth()) {
    value = row_.has_sign ? build_.CreateSExt(value, lifter_.Word()) : build_.CreateZExt(value, lifter_.Word());
  }
  Set(0, value);
}

void RiscvLifter::StoreIt() {
  llvm::Value* address = Address(llvm::ELF::R_RISCV_PCREL_LO12_S, llvm::ELF::R_RISCV_LO12_S);
  llvm::Value* value = Get(0);
  if (row_.bits < lifter_.Word()->getBitWidth()) value = build_.CreateTrunc(value, build_.getIntNTy(row_.bits));
  lifter_.Store(address, value, row_.bits / 8);
}

bool RiscvLifter::IsOfWholeFunction(const Link& link) {
  if (link.addend != 0) lifter_.Refuse("a jump into the middle of a function");
  return link.addend == 0;
}

void RiscvLifter::Branch(llvm::Value* condition, unsigned operand) {
  const Link* link = lifter_.LinkAt({llvm::ELF::R_RISCV_BRANCH, llvm::ELF::R_RISCV_RVC_BRANCH});
  if (link == nullptr) {
    const uint64_t target = lifter_.current().address + static_cast<uint64_t>(NumberAt(operand));
    if (lifter_.MayMoveTo(target)) lifter_.Refuse("a branch that the linker does not know of");
    lifter_.BranchIf(condition, target);
  } else if (const auto target = lifter_.TargetOf(*link)) {
    lifter_.BranchIf(condition, *target);
  } else {
    lifter_.Refuse("a branch out of the function");
  }
}

void RiscvLifter::JumpBy(unsigned operand) {
  const Link* link = lifter_.LinkAt({llvm::ELF::R_RISCV_JAL, llvm::ELF::R_RISCV_RVC_JUMP});
  if (link == nullptr) {
    const uint64_t target = lifter_.current().address + static_cast<uint64_t>(NumberAt(operand));
    if (lifter_.MayMoveTo(target)) lifter_.Refuse("a branch that the linker does not know of");
    lifter_.JumpTo(target);
  } else if (const auto target = lifter_.TargetOf(*link)) {
    lifter_.JumpTo(*target);
  } else if (IsOfWholeFunction(*link)) {
    lifter_.TailCall(*link);
  }
}

/// The linker puts the address into both instructions: they must be what it takes them for.
bool RiscvLifter::IsFarCallHere() const {
  const compile::audit::Instruction* jump = lifter_.next();
  if (jump == nullptr || jump->address != lifter_.current().address + 4) return false;
  const compile::audit::MachineCode& machine = lifter_.program().machine();
  return machine.OpcodeName(jump->inst) == "JALR" &&
         machine.registers().getEncodingValue(jump->inst.getOperand(1).getReg()) == RegisterAt(0) &&
         jump->inst.getOperand(2).isImm() && jump->inst.getOperand(2).getImm() == 0;
}

const Link* RiscvLifter::FarCall() const {
  const auto& links = lifter_.section().links;
  const compile::audit::Instruction* before = lifter_.previous();
  if (before == nullptr || before->address + 4 != lifter_.current().address) return nullptr;
  const auto [first, last] = links.equal_range(lifter_.current().address - 4);
  for (auto link = first; link != last; ++link) {
    if (link->second.type == llvm::ELF::R_RISCV_CALL || link->second.type == llvm::ELF::R_RISCV_CALL_PLT)
      return &link->second;
  }
  return nullptr;
}

void RiscvLifter::JumpIndirect() {
  const bool linking = row_.form == Form::kIndirectLink;
  if (linking && inst_.getNumOperands() == 1) {
    lifter_.Refuse("a call to where a register says");
    return;
  }
  const unsigned back = linking ? RegisterAt(0) : 0;
  const unsigned to = RegisterAt(linking ? 1 : 0);
  if (const Link* call = FarCall()) {
    // The linker puts the address into both instructions: they must be what it takes them for.
    const unsigned upper =
        lifter_.program().machine().registers().getEncodingValue(lifter_.previous()->inst.getOperand(0).getReg());
    if (lifter_.IsBranchTarget() || !linking || upper != to || NumberAt(2) != 0) {
      lifter_.Refuse("a call whose two halves do not fit together");
    } else if (back != 0 && back != lifter_.program().convention().link) {
      lifter_.Refuse("a call that returns by another register");
    } else if (IsOfWholeFunction(*call)) {
      back == 0 ? lifter_.TailCall(*call) : lifter_.Call(*call);
    }
  } else if (back == 0 && to == lifter_.program().convention().link && (!linking || NumberAt(2) == 0)) {
    lifter_.ReturnTo(lifter_.Get(to));
  } else {
    lifter_.Refuse("a jump to where a register says");
  }
}

void RiscvLifter::Run() {
  switch (row_.form) {
    case Form::kRegisters:
      Set(0, Compute(Get(1), Get(2)));
      return;
    case Form::kNumber:
      Set(0, row_.operation == Operation::kAdd ? Address(llvm::ELF::R_RISCV_PCREL_LO12_I, llvm::ELF::R_RISCV_LO12_I)
                                               : Compute(Get(1), lifter_.Number(static_cast<uint64_t>(NumberAt(2)))));
      return;
    case Form::kSetRegisters:
      Set(0, build_.CreateZExt(Compare(Get(1), Get(2)), lifter_.Word()));
      return;
    case Form::kSetNumber:
      Set(0, build_.CreateZExt(Compare(Get(1), lifter_.Number(static_cast<uint64_t>(NumberAt(2)))), lifter_.Word()));
      return;
    case Form::kMove:
      Set(0, Get(1));
      return;
    case Form::kConstant:
    case Form::kUpper:
    case Form::kUpperOfCounter:
      SetConstant();
      return;
    case Form::kLoad:
      LoadIt();
      return;
    case Form::kStore:
      StoreIt();
      return;
    case Form::kBranch:
      Branch(Compare(Get(0), Get(1)), 2);
      return;
    case Form::kBranchZero:
      Branch(Compare(Get(0), lifter_.Number(0)), 1);
      return;
    case Form::kJump:
      JumpBy(0);
      return;
    case Form::kLink: {
      const bool compressed = inst_.getNumOperands() == 1;
      const unsigned back = compressed ? lifter_.program().convention().link : RegisterAt(0);
      const Link* link = lifter_.LinkAt({llvm::ELF::R_RISCV_JAL, llvm::ELF::R_RISCV_RVC_JUMP});
      if (back == 0) {
        JumpBy(compressed ? 0 : 1);
      } else if (link != nullptr && back == lifter_.program().convention().link) {
        if (IsOfWholeFunction(*link)) lifter_.Call(*link);
      } else {
        lifter_.Refuse("a call that no note of the linker tells of");
      }
      return;
    }
    case Form::kIndirect:
    case Form::kIndirectLink:
      JumpIndirect();
      return;
    case Form::kNothing:
      return;
  }
}

}  // namespace

void LiftRiscv(FunctionLifter& lifter) {
  const llvm::StringRef name = lifter.program().machine().OpcodeName(lifter.current().inst);
  const Row* row = RowOf(std::string_view(name));
  if (row == nullptr) {
    lifter.Refuse("instruction '" + name.str() + "'");
    return;
  }
  RiscvLifter(lifter, *row).Run();
}

}  // namespace plcxx::prove::verify::machine_code
