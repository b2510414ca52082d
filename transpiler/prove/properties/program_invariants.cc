#include "transpiler/prove/properties/program_invariants.h"

#include <algorithm>

#include "transpiler/prove/properties/cone.h"
#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::properties {
namespace {

constexpr size_t kMostInvariantCells = 160;  // around which they are looked for

}  // namespace

std::vector<terms::TermId> ProgramInvariants::ConditionsOf(
    const std::function<terms::TermId(execute::CellId)>& value) const {
  std::vector<terms::TermId> conditions;
  for (const invariants::Invariant& invariant : found_)
    conditions.push_back(invariants::ConditionOf(checked_.terms, invariant, value));
  return conditions;
}

void ProgramInvariants::FindFor(const Property& property) {
  const uint32_t window = WindowOf(property);
  // The cells that the nearest periods depend on; those of the next ones as far as there are not too many.
  std::vector<execute::CellId> cells;
  const ValueAfter value = [this](execute::CellId cell, uint32_t period) {
    return checked_.anywhere->Value(cell, period - 1);
  };
  for (uint32_t period = 1; period <= window + 1 && cells.size() < kMostInvariantCells; ++period) {
    const terms::TermId holds = HoldsAfter(checked_.terms, property, period, value);
    for (const execute::CellId cell : CellsIn(checked_.terms, holds, checked_.anywhere->start_variables())) {
      if (std::ranges::find(cells, cell) == cells.end()) cells.push_back(cell);
    }
  }
  FindAround(cells);
}

void ProgramInvariants::FindAround(const std::vector<execute::CellId>& cells) {
  // Of those that outlive a fast part, too, no property is known that needs them.
  if (checked_.version.program->schedule.fast_ms != 0) return;
  const std::vector<execute::CellId> behind = CellsBehind(checked_.terms, checked_.Widest(), cells);
  std::vector<terms::TermId> next;
  for (const execute::CellId cell : behind) {
    if (checked_.Widest().period()[cell.index].valid()) next.push_back(checked_.Widest().period()[cell.index]);
  }
  if (terms::ConeOf(checked_.terms, next).size() > kMostQuestionTerms) return;
  checked_.Report("invariants");
  invariants::InvariantFinder finder(
      checked_.terms, *checked_.solver,
      {.version = checked_.version,
       .cells = cells,
       .is_input = [this](execute::CellId cell) { return bool{checked_.new_each_time[cell.index]}; },
       .seen_states = trials_.SeenStates()});
  finder.Find(checked_.RestMs() / 3);
  found_ = finder.invariants();
}

}  // namespace plcxx::prove::properties
