// Machine code as LLVM's instructions, so that the executor of those (llvm_ir/) executes it.
//
//   addi a5, a0, 4        %1 = load i32, ptr %a0          registers are variables, which become values (mem2reg)
//   sb   zero, 2(a5)  ->  %2 = add i32 %1, 4
//                         %3 = add i32 %2, 2              addresses are numbers: State's own plus an offset
//                         %4 = inttoptr i32 %3 to ptr
//                         store i8 0, ptr %4
//
// A function of machine code becomes one from all registers to all registers, exactly what it does. Around a function
// that C++ declares stands another one of its symbol that calls it as the target's convention says, with a stack of its
// own, and demands what callers rely on: the registers that are kept, the stack pointer, the way back.
// In: objects. Out: a module. Not its job: what single instructions mean (riscv.cc, arm.cc).
#pragma once

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>
#include <llvm/IR/NoFolder.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "transpiler/compile/audit/machine_code.h"
#include "transpiler/prove/verify/machine_code/convention.h"
#include "transpiler/prove/verify/machine_code/objects.h"
#include "transpiler/prove/verify/object_code.h"

namespace plcxx::prove::verify::machine_code {

/// Without folding: what an address is made of stays visible.
using Builder = llvm::IRBuilder<llvm::NoFolder>;

class Program;

/// Of addresses that two instructions make.
enum class AddressPart : uint8_t {
  kCounterUpper,         // auipc, which the note at this place is for
  kUpper,                // lui
  kRelaxedCounterUpper,  // of those that the linker may leave out: then the other half needs no register
  kRelaxedUpper,
  kLow  // movw
};

/// One function while it is lifted. The architecture's part calls these for each instruction, in order.
class FunctionLifter {
 public:
  FunctionLifter(Program& program, uint32_t function, llvm::Function& target);

  void Run();

  // Registers, by the architecture's numbers.
  llvm::Value* Get(unsigned number);
  void Set(unsigned number, llvm::Value* value);
  // Flags of width 1, by number.
  llvm::Value* GetFlag(unsigned number);
  void SetFlag(unsigned number, llvm::Value* value);

  Builder& build() { return builder_; }
  llvm::IntegerType* Word() const;
  /// Its low bits.
  llvm::Value* Number(uint64_t value) const;
  /// What no instruction has written: another number each time.
  llvm::Value* Unknown();
  llvm::Value* Load(llvm::Value* address, unsigned bits, unsigned align);
  /// A quotient or rest that no operand makes undefined: by 0 it is `by_zero`, and the least number by -1 is itself,
  /// with rest 0.
  llvm::Value* Divide(llvm::Value* a, llvm::Value* b, llvm::Instruction::BinaryOps operation, llvm::Value* by_zero);
  void Store(llvm::Value* address, llvm::Value* value, unsigned align);

  // What ends a block, or may.
  void BranchIf(llvm::Value* condition, uint64_t target);
  void JumpTo(uint64_t target);
  void Call(const Link& link);
  /// Its callee returns to our caller.
  void TailCall(const Link& link);
  /// Flags and registers that a callee need not give back; of one that is known, those that it may write.
  void ForgetAfterCall(std::optional<uint32_t> callee = std::nullopt);
  void ForgetFlags();
  /// To an address that must be the one that the caller gave.
  void ReturnTo(llvm::Value* address);
  /// What comes here is refused.
  void Refuse(const std::string& what);
  /// Shown to be so wherever execution comes here.
  void Demand(llvm::Value* condition) { builder_.CreateAssumption(condition); }
  /// Interrupts write below the stack pointer at any time.
  void DemandNotBelowStack(llvm::Value* address);
  /// The following instruction is executed only then.
  void BeginGuard(llvm::Value* condition);
  void EndGuard();

  const compile::audit::Instruction& current() const { return *current_; }
  /// The instruction behind it; none: it is the function's last.
  const compile::audit::Instruction* next() const {
    return current_ + 1 == code_.data() + code_.size() ? nullptr : current_ + 1;
  }
  /// The instruction in front of it; none: it is the function's first.
  const compile::audit::Instruction* previous() const { return current_ == code_.data() ? nullptr : current_ - 1; }
  /// Whether a branch leads to the current instruction.
  bool IsBranchTarget() const { return targets_.contains(current_->address); }
  /// The linker's note of one of these types at the current instruction, which is executed with what the note says. A
  /// function with a note that no instruction asks for is refused.
  const Link* LinkAt(std::initializer_list<uint64_t> types);
  /// Whether the linker may make a shorter instruction of it, or none.
  bool MayBeRelaxed() const;
  /// Whether the linker may change how far it is from the current instruction to that place.
  bool MayMoveTo(uint64_t target) const;
  /// The address of what a link leads to; none: not of a constant.
  llvm::Value* AddressOf(const Link& link);
  /// What a register holds after the first of two instructions that make an address: a number that nothing is known of,
  /// always the same for one part and place. No access by it is executed.
  llvm::Value* PartOf(AddressPart part, const Place& place);
  const Section& section() const;
  const Function& function() const;
  /// In this function's section, where a link leads into it.
  std::optional<uint64_t> TargetOf(const Link& link) const;
  Program& program() { return program_; }

 private:
  void FindBlocks();
  bool HasOpenNote() const;
  bool DoesNothing() const;
  /// Interrupts and callees write below the stack pointer; callees also into what they are given, so many bytes
  /// above it.
  void ForgetBelowStack(uint64_t above = 0);
  /// That it leads into the stack that the function was given, and is aligned so.
  void DemandStack(llvm::Value* pointer, unsigned align);
  llvm::BasicBlock* BlockAt(uint64_t address);
  void CallSignature(const Signature& signature, const std::string& symbol, std::optional<uint32_t> defined);
  void CallLifted(llvm::Function& callee);
  /// Whether it is a function of the compiler's library that is known (library.def).
  bool CallLibrary(const std::string& symbol);

  Program& program_;
  uint32_t number_;
  llvm::Function& target_;
  Builder builder_;
  const std::vector<compile::audit::Instruction>& code_;
  const compile::audit::Instruction* current_ = nullptr;
  std::set<uint64_t> targets_;        // of branches
  std::set<const Link*> understood_;  // notes of the linker
  std::map<uint64_t, llvm::BasicBlock*> blocks_;
  std::vector<llvm::AllocaInst*> registers_, flags_;
  llvm::AllocaInst* unknown_ = nullptr;
  llvm::BasicBlock* exit_ = nullptr;
  llvm::BasicBlock* after_guard_ = nullptr;
};

class Program {
 public:
  Program(llvm::LLVMContext& context, const Objects& objects, compile::audit::MachineCode& machine,
          std::span<const Signature> signatures);

  std::unique_ptr<llvm::Module> Lift();

  const Objects& objects() const { return objects_; }
  compile::audit::MachineCode& machine() { return machine_; }
  const Convention& convention() const { return convention_; }
  llvm::Module& module() { return *module_; }
  /// As registers, in order.
  llvm::FunctionType* LiftedType() const;
  llvm::Function& Lifted(uint32_t function) { return *lifted_[function]; }
  const Signature* SignatureOf(const std::string& symbol) const;
  llvm::Function& Declared(const std::string& symbol, const Signature& signature);
  /// What comes there is refused.
  void CallRefusal(Builder& build, const std::string& what);
  /// Of these bytes of it.
  llvm::GlobalVariable& ConstantsOf(uint32_t section, uint64_t first, uint64_t bytes);
  llvm::GlobalVariable& PartOf(AddressPart part, const Place& place);
  /// In order, without the constants among them; empty: there are bytes that are no instruction.
  const std::vector<compile::audit::Instruction>& InstructionsOf(uint32_t function) const { return code_[function]; }
  /// How many bytes the linker writes for a note.
  uint64_t BytesOf(const Link& link) const;
  /// Those for which it writes into any of these bytes, with their places.
  std::vector<std::pair<uint64_t, const Link*>> NotesOn(const Section& section, uint64_t begin, uint64_t bytes) const;
  /// A number as words of registers, the low one first, and back.
  std::vector<llvm::Value*> Split(Builder& build, llvm::Value* value) const;
  llvm::Value* Join(Builder& build, std::span<llvm::Value* const> words, unsigned width) const;
  /// Whether it, or what it calls, may write the register.
  bool MayWrite(uint32_t function, unsigned number) const { return writes_[function][number]; }

 private:
  void Decode();
  unsigned InstructionsUnder(const llvm::MCInst& inst) const;
  void EndConditions();
  void NoteWrites(const llvm::MCInst& inst, std::vector<bool>& writes) const;
  void FindWrites();
  void AddWrapper(uint32_t function, const Signature& signature);

  llvm::LLVMContext& context_;
  const Objects& objects_;
  compile::audit::MachineCode& machine_;
  const Convention& convention_;
  std::unordered_map<std::string, const Signature*> signatures_;  // by name in C++; looked up only
  std::unordered_map<std::string, uint32_t> wrapped_;             // by symbol; looked up only
  std::unique_ptr<llvm::Module> module_;
  std::vector<llvm::Function*> lifted_;                         // by function
  std::vector<std::vector<bool>> writes_;                       // by function and register
  std::vector<std::vector<compile::audit::Instruction>> code_;  // by function
  std::map<Place, llvm::GlobalVariable*> constants_;
  std::map<std::pair<AddressPart, Place>, llvm::GlobalVariable*> parts_;
};

/// One instruction, by the architecture.
void LiftRiscv(FunctionLifter& lifter);
void LiftArm(FunctionLifter& lifter);

/// Optimizes nothing but registers into values.
void PromoteRegisters(llvm::Function& function);

}  // namespace plcxx::prove::verify::machine_code
