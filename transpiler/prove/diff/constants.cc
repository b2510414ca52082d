// Cells of one version that keep the value of power-on in every state that can be reached.
//
// All are taken for constant, and what a part would change while they are is taken out, until nothing is: the greatest
// set that keeps itself. Nothing is asked of a solver; a part is executed once, and only the bits that are known in its
// terms are computed anew. After a change that reaches thousands of cells most of a program is masked by what stays 0.
#include <array>

#include "transpiler/prove/diff/comparison.h"
#include "transpiler/prove/machine/inputs.h"
#include "transpiler/prove/machine/requests.h"
#include "transpiler/prove/machine/sets.h"
#include "transpiler/symbolic/terms/cone.h"
#include "transpiler/symbolic/terms/known_bits.h"

namespace plcxx::prove::diff {
namespace {

/// One version, and which of its cells are still taken for constant.
class ConstantCells {
 public:
  ConstantCells(Comparison& comparison, Which which)
      : comparison_(comparison),
        terms_(comparison.terms),
        version_(comparison.pairing.version(which)),
        which_(which),
        constants_(version_.cells.count) {}

  /// Those that have one value whenever power comes. Memory that is kept without power may have any.
  void Begin(const machine::Transition& init) {
    const std::vector<bool> requests = machine::RequestCells(version_);
    for (uint32_t i = 0; i < version_.cells.calls; ++i) {
      const execute::CellId cell(i);
      if (!machine::IsState(version_, cell) || machine::IsRetentive(version_, cell) ||
          comparison_.IsInput(which_, cell))
        continue;
      const terms::TermId value = init.next[i];
      if (!value.valid() || !terms_.IsConst(value)) continue;
      // The control takes a request back when it likes.
      if (i < requests.size() && requests[i] && !terms_.IsZero(value)) continue;
      constants_[i] = value;
    }
  }

  /// What a part makes of the cells; the terms are over the pairing's variables.
  void AddPart(const machine::Transition& part) {
    for (uint32_t i = 0; i < constants_.size(); ++i) {
      if (!constants_[i].valid() || !part.next[i].valid()) continue;
      next_.emplace_back(i, part.next[i]);
      roots_.push_back(part.next[i]);
    }
  }

  std::vector<terms::TermId> Find() {
    const std::vector<terms::TermId> cone = terms::ConeOf(terms_, roots_);
    FindVariables();
    std::vector<terms::KnownBits> known(terms_.size());
    const auto of = [&known](terms::TermId id) { return known[id.index]; };
    for (bool any = true; any;) {
      if (comparison_.Late()) return {};
      const std::vector<terms::KnownBits> variables = KnownVariables();
      for (const terms::TermId id : cone) {
        known[id.index] =
            terms::KnownBitsOf(terms_, terms_[id], of, [&](uint32_t number) { return variables[number]; });
      }
      any = false;
      for (const auto& [cell, next] : next_) {
        if (!constants_[cell].valid()) continue;
        const uint8_t width = terms_.Width(next);
        if (known[next.index] == terms::AllKnown(terms_.Value(constants_[cell]), width)) continue;
        constants_[cell] = terms::TermId();
        any = true;
      }
    }
    return constants_;
  }

 private:
  /// Where the bits of a cell are in a variable.
  struct PlaceInVariable {
    uint32_t cell, variable, low;
  };

  void FindVariables() {
    for (uint32_t i = 0; i < constants_.size(); ++i) {
      if (!constants_[i].valid()) continue;
      const terms::TermId initial = comparison_.pairing.Initial(which_, execute::CellId(i));
      const terms::Term& term = terms_[initial];
      const bool is_part = term.kind == terms::TermKind::kExtract;
      places_.push_back({i, is_part ? terms_[terms::TermId(term.a)].a : term.a, is_part ? term.b : 0});
    }
  }

  std::vector<terms::KnownBits> KnownVariables() const {
    std::vector<terms::KnownBits> variables(terms_.variable_count());
    for (const auto& [cell, variable, low] : places_) {
      if (!constants_[cell].valid()) continue;
      const terms::KnownBits bits = terms::AllKnown(terms_.Value(constants_[cell]), terms_.Width(constants_[cell]));
      variables[variable].zeros |= bits.zeros << low;
      variables[variable].ones |= bits.ones << low;
    }
    return variables;
  }

  Comparison& comparison_;
  terms::Terms& terms_;
  const machine::Version& version_;
  const Which which_;
  std::vector<terms::TermId> constants_;                  // by cell; none: it is not taken for constant
  std::vector<std::pair<uint32_t, terms::TermId>> next_;  // of each part
  std::vector<terms::TermId> roots_;
  std::vector<PlaceInVariable> places_;
};

}  // namespace

bool FindConstants(Comparison& comparison) {
  comparison.Report("what never changes");
  std::array<ConstantCells, 2> sides{ConstantCells(comparison, Which::kOld), ConstantCells(comparison, Which::kNew)};
  const std::optional<std::array<machine::Transition, 2>> init = ExecutePowerOn(comparison);
  if (!init) return false;
  for (size_t side = 0; side < 2; ++side) sides[side].Begin((*init)[side]);
  for (const machine::Part part : PartsOf(comparison)) {
    if (!ExecutePart(comparison, part)) return false;
    sides[0].AddPart(comparison.old_next);
    sides[1].AddPart(comparison.new_next);
  }
  comparison.pairing.SetConstants(sides[0].Find(), sides[1].Find());
  comparison.executions.clear();
  return true;
}

}  // namespace plcxx::prove::diff
