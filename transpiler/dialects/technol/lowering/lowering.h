// Lowers the syntax tree of a technol program to the typed IR (specification sections 4 to 8): RLO and registers are
// evaluated at compile time, so that a sequence becomes one expression; a mechanism becomes a routine that begins with
// a choice of its waiting point.
//
// In: the paths of a tree without errors. Out: a complete program.
#pragma once

#include "transpiler/dialects/technol/analysis/flow.h"
#include "transpiler/dialects/technol/machine/options.h"
#include "transpiler/dialects/technol/syntax/syntax.h"
#include "transpiler/ir/program.h"
#include "transpiler/source/source.h"

namespace plcxx::technol {

ir::Program Lower(const Flow& flow, const Settings& settings, const source::SourceManager& sources);

}  // namespace plcxx::technol
