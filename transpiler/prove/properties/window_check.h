// Properties by facts about the reachable states: what a property says of several periods becomes state of its own.
#pragma once

#include "transpiler/prove/properties/checked_program.h"
#include "transpiler/prove/properties/program_invariants.h"

namespace plcxx::prove::properties {

/// After any reachable state, a period that does not violate it: shorter runs than its window have been searched.
/// True: `result` has a verdict or a reason.
bool TryReachable(CheckedProgram& checked, ProgramInvariants& invariants, const Property& property,
                  PropertyResult& result);
/// Only what is proved in so short a time counts.
bool TryReachableFor(uint32_t milliseconds, CheckedProgram& checked, ProgramInvariants& invariants,
                     const Property& property, PropertyResult& result);

}  // namespace plcxx::prove::properties
