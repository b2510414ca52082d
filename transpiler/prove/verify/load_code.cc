#include "transpiler/prove/verify/compiled_code.h"
#include "transpiler/support/module.h"

namespace plcxx::prove::verify {

LoadedCode LoadCode(std::span<const std::string> bitcode) {
  const support::ModuleFunction function = support::LoadFunction(kVerifyModule, kReadCode);
  if (function.address == nullptr) return {.code = nullptr, .reason = function.reason};
  auto* const read = reinterpret_cast<ReadCodeFunction*>(function.address);
  LoadedCode loaded;
  loaded.code.reset(read(bitcode, loaded.reason));
  return loaded;
}

LoadedCode LoadSourceCode(const SourceCode& source) {
  const support::ModuleFunction function = support::LoadFunction(kVerifyModule, kReadSource);
  if (function.address == nullptr) return {.code = nullptr, .reason = function.reason};
  auto* const read = reinterpret_cast<ReadSourceFunction*>(function.address);
  LoadedCode loaded;
  loaded.code.reset(read(source, loaded.reason));
  return loaded;
}

}  // namespace plcxx::prove::verify
