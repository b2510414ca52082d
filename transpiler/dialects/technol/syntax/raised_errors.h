// The numbers of all ESETs of a program (specification 9.5): for reports, the cross reference and the printed tree.
#pragma once

#include <vector>

#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/technol/syntax/syntax.h"

namespace plcxx::technol {

/// By number, then by place; main 1 to 99, sub 0 to 99. Not those that are faulty.
std::vector<dialects::RaisedError> RaisedErrors(const Program& program);

}  // namespace plcxx::technol
