// What the parameters of the function that is asked for hold.
#pragma once

#include <llvm/IR/Argument.h>
#include <llvm/IR/Function.h>

#include <vector>

#include "transpiler/prove/verify/llvm_ir/code_values.h"
#include "transpiler/prove/verify/llvm_ir/execution.h"
#include "transpiler/prove/verify/llvm_ir/object_memory.h"

namespace plcxx::prove::verify::llvm_ir {

class Arguments : private ExecutionPart {
 public:
  Arguments(Execution& execution, CodeValues& values, ObjectMemory& memory)
      : ExecutionPart(execution), values_(values), memory_(memory) {}

  /// False: the parameters are others than expected.
  bool Bind(const llvm::Function& function, std::vector<CodeValue>& values);

 private:
  bool BindOne(const llvm::Argument& parameter, const CodeArgument& argument, CodeValue& value);
  bool BindByName(const llvm::Argument& parameter, CodeValue& value);

  CodeValues& values_;
  ObjectMemory& memory_;
};

}  // namespace plcxx::prove::verify::llvm_ir
