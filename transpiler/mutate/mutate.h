// How much the scenarios of a program notice: each change of changes.h is executed by those that reach it.
//
// In: a compiled program and its scenarios. Out: for each change whether a scenario fails with it, all pass with it, or
// none executes it. The scenarios run in the simulator, in child processes: what crashes or does not end is noticed.
// The result is the same whatever `jobs` is. Not its job: compiling, texts (driver).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/mutate/changes.h"
#include "transpiler/scenarios/scenario.h"

namespace plcxx::mutate {

enum class Outcome : uint8_t { kNoticed, kNotNoticed, kNotReached };

/// "noticed", for documents.
std::string_view Name(Outcome outcome);

/// How changes are tried: together, as far as their time runs as that of the original, or each by itself. The result is
/// the same.
enum class Way : uint8_t { kSideBySide, kAlone };

struct MutateRequest {
  compilation::Compilation& compilation;       // without errors; unchanged afterwards
  std::vector<scenarios::Scenario> scenarios;  // with steps
  size_t most = 0;                             // changes, spread evenly over all that there are; 0: all
  unsigned jobs = 1;                           // processes at a time
  unsigned time_limit = 60;                    // seconds of real time for a change, or for a scenario before any change
  std::function<void(size_t done, size_t all)> progress = {};
  Way way = Way::kSideBySide;
};

struct ChangeResult {
  Change change;
  Outcome outcome{};
};

struct Mutated {
  size_t found = 0;                   // changes that there are
  size_t alone = 0;                   // that were tried each by itself
  std::vector<ChangeResult> results;  // of those that were tried, in the order of the source
};

/// A scenario fails although nothing was changed.
struct FailsBefore {
  std::string path, text;
};

std::variant<Mutated, std::vector<FailsBefore>> Mutate(const MutateRequest& request);

}  // namespace plcxx::mutate
