// What is done to a machine in one step of a run: as the steps of a scenario, with inputs that need no name.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/prove/diff/compare.h"
#include "transpiler/scenarios/known_runs.h"

namespace plcxx::review::diff {

/// Power fails, perhaps, and something else is kept; inputs are set; then time passes.
struct Stimulus {
  std::vector<prove::diff::SetCell> inputs;
  std::vector<std::pair<std::string, std::string>> words;  // the same as a scenario writes it: location, value
  uint32_t slow = 0;                                       // complete slow passes; 0: `fast` or `ms`
  uint32_t ms = 0;
  uint32_t fast = 0;  // times the fast part alone; 0: `ms`
  bool power_cycle = false;
  /// Memory that is kept without power: what is there when the power comes again. Only where a run begins, for nobody
  /// knows what was there before.
  std::vector<prove::diff::SetCell> kept = {};
  /// Not empty: it is these, so many times, and nothing of the above.
  std::vector<Stimulus> repeated = {};
  uint32_t times = 0;

  bool operator==(const Stimulus&) const = default;
};
using Stimuli = std::vector<Stimulus>;

/// The same run, with what comes several times in a row written once.
Stimuli Folded(const Stimuli& stimuli);

/// What begins a run with such memory; nothing where it is 0.
Stimuli PowerOnWith(const std::vector<prove::diff::SetCell>& kept);

/// The time and the power cycle of a known step; which words a machine knows is for the caller to say.
Stimulus WithoutWords(const scenarios::KnownStep& step);

/// The steps of a scenario, and the same in one line.
struct WrittenSteps {
  std::string scenario, line;

  void AddPowerCycle();
  /// In one step, or in several where a location is set again: a step names each of them once.
  void AddSets(const std::vector<std::pair<std::string, std::string>>& words);
  /// Of `stimulus` what it sets by words, then its time.
  void Add(const Stimulus& stimulus);
  void AddRepeated(const WrittenSteps& steps, uint32_t times);
};

}  // namespace plcxx::review::diff
