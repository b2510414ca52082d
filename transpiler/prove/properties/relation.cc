#include "transpiler/prove/properties/relation.h"

#include <algorithm>

#include "transpiler/prove/execute/execute.h"
#include "transpiler/prove/execute/summary.h"
#include "transpiler/prove/properties/answers.h"
#include "transpiler/prove/terms/cone.h"

namespace plcxx::prove {
namespace {

/// A part that takes more terms would take too much time in every question.
constexpr uint32_t kSummarizeAfter = 16, kMostTerms = 10'000'000;

}  // namespace

Relation::Relation(Terms& terms, const Version& version, HostAnswers answers, const Relation* other)
    : terms_(terms),
      version_(version),
      answers_(answers),
      now_(other == nullptr ? terms.Variable("now", 32) : other->now_) {
  if (other != nullptr) {
    variables_ = other->variables_;
    cells_ = other->cells_;
  }
  if (HasFastPart(version)) fast_ = Execute(Part::kFast);
  period_ = Execute(Part::kPeriod);
}

std::vector<TermId> Relation::Execute(Part part) {
  std::vector<TermId> after(version_.cells.count);
  if (!refusal_.empty()) return after;
  const std::map<ir::InstId, ir::PlaceId> fetched = FetchedInputs(version_);
  const std::vector<bool> handshakes = HandshakeCells(version_);
  Memory memory(terms_, *version_.program, version_.cells,
                {.initial = [this](CellId cell) { return VariableOf(cell); },
                 .observe = {},
                 .now = now_,
                 .host_answers = answers_ == HostAnswers::kAny,
                 .fetched =
                     [&](ir::InstId call) {
                       const auto place = fetched.find(call);
                       return place == fetched.end() ? nullptr : &version_.program->places[place->second];
                     },
                 .is_exchanged = [&](CellId cell) { return bool{handshakes[cell.index]}; },
                 .summarize_after = kSummarizeAfter,
                 .most_terms = kMostTerms});
  const ir::Schedule& schedule = version_.program->schedule;
  refusal_ = prove::Execute(memory, part == Part::kFast ? schedule.fast_only : schedule.period);
  for (uint32_t i = 0; i < version_.cells.count; ++i) {
    if (memory.IsWritten(CellId(i)) && IsState(version_, CellId(i))) after[i] = memory.Read(CellId(i));
  }
  return after;
}

TermId Relation::VariableOf(CellId cell) {
  TermId& variable = variables_[cell];
  if (!variable.valid()) {
    const Cell what = CellAt(*version_.program, version_.cells, cell);
    variable = terms_.Variable(CellName(*version_.program, what), CellWidth(*version_.program, what));
    cells_[variable] = cell;
  }
  return variable;
}

CellId Relation::CellOf(TermId variable) const {
  const auto found = cells_.find(variable);
  return found == cells_.end() ? CellId() : found->second;
}

bool DependsOnLoop(const Terms& terms, TermId term) {
  return std::ranges::any_of(ConeOf(terms, {&term, 1}), [&terms](TermId id) {
    return terms[id].kind == TermKind::kApply && terms.Info(FunctionId(terms[id].a)).name.starts_with(kLoopFunction);
  });
}

}  // namespace plcxx::prove
