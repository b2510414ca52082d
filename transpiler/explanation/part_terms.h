// One executed part as terms in which each write of the program is a variable that is defined by what was written.
//
// A term over such variables has the statements of the source in it: why a coil is 0 is asked of the term that its
// statement wrote, and goes on at the variables of that term. In: a frame. Out: the term of each cell after the part,
// the concrete value of every term, reasons. Not its job: names and words (explain.h).
//
// Nothing is claimed that the terms do not show: where a part cannot be followed (a loop without a known end, answers
// of the host out of order) there is a refusal.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/explanation/frame.h"
#include "transpiler/symbolic/execute/execute.h"
#include "transpiler/symbolic/terms/justify.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::explanation {

enum class VariableKind : uint8_t {
  kBefore,   // what a cell held before the part
  kForced,   // what a cell is held at
  kWritten,  // what a statement wrote, or the schedule
  kHost      // what the host wrote into a cell in the middle of the part
};

/// What a variable of the terms is.
struct PartVariable {
  VariableKind kind{};
  execute::CellId cell;
  uint64_t value = 0;         // but of kWritten
  terms::TermId definition;   // of kWritten
  ir::StatementId statement;  // of kWritten; none: the schedule
};

class PartTerms {
 public:
  /// `cells` are the program's; `wanted` are those that are asked about. All but these outlive the object.
  PartTerms(const ir::Program& program, const execute::Cells& cells, const Frame& frame,
            std::span<const execute::CellId> wanted);
  PartTerms(const PartTerms&) = delete;
  PartTerms& operator=(const PartTerms&) = delete;

  /// Why there are no terms; empty: there are.
  const std::string& refusal() const { return refusal_; }
  /// What the wanted cells hold after the part, in their order.
  const std::vector<terms::TermId>& after() const { return after_; }
  uint64_t Value(terms::TermId term) const { return values_[term.index]; }
  const terms::Terms& terms() const { return terms_; }
  /// None: the term is an answer of the host, by the name of the function.
  const PartVariable* VariableOf(terms::TermId term) const;
  std::string HostFunctionOf(terms::TermId answer) const;
  /// Whether a reason has a value that is known: not what a loop computes whose rounds nobody can tell.
  bool IsKnown(terms::TermId reason) const;

  std::vector<terms::Reason> ReasonsFor(std::span<const terms::Reason> wanted) const {
    return justification_->ReasonsFor(wanted);
  }

 private:
  class Watch;

  static bool IsAnswer(const terms::TermFunction& function);

  terms::TermId NewVariable(PartVariable variable);
  terms::TermId Initial(execute::CellId cell);
  uint64_t ValueBefore(const execute::Cell& cell) const;
  bool IsForced(const execute::Cell& cell) const;
  void Execute(std::span<const execute::CellId> wanted);
  void ReplayCalls();
  void Evaluate();
  /// Whether a condition was 1 in the executed part.
  bool Holds(terms::TermId condition);

  const ir::Program& program_;
  const execute::Cells& cells_;
  const Frame& frame_;
  mutable sim::Simulator::Saved written_;  // the state before the part, for trials
  std::vector<uint64_t> fields_;           // before the part, by cell from the first field on
  terms::Terms terms_;
  std::vector<PartVariable> variables_;  // by number
  std::vector<terms::TermId> definitions_;
  std::vector<terms::TermId> after_;
  std::vector<uint64_t> values_;  // by TermId
  std::vector<terms::TermId> cone_;
  std::optional<terms::Justification> justification_;
  /// What the host answered, by function and what it had been told.
  std::map<std::pair<std::string, uint64_t>, sim::HostAnswer> answers_;
  std::string refusal_;
};

}  // namespace plcxx::explanation
