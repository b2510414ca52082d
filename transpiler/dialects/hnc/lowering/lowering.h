// From the tree to IR: functions, the cycle around them, and the checks that need the flow of the program.
//
// Implements sections 4 to 7 of the specification. In: the tree, whole but perhaps with poison in it. Out: the program;
// it is only meaningful when no error was reported.
#pragma once

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/hnc/analysis/facts.h"
#include "transpiler/dialects/hnc/analysis/objects.h"
#include "transpiler/dialects/hnc/machine/options.h"
#include "transpiler/dialects/hnc/syntax/syntax.h"
#include "transpiler/ir/program.h"
#include "transpiler/ir/reference.h"

namespace plcxx::hnc {

/// `objects` and `facts` are those of the unit.
ir::Program Lower(const Unit& unit, const Objects& objects, const Facts& facts, const Settings& settings,
                  const source::SourceManager& sources, diag::Engine& diagnostics);
/// Which functions and variables are which routines and bytes of the program that Lower gives; without bitcode.
ir::Reference DescribeLowered(const Unit& unit, const Settings& settings, const source::SourceManager& sources,
                              diag::Engine& diagnostics);

}  // namespace plcxx::hnc
