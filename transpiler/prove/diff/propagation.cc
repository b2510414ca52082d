// Which pairs have a change of their own, and which differ at most because others do.
//
// Both versions are executed from the same state, and every value that one of the differing cells gets is replaced by
// an unknown that is the same for both: the k-th value of a cell. A pair whose k-th values are equal for all k,
// whatever the unknowns are, has no change of its own: a value of it differs only when one that it is computed from
// does. A host function sees outputs in the middle of a period; when it sees others, the change is that of the output.
//
//   old  LAMP = RUN;          BELL = LAMP & TEST
//   new  LAMP = RUN & !DOOR;  BELL = LAMP & TEST
//   1st value of LAMP   RUN         RUN & !DOOR    not equal: LAMP has a change of its own
//   1st value of BELL   u & TEST    u & TEST       equal: BELL has none (u replaces the 1st value of LAMP in both)
#include <map>

#include "transpiler/prove/diff/comparison.h"

namespace plcxx::prove::diff {
namespace {

/// By old cell: the values that it gets, in their order.
using Values = std::map<uint32_t, std::vector<terms::TermId>>;

}  // namespace

bool SeparatePropagated(Comparison& comparison) {
  std::vector<bool> is_cut(comparison.old_version.cells.count);
  std::vector<execute::CellId> cells;  // old ones
  for (const PairResult& result : comparison.results) {
    if (comparison.pairing.IsEqual(result.old_cell)) continue;
    is_cut[result.old_cell.index] = true;
    cells.push_back(result.old_cell);
  }
  if (cells.empty()) return true;
  comparison.Report("where the changes are");
  for (const execute::CellId cell : cells) comparison.pairing.Join(cell);
  std::map<std::pair<uint32_t, size_t>, terms::TermId> unknowns;
  std::vector<bool> has_change(comparison.old_version.cells.count);
  bool executed = true;
  for (const machine::Part part : PartsOf(comparison)) {
    Values old_values, new_values;
    const auto old_cell_of = [&](Which which, execute::CellId cell) {
      return which == Which::kOld ? cell : comparison.match.old_of_new[cell.index];
    };
    Cut cut;
    cut.is_cut = [&](Which which, execute::CellId cell) {
      const execute::CellId old_cell = old_cell_of(which, cell);
      return old_cell.valid() && is_cut[old_cell.index];
    };
    cut.value = [&](Which which, execute::CellId cell, terms::TermId value) {
      if (!cut.is_cut(which, cell)) return value;
      const execute::CellId old_cell = old_cell_of(which, cell);
      std::vector<terms::TermId>& values = (which == Which::kOld ? old_values : new_values)[old_cell.index];
      values.push_back(value);
      terms::TermId& unknown = unknowns[{old_cell.index, values.size()}];
      if (!unknown.valid()) {
        unknown = comparison.terms.Variable(
            "value " + std::to_string(values.size()) + " of cell " + std::to_string(old_cell.index),
            comparison.terms.Width(value));
      }
      return unknown;
    };
    executed = ExecutePart(comparison, part, machine::HostAnswers::kAny, &cut);
    if (!executed) break;
    std::vector<Question> questions;
    for (const execute::CellId cell : cells) {
      const std::vector<terms::TermId>&one = old_values[cell.index], &other = new_values[cell.index];
      if (one.size() != other.size()) has_change[cell.index] = true;
      for (size_t k = 0; k < std::min(one.size(), other.size()); ++k) {
        if (one[k] != other[k]) questions.push_back({{one[k], other[k]}, comparison.result_of_old[cell.index]});
      }
    }
    AddObservations(comparison, [&is_cut](execute::CellId calls) { return !is_cut[calls.index]; }, questions);
    const std::vector<solver::Verdict> verdicts = Answers(comparison, questions);
    for (size_t i = 0; i < questions.size(); ++i) {
      const PairResult& result = comparison.results[questions[i].result];
      if (verdicts[i] != solver::Verdict::kEqual) has_change[result.old_cell.index] = true;
    }
  }
  for (PairResult& result : comparison.results) {
    if (!is_cut[result.old_cell.index]) continue;
    comparison.pairing.Separate(result.old_cell);
    result.changed_itself = result.changed_itself || has_change[result.old_cell.index];
  }
  return executed;
}

}  // namespace plcxx::prove::diff
