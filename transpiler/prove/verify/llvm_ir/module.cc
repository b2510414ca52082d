// The module's functions: bitcode files to one program that can be executed.
#include <llvm/Analysis/LoopInfo.h>
#include <llvm/Bitcode/BitcodeReader.h>
#include <llvm/Bitcode/BitcodeWriter.h>
#include <llvm/IR/Dominators.h>
#include <llvm/IR/LLVMContext.h>
#include <llvm/Linker/Linker.h>
#include <llvm/Support/MemoryBuffer.h>
#include <llvm/Support/raw_ostream.h>
#include <llvm/Transforms/Utils/LoopUtils.h>

#include <set>
#include <unordered_map>
#include <utility>

#include "transpiler/prove/verify/compiled_code.h"
#include "transpiler/prove/verify/llvm_ir/executor.h"
#include "transpiler/prove/verify/llvm_ir/module.h"
#include "transpiler/prove/verify/llvm_ir/source_code.h"
#include "transpiler/support/check.h"

namespace plcxx::prove::verify::llvm_ir {
namespace {

/// What a loop computes leaves it by phis only, so that each way out has its own values.
void CloseLoops(llvm::Function& function) {
  llvm::DominatorTree dominators(function);
  llvm::LoopInfo loops(dominators);
  for (llvm::Loop* loop : loops) llvm::formLCSSARecursively(*loop, dominators, &loops, nullptr);
}

class Code : public CompiledCode {
 public:
  Code(std::unique_ptr<llvm::LLVMContext> context, std::unique_ptr<llvm::Module> module)
      : context_(std::move(context)), module_(std::move(module)) {
    for (llvm::Function& function : *module_) {
      if (function.isDeclaration()) continue;
      CloseLoops(function);
      const std::string& name = flows_.NameOf(function);
      if (!functions_.emplace(name, &function).second) ambiguous_.insert(name);
    }
    for (const llvm::Function& function : *module_) {
      if (!function.isDeclaration() || function.isIntrinsic()) continue;
      if (functions_.contains(flows_.NameOf(function))) ambiguous_.insert(flows_.NameOf(function));
    }
    // Which of them is meant by its name nobody knows: calls lead to each, and are followed.
    for (const std::string& name : ambiguous_) functions_.erase(name);
  }

  CodeOutcome Execute(terms::Terms& terms, CodeEnvironment& environment, const CodeRun& run) override {
    const auto found = functions_.find(run.function);
    if (found == functions_.end()) {
      const bool several = ambiguous_.contains(run.function);
      return {.refusal = (several ? "the code has several functions " : "the code has no function ") + run.function};
    }
    return Executor(*module_, flows_, terms, environment, run).Run(*found->second);
  }

  std::unique_ptr<CompiledCode> Copy() const override {
    llvm::SmallVector<char, 0> bytes;
    llvm::raw_svector_ostream stream(bytes);
    // The order of uses is that in which blocks are found from which one is reached.
    llvm::WriteBitcodeToFile(*module_, stream, /*ShouldPreserveUseListOrder=*/true);
    auto context = std::make_unique<llvm::LLVMContext>();
    auto module = llvm::parseBitcodeFile(llvm::MemoryBufferRef(stream.str(), "copy"), *context);
    PLCXX_CHECK(static_cast<bool>(module));
    return std::make_unique<Code>(std::move(context), std::move(*module));
  }

  std::optional<std::vector<std::string>> Parameters(const std::string& function) const override {
    const auto found = functions_.find(function);
    if (found == functions_.end()) return std::nullopt;
    std::vector<std::string> names;
    for (const llvm::Argument& parameter : found->second->args()) names.push_back(parameter.getName().str());
    return names;
  }

  std::optional<NumberRange> ResultRange(const std::string& function) const override {
    const auto found = functions_.find(function);
    if (found == functions_.end() || !found->second->hasRetAttribute(llvm::Attribute::Range)) return std::nullopt;
    const llvm::ConstantRange& range = found->second->getRetAttribute(llvm::Attribute::Range).getRange();
    if (range.isFullSet() || range.isEmptySet()) return std::nullopt;
    const llvm::APInt count = range.getUpper() - range.getLower();
    return NumberRange{.low = range.getLower().getZExtValue(), .count = count.getZExtValue()};
  }

  std::vector<int16_t> InitialBytes(const std::string& global) const override {
    const llvm::GlobalVariable* found = module_->getGlobalVariable(global, /*AllowInternal=*/true);
    if (found == nullptr || !found->hasInitializer()) return {};
    return BytesOf(*found->getInitializer(), module_->getDataLayout());
  }

 private:
  std::unique_ptr<llvm::LLVMContext> context_;
  std::unique_ptr<llvm::Module> module_;
  std::unordered_map<std::string, const llvm::Function*> functions_;  // by name in C++; looked up only
  std::set<std::string> ambiguous_;                                   // names that several have
  FlowCache flows_;
};

/// What is executed outside of the functions that are compared; empty: nothing.
std::string OutsideOfFunctions(const llvm::Module& module) {
  if (!module.getModuleInlineAsm().empty()) return "assembler outside of functions";
  for (const char* const list : {"llvm.global_ctors", "llvm.global_dtors"}) {
    const llvm::GlobalVariable* functions = module.getGlobalVariable(list);
    if (functions != nullptr && !functions->getValueType()->isEmptyTy() &&
        !(functions->hasInitializer() && functions->getInitializer()->isNullValue()))
      return "functions that run before or after the program's (" + std::string(list) + ")";
  }
  // What is loaded from where, and when, is not for the code to say.
  for (const llvm::Function& function : module) {
    if (!function.isDeclaration() && function.hasSection())
      return "a function in a section that it names (" + function.getSection().str() + ")";
  }
  // The start-up code calls what stands in some of them (.init_array).
  for (const llvm::GlobalVariable& variable : module.globals()) {
    if (!variable.isDeclaration() && variable.hasSection() && !variable.getName().starts_with("llvm."))
      return "data in a section that it names (" + variable.getSection().str() + ")";
  }
  return {};
}

/// A name that no function of C++ has: what the compiler takes for its library's (memset, __udivdi3), it calls without
/// saying so. Empty: there is none.
std::string NameOfLibrary(const llvm::Module& module) {
  const auto is_plain = [](const llvm::GlobalValue& value) {
    return !value.isDeclaration() && !value.getName().starts_with("_Z");
  };
  for (const llvm::Function& function : module) {
    if (is_plain(function)) return function.getName().str();
  }
  for (const llvm::GlobalAlias& alias : module.aliases()) {
    if (is_plain(alias)) return alias.getName().str();
  }
  for (const llvm::GlobalIFunc& choice : module.ifuncs()) {
    if (is_plain(choice)) return choice.getName().str();
  }
  for (const llvm::GlobalVariable& variable : module.globals()) {
    if (is_plain(variable) && !variable.hasLocalLinkage() && !variable.getName().starts_with("llvm."))
      return variable.getName().str();
  }
  return {};
}

/// `source`: what is done with code of the sources' language; none: with generated code.
std::unique_ptr<CompiledCode> ReadBitcode(std::span<const std::string> bitcode, const SourceCode* source,
                                          std::string& reason) {
  auto context = std::make_unique<llvm::LLVMContext>();
  std::unique_ptr<llvm::Module> all;
  for (const std::string& bytes : bitcode) {
    auto module = llvm::parseBitcodeFile(llvm::MemoryBufferRef(bytes, "generated code"), *context);
    if (!module) {
      reason = "the compiler's bitcode cannot be read: " + llvm::toString(module.takeError());
      return nullptr;
    }
    if (const std::string outside = OutsideOfFunctions(**module); !outside.empty()) {
      reason = "the code has " + outside;
      return nullptr;
    }
    if (const std::string name = NameOfLibrary(**module); source == nullptr && !name.empty()) {
      reason = "the code defines a name that is not of C++ (" + name + ")";
      return nullptr;
    }
    if (all == nullptr) {
      all = std::move(*module);
    } else if (llvm::Linker::linkModules(*all, std::move(*module))) {
      reason = "the files of the generated code do not fit together";
      return nullptr;
    }
  }
  if (all == nullptr || !all->getDataLayout().isLittleEndian()) {
    reason = "there is no code for a processor that stores the least significant byte first";
    return nullptr;
  }
  if (source != nullptr) AdaptSource(*all, *source);
  return MakeCode(std::move(context), std::move(all));
}

}  // namespace

std::unique_ptr<CompiledCode> MakeCode(std::unique_ptr<llvm::LLVMContext> context,
                                       std::unique_ptr<llvm::Module> module) {
  return std::make_unique<Code>(std::move(context), std::move(module));
}

}  // namespace plcxx::prove::verify::llvm_ir

extern "C" [[gnu::visibility("default")]] plcxx::prove::verify::CompiledCode* plcxx_read_code(
    std::span<const std::string> bitcode, std::string& reason) {
  return plcxx::prove::verify::llvm_ir::ReadBitcode(bitcode, nullptr, reason).release();
}

extern "C" [[gnu::visibility("default")]] plcxx::prove::verify::CompiledCode* plcxx_read_source(
    const plcxx::prove::verify::SourceCode& source, std::string& reason) {
  return plcxx::prove::verify::llvm_ir::ReadBitcode({&source.bitcode, 1}, &source, reason).release();
}
