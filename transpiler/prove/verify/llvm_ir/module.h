// A module of LLVM's instructions as code that can be executed on terms.
#pragma once

#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>

#include <memory>

#include "transpiler/prove/verify/compiled_code.h"

namespace plcxx::prove::verify::llvm_ir {

/// Of a processor that stores the least significant byte first.
std::unique_ptr<CompiledCode> MakeCode(std::unique_ptr<llvm::LLVMContext> context,
                                       std::unique_ptr<llvm::Module> module);

}  // namespace plcxx::prove::verify::llvm_ir
