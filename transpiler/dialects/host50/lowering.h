// Lowers a syntax tree of dialect host50 to IR (specification sections 4, 6 and 7).
//
// In: a tree without errors, its settings. Out: a program.
#pragma once

#include "transpiler/dialects/host50/syntax.h"
#include "transpiler/ir/program.h"
#include "transpiler/source/source.h"

namespace plcxx::host50 {

ir::Program Lower(const Program& tree, const Settings& settings, const source::SourceManager& sources);

}  // namespace plcxx::host50
