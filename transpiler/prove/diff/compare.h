// Do two versions of a program behave alike, cell by cell, for all inputs and all scans?
//
// A set of matched cells is equal in every scan when it is equal after power-on and when, from any state in which the
// set is equal, one more period leaves it equal; the rest of the state may be anything, but for invariants that are
// proved the same way. The greatest such set is found by taking out what fails until nothing does. For what is left,
// runs from power-on are searched for a difference. The slow part is one piece here, however it is sliced.
//
//   old  RUN = START;  LAMP = RUN;             after power-on all are 0: the set is {RUN, LAMP, BELL}
//        BELL = LAMP                           one period from a state in which these are equal, same inputs:
//   new  RUN = START;  LAMP = RUN & !DOOR;       RUN   START          START                  equal
//        BELL = LAMP                             LAMP  START          START & !DOOR          not equal: taken out
//                                                BELL  START          START & !DOOR          not equal: taken out
//                                              again, with LAMP and BELL any values on each side: RUN is still equal,
//                                              so {RUN} is inductive and RUN is proved; a run with START = DOOR = 1
//                                              shows LAMP; propagation.cc says that BELL follows from LAMP alone
//
// In: two structured programs, what matches. Out: a verdict for each pair. Not its job: words about it, replaying runs.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/prove/diff/match.h"
#include "transpiler/prove/diff/one_sided.h"
#include "transpiler/prove/diff/pairing.h"
#include "transpiler/prove/invariants/invariants.h"
#include "transpiler/symbolic/solver/solver.h"

namespace plcxx::prove::diff {

struct CompareLimits {
  uint32_t question_ms = 2000;  // for one question to the solver
  uint64_t total_ms = 60'000;   // for everything; what is not decided then stays so
  uint32_t most_periods = 6;    // of the runs from power-on that the solver searches
  /// Told what is being done, for a progress line; may be empty.
  std::function<void(const std::string& what)> progress;
};

/// An input, or a part of the state, as it is set before a period.
struct SetCell {
  execute::CellId old_cell, new_cell;  // either may be none
  uint64_t value = 0;

  bool operator==(const SetCell&) const = default;
};

/// What is set before each period; after the last one the pair differs. It begins with power-on and all memory 0 but
/// what is in `kept`, or `from_state`: then the first period sets a part of the state, too, and nothing is known of how
/// to come there.
struct Run {
  std::vector<std::vector<SetCell>> periods;
  std::vector<SetCell> kept = {};  // memory that is kept without power, when power comes for the first time
  bool from_state = false;
};

enum class PairVerdict : uint8_t {
  kUntouched,  // neither version writes it
  kEqual,      // proved, for every run
  kDifferent,  // see `run`, when there is one
  kUndecided
};

struct PairResult {
  execute::CellId old_cell, new_cell;  // one of them none: the other version has no such cell
  PairVerdict verdict = PairVerdict::kUndecided;
  /// What its own statements do differs, with every value that they read equal. Of others that are undecided it is
  /// proved that they behave alike in every run in which those with such a change do.
  bool changed_itself = false;
  /// Of calls: the version that makes them whenever power comes, while the other one never does. No run has to show it.
  std::optional<Which> only_caller;
  std::optional<Run> run;
  std::string reason;  // of kUndecided
};

struct CompareResult {
  std::vector<PairResult> pairs;   // of all state, ascending by old cell, then those of the new version only
  std::string refusal;             // not empty: nothing was compared, and why
  uint32_t invariants = 0;         // that were proved on the way and needed
  bool changes_are_found = false;  // PairResult::changed_itself says something
  OneSided one_sided;              // what is in no pair
  /// Routines that the host alone calls, and that do, or may do, something else in the new version: nothing else is
  /// said of them.
  std::vector<std::string> changed_for_host;
};

/// kScenarios: known runs alone, before anything is asked; what they show is told with the next effort.
enum class Effort : uint8_t { kScenarios, kQuick, kThorough, kLasting };
/// Pairs, by old cell: all that are compared, and those that are open, with a change of their own first, then outputs;
/// runs from power-on that show a difference.
struct Sought {
  std::vector<execute::CellId> all, open;
  std::vector<Run> runs;
};
/// What running both versions beside each other tells; nothing where a function is empty.
struct SimulatedRuns {
  /// Gives those of all pairs of which running both versions shows a difference. `most_ms` is for a lasting search; the
  /// others know what they may cost.
  std::function<std::vector<execute::CellId>(const Sought& sought, Effort effort, uint64_t most_ms)> find_different;
  /// Whether find_different looks for a difference of an open pair: of a word that differs no other bit is of interest.
  std::function<bool(execute::CellId old_cell)> is_sought;
  /// Calls `visit` with states that find_different has come by, after a period or a fast part.
  std::function<void(Which which, const std::function<void(const invariants::CellValues&, uint64_t now_ms)>& visit)>
      for_each_seen_state;
  /// The same with both versions as they were at one time.
  std::function<void(const std::function<void(const invariants::CellValues& of_old,
                                              const invariants::CellValues& of_new, uint64_t now_ms)>& visit)>
      for_each_seen_pair;
};

CompareResult CompareVersions(const machine::Version& old_version, const machine::Version& new_version,
                              const Match& match, const SimulatedRuns& runs, const CompareLimits& limits);

}  // namespace plcxx::prove::diff
