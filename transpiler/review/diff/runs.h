// Running both versions beside each other: what differs is found, shortened, and written as a scenario.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/prove/diff/compare.h"
#include "transpiler/prove/diff/match.h"
#include "transpiler/review/diff/diff.h"
#include "transpiler/review/diff/items.h"
#include "transpiler/review/diff/stimulus.h"
#include "transpiler/scenarios/program.h"

namespace plcxx::review::diff {

struct RandomRuns {
  std::vector<Stimuli> runs;
  struct Difference {
    uint32_t run = 0, steps = 0;  // after so many stimuli of the run
    uint64_t periods = 0;         // about so many of them passed until then
  };
  std::map<execute::CellId, Difference> difference_of;  // by old cell: the first one
};

struct RunRequest {
  const prove::machine::Version& old_version;
  const prove::machine::Version& new_version;
  const prove::diff::Match& match;
  const std::vector<execute::CellId>& cells;  // old ones: what is looked at
  prove::diff::Effort effort{};
  std::chrono::steady_clock::time_point end;
  uint32_t round = 0;  // of thorough searches: each has other inputs
  /// Only what takes patience and no luck: where constants changed, runs that wait and count as long as these say; and
  /// one long run where there is nothing to set.
  bool waits_only = false;
};

inline constexpr size_t kMostSought = 400;  // cells, of a search that is not quick; of more it does nothing

/// The pairs that the host writes and a version reads.
std::vector<prove::diff::SetCell> InputsOf(const prove::machine::Version& old_version,
                                           const prove::machine::Version& new_version, const prove::diff::Match& match);

/// Runs of both versions from power-on, in the simulator, with the same random inputs at the same time. A thorough
/// search ends when all of the cells have differed, or with its share of the time. Adds to `result`. See search.h
/// for what begins with a machine at work.
void RunBoth(const DiffSide& old_side, const DiffSide& new_side, const RunRequest& request, const DiffOptions& options,
             RandomRuns& result);

struct CounterexampleRequest {
  const prove::machine::Version& old_version;
  const prove::machine::Version& new_version;
  const CellWords& old_words;
  const CellWords& new_words;
  std::string name;
  ItemKind kind{};
  std::vector<execute::CellId> old_cells;
  std::optional<prove::diff::Run> run;  // the solver's
  const RandomRuns& runs;
  const prove::diff::Match& match;
};

/// A run that was shown, with both versions at its end: other items may differ there, too.
struct ShownRun;

/// What all counterexamples of a comparison may cost together, and the programs that they are replayed on.
struct ExampleBudget {
  int left = 0;
  std::chrono::steady_clock::time_point end;       // of the search for a shorter one
  std::chrono::steady_clock::time_point last_end;  // of showing what is known
  std::chrono::steady_clock::time_point all_end;   // of everything
  scenarios::ScenarioProgram old_program, new_program;
  std::vector<std::shared_ptr<const ShownRun>> shown;
};

/// The shortest scenario that could be found.
std::optional<Counterexample> FindCounterexample(DiffSide& old_side, DiffSide& new_side,
                                                 const CounterexampleRequest& request, const DiffOptions& options,
                                                 ExampleBudget& budget);

/// The same for an item that has no time of its own left: one of the runs that were shown for others, as it is.
std::optional<Counterexample> FindAmongShown(DiffSide& old_side, DiffSide& new_side,
                                             const CounterexampleRequest& request, const DiffOptions& options,
                                             ExampleBudget& budget);

}  // namespace plcxx::review::diff
