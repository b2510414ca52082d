#include "transpiler/prove/verify/llvm_ir/function_name.h"

#include <llvm/Demangle/Demangle.h>

#include <cstdlib>
#include <memory>

namespace plcxx::prove::verify::llvm_ir {

std::string NameInSource(const std::string& symbol) {
  // What the linker or the compiler adds is no part of the name.
  const std::string mangled = symbol.substr(0, symbol.find('.'));
  llvm::ItaniumPartialDemangler demangler;
  if (demangler.partialDemangle(mangled.c_str()) || !demangler.isFunction()) return llvm::demangle(symbol);
  size_t size = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(demangler.getFunctionName(nullptr, &size), &std::free);
  return name == nullptr ? llvm::demangle(symbol) : std::string(name.get());
}

}  // namespace plcxx::prove::verify::llvm_ir
