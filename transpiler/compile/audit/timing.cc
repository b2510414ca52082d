// Cycles of instructions: LLVM's scheduling models, and the published table of a core that has none there.
#include <llvm/MC/MCSchedule.h>

#include <algorithm>
#include <map>

#include "transpiler/compile/audit/machine_code.h"

namespace plcxx::compile::audit {
namespace {

constexpr uint64_t kCycle = 1000;
constexpr unsigned kMostOutOfOrder = 1;  // micro-ops in flight of a core that keeps the order

}  // namespace

Timing::Timing(const MachineCode& machine) : machine_(machine) {
  const llvm::MCSchedModel& model = machine.subtarget().getSchedModel();
  if (model.hasInstrSchedModel()) {
    source_ = model.MicroOpBufferSize <= kMostOutOfOrder ? Source::kInOrderModel : Source::kThroughputModel;
  } else if (machine.processor() == "cortex-m0plus") {
    source_ = Source::kCortexM0Plus;
  }
}

std::string Timing::Text() const {
  switch (source_) {
    case Source::kInOrderModel:
      return "LLVM's scheduling model of " + machine_.processor() + ", memory without wait states";
    case Source::kThroughputModel:
      return "LLVM's scheduling model of " + machine_.processor() + ", throughput with all data in the cache";
    case Source::kCortexM0Plus:
      return "ARM's instruction timing of the Cortex-M0+, memory without wait states";
    case Source::kNone:
      return "one cycle an instruction (LLVM has no model of this processor)";
  }
  return "";
}

/// Of an instruction that loads or stores a list of registers; 0: it does not.
uint64_t Timing::RegistersInList(const llvm::MCInst& inst) const {
  const llvm::MCInstrDesc& description = machine_.Describe(inst);
  if (!machine_.is_arm() || !description.isVariadic()) return 0;
  return inst.getNumOperands() + 1 - std::min(inst.getNumOperands() + 1, description.getNumOperands());
}

Timing::Duration Timing::DurationOf(const llvm::MCInst& inst) const {
  const llvm::MCInstrDesc& description = machine_.Describe(inst);
  const uint64_t listed = RegistersInList(inst);
  if (source_ == Source::kCortexM0Plus) {
    const bool memory = description.mayLoad() || description.mayStore();
    const uint64_t cycles = listed > 0 ? 1 + listed : memory ? 2 : 1;
    return {cycles * kCycle, cycles * kCycle};
  }
  if (source_ == Source::kNone) return {kCycle, kCycle};
  const llvm::MCSubtargetInfo& subtarget = machine_.subtarget();
  const llvm::MCSchedModel& model = subtarget.getSchedModel();
  unsigned row = description.getSchedClass();
  const llvm::MCSchedClassDesc* timing = model.getSchedClassDesc(row);
  while (timing->isVariant()) {
    row = subtarget.resolveVariantSchedClass(row, &inst, &machine_.instructions(), model.getProcessorID());
    if (row == 0) break;
    timing = model.getSchedClassDesc(row);
  }
  if (!timing->isValid() || timing->isVariant()) return {kCycle, kCycle};
  const int latency = std::max(llvm::MCSchedModel::computeInstrLatency(subtarget, *timing), 0);
  const double throughput = llvm::MCSchedModel::getReciprocalThroughput(subtarget, *timing);
  const uint64_t slots = timing->NumMicroOps * kCycle / std::max(model.IssueWidth, 1u);
  const auto busy = static_cast<uint64_t>(throughput * static_cast<double>(kCycle));
  return {std::max({slots, busy, listed > 0 ? (1 + listed) * kCycle : 0}), static_cast<uint64_t>(latency) * kCycle};
}

uint64_t Timing::Cycles(llvm::ArrayRef<Instruction> instructions) const {
  // A core that keeps the order waits for the operands of each instruction; one that does not hides it.
  const bool waits = source_ == Source::kInOrderModel;
  std::map<unsigned, uint64_t> ready;  // by register unit
  uint64_t now = 0;
  for (const Instruction& instruction : instructions) {
    const llvm::MCInst& inst = instruction.inst;
    const Duration duration = DurationOf(inst);
    if (!waits) {
      now += duration.issue;
      continue;
    }
    const llvm::MCInstrDesc& description = machine_.Describe(inst);
    const llvm::MCRegisterInfo& registers = machine_.registers();
    const auto wait_for = [&](llvm::MCRegister reg) {
      for (const llvm::MCRegUnit unit : registers.regunits(reg)) {
        const auto found = ready.find(unit);
        if (found != ready.end()) now = std::max(now, found->second);
      }
    };
    for (unsigned i = description.getNumDefs(); i < inst.getNumOperands(); ++i) {
      if (inst.getOperand(i).isReg() && inst.getOperand(i).getReg() != 0) wait_for(inst.getOperand(i).getReg());
    }
    for (const llvm::MCPhysReg reg : description.implicit_uses()) wait_for(reg);
    const uint64_t done = now + duration.latency;
    const auto set = [&](llvm::MCRegister reg) {
      for (const llvm::MCRegUnit unit : registers.regunits(reg)) ready[unit] = done;
    };
    for (unsigned i = 0; i < description.getNumDefs() && i < inst.getNumOperands(); ++i) {
      if (inst.getOperand(i).isReg() && inst.getOperand(i).getReg() != 0) set(inst.getOperand(i).getReg());
    }
    for (const llvm::MCPhysReg reg : description.implicit_defs()) set(reg);
    now += duration.issue;
  }
  return now;
}

uint32_t Timing::TakenCycles() const {
  switch (source_) {
    case Source::kInOrderModel:
      return static_cast<uint32_t>(machine_.subtarget().getSchedModel().MispredictPenalty * kCycle);
    case Source::kCortexM0Plus:
      return kCycle;
    case Source::kThroughputModel:
    case Source::kNone:
      return 0;
  }
  return 0;
}

uint32_t Timing::CallCycles() const {
  // The table gives BL 3 cycles and BX 2.
  return source_ == Source::kCortexM0Plus ? 2 * kCycle : TakenCycles();
}

}  // namespace plcxx::compile::audit
