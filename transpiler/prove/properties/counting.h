// Properties that speak about long times: what has been held, and what is waited for, is counted.
#pragma once

#include "transpiler/prove/properties/checked_program.h"
#include "transpiler/prove/properties/program_invariants.h"

namespace plcxx::prove::properties {

/// True: `result` has the verdict kProved.
bool TryCounting(CheckedProgram& checked, ProgramInvariants& invariants, const Property& property,
                 PropertyResult& result);

}  // namespace plcxx::prove::properties
