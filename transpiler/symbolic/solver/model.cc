#include "transpiler/symbolic/solver/model.h"

#include <map>

#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::solver {

std::vector<uint64_t> ModelValues(const terms::Terms& terms, Solver& solver, std::span<const terms::TermId> cone) {
  std::vector<uint64_t> values(terms.size());
  // Whose arguments were made up, and are alike when they are evaluated, must have one value.
  std::map<std::vector<uint64_t>, uint64_t> results;  // by function and arguments
  const auto unknown = [&](terms::TermId id) {
    const terms::Term& term = terms[id];
    std::vector<uint64_t> key = {term.a};
    for (const terms::TermId argument : terms.Arguments(term)) key.push_back(values[argument.index]);
    const auto [result, is_new] = results.try_emplace(std::move(key), 0);
    if (is_new) result->second = solver.ValueOf(id);
    return result->second;
  };
  for (const terms::TermId id : cone) {
    const terms::Term& term = terms[id];
    const bool is_unknown =
        term.kind == terms::TermKind::kApply && terms.Info(terms::FunctionId(term.a)).evaluate == nullptr;
    values[id.index] = is_unknown ? unknown(id)
                                  : terms::EvaluateTerm(
                                        terms, term, [&values](terms::TermId operand) { return values[operand.index]; },
                                        [&](uint32_t) { return solver.ValueOf(id); });
  }
  return values;
}

}  // namespace plcxx::solver
