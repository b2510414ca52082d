#include "transpiler/sim/same_arguments.h"

#include "transpiler/sim/value_text.h"

namespace plcxx::sim {

bool SameArguments(const ir::HostFunction& function, std::span<const uint64_t> a, std::span<const uint64_t> b) {
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i) {
    const ir::Type type = i < function.parameters.size() ? function.parameters[i].type : ir::Type::kNone;
    if (!SameValue(type, a[i], b[i])) return false;
  }
  return true;
}

}  // namespace plcxx::sim
