// What decides whether a condition can hold: the narrow interface behind which Z3 is.
//
// The implementation is a module beside the tool (lib/plcxx_z3.so, see LoadSolver), so that commands that ask nothing
// do not pay for it. Terms are given to it as they are asked for: what a question does not depend on costs nothing.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::solver {

enum class Answer : uint8_t {
  kNever,     // no values of the variables make all conditions 1
  kPossible,  // ValueOf tells some that do
  kUnknown    // the limit was not enough
};

/// How much a question may take. Effort is counted in steps of the solver, so many as an idle core makes in a
/// millisecond: on a loaded or a slow machine the answer comes later, and is the same.
struct Limit {
  static constexpr uint32_t kNone = 0xFFFFFFFF;
  static constexpr uint32_t kPatience = 20;  // times as long by the clock: who measures a slow machine waits for it

  uint32_t effort_ms = kNone;
  uint32_t clock_ms = kNone;

  /// So much effort, and what it takes by the clock on a machine that is kPatience times slower.
  static Limit Effort(uint32_t ms) {
    return {.effort_ms = ms, .clock_ms = ms < kNone / kPatience ? ms * kPatience : kNone};
  }
  /// By the clock alone: where a command's own time ends.
  static Limit Clock(uint32_t ms) { return {.effort_ms = kNone, .clock_ms = ms}; }
  /// Not beyond so many milliseconds by the clock.
  Limit Within(uint64_t rest_ms) const {
    return {.effort_ms = effort_ms, .clock_ms = rest_ms < clock_ms ? static_cast<uint32_t>(rest_ms) : clock_ms};
  }
};

class Solver {
 public:
  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  virtual ~Solver() = default;

  /// From now on `condition` (width 1) holds in every question.
  virtual void Assume(terms::TermId condition) = 0;
  /// Assumptions made between Push and Pop are forgotten at Pop.
  virtual void Push() = 0;
  virtual void Pop() = 0;
  /// Whether all of `conditions` can be 1 at once.
  virtual Answer Check(std::span<const terms::TermId> conditions, const Limit& limit) = 0;
  /// After kPossible: the value of a term there. What the question does not depend on is 0.
  virtual uint64_t ValueOf(terms::TermId term) = 0;
};

struct LoadedSolver {
  std::unique_ptr<Solver> solver;
  std::string reason;  // why there is none; lower case, no full stop
};

/// `terms` outlives the solver.
LoadedSolver LoadSolver(const terms::Terms& terms);

/// The function of the module.
using MakeSolverFunction = Solver*(const terms::Terms& terms);
inline constexpr const char* kSolverModule = "plcxx_z3.so";
inline constexpr const char* kMakeSolver = "plcxx_make_solver";

}  // namespace plcxx::solver
