#include "transpiler/prove/machine/relation.h"

#include <algorithm>

#include "transpiler/prove/machine/answers.h"
#include "transpiler/symbolic/execute/execute.h"
#include "transpiler/symbolic/execute/summary.h"
#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::machine {
namespace {

/// A part that takes more terms would take too much time in every question.
constexpr uint32_t kSummarizeAfter = 16, kMostTerms = 10'000'000;

}  // namespace

Relation::Relation(terms::Terms& terms, const Version& version, HostAnswers answers, const Relation* other)
    : terms_(terms),
      version_(version),
      answers_(answers),
      now_(other == nullptr ? terms.Variable("now", 32) : other->now_) {
  if (other != nullptr) {
    variables_ = other->variables_;
    cells_ = other->cells_;
  }
  if (HasTimedFastPart(version)) fast_ = Execute(Part::kFast);
  period_ = Execute(Part::kPeriod);
}

std::vector<terms::TermId> Relation::Execute(Part part) {
  std::vector<terms::TermId> after(version_.cells.count);
  if (!refusal_.empty()) return after;
  const std::map<ir::InstId, ir::PlaceId> fetched = FetchedInputs(version_);
  const std::vector<bool> handshakes = HandshakeCells(version_);
  execute::Memory memory(terms_, *version_.program, version_.cells,
                         {.initial = [this](execute::CellId cell) { return VariableOf(cell); },
                          .observe = {},
                          .now = now_,
                          .host_answers = answers_ == HostAnswers::kAny,
                          .fetched =
                              [&](ir::InstId call) {
                                const auto place = fetched.find(call);
                                return place == fetched.end() ? nullptr : &version_.program->places[place->second];
                              },
                          .is_exchanged = [&](execute::CellId cell) { return bool{handshakes[cell.index]}; },
                          .summarize_after = kSummarizeAfter,
                          .unroll_up_to = kMostUnrolled,
                          .never_unrolled = &version_.shared_loops,
                          .most_terms = kMostTerms});
  const ir::Schedule& schedule = version_.program->schedule;
  refusal_ = execute::Execute(memory, part == Part::kFast ? schedule.fast_only : schedule.period);
  for (uint32_t i = 0; i < version_.cells.count; ++i) {
    if (memory.IsWritten(execute::CellId(i)) && IsState(version_, execute::CellId(i)))
      after[i] = memory.Read(execute::CellId(i));
  }
  return after;
}

terms::TermId Relation::VariableOf(execute::CellId cell) {
  terms::TermId& variable = variables_[cell];
  if (!variable.valid()) {
    const execute::Cell what = execute::CellAt(*version_.program, version_.cells, cell);
    variable = terms_.Variable(execute::CellName(*version_.program, what), execute::CellWidth(*version_.program, what));
    cells_[variable] = cell;
  }
  return variable;
}

execute::CellId Relation::CellOf(terms::TermId variable) const {
  const auto found = cells_.find(variable);
  return found == cells_.end() ? execute::CellId() : found->second;
}

bool DependsOnLoop(const terms::Terms& terms, terms::TermId term) {
  return std::ranges::any_of(terms::ConeOf(terms, {&term, 1}), [&terms](terms::TermId id) {
    return terms[id].kind == terms::TermKind::kApply &&
           terms.Info(terms::FunctionId(terms[id].a)).name.starts_with(execute::kLoopFunction);
  });
}

}  // namespace plcxx::prove::machine
