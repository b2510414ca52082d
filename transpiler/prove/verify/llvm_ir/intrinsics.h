// LLVM's own functions.
#pragma once

#include <llvm/IR/IntrinsicInst.h>

#include "transpiler/prove/verify/llvm_ir/code_values.h"
#include "transpiler/prove/verify/llvm_ir/execution.h"
#include "transpiler/prove/verify/llvm_ir/object_memory.h"
#include "transpiler/prove/verify/llvm_ir/poison.h"

namespace plcxx::prove::verify::llvm_ir {

class Intrinsics : private ExecutionPart {
 public:
  Intrinsics(Execution& execution, CodeValues& values, ObjectMemory& memory, Poison& poison)
      : ExecutionPart(execution), values_(values), memory_(memory), poison_(poison) {}

  CodeValue Execute(const llvm::IntrinsicInst& call);

 private:
  void Assume(const llvm::AssumeInst& assumption);
  void Transfer(const llvm::MemIntrinsic& call);
  CodeValue WithOverflow(const llvm::WithOverflowInst& call);
  terms::TermId Saturated(const llvm::SaturatingInst& call);
  terms::TermId OfInteger(const llvm::IntrinsicInst& call);
  terms::TermId CountBits(const llvm::IntrinsicInst& call, terms::TermId a);
  terms::TermId OfFloat(const llvm::IntrinsicInst& call);

  CodeValues& values_;
  ObjectMemory& memory_;
  Poison& poison_;
};

}  // namespace plcxx::prove::verify::llvm_ir
