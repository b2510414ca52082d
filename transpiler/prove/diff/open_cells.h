// The numbers of which relations (relation.h) may be said: memory that is in no equal pair, and the bits beside it.
//
// In: a comparison whose undecided pairs are separated, and whose period is executed. Out: words, fields and bits. Not
// its job: what they have to do with each other (relations.h).
#pragma once

#include <array>
#include <set>
#include <span>
#include <vector>

#include "transpiler/prove/diff/comparison.h"
#include "transpiler/prove/diff/relation.h"

namespace plcxx::prove::diff {

/// What is in no equal pair, and its version alone writes.
class OpenCells {
 public:
  explicit OpenCells(Comparison& comparison);

  const std::set<execute::CellId>& of(Which which) const { return cells_[which == Which::kOld ? 0 : 1]; }
  std::vector<Number> NumbersOf(Which which) const;
  /// Bits that are alike in both versions, which write them: what the open ones are computed from, as far as that can
  /// be seen in one part.
  std::vector<Number> EqualBits() const;

 private:
  void Add(Which which, std::span<const execute::CellId> cells);
  /// What others set, or clear, between two parts, or keep without power, is not the version's own.
  bool IsOwn(Which which, execute::CellId cell) const;

  Comparison& comparison_;
  std::array<std::set<execute::CellId>, 2> cells_;
};

}  // namespace plcxx::prove::diff
