#include "transpiler/symbolic/terms/cone.h"

#include <algorithm>

namespace plcxx::terms {
namespace {

template <class IsEntered>
std::vector<TermId> Cone(const Terms& terms, std::span<const TermId> roots, IsEntered&& is_entered) {
  std::vector<bool> seen(terms.size());
  std::vector<TermId> open(roots.begin(), roots.end()), cone;
  while (!open.empty()) {
    const TermId id = open.back();
    open.pop_back();
    if (seen[id.index]) continue;
    seen[id.index] = true;
    cone.push_back(id);
    if (is_entered(terms[id])) terms.ForEachOperand(terms[id], [&open](TermId operand) { open.push_back(operand); });
  }
  std::ranges::sort(cone);
  return cone;
}

}  // namespace

std::vector<TermId> ConeOf(const Terms& terms, std::span<const TermId> roots) {
  return Cone(terms, roots, [](const Term&) { return true; });
}

std::vector<TermId> ConeAboveFunctions(const Terms& terms, std::span<const TermId> roots) {
  return Cone(terms, roots, [](const Term& term) { return term.kind != TermKind::kApply; });
}

}  // namespace plcxx::terms
