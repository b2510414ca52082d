#include "transpiler/dialects/hnc/parser/module_loading.h"

#include "transpiler/support/module.h"

namespace plcxx::hnc {
namespace {

support::ModuleFunction Load() {
#if PLCXX_HNC
  return support::LoadFunction("plcxx_hnc_parser.so", kParseSymbol);
#else
  return {nullptr, "it was built without Clang"};
#endif
}

}  // namespace

ParseFunction LoadParser(std::string& reason) {
  static const support::ModuleFunction loaded = Load();
  reason = loaded.reason;
  return reinterpret_cast<ParseFunction>(loaded.address);
}

}  // namespace plcxx::hnc
