#include "transpiler/prove/verify/llvm_ir/execution.h"

#include <utility>

#include "transpiler/prove/verify/llvm_ir/function_name.h"

namespace plcxx::prove::verify::llvm_ir {
namespace {

constexpr unsigned kWidest = 64;

}  // namespace

const FlowLevel* FlowCache::Of(const llvm::Function& function) {
  std::unique_ptr<FunctionFlow>& flow = flows_[&function];
  if (flow == nullptr) {
    flow = std::make_unique<FunctionFlow>();
    // The analyses do not change the function.
    flow->dominators.recalculate(const_cast<llvm::Function&>(function));
    flow->loops.analyze(flow->dominators);
    flow->level = MakeFlow(function, flow->loops);
  }
  return flow->level.get();
}

const std::string& FlowCache::NameOf(const llvm::Function& function) {
  std::string& name = names_[&function];
  if (name.empty()) name = NameInSource(function.getName().str());
  return name;
}

Execution::Execution(const llvm::DataLayout& of_module, FlowCache& cache, terms::Terms& all_terms,
                     CodeEnvironment& code_environment, const CodeRun& code_run)
    : layout(of_module),
      flows(cache),
      terms(all_terms),
      environment(code_environment),
      run(code_run),
      ranges(all_terms),
      first_term(all_terms.size()),
      objects{{.kind = ObjectKind::kNull},
              {.kind = ObjectKind::kState, .bytes = code_run.state_bytes},
              {.kind = ObjectKind::kHost}},
      next_slot(code_run.state_bytes + code_run.further_slots),
      context(all_terms.Bit(true)) {
  outcome.left_out = all_terms.Bit(false);
}

void ExecutionPart::Refuse(std::string reason) {
  if (!refused()) outcome_.refusal = std::move(reason);
}

void ExecutionPart::Require(terms::TermId never, const char* text) {
  const terms::TermId condition = terms_.And(context_, never);
  if (!terms_.IsFalse(condition)) outcome_.obligations.push_back({condition, text, environment_.Given()});
}

bool ExecutionPart::IsSupported(const llvm::Type& type) const {
  if (type.isIntegerTy()) return type.getIntegerBitWidth() <= kWidest;
  if (const auto* structure = llvm::dyn_cast<llvm::StructType>(&type)) {
    for (const llvm::Type* element : structure->elements()) {
      if (!IsSupported(*element)) return false;
    }
    return true;
  }
  return type.isFloatTy() || type.isDoubleTy() || (type.isPointerTy() && type.getPointerAddressSpace() == 0);
}

uint8_t ExecutionPart::WidthOf(const llvm::Type& type) const {
  return static_cast<uint8_t>(type.isIntegerTy() ? type.getIntegerBitWidth() : type.isFloatTy() ? 32U : 64U);
}

terms::TermId ExecutionPart::Undefined(uint8_t width) {
  return terms_.Variable("undefined " + std::to_string(terms_.variable_count()), width);
}

terms::TermId ExecutionPart::Either(terms::TermId a, terms::TermId b) {
  if (!a.valid() || !b.valid()) return a.valid() ? a : b;
  return terms_.Or(a, b);
}

terms::TermId ExecutionPart::OrNone(terms::TermId condition) {
  return condition.valid() && terms_.IsFalse(condition) ? terms::TermId() : condition;
}

}  // namespace plcxx::prove::verify::llvm_ir
