// What a term depends on.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "transpiler/prove/machine/relation.h"
#include "transpiler/symbolic/execute/cells.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::properties {

/// A term with everything below it; Evaluate costs what these cost, however many terms there are beside them.
class Cone {
 public:
  Cone(const terms::Terms& terms, terms::TermId top);

  /// Whether there is a function in it of whose values nothing is known: Evaluate makes them up.
  bool has_unknown_function() const { return has_unknown_function_; }
  bool Has(terms::TermId term) const { return term.index < has_.size() && has_[term.index]; }
  /// The value of the term; `variables` by number.
  uint64_t Evaluate(std::span<const uint64_t> variables) const;

 private:
  const terms::Terms& terms_;
  terms::TermId top_;
  std::vector<bool> has_;
  std::vector<terms::TermId> order_;  // operands first
  bool has_unknown_function_ = false;
};

/// The cells whose variables the term depends on, ascending.
std::vector<execute::CellId> CellsIn(const terms::Terms& terms, terms::TermId term,
                                     const std::map<execute::CellId, terms::TermId>& variables);

/// By variable, the constants with which it, or a sum or choice of it, is compared in the roots.
std::map<terms::TermId, std::set<uint64_t>> ConstantsComparedWith(const terms::Terms& terms,
                                                                  std::span<const terms::TermId> roots);

/// The cells on which the future of `cells` depends, themselves first, then by the number of parts of a period that it
/// takes.
std::vector<execute::CellId> CellsBehind(const terms::Terms& terms, const machine::Relation& relation,
                                         std::span<const execute::CellId> cells);
/// The same, themselves first, then by the number of operations between.
std::vector<execute::CellId> NearestCellsBehind(const terms::Terms& terms, const machine::Relation& relation,
                                                std::span<const execute::CellId> cells);

}  // namespace plcxx::prove::properties
