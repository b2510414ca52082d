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
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "transpiler/compile/audit/machine_code.h"
#include "transpiler/prove/compiled/machine_code/convention.h"
#include "transpiler/prove/compiled/machine_code/objects.h"
#include "transpiler/prove/compiled/object_code.h"

namespace plcxx::prove::compiled::machine_code {

/// Without folding: what an address is made of stays visible.
using Builder = llvm::IRBuilder<llvm::NoFolder>;

class Program;

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
  /// The following instruction is executed only then.
  void BeginGuard(llvm::Value* condition);
  void EndGuard();

  const compile::audit::Instruction& current() const { return *current_; }
  /// The linker's note of one of these types at the current instruction.
  const Link* LinkAt(std::initializer_list<uint64_t> types) const;
  /// The address of a place in a section, or of what a link leads to; none: not of a constant.
  llvm::Value* AddressOf(const Link& link);
  const Section& section() const;
  const Function& function() const;
  /// In this function's section, where a link leads into it.
  std::optional<uint64_t> TargetOf(const Link& link) const;
  Program& program() { return program_; }

 private:
  bool Decode();
  void FindBlocks();
  llvm::BasicBlock* BlockAt(uint64_t address);
  void CallSignature(const Signature& signature, const std::string& symbol, std::optional<uint32_t> defined);
  void CallLifted(llvm::Function& callee);
  /// Whether it is a function of the compiler's library that is known (library.def).
  bool CallLibrary(const std::string& symbol);

  Program& program_;
  uint32_t number_;
  llvm::Function& target_;
  Builder builder_;
  std::vector<compile::audit::Instruction> code_;
  const compile::audit::Instruction* current_ = nullptr;
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
  llvm::GlobalVariable& ConstantsOf(uint32_t section);
  /// Whether it, or what it calls, may write the register.
  bool MayWrite(uint32_t function, unsigned number) const { return writes_[function][number]; }

 private:
  void FindWrites();
  void AddWrapper(uint32_t function, const Signature& signature);

  llvm::LLVMContext& context_;
  const Objects& objects_;
  compile::audit::MachineCode& machine_;
  const Convention& convention_;
  std::unordered_map<std::string, const Signature*> signatures_;  // by name in C++; looked up only
  std::unique_ptr<llvm::Module> module_;
  std::vector<llvm::Function*> lifted_;    // by function
  std::vector<std::vector<bool>> writes_;  // by function and register
  std::map<uint32_t, llvm::GlobalVariable*> constants_;
};

/// One instruction, by the architecture.
void LiftRiscv(FunctionLifter& lifter);
void LiftArm(FunctionLifter& lifter);

/// Optimizes nothing but registers into values.
void PromoteRegisters(llvm::Function& function);

}  // namespace plcxx::prove::compiled::machine_code
