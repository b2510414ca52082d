// The parts of a program's period as functions of the state before them: executed once, used for every period.
//
// In: a structured program. Out: for each part the state behind it as terms over variables, one for each cell that
// is read. A loop of which it is not known how often it goes round is an unknown function (execute/summary.h). Not its
// job: runs of several periods (unroll.h).
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "transpiler/prove/compare/match.h"
#include "transpiler/prove/compare/transition.h"
#include "transpiler/prove/terms/terms.h"

namespace plcxx::prove {

class Relation {
 public:
  /// `terms` and `version` outlive it. What `other`, of the same version, computes alike is the same term; it may be
  /// none.
  Relation(Terms& terms, const Version& version, HostAnswers answers, const Relation* other = nullptr);

  /// Not empty: a part cannot be executed, and why.
  const Refusal& refusal() const { return refusal_; }
  HostAnswers answers() const { return answers_; }
  const Version& version() const { return version_; }

  /// By cell, over the variables; none: the cell keeps its value. Of the fast part only where it has a time of its own.
  const std::vector<TermId>& fast() const { return fast_; }
  const std::vector<TermId>& period() const { return period_; }

  /// What a variable stands for; none: the time, when it is `now`, or not one of this relation.
  CellId CellOf(TermId variable) const;
  /// That of a cell before a part.
  TermId VariableOf(CellId cell);
  TermId now() const { return now_; }

 private:
  std::vector<TermId> Execute(Part part);

  Terms& terms_;
  const Version& version_;
  HostAnswers answers_;
  TermId now_;
  std::map<CellId, TermId> variables_;
  std::map<TermId, CellId> cells_;
  std::vector<TermId> fast_, period_;
  Refusal refusal_;
};

/// Whether a term's value depends on a loop of which only that it is a function is known.
bool DependsOnLoop(const Terms& terms, TermId term);

}  // namespace plcxx::prove
