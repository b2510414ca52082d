// What holds between memory of the old version and memory of the new one, in every state that both come to by the same
// inputs: that one counts down what the other one counts up, that a flag is set where a step has a number.
//
//   old  n = 0; each pulse: n++, at 60: n = 0, LUBE       0 1 2 ... 59     while the new one has
//   new  n = 60; each pulse: n--, at 0: n = 60, LUBE     60 59 58 ... 1    new n + old n = 60
//
// In: numbers of both sides. Out: the condition as a term. Not its job: which relations there may be (relations.h), and
// whether they hold, which is proved with the pairs that are equal, one by the other (FindInductiveSet).
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "transpiler/prove/diff/pairing.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::diff {

/// Bits of one version's memory, together one number.
struct Number {
  Which which = Which::kOld;
  std::vector<execute::CellId> cells;  // from the most significant down; a field is one cell
  uint8_t low = 0, width = 1;          // the bits of it that count

  bool operator==(const Number&) const = default;
};

struct Relation {
  enum class Kind : uint8_t {
    kLinear,  // number = factor * other + constant, in as many bits as the number has
    kSum,    // number = other + third + constant, in as many bits: one time, and the same as two that follow each other
    kAmong,  // the two are one of `values`
    kIs,     // number, a bit, is set where the other one is `constant`
    kAtLeast,  // number, a bit, is set where the other one is `constant` or more
  };
  Kind kind = Kind::kLinear;
  Number number, other;  // of two sides, in any order
  Number third = {};     // kSum: of the other one's side
  uint64_t factor = 1, constant = 0;
  bool is_inverted = false;                           // kIs, kAtLeast: is not set there
  std::vector<std::pair<uint64_t, uint64_t>> values;  // kAmong: number, other
  /// Not empty: it is said of those states only in which each of these bits has that value.
  struct While {
    Number bit;
    bool is_set = false;
  };
  std::vector<While> whiles = {};
};

/// The relation as a condition on the values that `value` gives.
terms::TermId ConditionOf(terms::Terms& terms, const Relation& relation,
                          const std::function<terms::TermId(Which which, execute::CellId cell)>& value);

}  // namespace plcxx::prove::diff
