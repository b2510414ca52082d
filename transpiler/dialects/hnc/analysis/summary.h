// The lists of specification 9.5 for reports: handlers, alarms, codes, register cells, variables, limits.
//
// In: the tree, and the program for its loops and names. Out: tables of texts. Places are "file:line" with the file's
// name alone, so that a report does not depend on where the sources stand.
#pragma once

#include <vector>

#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/hnc/analysis/facts.h"
#include "transpiler/dialects/hnc/analysis/objects.h"
#include "transpiler/dialects/hnc/syntax/syntax.h"

namespace plcxx::hnc {

/// Tables in a fixed order, also where they are empty.
std::vector<dialects::SummaryTable> SummaryTables(const Unit& unit, const Objects& objects, const Facts& facts,
                                                  const ir::Program& program, const source::SourceManager& sources);

}  // namespace plcxx::hnc
