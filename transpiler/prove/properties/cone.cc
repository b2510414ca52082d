#include "transpiler/prove/properties/cone.h"

#include "transpiler/prove/terms/cone.h"
#include "transpiler/prove/terms/evaluate.h"

namespace plcxx::prove {

Cone::Cone(const Terms& terms, TermId top)
    : terms_(terms), top_(top), has_(terms.size()), order_(ConeOf(terms, {&top, 1})) {
  for (const TermId id : order_) has_[id.index] = true;
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
