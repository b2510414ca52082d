// Calls of the host, which the environment answers.
#pragma once

#include <llvm/IR/Instructions.h>

#include <string>

#include "transpiler/prove/verify/llvm_ir/code_values.h"
#include "transpiler/prove/verify/llvm_ir/execution.h"
#include "transpiler/prove/verify/llvm_ir/object_memory.h"
#include "transpiler/prove/verify/llvm_ir/poison.h"

namespace plcxx::prove::verify::llvm_ir {

class HostCalls : private ExecutionPart {
 public:
  HostCalls(Execution& execution, CodeValues& values, ObjectMemory& memory, Poison& poison)
      : ExecutionPart(execution), values_(values), memory_(memory), poison_(poison) {}

  CodeValue Call(const llvm::CallInst& call, const llvm::Function& callee, const std::string& name);

 private:
  class Memory;
  HostArgument ArgumentOf(const CodeValue& value);
  static bool IsWidened(const llvm::CallInst& call);

  CodeValues& values_;
  ObjectMemory& memory_;
  Poison& poison_;
};

}  // namespace plcxx::prove::verify::llvm_ir
