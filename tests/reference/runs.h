// Scenarios run by the simulator and by the reference, side by side.
//
// In: a scenario file, or a random program. Out: what they disagree about, and how much was compared.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/reference/random_program.h"
#include "tests/reference/reference_dialects.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/scenario.h"

namespace plcxx::reference {

enum class Outcome : uint8_t {
  kAgrees,
  kDisagrees,
  kUnsupported,  // the reference passes over something
  kNothingToRun  // an expected error, no steps
};

struct RunResult {
  Outcome outcome = Outcome::kAgrees;
  std::string text;       // of a disagreement: the scenario, its step, the place; of kUnsupported: what
  uint64_t compared = 0;  // values: bytes of memory and fields of elements, after each period
};

RunResult RunBeside(const scenarios::Scenario& scenario, compilation::Compilation& compilation,
                    const ReferenceDialect& dialect);

/// What the host sees of a scenario in the simulator: its memory after each piece of execution, as hashes.
std::vector<uint64_t> TraceOf(const scenarios::Scenario& scenario, compilation::Compilation& compilation);

/// Writes the program into `directory`, and reads the scenario that drives it there.
scenarios::ScenarioOrErrors WriteRandom(const RandomProgram& program, const ReferenceDialect& dialect,
                                        const std::string& directory);

/// Writes the program into `directory`, compiles and runs it.
RunResult RunRandom(const RandomProgram& program, const ReferenceDialect& dialect, const std::string& directory);

/// Deletes pieces and steps while `fails` holds of what is left.
RandomProgram Shrink(RandomProgram program, const std::function<bool(const RandomProgram& program)>& fails);

}  // namespace plcxx::reference
