// The instructions of one object's architecture, as LLVM's MC layer knows them. Only audit/*.cc include this.
#pragma once

#include <llvm/ADT/ArrayRef.h>
#include <llvm/MC/MCAsmInfo.h>
#include <llvm/MC/MCContext.h>
#include <llvm/MC/MCDisassembler/MCDisassembler.h>
#include <llvm/MC/MCInst.h>
#include <llvm/MC/MCInstrAnalysis.h>
#include <llvm/MC/MCInstrInfo.h>
#include <llvm/MC/MCRegisterInfo.h>
#include <llvm/MC/MCSubtargetInfo.h>
#include <llvm/Object/ELFObjectFile.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace plcxx::compile::audit {

/// What an instruction does to the flow of control.
enum class Flow : uint8_t {
  kNext,          // goes on after itself
  kBranch,        // goes on after itself, or to its target
  kJump,          // goes to its target
  kCall,          // of its target, then on after itself
  kReturn,        // ends the function
  kMaybeReturn,   // ends the function, or goes on after itself
  kIndirectJump,  // where a register says
  kIndirectCall,  // likewise
  kStop           // a trap
};

struct Instruction {
  llvm::MCInst inst;
  uint64_t address = 0;  // within its section
  uint32_t bytes = 0;
  Flow flow = Flow::kNext;
  std::optional<uint64_t> target;  // within its section, where the instruction itself says it
};

/// Disassembler, tables and scheduling model of one architecture.
class MachineCode {
 public:
  /// None with `failure` set when LLVM does not know the architecture.
  static std::unique_ptr<MachineCode> Make(const llvm::object::ELFObjectFileBase& object, std::string processor,
                                           std::string& failure);

  /// Decodes one instruction; false when there is none.
  bool Decode(llvm::ArrayRef<uint8_t> bytes, uint64_t address, Instruction& out);

  const llvm::MCInstrDesc& Describe(const llvm::MCInst& inst) const { return instructions_->get(inst.getOpcode()); }
  llvm::StringRef OpcodeName(const llvm::MCInst& inst) const { return instructions_->getName(inst.getOpcode()); }
  llvm::StringRef RegisterName(llvm::MCRegister reg) const { return registers_->getName(reg); }
  const llvm::MCInstrInfo& instructions() const { return *instructions_; }
  const llvm::MCRegisterInfo& registers() const { return *registers_; }
  const llvm::MCSubtargetInfo& subtarget() const { return *subtarget_; }
  bool is_arm() const { return architecture_ == llvm::Triple::thumb; }
  bool is_riscv() const { return architecture_ == llvm::Triple::riscv32 || architecture_ == llvm::Triple::riscv64; }
  bool is_x86() const { return architecture_ == llvm::Triple::x86_64; }
  const std::string& processor() const { return processor_; }
  /// DWARF's number of the stack pointer.
  uint64_t StackPointer() const { return is_arm() ? 13 : is_riscv() ? 2 : is_x86() ? 7 : 31; }

 private:
  Flow FlowOf(const llvm::MCInst& inst) const;
  Flow ArmFlow(const llvm::MCInst& inst, bool conditional) const;
  bool Names(const llvm::MCInst& inst, unsigned operand, llvm::StringRef name) const;

  llvm::Triple::ArchType architecture_ = llvm::Triple::UnknownArch;
  std::string processor_;
  std::unique_ptr<const llvm::MCRegisterInfo> registers_;
  std::unique_ptr<const llvm::MCAsmInfo> assembly_;
  std::unique_ptr<const llvm::MCInstrInfo> instructions_;
  std::unique_ptr<const llvm::MCSubtargetInfo> subtarget_;
  std::unique_ptr<const llvm::MCInstrAnalysis> analysis_;
  std::unique_ptr<llvm::MCContext> context_;
  std::unique_ptr<const llvm::MCDisassembler> disassembler_;
};

/// How long instructions take: by LLVM's scheduling model of the processor where it has one.
class Timing {
 public:
  explicit Timing(const MachineCode& machine);
  /// In words, for the report.
  std::string Text() const;
  /// Thousandths of a cycle of instructions that are executed one after the other, without what jumps cost.
  uint64_t Cycles(llvm::ArrayRef<Instruction> instructions) const;
  /// What a branch costs on top when it is taken; what a call or return costs on top.
  uint32_t TakenCycles() const;
  uint32_t CallCycles() const;

 private:
  enum class Source : uint8_t { kInOrderModel, kThroughputModel, kCortexM0Plus, kNone };
  struct Duration {
    uint64_t issue;    // thousandths of a cycle until the next one can begin
    uint64_t latency;  // until its result is there
  };
  Duration DurationOf(const llvm::MCInst& inst) const;
  uint64_t RegistersInList(const llvm::MCInst& inst) const;

  const MachineCode& machine_;
  Source source_ = Source::kNone;
};

}  // namespace plcxx::compile::audit
