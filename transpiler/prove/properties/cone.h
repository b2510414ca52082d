// What a term depends on.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "transpiler/prove/execute/cells.h"
#include "transpiler/prove/properties/relation.h"
#include "transpiler/prove/terms/terms.h"

namespace plcxx::prove {

/// A term with everything below it; Evaluate costs what these cost, however many terms there are beside them.
class Cone {
 public:
  Cone(const Terms& terms, TermId top);

  /// Whether there is a function in it of whose values nothing is known: Evaluate makes them up.
  bool has_unknown_function() const { return has_unknown_function_; }
  bool Has(TermId term) const { return term.index < has_.size() && has_[term.index]; }
  /// The value of the term; `variables` by number.
  uint64_t Evaluate(std::span<const uint64_t> variables) const;

 private:
  const Terms& terms_;
  TermId top_;
  std::vector<bool> has_;
  std::vector<TermId> order_;  // operands first
  bool has_unknown_function_ = false;
};

/// The cells whose variables the term depends on, ascending.
std::vector<CellId> CellsIn(const Terms& terms, TermId term, const std::map<CellId, TermId>& variables);

/// The cells on which the future of `cells` depends, themselves first, then by the number of parts of a period that it
/// takes.
std::vector<CellId> CellsBehind(const Terms& terms, const Relation& relation, std::span<const CellId> cells);

}  // namespace plcxx::prove
