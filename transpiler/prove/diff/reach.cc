// How far a change reaches, from one execution of each part: what is computed from what differs, and what is computed
// from that.
//
// When the pairs that differ after one period are known, and no other pair's next value depends on them, directly or
// through others, then those other pairs are equal in every scan: their next values are equal, and are computed from
// such pairs alone. To find them out by executing again and again gives a few more, which differ from nothing because
// what they read is masked; after a change that reaches thousands of pairs that is not worth its time.
#include <algorithm>
#include <optional>

#include "transpiler/prove/diff/comparison.h"
#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::diff {
namespace {

/// Which terms depend on the cells that are reached.
class Reach {
 public:
  explicit Reach(Comparison& comparison) : comparison_(comparison), terms_(comparison.terms) {
    for (const PairResult& result : comparison.results)
      initial_.push_back(comparison.pairing.Initial(Which::kOld, result.old_cell));
  }

  /// What the part does that was executed last.
  void AddPart() {
    const Comparison& comparison = comparison_;
    next_.resize(initial_.size());
    for (size_t i = 0; i < initial_.size(); ++i) {
      const PairResult& result = comparison.results[i];
      for (const terms::TermId next : {comparison_.NextOld(result.old_cell), comparison_.NextNew(result.new_cell)}) {
        next_[i].push_back(next);
        roots_.push_back(next);
      }
    }
    for (const machine::Transition* transition : {&comparison.old_next, &comparison.new_next}) {
      for (const machine::Seen& seen : transition->seen) {
        const bool is_old = transition == &comparison.old_next;
        const machine::Version& version = is_old ? comparison.old_version : comparison.new_version;
        const execute::CellId calls = version.cells.OfCalls(seen.function);
        const execute::CellId old_calls = is_old ? calls : comparison.match.old_of_new[calls.index];
        // Of what neither calls there is no result.
        if (!old_calls.valid() || comparison.result_of_old[old_calls.index] >= initial_.size()) continue;
        for (const terms::TermId id : seen.cells) {
          if (id.valid()) roots_.push_back(id);
        }
        seen_.push_back({comparison.result_of_old[old_calls.index], seen.cells});
      }
    }
  }

  /// When all parts are there.
  void Prepare() {
    cone_ = terms::ConeOf(terms_, roots_);
    depends_.resize(terms_.size());
    seeds_.resize(terms_.size());
    is_cell_.resize(terms_.size());
    for (const terms::TermId initial : initial_) is_cell_[initial.index] = true;
  }

  void Add(size_t result) {
    const terms::TermId initial = initial_[result];
    seeds_[initial.index] = true;
    // The byte that the bit is a part of.
    if (terms_[initial].kind == terms::TermKind::kExtract) seeds_[terms_[initial].a] = true;
  }

  void Spread() {
    for (const terms::TermId id : cone_) {
      bool depends = seeds_[id.index];
      // A bit of a byte is reached when it is one of the cells, whatever the others are.
      if (!is_cell_[id.index]) {
        terms_.ForEachOperand(terms_[id], [&](terms::TermId operand) { depends = depends || depends_[operand.index]; });
      }
      depends_[id.index] = depends;
    }
  }

  bool IsReached(size_t result) const {
    return std::ranges::any_of(next_[result], [this](terms::TermId next) { return depends_[next.index]; });
  }

  /// What a host function sees in the middle of a part; nothing of one that is called otherwise, for that is what
  /// differs then.
  std::vector<uint32_t> ReachedByObservation(const std::vector<bool>& reached) const {
    std::vector<uint32_t> found;
    for (const auto& [calls, cells] : seen_) {
      if (reached[calls] || IsReached(calls)) continue;
      for (size_t i = 0; i < cells.size(); ++i) {
        if (cells[i].valid() && depends_[cells[i].index])
          found.push_back(comparison_.result_of_old[comparison_.old_observed[i].index]);
      }
    }
    return found;
  }

 private:
  Comparison& comparison_;
  terms::Terms& terms_;
  std::vector<terms::TermId> initial_;            // by result
  std::vector<std::vector<terms::TermId>> next_;  // by result: of each part, of both versions
  struct SeenCells {
    uint32_t calls;                    // result
    std::vector<terms::TermId> cells;  // as machine::Seen
  };
  std::vector<SeenCells> seen_;
  std::vector<terms::TermId> roots_, cone_;
  std::vector<bool> depends_, seeds_, is_cell_;  // by term
};

}  // namespace

std::optional<std::vector<execute::CellId>> ReachOfDifferences(Comparison& comparison) {
  std::vector<execute::CellId> separated, all;
  for (const PairResult& result : comparison.results) {
    if (!comparison.pairing.IsEqual(result.old_cell)) separated.push_back(result.old_cell);
  }
  if (separated.empty()) return all;
  // The variables are those of the execution, in which everything was equal.
  for (const execute::CellId cell : separated) comparison.pairing.Join(cell);
  Reach reach(comparison);
  bool executed = true;
  for (const machine::Part part : PartsOf(comparison)) {
    executed = executed && ExecutePart(comparison, part);
    if (executed) reach.AddPart();
  }
  for (const execute::CellId cell : separated) comparison.pairing.Separate(cell);
  if (!executed) return std::nullopt;
  reach.Prepare();
  std::vector<bool> reached(comparison.results.size());
  std::vector<uint32_t> added;
  for (const execute::CellId cell : separated) added.push_back(comparison.result_of_old[cell.index]);
  while (!added.empty()) {
    for (const uint32_t result : added) {
      if (!reached[result]) reach.Add(result);
      reached[result] = true;
    }
    reach.Spread();
    added = reach.ReachedByObservation(reached);
    std::erase_if(added, [&](uint32_t result) { return reached[result]; });
    for (uint32_t i = 0; i < reached.size(); ++i) {
      if (reached[i] || comparison.pairing.IsConstantPair(comparison.results[i].old_cell)) continue;
      if (reach.IsReached(i)) added.push_back(i);
    }
  }
  for (uint32_t i = 0; i < reached.size(); ++i) {
    if (reached[i]) all.push_back(comparison.results[i].old_cell);
  }
  return all;
}

}  // namespace plcxx::prove::diff
