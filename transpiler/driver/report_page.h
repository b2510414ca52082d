// A compiled program as the report's page takes it.
#pragma once

#include "transpiler/compilation/compilation.h"
#include "transpiler/report/program_input.h"

namespace plcxx::driver {

/// `compilation` has reached kOptimized without errors, has a program, and outlives the result, which refers to it.
/// The C++ is printed as `plcxx emit` prints it.
report::ProgramInput PageInput(const compilation::Compilation& compilation);

}  // namespace plcxx::driver
