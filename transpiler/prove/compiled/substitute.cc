#include "transpiler/prove/compiled/substitute.h"

#include <unordered_map>
#include <vector>

#include "transpiler/prove/terms/cone.h"

namespace plcxx::prove {

TermId Substitute(Terms& terms, TermId term, const Replacements& replacements) {
  std::unordered_map<uint32_t, TermId> changed;  // looked up only
  const auto now = [&changed](TermId id) {
    const auto at = changed.find(id.index);
    return at == changed.end() ? id : at->second;
  };
  std::vector<TermId> operands;
  for (const TermId id : ConeOf(terms, {&term, 1})) {
    if (const auto at = replacements.find(id); at != replacements.end()) {
      changed.emplace(id.index, at->second);
      continue;
    }
    const Term copy = terms[id];  // Rebuild moves the table
    operands.clear();
    bool differs = false;
    terms.ForEachOperand(copy, [&](TermId operand) {
      operands.push_back(now(operand));
      differs = differs || operands.back() != operand;
    });
    if (differs) changed.emplace(id.index, terms.Rebuild(copy, operands));
  }
  return now(term);
}

}  // namespace plcxx::prove
