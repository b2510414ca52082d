// Executes functions of LLVM IR on terms: the inner part of the module.
#pragma once

#include <llvm/IR/Module.h>

#include <vector>

#include "transpiler/prove/verify/llvm_ir/addresses.h"
#include "transpiler/prove/verify/llvm_ir/code_values.h"
#include "transpiler/prove/verify/llvm_ir/execution.h"
#include "transpiler/prove/verify/llvm_ir/flow_execution.h"
#include "transpiler/prove/verify/llvm_ir/instruction_execution.h"
#include "transpiler/prove/verify/llvm_ir/loop_execution.h"
#include "transpiler/prove/verify/llvm_ir/object_memory.h"
#include "transpiler/prove/verify/llvm_ir/poison.h"

namespace plcxx::prove::verify::llvm_ir {

/// The parts of one execution. Those of instructions, flow and loops use each other, as code nests them.
class Executor {
 public:
  Executor(const llvm::Module& module, FlowCache& flows, terms::Terms& terms, CodeEnvironment& environment,
           const CodeRun& run)
      : execution_(module.getDataLayout(), flows, terms, environment, run),
        values_(execution_),
        memory_(execution_),
        addresses_(execution_, values_),
        poison_(execution_, values_, memory_),
        instructions_(execution_, values_, memory_, addresses_, poison_, flow_),
        flow_(execution_, values_, memory_, poison_, instructions_, loops_),
        loops_(execution_, memory_, poison_, flow_) {}
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  CodeOutcome Run(const llvm::Function& function);

 private:
  Execution execution_;
  CodeValues values_;
  ObjectMemory memory_;
  Addresses addresses_;
  Poison poison_;
  InstructionExecution instructions_;
  FlowExecution flow_;
  LoopExecution loops_;
};

}  // namespace plcxx::prove::verify::llvm_ir
