// What a machine is made to do next: by chance, and towards what nobody has reached.
//
// In: what is known so far, and numbers from which all chance is made. Out: inputs with their values, times. Not its
// job: doing it (trial.h, wide_runs.h).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/review/diff/stimulus.h"
#include "transpiler/sim/engine.h"
#include "transpiler/soak/inputs.h"
#include "transpiler/soak/machines.h"
#include "transpiler/soak/watch.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::soak {

using review::diff::Stimuli;
using review::diff::Stimulus;

/// What one machine did first, and where it was then.
struct Entry {
  Stimuli stimuli;  // from power-on
  std::shared_ptr<const Moment> moment;
  std::vector<uint8_t> given;  // since power-on, see Simulator::NoteGiven
};

/// A message that came, and was never seen to go.
struct Standing {
  std::shared_ptr<const Entry> entry;  // where it has come
  std::vector<uint32_t> writers;       // statements that write it
};

/// What is known when a generation begins.
struct Known {
  const Inputs& inputs;
  const WatchPlan& plan;
  const std::vector<Stimuli>& scenarios;
  std::vector<std::shared_ptr<const Entry>> entries;  // the newest at the end
  std::vector<uint8_t> given;                         // by all so far; 3 where it does not matter
  std::vector<ir::StatementId> open;                  // statements with goals that were not reached
  std::vector<Standing> standing;
  std::set<uint32_t> gone;       // messages that were seen to go
  std::set<std::string> causes;  // by key: they are no news
};

/// Steps of a trial, of a wide run.
inline constexpr size_t kMostSteps = 60;

/// Where a trial or a wide run begins, and where it goes from there.
struct Beginning {
  std::shared_ptr<const Entry> from;              // none: power-on
  const Stimuli* scenario = nullptr;              // to follow from power-on; may be none
  const std::vector<uint32_t>* sought = nullptr;  // statements to which inputs are steered; none: the open ones
};
Beginning ChooseBeginning(const Known& known, terms::Random& random);

/// What chance wants the input of this number to be, on a machine.
uint64_t ChooseValue(const Known& known, uint32_t input, sim::Engine& machine, terms::Random& random);

/// Calls `set` for the inputs that chance wants to be set now, by their number; for one of them perhaps again.
/// `sought`: statements to which inputs are steered; none: the open ones.
void ChooseInputs(const Known& known, const std::vector<uint32_t>* sought, terms::Random& random,
                  const std::function<void(uint32_t input)>& set);
void ChooseTime(const Known& known, terms::Random& random, Stimulus& stimulus);
/// Now and then a step of some scenario, whose words are to be set; else none.
const Stimulus* PickOtherStep(const Known& known, terms::Random& random);
/// The word of a stimulus is this one, in the place of another one of that name.
void PutWord(Stimulus& stimulus, std::pair<std::string, std::string> word);

/// A number of chance that makes a sequence of its own.
terms::Random RandomOf(uint64_t chance);

/// The same as time that a machine can have: a part that runs alone, while the other one has a time of its own, is a
/// scenario's means and nothing that happens.
Stimulus AsItHappens(Stimulus stimulus, const ir::Schedule& schedule);

}  // namespace plcxx::soak
