#include "transpiler/prove/verify/llvm_ir/executor.h"

#include <algorithm>
#include <utility>

#include "transpiler/prove/verify/llvm_ir/arguments.h"

namespace plcxx::prove::verify::llvm_ir {

namespace {

/// Whether others can call it as its declaration says; what they give and get has zeros above it.
bool IsCalledAsDeclared(const llvm::Function& function) {
  if (function.hasLocalLinkage()) return true;
  const auto has_sign = [](const llvm::Argument& parameter) { return parameter.hasSExtAttr(); };
  for (const char* other : {"no_caller_saved_registers", "no_callee_saved_registers", "interrupt"}) {
    if (function.hasFnAttribute(other)) return false;
  }
  return function.getCallingConv() == llvm::CallingConv::C && !function.hasRetAttribute(llvm::Attribute::SExt) &&
         std::none_of(function.arg_begin(), function.arg_end(), has_sign);
}

}  // namespace

CodeOutcome Executor::Run(const llvm::Function& function) {
  CodeOutcome& outcome = execution_.outcome;
  if (execution_.run.language == CodeRun::Language::kCpp && !IsCalledAsDeclared(function)) {
    outcome.refusal = execution_.run.function + " is called in another way than its declaration says";
    return std::move(outcome);
  }
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
