#include "transpiler/prove/verify/substitute.h"

#include <unordered_map>
#include <vector>

#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::verify {

terms::TermId Substitute(terms::Terms& terms, terms::TermId term, const Replacements& replacements) {
  std::unordered_map<uint32_t, terms::TermId> changed;  // looked up only
  const auto now = [&changed](terms::TermId id) {
    const auto at = changed.find(id.index);
    return at == changed.end() ? id : at->second;
  };
  std::vector<terms::TermId> operands;
  for (const terms::TermId id : terms::ConeOf(terms, {&term, 1})) {
    if (const auto at = replacements.find(id); at != replacements.end()) {
      changed.emplace(id.index, at->second);
      continue;
    }
    const terms::Term copy = terms[id];  // Rebuild moves the table
    operands.clear();
    bool differs = false;
    terms.ForEachOperand(copy, [&](terms::TermId operand) {
      operands.push_back(now(operand));
      differs = differs || operands.back() != operand;
    });
    if (differs) changed.emplace(id.index, terms.Rebuild(copy, operands));
  }
  return now(term);
}

}  // namespace plcxx::prove::verify
