// One version executed with concrete values, as far as its parts' terms go: fast where a simulator would be exact.
//
// In: the parts as terms over variables of the cells. Out: what cells of the state become. Answers of the host and
// loops without a summary are made up. Not its job: which inputs are set, what the states are for.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "transpiler/prove/machine/transition.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::invariants {

class ConcreteRun {
 public:
  /// What one part, or power-on, makes of the state: terms by index of `state`.
  struct Step {
    std::vector<terms::TermId> next, cone;
  };

  /// `variables`: of each cell that the steps read; `now` that of the time. `terms` outlives the run.
  ConcreteRun(const terms::Terms& terms, const machine::Version& version, std::vector<execute::CellId> state,
              const std::map<execute::CellId, terms::TermId>& variables, terms::TermId now);

  Step StepOf(std::vector<terms::TermId> next) const;
  void Execute(const Step& step);

  void Set(execute::CellId cell, uint64_t value) { cells_[cell.index] = value; }
  uint64_t ValueOf(execute::CellId cell) const { return cells_[cell.index]; }
  uint64_t now_ms = 0;
  /// What is made up may be something else instead; may be empty.
  std::function<uint64_t(terms::TermId answer, uint64_t made_up)> answer;

 private:
  /// An answer of the host, or what a loop without a summary gives.
  bool IsMadeUp(terms::TermId id) const;

  const terms::Terms& terms_;
  std::vector<execute::CellId> state_;
  std::vector<execute::CellId> cell_of_;  // by variable
  uint32_t now_;                          // its variable
  std::vector<uint64_t> cells_;           // by cell
  std::vector<uint64_t> values_;          // by term
};

}  // namespace plcxx::prove::invariants
