// What holds in every state that one version can reach: guessed from random runs and from states that others have seen,
// then proved by induction.
//
// In: a version and the cells of interest. Out: clauses over its cells, each proved for every run from power-on, with
// any inputs and answers of the host; the host writes inputs only. Candidates: a bit that never changes, two bits that
// never have certain values together, a byte or field that takes few values, or fewer while a bit is set or not (the
// output of a step, and the step counter), or none above a constant of the program, while a step lasts, too (what is
// counted in it). What one candidate needs another one may give: they are proved together, and what fails is dropped
// until nothing does. Pairs of bits are many, and come last.
//
//   STEP goes 0, 1, 2, 0 on inputs; STAR = STEP == 1; DELTA = STEP == 2
//   seen in random runs   STEP 0 1 2; STAR and DELTA never both; DELTA 0, for its input is rare
//   candidates            STEP one of {0, 1, 2};  !(STAR & DELTA);  !DELTA
//   together, one period  from any state where all hold: STEP stays one of them, STAR and DELTA are set from one STEP;
//                         !DELTA fails (STEP = 1 goes to 2) and is dropped; the other two are proved without it
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "transpiler/prove/machine/version.h"
#include "transpiler/symbolic/solver/solver.h"

namespace plcxx::prove::invariants {

/// What the number that `cells` make may be.
struct Invariant {
  enum class Kind : uint8_t { kOneOf, kNoneOf, kAtMost };
  std::vector<execute::CellId> cells;  // from the most significant down; together one number
  std::vector<uint64_t> values;        // of kAtMost one
  Kind kind = Kind::kOneOf;
  /// Not none: it is said of those states only in which these, together, have that value.
  std::vector<execute::CellId> while_cells = {};
  uint64_t while_value = 0;

  auto operator<=>(const Invariant&) const = default;
};

/// The value of a cell in some state.
using CellValues = std::function<uint64_t(execute::CellId)>;
/// Calls `visit` with each state in which a version was seen, and the time then.
using SeenStates = std::function<void(const std::function<void(const CellValues&, uint64_t now_ms)>& visit)>;

/// Of bits, the most significant first, or of one cell.
uint64_t NumberOf(std::span<const execute::CellId> cells, const CellValues& state);

/// An invariant as a condition on the values that `value` gives.
terms::TermId ConditionOf(terms::Terms& terms, const Invariant& invariant,
                          const std::function<terms::TermId(execute::CellId)>& value);
bool HoldsIn(const Invariant& invariant, const CellValues& state);

struct InvariantSearch {
  const machine::Version& version;
  std::vector<execute::CellId> cells;             // of interest
  std::function<bool(execute::CellId)> is_input;  // the host writes the cell
  /// A machine at work, which random inputs do not start; may be empty. Nothing is taken for true because of them.
  SeenStates seen_states;
};

class InvariantFinder {
 public:
  /// All that it refers to outlives it.
  InvariantFinder(terms::Terms& terms, solver::Solver& solver, InvariantSearch search);
  ~InvariantFinder();
  InvariantFinder(const InvariantFinder&) = delete;
  InvariantFinder& operator=(const InvariantFinder&) = delete;

  /// In about so much time; it goes on from there when it is called again.
  void Find(uint64_t milliseconds);
  /// Others have seen more states since the first time: what they are like is guessed from, too, by the next Find.
  void GuessAgain();
  /// What is proved so far.
  const std::vector<Invariant>& invariants() const;
  /// Nothing more will be found.
  bool is_done() const;

 private:
  class Finder;
  std::unique_ptr<Finder> finder_;
};

}  // namespace plcxx::prove::invariants
