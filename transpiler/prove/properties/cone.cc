#include "transpiler/prove/properties/cone.h"

#include "transpiler/prove/terms/cone.h"
#include "transpiler/prove/terms/evaluate.h"

namespace plcxx::prove {

Cone::Cone(const Terms& terms, TermId top)
    : terms_(terms), top_(top), has_(terms.size()), order_(ConeOf(terms, {&top, 1})) {
  for (const TermId id : order_) {
    has_[id.index] = true;
    const Term& term = terms[id];
    if (term.kind == TermKind::kApply && terms.Info(FunctionId(term.a)).evaluate == nullptr)
      has_unknown_function_ = true;
  }
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

std::vector<CellId> CellsBehind(const Terms& terms, const Relation& relation, std::span<const CellId> cells) {
  std::vector<bool> seen_terms(terms.size()), seen_cells(relation.period().size());
  std::vector<CellId> behind;
  const auto add = [&](CellId cell) {
    if (!cell.valid() || seen_cells[cell.index]) return;
    seen_cells[cell.index] = true;
    behind.push_back(cell);
  };
  for (const CellId cell : cells) add(cell);
  for (size_t at = 0; at < behind.size(); ++at) {
    std::vector<TermId> open;
    for (const std::vector<TermId>* const part : {&relation.fast(), &relation.period()}) {
      if (behind[at].index < part->size() && (*part)[behind[at].index].valid()) {
        open.push_back((*part)[behind[at].index]);
      }
    }
    while (!open.empty()) {
      const TermId term = open.back();
      open.pop_back();
      if (seen_terms[term.index]) continue;
      seen_terms[term.index] = true;
      if (terms[term].kind == TermKind::kVariable) add(relation.CellOf(term));
      terms.ForEachOperand(terms[term], [&open](TermId operand) { open.push_back(operand); });
    }
  }
  return behind;
}

}  // namespace plcxx::prove
