// Machine-hours of a program with inputs that nobody meant, steered to what has not been seen.
//
// In: a program, its properties, scenarios and runs of earlier times. Machines run in generations: each of them has a
// trial of its own, whose chance follows from the seed, the machine's number and the generation's; what all of them
// found is taken together in the order of their numbers, and is where the next generation begins. So the result does
// not depend on how many run at a time. In a fleet the machines of a generation run side by side, and those that
// promise something new are repeated one by one. Out: findings, what was reached, runs worth keeping. Not its job:
// files.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "transpiler/soak/findings.h"
#include "transpiler/soak/goals.h"
#include "transpiler/soak/wide_runs.h"

namespace plcxx::soak {

struct SoakRequest {
  const scenarios::ProveMachine& machine;  // the program as it runs, with its slices
  const compilation::CompilationRequest& request;
  std::vector<Stimuli> scenarios;  // beside the program
  std::vector<Stimuli> corpus;     // of earlier times
  MakeMachines make;
  std::shared_ptr<const WideProgram> wide;             // then machines run in it, kWideMachines at a time; may be none
  std::shared_ptr<const scenarios::BoundPlant> plant;  // of these machines; may be none
  uint32_t machines = 16;                              // of this shard
  uint32_t first_machine = 0, every = 1;               // their numbers: the first, and so many on from each to the next
  uint64_t machine_ms = 0;                             // of all of them together
  std::optional<std::chrono::steady_clock::time_point> end;
  std::function<bool()> is_asked_to_end;  // as if it were late; from several threads; may be empty
  uint32_t jobs = 1;
  uint64_t seed = 1;
  std::optional<std::string> until;                       // ends with a finding whose text has these words
  std::string directory;                                  // where findings will stand
  std::function<bool(const std::string& name)> is_taken;  // a file there that no finding may replace; may be empty
  std::function<void(const std::string& text)> progress;  // may be empty
};

/// A run that is worth keeping: it reaches something that no other one does.
struct KeptRun {
  Stimuli stimuli;
  GoalSet goals;
};

struct Soaked {
  std::vector<Finding> findings;
  std::vector<std::pair<Cause, std::string>> not_repeated;  // seen once, and not again from power-on
  std::set<std::string> more;                               // causes of further findings, which are only counted
  GoalSet reached;
  std::vector<KeptRun> corpus;
  std::vector<bool> repeated;  // which of SoakRequest::corpus: for the others there was no time
  std::map<uint32_t, MessageLife> messages;
  OutputLife outputs;
  uint64_t machine_ms = 0, parts = 0, steps = 0, generations = 0;
  uint64_t wide_parts = 0;        // of the parts: in wide runs
  bool is_found = false;          // what SoakRequest::until names
  bool out_of_time = false;       // of real time, before the machine-hours were over
  bool was_asked_to_end = false;  // before they were
};

Soaked Soak(const SoakRequest& request, const Goals& goals, const Inputs& inputs, const WatchPlan& plan);

/// Those of the runs that are enough to reach what all of them reach, in their order: none of them is redundant.
std::vector<size_t> Needed(const std::vector<GoalSet>& runs, const GoalSet& all);

}  // namespace plcxx::soak
