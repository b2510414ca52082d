// The run that a solver's values are: what is set before power comes, and in front of each part.
#pragma once

#include "transpiler/prove/properties/checked_program.h"

namespace plcxx::prove::properties {

/// After an answer kPossible to `violated`, which is over `unrolled`: a run of so many periods.
PropertyRun RunOf(CheckedProgram& checked, machine::Unrolled& unrolled, terms::TermId violated, uint32_t periods);

}  // namespace plcxx::prove::properties
