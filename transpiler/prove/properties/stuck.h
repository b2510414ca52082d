// Outputs that can always still be moved: for every state there are inputs, which is not one question to a solver.
//
// A few sequences of inputs are collected, of which one works from every state: a state from which none of those so far
// works is found, then inputs that work from this very state, until there is no such state, or no such inputs. The host
// answers 0 here.
#pragma once

#include "transpiler/prove/properties/checked_program.h"
#include "transpiler/prove/properties/program_invariants.h"
#include "transpiler/prove/properties/run_trials.h"

namespace plcxx::prove::properties {

PropertyResult CheckNeverStuck(CheckedProgram& checked, ProgramInvariants& invariants, RunTrials& trials,
                               const Property& property);

}  // namespace plcxx::prove::properties
