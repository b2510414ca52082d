#include "transpiler/compile/audit/machine_code.h"

#include <llvm/MC/MCTargetOptions.h>
#include <llvm/MC/TargetRegistry.h>
#include <llvm/Support/TargetSelect.h>
#include <llvm/TargetParser/SubtargetFeature.h>

namespace plcxx::compile::audit {
namespace {

constexpr int64_t kAlways = 14;  // ARM's condition "al"

/// Cortex-M executes Thumb only; the object just says ARM.
llvm::Triple TripleOf(const llvm::object::ELFObjectFileBase& object) {
  switch (object.getArch()) {
    case llvm::Triple::arm:
    case llvm::Triple::thumb:
      return llvm::Triple("thumbv7em-none-eabi");
    case llvm::Triple::riscv32:
      return llvm::Triple("riscv32-unknown-elf");
    case llvm::Triple::riscv64:
      return llvm::Triple("riscv64-unknown-elf");
    case llvm::Triple::x86_64:
      return llvm::Triple("x86_64-unknown-linux-gnu");
    case llvm::Triple::aarch64:
      return llvm::Triple("aarch64-unknown-linux-gnu");
    default:  // of LLVM's, which has dozens
      return {};
  }
}

}  // namespace

std::unique_ptr<MachineCode> MachineCode::Make(const llvm::object::ELFObjectFileBase& object, std::string processor,
                                               std::string& failure) {
  static const bool initialized = [] {
    llvm::InitializeAllTargetInfos();
    llvm::InitializeAllTargetMCs();
    llvm::InitializeAllDisassemblers();
    return true;
  }();
  static_cast<void>(initialized);
  llvm::Triple triple = TripleOf(object);
  if (processor == "cortex-m0plus") triple = llvm::Triple("thumbv6m-none-eabi");
  std::string unknown;
  const llvm::Target* target = llvm::TargetRegistry::lookupTarget(triple.str(), unknown);
  if (target == nullptr) {
    failure = "no disassembler for this architecture";
    return nullptr;
  }
  auto machine = std::make_unique<MachineCode>();
  machine->architecture_ = triple.getArch();
  // The same figures on every machine: of a plain processor, not of the one that happens to be there.
  if (processor == "native") processor = machine->is_x86() ? "x86-64" : "generic";
  machine->processor_ = processor;
  std::string features;
  if (llvm::Expected<llvm::SubtargetFeatures> own = object.getFeatures()) {
    features = own->getString();
  } else {
    llvm::consumeError(own.takeError());
  }
  machine->registers_.reset(target->createMCRegInfo(triple.str()));
  machine->assembly_.reset(target->createMCAsmInfo(*machine->registers_, triple.str(), llvm::MCTargetOptions()));
  machine->instructions_.reset(target->createMCInstrInfo());
  machine->subtarget_.reset(target->createMCSubtargetInfo(triple.str(), processor, features));
  machine->analysis_.reset(target->createMCInstrAnalysis(machine->instructions_.get()));
  machine->context_ = std::make_unique<llvm::MCContext>(triple, machine->assembly_.get(), machine->registers_.get(),
                                                        machine->subtarget_.get());
  machine->disassembler_.reset(target->createMCDisassembler(*machine->subtarget_, *machine->context_));
  if (machine->disassembler_ == nullptr || machine->analysis_ == nullptr) {
    failure = "no disassembler for this architecture";
    return nullptr;
  }
  return machine;
}

bool MachineCode::Names(const llvm::MCInst& inst, unsigned operand, llvm::StringRef name) const {
  return operand < inst.getNumOperands() && inst.getOperand(operand).isReg() &&
         RegisterName(inst.getOperand(operand).getReg()) == name;
}

/// On ARM any instruction that writes the program counter jumps; the tables call only some of them branches.
Flow MachineCode::ArmFlow(const llvm::MCInst& inst, bool conditional) const {
  const llvm::MCInstrDesc& description = Describe(inst);
  const llvm::StringRef name = OpcodeName(inst);
  const Flow back = conditional ? Flow::kMaybeReturn : Flow::kReturn;
  if (name == "tBX") return Names(inst, 0, "LR") ? back : Flow::kIndirectJump;
  if (description.isIndirectBranch()) return Flow::kIndirectJump;
  // Read it is by loads of constants beside the code; written as a result, or in a list of registers.
  const unsigned list = description.isVariadic() ? description.getNumOperands() - 1 : inst.getNumOperands();
  bool writes_counter = false;
  for (unsigned i = 0; i < inst.getNumOperands(); ++i) {
    if (i < description.getNumDefs() || i >= list) writes_counter = writes_counter || Names(inst, i, "PC");
  }
  if (!writes_counter || description.isBranch() || description.isCall()) return Flow::kNext;
  const bool from_stack = name == "tPOP" || name.starts_with("t2LDMIA") || name == "t2LDR_POST";
  if (from_stack || (name == "tMOVr" && Names(inst, 1, "LR"))) return back;
  return Names(inst, 0, "PC") || description.mayLoad() ? Flow::kIndirectJump : Flow::kNext;
}

Flow MachineCode::FlowOf(const llvm::MCInst& inst) const {
  const llvm::MCInstrDesc& description = Describe(inst);
  bool conditional = description.isConditionalBranch();
  if (is_arm()) {
    const int predicate = description.findFirstPredOperandIdx();
    if (predicate >= 0 && inst.getOperand(static_cast<unsigned>(predicate)).isImm()) {
      conditional = conditional || inst.getOperand(static_cast<unsigned>(predicate)).getImm() != kAlways;
    }
    const Flow flow = ArmFlow(inst, conditional);
    if (flow != Flow::kNext) return flow;
    if (OpcodeName(inst).starts_with("tBLXr") || OpcodeName(inst).starts_with("tBLXNSr")) return Flow::kIndirectCall;
  }
  // RISC-V spells everything as jalr; without register 0 it is told by LLVM's own analysis.
  if (analysis_->isReturn(inst)) return conditional ? Flow::kMaybeReturn : Flow::kReturn;
  const bool direct = [&] {
    uint64_t target = 0;
    return analysis_->evaluateBranch(inst, 0, 4, target);
  }();
  if (analysis_->isCall(inst)) return direct ? Flow::kCall : Flow::kIndirectCall;
  if (analysis_->isIndirectBranch(inst)) return Flow::kIndirectJump;
  if (conditional && analysis_->isBranch(inst)) return direct ? Flow::kBranch : Flow::kIndirectJump;
  if (analysis_->isUnconditionalBranch(inst)) return direct ? Flow::kJump : Flow::kIndirectJump;
  if (analysis_->isBranch(inst)) return direct ? Flow::kBranch : Flow::kIndirectJump;
  return description.isTrap() || OpcodeName(inst) == "tTRAP" ? Flow::kStop : Flow::kNext;
}

bool MachineCode::Decode(llvm::ArrayRef<uint8_t> bytes, uint64_t address, Instruction& out) {
  uint64_t size = 0;
  out = {};
  if (disassembler_->getInstruction(out.inst, size, bytes, address, llvm::nulls()) !=
      llvm::MCDisassembler::DecodeStatus::Success) {
    return false;
  }
  out.address = address;
  out.bytes = static_cast<uint32_t>(size);
  out.flow = FlowOf(out.inst);
  uint64_t target = 0;
  if (analysis_->evaluateBranch(out.inst, address, size, target)) out.target = target;
  return true;
}

}  // namespace plcxx::compile::audit
