// What only follows from one mistake that many places show: a missing header, a missing brace (specification 10.2).
#pragma once

#include <vector>

#include "transpiler/dialects/hnc/source/findings.h"
#include "transpiler/source/source.h"

namespace plcxx::hnc {

/// Without the system header, everything about its names: one finding, at the first of them, is left.
void MergeMissingHeader(const source::SourceManager& sources, std::vector<Finding>& findings);

/// With a brace too few, what the parser says of the functions behind it: the first finding is left.
void MergeMissingBrace(const source::SourceManager& sources, std::vector<Finding>& findings);

}  // namespace plcxx::hnc
