// Runs of state words: the numbers that a program, and what is counted beside it, have after one part and the next.
//
// In: state words, each with its term after each part. Out: states. Inputs are the variables that are no state word;
// they stay until they are drawn anew. Not its job: what is made of the states.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "transpiler/prove/properties/reachable.h"
#include "transpiler/symbolic/terms/random.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::properties {

class StateRuns {
 public:
  using State = std::map<terms::TermId, uint64_t>;  // by variable

  /// `words` by their variables; they outlive it.
  StateRuns(const terms::Terms& terms, const std::map<terms::TermId, StateWord>& words, size_t parts);

  /// The terms that one part costs.
  size_t cost() const { return cone_.size(); }
  State Start() const;
  /// Sets inputs and state; what a solver has found, as `value_of`.
  void Set(const std::function<uint64_t(terms::TermId variable)>& value_of);
  /// The state after a part, from what was set.
  State After(size_t part);
  /// Each input is drawn with a chance of one in `one_in`.
  void DrawInputs(uint64_t one_in, const std::function<uint64_t()>& draw);
  const std::vector<uint64_t>& inputs() const { return by_number_; }
  void SetInputs(std::vector<uint64_t> inputs) { by_number_ = std::move(inputs); }
  /// One period after the other; `next_inputs` is called before each but the first, `visit` after each: false ends it.
  void Run(State state, size_t periods, const std::function<void()>& next_inputs,
           const std::function<bool(const State&)>& visit);
  uint64_t Draw() { return random_.Next() >> 7; }
  void BeginAgain() { random_ = terms::Random(kSeed); }

 private:
  static constexpr uint64_t kSeed = 0x9E3779B97F4A7C15;

  const terms::Terms& terms_;
  const std::map<terms::TermId, StateWord>& words_;
  size_t parts_;
  std::vector<terms::TermId> cone_, variables_;  // of all state words
  std::vector<uint64_t> values_;                 // of the cone, by term
  std::vector<uint64_t> by_number_;              // of variables, before a part
  terms::Random random_{kSeed};
};

}  // namespace plcxx::prove::properties
