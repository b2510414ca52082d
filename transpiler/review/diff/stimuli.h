// What is set and how long is waited in the runs that look for a difference.
//
// In: the inputs that matter, two programs. Out: stimuli for both versions. Not its job: running them.
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/prove/diff/match.h"
#include "transpiler/review/diff/runs.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::review::diff {

/// What the constants tell that only one of two versions has: a preset or a limit was changed, perhaps.
struct ChangedConstants {
  std::vector<uint32_t> times_ms;  // ascending: between an old preset and a new one, whatever its unit
  uint32_t counts = 0;             // the greatest one that a counter may have to reach; 0: none
  bool are_any = false;            // one version has a constant that the other one does not have
};
ChangedConstants FindChangedConstants(const prove::machine::Version& old_version,
                                      const prove::machine::Version& new_version);

/// A value for each input; `run`: half, many or few of them are 1, in turn.
std::vector<prove::diff::SetCell> RandomInputs(terms::Random& random, std::vector<prove::diff::SetCell> inputs,
                                               int run);

/// At most two of them have another value.
std::vector<prove::diff::SetCell> AlmostTheSame(terms::Random& random, std::vector<prove::diff::SetCell> inputs);

/// Of HoldStimuli: it waits for all times.
inline constexpr int kMostPatientRun = 5;
/// All inputs are set once, and then nothing happens for longer and longer: until each of `times_ms`, too, as far as
/// this run is one of the patient ones. Long waits cost much, so most runs end early.
Stimuli HoldStimuli(std::vector<prove::diff::SetCell> inputs, int run, const std::vector<uint32_t>& times_ms);

/// All inputs are set once; then one of them comes and goes `count` times.
Stimuli PulseStimuli(terms::Random& random, const std::vector<prove::diff::SetCell>& inputs, int run, uint32_t count);

}  // namespace plcxx::review::diff
