// Values of the function that executes: constants, globals, and what was computed.
#pragma once

#include <llvm/IR/Constants.h>
#include <llvm/IR/GlobalVariable.h>
#include <llvm/IR/Value.h>

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "transpiler/prove/verify/llvm_ir/execution.h"

namespace plcxx::prove::verify::llvm_ir {

class CodeValues : private ExecutionPart {
 public:
  using ExecutionPart::ExecutionPart;

  CodeValue ValueOf(const llvm::Value* value);
  terms::TermId TermOf(const llvm::Value* value) { return ValueOf(value).term; }
  /// Any value of the type.
  CodeValue AnyOf(const llvm::Type& type);
  /// The same of what a function returns, which may be nothing.
  CodeValue AnyResult(const llvm::Type& type) { return type.isVoidTy() ? CodeValue{} : AnyOf(type); }
  CodeValue PointerTo(uint32_t object, uint64_t offset = 0);
  CodeValue Choose(terms::TermId condition, const CodeValue& then, const CodeValue& otherwise);

 private:
  CodeValue ConstantOf(const llvm::Constant& constant);
  uint32_t ObjectOf(const llvm::GlobalVariable& global);
  uint32_t PlacedObject(const CodeGlobal& global);

  std::unordered_map<const llvm::GlobalVariable*, uint32_t> globals_;  // looked up only
};

/// Of a constant as it lies in memory.
std::vector<int16_t> BytesOf(const llvm::Constant& constant, const llvm::DataLayout& layout);

}  // namespace plcxx::prove::verify::llvm_ir
