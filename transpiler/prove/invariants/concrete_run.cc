#include "transpiler/prove/invariants/concrete_run.h"

#include <algorithm>

#include "transpiler/symbolic/terms/cone.h"
#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::prove::invariants {

ConcreteRun::ConcreteRun(const terms::Terms& terms, const machine::Version& version, std::vector<execute::CellId> state,
                         const std::map<execute::CellId, terms::TermId>& variables, terms::TermId now)
    : terms_(terms),
      state_(std::move(state)),
      cell_of_(terms.variable_count()),
      now_(terms[now].a),
      cells_(version.cells.count),
      values_(terms.size()) {
  for (const auto& [cell, variable] : variables) cell_of_[terms[variable].a] = cell;
}

ConcreteRun::Step ConcreteRun::StepOf(std::vector<terms::TermId> next) const {
  std::vector<terms::TermId> cone = terms::ConeOf(terms_, next);
  return {.next = std::move(next), .cone = std::move(cone)};
}

bool ConcreteRun::IsMadeUp(terms::TermId id) const {
  const terms::Term& term = terms_[id];
  return term.kind == terms::TermKind::kApply && terms_.Info(terms::FunctionId(term.a)).evaluate == nullptr;
}

void ConcreteRun::Execute(const Step& step) {
  values_.resize(std::max<size_t>(values_.size(), terms_.size()));
  for (const terms::TermId id : step.cone) {
    values_[id.index] = terms::EvaluateTerm(
        terms_, terms_[id], [this](terms::TermId operand) { return values_[operand.index]; },
        [this](uint32_t variable) -> uint64_t {
          if (variable == now_) return now_ms;
          const execute::CellId cell = variable < cell_of_.size() ? cell_of_[variable] : execute::CellId();
          return cell.valid() ? cells_[cell.index] : 0;
        });
    if (answer && IsMadeUp(id)) values_[id.index] = answer(id, values_[id.index]);
  }
  for (size_t i = 0; i < state_.size(); ++i) cells_[state_[i].index] = values_[step.next[i].index];
}

}  // namespace plcxx::prove::invariants
