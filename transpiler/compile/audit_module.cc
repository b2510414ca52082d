#include "transpiler/compile/audit_module.h"

#include "transpiler/support/module.h"

namespace plcxx::compile {
namespace {

support::ModuleFunction Load() {
#if PLCXX_AUDIT
  return support::LoadFunction("plcxx_audit.so", kReadObjectSymbol);
#else
  return {nullptr, "this plcxx was built without LLVM"};
#endif
}

}  // namespace

ReadObjectFunction LoadObjectReader(std::string& reason) {
  static const support::ModuleFunction loaded = Load();
  reason = loaded.reason;
  return reinterpret_cast<ReadObjectFunction>(loaded.address);
}

}  // namespace plcxx::compile
