// What heads a routine in the page and in ladder pictures.
#pragma once

#include <string>

#include "transpiler/ir/program.h"

namespace plcxx::report {

/// The name and the comment of a routine, in one line.
std::string RoutineTitle(const ir::Routine& routine);

}  // namespace plcxx::report
