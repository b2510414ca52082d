// Lowers the syntax tree of a prostep program to the typed IR (specification sections 4 to 7): S, AX and the bracket
// stack are evaluated at compile time, so that a sequence becomes one expression.
//
// In: a tree without errors. Out: a complete program. Warnings that need the control flow are found on the way.
#pragma once

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/prostep/machine/options.h"
#include "transpiler/dialects/prostep/syntax/syntax.h"
#include "transpiler/ir/program.h"
#include "transpiler/source/source.h"

namespace plcxx::prostep {

ir::Program Lower(const Program& tree, const Settings& settings, const source::SourceManager& sources,
                  diag::Engine& diagnostics);

}  // namespace plcxx::prostep
