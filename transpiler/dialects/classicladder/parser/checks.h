// What a project means beyond its lines: do the rungs of each section lead to its last one, is there what elements
// name.
//
// In: a parsed program. Out: errors and warnings; variables beyond their kind are replaced by those that the engine
// takes; the expressions that elements use are read.
#pragma once

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/classicladder/machine/options.h"
#include "transpiler/dialects/classicladder/syntax/syntax.h"

namespace plcxx::classicladder {

void CheckProgram(Program& program, const Settings& settings, diag::Engine& diagnostics);

}  // namespace plcxx::classicladder
