// One instruction after the other: those that compute, and loads, stores and calls.
#pragma once

#include <llvm/IR/Instructions.h>

#include "transpiler/prove/verify/llvm_ir/addresses.h"
#include "transpiler/prove/verify/llvm_ir/arithmetic.h"
#include "transpiler/prove/verify/llvm_ir/code_values.h"
#include "transpiler/prove/verify/llvm_ir/execution.h"
#include "transpiler/prove/verify/llvm_ir/host_calls.h"
#include "transpiler/prove/verify/llvm_ir/intrinsics.h"
#include "transpiler/prove/verify/llvm_ir/object_memory.h"
#include "transpiler/prove/verify/llvm_ir/poison.h"

namespace plcxx::prove::verify::llvm_ir {

class FlowExecution;

class InstructionExecution : private ExecutionPart {
 public:
  InstructionExecution(Execution& execution, CodeValues& values, ObjectMemory& memory, Addresses& addresses,
                       Poison& poison, FlowExecution& flow)
      : ExecutionPart(execution),
        values_(values),
        memory_(memory),
        addresses_(addresses),
        poison_(poison),
        flow_(flow),
        arithmetic_(execution, values, poison),
        intrinsics_(execution, values, memory, poison),
        host_calls_(execution, values, memory, poison) {}

  void Execute(const llvm::Instruction& inst);
  /// Are its types read, is it not volatile, are there not too many terms? Refuses.
  bool Check(const llvm::Instruction& inst);

 private:
  CodeValue Evaluate(const llvm::Instruction& inst);
  CodeValue Compute(const llvm::Instruction& inst);
  CodeValue Select(const llvm::SelectInst& inst);
  CodeValue Freeze(const llvm::FreezeInst& inst);
  CodeValue Allocate(const llvm::AllocaInst& inst);
  CodeValue Extract(const llvm::ExtractValueInst& inst);
  CodeValue Insert(const llvm::InsertValueInst& inst);
  CodeValue ElementPointer(const llvm::GetElementPtrInst& inst);
  void Store(const llvm::StoreInst& store);
  CodeValue Load(const llvm::LoadInst& load);
  CodeValue LoadAddress(const CodeValue& pointer);
  CodeValue Call(const llvm::CallInst& call);
  bool CallOfStack(const llvm::CallInst& call, llvm::StringRef name);

  CodeValues& values_;
  ObjectMemory& memory_;
  Addresses& addresses_;
  Poison& poison_;
  FlowExecution& flow_;
  Arithmetic arithmetic_;
  Intrinsics intrinsics_;
  HostCalls host_calls_;
};

}  // namespace plcxx::prove::verify::llvm_ir
