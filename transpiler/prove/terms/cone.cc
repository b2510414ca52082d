#include "transpiler/prove/terms/cone.h"

#include <algorithm>

namespace plcxx::prove {

std::vector<TermId> ConeOf(const Terms& terms, std::span<const TermId> roots) {
  std::vector<bool> seen(terms.size());
  std::vector<TermId> open(roots.begin(), roots.end()), cone;
  while (!open.empty()) {
    const TermId id = open.back();
    open.pop_back();
    if (seen[id.index]) continue;
    seen[id.index] = true;
    cone.push_back(id);
    terms.ForEachOperand(terms[id], [&open](TermId operand) { open.push_back(operand); });
  }
  std::ranges::sort(cone);
  return cone;
}

}  // namespace plcxx::prove
