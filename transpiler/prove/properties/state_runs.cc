#include "transpiler/prove/properties/state_runs.h"

#include <utility>

#include "transpiler/symbolic/terms/cone.h"
#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::prove::properties {

StateRuns::StateRuns(const terms::Terms& terms, const std::map<terms::TermId, StateWord>& words, size_t parts)
    : terms_(terms), words_(words), parts_(parts), values_(terms.size()), by_number_(terms.variable_count()) {
  std::vector<terms::TermId> roots;
  for (const auto& [variable, word] : words) {
    roots.push_back(variable);
    roots.insert(roots.end(), word.next.begin(), word.next.end());
  }
  cone_ = terms::ConeOf(terms, roots);
  for (const terms::TermId id : cone_) {
    if (terms[id].kind == terms::TermKind::kVariable) variables_.push_back(id);
  }
}

StateRuns::State StateRuns::Start() const {
  State state;
  for (const auto& [variable, word] : words_)
    state.emplace_hint(state.end(), variable, terms_.IsConst(word.start) ? terms_.Value(word.start) : 0);
  return state;
}

void StateRuns::Set(const std::function<uint64_t(terms::TermId variable)>& value_of) {
  for (const terms::TermId variable : variables_) by_number_[terms_[variable].a] = value_of(variable);
}

StateRuns::State StateRuns::After(size_t part) {
  const auto value_of = [this](terms::TermId operand) { return values_[operand.index]; };
  for (const terms::TermId id : cone_) {
    values_[id.index] =
        terms::EvaluateTerm(terms_, terms_[id], value_of, [this](uint32_t number) { return by_number_[number]; });
  }
  State state;
  for (const auto& [variable, word] : words_) state.emplace_hint(state.end(), variable, values_[word.next[part].index]);
  return state;
}

void StateRuns::DrawInputs(uint64_t one_in, const std::function<uint64_t()>& draw) {
  for (const terms::TermId variable : variables_) {
    if (!words_.contains(variable) && random_.OneIn(one_in)) by_number_[terms_[variable].a] = draw();
  }
}

void StateRuns::Run(State state, size_t periods, const std::function<void()>& next_inputs,
                    const std::function<bool(const State&)>& visit) {
  for (size_t period = 0; period < periods; ++period) {
    if (period != 0) next_inputs();
    for (size_t part = 0; part < parts_; ++part) {
      for (const auto& [variable, value] : state) by_number_[terms_[variable].a] = value;
      state = After(part);
    }
    if (!visit(state)) return;
  }
}

}  // namespace plcxx::prove::properties
