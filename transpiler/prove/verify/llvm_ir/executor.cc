#include "transpiler/prove/verify/llvm_ir/executor.h"

#include <utility>

#include "transpiler/prove/verify/llvm_ir/arguments.h"

namespace plcxx::prove::verify::llvm_ir {

CodeOutcome Executor::Run(const llvm::Function& function) {
  CodeOutcome& outcome = execution_.outcome;
  std::vector<CodeValue> arguments;
  if (!Arguments(execution_, values_, memory_).Bind(function, arguments)) {
    if (outcome.refusal.empty())
      outcome.refusal = "the parameters of " + execution_.run.function + " are others than expected";
    return std::move(outcome);
  }
  const CodeValue result = flow_.Call(function, std::move(arguments));
  if (!outcome.refusal.empty()) return std::move(outcome);
  outcome.result = result.term;
  for (uint32_t slot = 0; slot < execution_.run.state_bytes + execution_.run.further_slots; ++slot)
    outcome.slots.push_back(memory_.ReadSlot(slot));
  return std::move(outcome);
}

}  // namespace plcxx::prove::verify::llvm_ir
