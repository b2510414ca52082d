// One run of a machine with inputs that nobody meant: from power-on, from a scenario, or from a moment that was worth
// keeping.
//
// In: what is known so far (the same for all trials of a generation, so that it does not matter which one runs first),
// and a number from which all chance is made. Out: what was new. Not its job: what becomes of it (soak.h).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/soak/goals.h"
#include "transpiler/soak/inputs.h"
#include "transpiler/soak/machines.h"
#include "transpiler/soak/steering.h"
#include "transpiler/soak/watch.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::soak {

struct TrialResult {
  std::vector<Entry> entries;  // each has given something that nothing before has
  struct Found {
    Cause cause;
    Stimuli stimuli;  // up to the step in which it was seen
  };
  std::vector<Found> found;
  std::map<uint32_t, Entry> came;  // by message that is not known to go: where it has come
  std::map<uint32_t, MessageLife> messages;
  OutputLife outputs;
  std::vector<uint8_t> given;
  uint64_t parts = 0, machine_ms = 0, steps = 0;
};

class Trial {
 public:
  /// What chance wants, for `most_ms` of the machine's time.
  Trial(const Known& known, Words& words, uint64_t chance, uint64_t most_ms);
  /// These steps and nothing else, from `from` on; none: from power-on.
  Trial(const Known& known, Words& words, std::shared_ptr<const Entry> from, const Stimuli& follows);

  void Begin(Machines& machines, size_t machine);
  /// The next step is done, but for its time. False: there is none.
  bool Next(Machines& machines, Piece& piece);
  void AfterPart(Machines& machines, sim::Clock::Part part);
  void AfterStep(Machines& machines);
  void End(Machines& machines);
  TrialResult Take() { return std::move(result_); }

 private:
  Stimulus Choose(Machines& machines);
  bool GaveNews() const;
  Entry Here(Machines& machines) const;
  void Keep(Machines& machines);

  const Known& known_;
  Words& words_;
  terms::Random random_;
  uint64_t most_ms_;
  Beginning begin_;
  const Stimuli* follows_ = nullptr;
  size_t next_step_ = 0;  // of the scenario, of `follows_`
  size_t machine_ = 0;
  Stimuli stimuli_;                            // from power-on
  std::vector<uint8_t> given_, given_before_;  // since the trial began; before it
  std::vector<uint8_t> seen_;                  // by anybody, this one included
  Watch watch_;
  uint64_t begin_work_ = 0, steps_ = 0, machine_ms_ = 0, time_ms_ = 0;
  bool is_over_ = false;
  TrialResult result_;
};

/// All of the trials, as many at a time as the machines are; in their order.
void RunTrials(Machines& machines, std::span<Trial* const> trials);

}  // namespace plcxx::soak
