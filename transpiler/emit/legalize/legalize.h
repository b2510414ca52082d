// Decides everything about the text of a program that is not spelling.
//
// In: a structured, sliced and optimized program. Out: the Emittable, which the printer spells as it is.
#pragma once

#include "transpiler/emit/emittable.h"

namespace plcxx::emit::legalize {

/// `program` outlives the result.
Emittable Legalize(const ir::Program& program, const EmitOptions& options);

}  // namespace plcxx::emit::legalize
