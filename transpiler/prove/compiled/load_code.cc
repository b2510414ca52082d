#include "transpiler/prove/compiled/compiled_code.h"
#include "transpiler/support/module.h"

namespace plcxx::prove {

LoadedCode LoadCode(std::span<const std::string> bitcode) {
  const support::ModuleFunction function = support::LoadFunction(kVerifyModule, kReadCode);
  if (function.address == nullptr) return {.code = nullptr, .reason = function.reason};
  auto* const read = reinterpret_cast<ReadCodeFunction*>(function.address);
  LoadedCode loaded;
  loaded.code.reset(read(bitcode, loaded.reason));
  return loaded;
}

std::string Sha256(std::string_view bytes) {
  const support::ModuleFunction function = support::LoadFunction(kVerifyModule, kSha256);
  std::string digits;
  if (function.address != nullptr) reinterpret_cast<Sha256Function*>(function.address)(bytes, digits);
  return digits;
}

}  // namespace plcxx::prove
