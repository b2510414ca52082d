// Lowers a syntax tree of dialect @name@ to IR.
//
// In: a tree without errors, its settings. Out: a program with the routines init, fast and period; its memory map and
// its schedule.
#pragma once

#include "transpiler/dialects/@name@/machine/options.h"
#include "transpiler/dialects/@name@/syntax/syntax.h"
#include "transpiler/ir/program.h"

namespace plcxx::@name@ {

ir::Program Lower(const Program& tree, const Settings& settings);

}  // namespace plcxx::@name@
