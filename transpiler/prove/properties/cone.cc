#include "transpiler/prove/properties/cone.h"

#include <algorithm>

#include "transpiler/prove/terms/evaluate.h"

namespace plcxx::prove {

Cone::Cone(const Terms& terms, TermId top) : terms_(terms), top_(top), has_(terms.size()) {
  std::vector<TermId> open{top};
  while (!open.empty()) {
    const TermId id = open.back();
    open.pop_back();
    if (has_[id.index]) continue;
    has_[id.index] = true;
    order_.push_back(id);
    terms.ForEachOperand(terms[id], [&open](TermId operand) { open.push_back(operand); });
  }
  std::ranges::sort(order_);  // a term is made after its operands
}

uint64_t Cone::Evaluate(std::span<const uint64_t> variables) const {
  std::vector<uint64_t> values(has_.size());
  for (const TermId id : order_) {
    values[id.index] = EvaluateTerm(
        terms_, terms_[id], [&values](TermId operand) { return values[operand.index]; },
        [variables](uint32_t variable) { return variable < variables.size() ? variables[variable] : 0; });
  }
  return values[top_.index];
}

std::vector<CellId> CellsIn(const Terms& terms, TermId term, const std::map<CellId, TermId>& variables) {
  const Cone cone(terms, term);
  std::vector<CellId> cells;
  for (const auto& [cell, variable] : variables) {
    if (cone.Has(variable)) cells.push_back(cell);
  }
  return cells;
}

}  // namespace plcxx::prove
