#include "transpiler/symbolic/terms/cone.h"

#include <algorithm>
#include <bit>

namespace plcxx::terms {
namespace {

constexpr uint32_t kWordBits = 64;

/// An operand is made before what it is an operand of, so its index is lower: from the highest root down, each term is
/// met when all that lead to it have been, and the order needs no sorting.
template <class IsEntered>
std::vector<TermId> Cone(const Terms& terms, std::span<const TermId> roots, IsEntered&& is_entered) {
  uint32_t highest = 0;
  for (const TermId root : roots) highest = std::max(highest, root.index);
  std::vector<uint64_t> reached(highest / kWordBits + 1);
  const auto reach = [&reached](TermId id) { reached[id.index / kWordBits] |= uint64_t{1} << id.index % kWordBits; };
  std::ranges::for_each(roots, reach);
  std::vector<TermId> cone;
  for (size_t word = reached.size(); word-- != 0;) {
    while (reached[word] != 0) {
      const auto bit = static_cast<uint32_t>(std::bit_width(reached[word])) - 1;
      reached[word] &= ~(uint64_t{1} << bit);
      const TermId id(static_cast<uint32_t>(word) * kWordBits + bit);
      cone.push_back(id);
      if (is_entered(terms[id])) terms.ForEachOperand(terms[id], reach);
    }
  }
  std::ranges::reverse(cone);
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
