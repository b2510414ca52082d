#include "transpiler/support/sha256.h"

#include "transpiler/support/module.h"

namespace plcxx::support {

std::string Sha256(std::string_view bytes) {
  static const ModuleFunction function = LoadFunction("plcxx_audit.so", kSha256Symbol);
  std::string digits;
  if (function.address != nullptr) reinterpret_cast<Sha256Function*>(function.address)(bytes, digits);
  return digits;
}

}  // namespace plcxx::support
