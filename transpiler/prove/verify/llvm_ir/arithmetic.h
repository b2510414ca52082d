// Instructions that compute numbers from numbers: operators, comparisons, conversions.
#pragma once

#include <llvm/IR/Instructions.h>

#include "transpiler/prove/verify/llvm_ir/code_values.h"
#include "transpiler/prove/verify/llvm_ir/execution.h"
#include "transpiler/prove/verify/llvm_ir/poison.h"

namespace plcxx::prove::verify::llvm_ir {

class Arithmetic : private ExecutionPart {
 public:
  Arithmetic(Execution& execution, CodeValues& values, Poison& poison)
      : ExecutionPart(execution), values_(values), poison_(poison) {}

  terms::TermId Operate(const llvm::BinaryOperator& inst);
  terms::TermId Compare(const llvm::ICmpInst& inst);
  terms::TermId CompareFloats(const llvm::FCmpInst& inst);
  terms::TermId Convert(const llvm::CastInst& inst);

 private:
  /// A divisor that is never negative where execution comes here, as the program has it that knows so.
  terms::TermId WithoutSign(terms::TermId divisor);
  terms::TermId Divide(const llvm::BinaryOperator& inst, terms::TermId a, terms::TermId b);
  terms::TermId ComparePointers(const llvm::ICmpInst& inst);
  void RequireTold(const Target& one, const Target& other);

  CodeValues& values_;
  Poison& poison_;
};

}  // namespace plcxx::prove::verify::llvm_ir
