// The parts of a program's period as functions of the state before them: executed once, used for every period.
//
// In: a structured program. Out: for each part the state after it as terms over variables, one for each cell that
// is read. A loop of which it is not known how often it goes round is an unknown function (execute/summary.h). Not its
// job: runs of several periods (unroll.h).
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "transpiler/prove/machine/transition.h"
#include "transpiler/prove/machine/version.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::machine {

class Relation {
 public:
  /// `terms` and `version` outlive it. What `other`, of the same version, computes alike is the same term; it may be
  /// none.
  Relation(terms::Terms& terms, const Version& version, HostAnswers answers, const Relation* other = nullptr);

  /// Not empty: a part cannot be executed, and why.
  const execute::Refusal& refusal() const { return refusal_; }
  HostAnswers answers() const { return answers_; }
  const Version& version() const { return version_; }

  /// By cell, over the variables; none: the cell keeps its value. Of the fast part only where it has a time of its own.
  const std::vector<terms::TermId>& fast() const { return fast_; }
  const std::vector<terms::TermId>& period() const { return period_; }
  /// What a cell becomes in each part that computes it, the period first.
  template <class Visit>
  void ForEachNext(execute::CellId cell, Visit&& visit) const {
    for (const std::vector<terms::TermId>* const part : {&period_, &fast_}) {
      if (cell.index < part->size() && (*part)[cell.index].valid()) visit((*part)[cell.index]);
    }
  }

  /// What a variable stands for; none: the time, when it is `now`, or not one of this relation.
  execute::CellId CellOf(terms::TermId variable) const;
  /// That of a cell before a part.
  terms::TermId VariableOf(execute::CellId cell);
  terms::TermId now() const { return now_; }

 private:
  std::vector<terms::TermId> Execute(Part part);

  terms::Terms& terms_;
  const Version& version_;
  HostAnswers answers_;
  terms::TermId now_;
  std::map<execute::CellId, terms::TermId> variables_;
  std::map<terms::TermId, execute::CellId> cells_;
  std::vector<terms::TermId> fast_, period_;
  execute::Refusal refusal_;
};

/// Whether a term's value depends on a loop of which only that it is a function is known.
bool DependsOnLoop(const terms::Terms& terms, terms::TermId term);

}  // namespace plcxx::prove::machine
