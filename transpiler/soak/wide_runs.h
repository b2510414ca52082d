// Hundreds of machines from one moment on, each a lane of a fleet: which of them come to what nobody has reached.
//
// All of them have one time, so that steps take the same time in each; inputs are each machine's own. In: a program
// that notes what it reaches (notes.h), what is known, chance. Out: runs that promise something new. They are repeated
// by a machine in the simulator before anything is told (trial.h): a lane is never believed. Not its job: findings.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/fleet/lane.h"
#include "transpiler/fleet/library.h"
#include "transpiler/scenarios/bound_plant.h"
#include "transpiler/soak/notes.h"
#include "transpiler/soak/steering.h"

namespace plcxx::soak {

/// Machines of a wide run, whatever the processor has: the same everywhere.
inline constexpr uint32_t kWideMachines = 512;

/// A program for wide runs, the same for all threads.
struct WideProgram {
  const compilation::Compilation& compilation;
  std::shared_ptr<const scenarios::BoundPlant> plant;  // may be none
  NotedProgram noted;
  fleet::HostOnlyBytes host_only;
  std::shared_ptr<const fleet::Library> library;
};

/// Takes seconds. A text: there is no such program, and why. What it is made of outlives it.
std::variant<std::shared_ptr<const WideProgram>, std::string> CompileWide(
    const compilation::Compilation& compilation, std::shared_ptr<const scenarios::BoundPlant> plant, const Goals& goals,
    const WatchPlan& plan, const fleet::LibraryRequest& request);

/// What a machine did that is worth repeating.
struct Promise {
  std::shared_ptr<const Entry> from;  // where it began; none: at power-on
  Stimuli stimuli;                    // from there on
  std::optional<uint32_t> mark;       // that was new; none: a part was not completed
};

struct WideResult {
  std::vector<Promise> promises;
  uint64_t parts = 0, machine_ms = 0, steps = 0;  // of all machines
  OutputLife outputs;                             // after each part of each of them
};

/// What a wide run is asked to do.
struct WideRequest {
  uint64_t run = 0;                                      // the chance of what all machines have in common
  std::function<uint64_t(uint32_t machine)> of_machine;  // and of each of them
  uint64_t most_ms = 0;                                  // of each machine's time: then no other step begins
  uint64_t left_ms = ~uint64_t{0};                       // of it until the soak is over: no step goes further
  std::function<bool()> is_late;                         // no real time is left; may be empty
};

/// Machines that make one wide run after the other; of one thread.
class WideMachines {
 public:
  explicit WideMachines(std::shared_ptr<const WideProgram> program);
  ~WideMachines();
  WideMachines(const WideMachines&) = delete;
  WideMachines& operator=(const WideMachines&) = delete;

  WideResult Run(const Known& known, Words& words, const WideRequest& request);

 private:
  class Herd;
  std::unique_ptr<Herd> herd_;
};

}  // namespace plcxx::soak
