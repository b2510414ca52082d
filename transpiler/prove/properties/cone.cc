#include "transpiler/prove/properties/cone.h"

#include "transpiler/symbolic/terms/cone.h"
#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::prove::properties {
namespace {

constexpr size_t kMostCompared = 200;  // terms of one side of a comparison

}  // namespace

Cone::Cone(const terms::Terms& terms, terms::TermId top)
    : terms_(terms), top_(top), has_(terms.size()), order_(terms::ConeOf(terms, {&top, 1})) {
  for (const terms::TermId id : order_) {
    has_[id.index] = true;
    const terms::Term& term = terms[id];
    if (term.kind == terms::TermKind::kApply && terms.Info(terms::FunctionId(term.a)).evaluate == nullptr)
      has_unknown_function_ = true;
  }
}

uint64_t Cone::Evaluate(std::span<const uint64_t> variables) const {
  std::vector<uint64_t> values(has_.size());
  for (const terms::TermId id : order_) {
    values[id.index] = terms::EvaluateTerm(
        terms_, terms_[id], [&values](terms::TermId operand) { return values[operand.index]; },
        [variables](uint32_t variable) { return variable < variables.size() ? variables[variable] : 0; });
  }
  return values[top_.index];
}

std::vector<execute::CellId> CellsIn(const terms::Terms& terms, terms::TermId term,
                                     const std::map<execute::CellId, terms::TermId>& variables) {
  const Cone cone(terms, term);
  std::vector<execute::CellId> cells;
  for (const auto& [cell, variable] : variables) {
    if (cone.Has(variable)) cells.push_back(cell);
  }
  return cells;
}

std::map<terms::TermId, std::set<uint64_t>> ConstantsComparedWith(const terms::Terms& terms,
                                                                  std::span<const terms::TermId> roots) {
  std::map<terms::TermId, std::set<uint64_t>> constants;
  for (const terms::TermId id : terms::ConeOf(terms, roots)) {
    const terms::Term& term = terms[id];
    using enum terms::TermKind;
    if (term.kind != kEq && term.kind != kUlt && term.kind != kSlt) continue;
    const terms::TermId a(term.a), b(term.b);
    if (terms.IsConst(a) == terms.IsConst(b)) continue;
    const uint64_t constant = terms.Value(terms.IsConst(a) ? a : b);
    std::set<terms::TermId> seen;
    std::vector<terms::TermId> open{terms.IsConst(a) ? b : a};
    while (!open.empty() && seen.size() < kMostCompared) {
      const terms::TermId at = open.back();
      open.pop_back();
      if (!seen.insert(at).second) continue;
      const terms::Term& part = terms[at];
      if (part.kind == kVariable) constants[at].insert(constant);
      if (part.kind == kIte) open.insert(open.end(), {terms::TermId(part.b), terms::TermId(part.c)});
      if (part.kind == kAdd || part.kind == kSub || part.kind == kConcat || part.kind == kExtract)
        terms.ForEachOperand(part, [&open](terms::TermId operand) { open.push_back(operand); });
    }
  }
  return constants;
}

std::vector<execute::CellId> CellsBehind(const terms::Terms& terms, const machine::Relation& relation,
                                         std::span<const execute::CellId> cells) {
  std::vector<bool> seen_terms(terms.size()), seen_cells(relation.period().size());
  std::vector<execute::CellId> behind;
  const auto add = [&](execute::CellId cell) {
    if (!cell.valid() || seen_cells[cell.index]) return;
    seen_cells[cell.index] = true;
    behind.push_back(cell);
  };
  for (const execute::CellId cell : cells) add(cell);
  for (size_t at = 0; at < behind.size(); ++at) {
    std::vector<terms::TermId> open;
    for (const std::vector<terms::TermId>* const part : {&relation.fast(), &relation.period()}) {
      if (behind[at].index < part->size() && (*part)[behind[at].index].valid()) {
        open.push_back((*part)[behind[at].index]);
      }
    }
    while (!open.empty()) {
      const terms::TermId term = open.back();
      open.pop_back();
      if (seen_terms[term.index]) continue;
      seen_terms[term.index] = true;
      if (terms[term].kind == terms::TermKind::kVariable) add(relation.CellOf(term));
      terms.ForEachOperand(terms[term], [&open](terms::TermId operand) { open.push_back(operand); });
    }
  }
  return behind;
}

std::vector<execute::CellId> NearestCellsBehind(const terms::Terms& terms, const machine::Relation& relation,
                                                std::span<const execute::CellId> cells) {
  std::vector<bool> seen_terms(terms.size()), seen_cells(relation.period().size());
  std::vector<execute::CellId> behind;
  std::vector<terms::TermId> open;  // a queue: what was met first is nearest
  const auto meet = [&](terms::TermId term) {
    if (!term.valid() || seen_terms[term.index]) return;
    seen_terms[term.index] = true;
    open.push_back(term);
  };
  const auto add = [&](execute::CellId cell) {
    if (!cell.valid() || seen_cells[cell.index]) return;
    seen_cells[cell.index] = true;
    behind.push_back(cell);
    for (const std::vector<terms::TermId>* const part : {&relation.fast(), &relation.period()}) {
      if (cell.index < part->size()) meet((*part)[cell.index]);
    }
  };
  for (const execute::CellId cell : cells) add(cell);
  for (size_t at = 0; at < open.size(); ++at) {
    const terms::TermId term = open[at];
    if (terms[term].kind == terms::TermKind::kVariable) add(relation.CellOf(term));
    terms.ForEachOperand(terms[term], meet);
  }
  return behind;
}

}  // namespace plcxx::prove::properties
