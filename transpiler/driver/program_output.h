// What emit and build share of writing the files of a program.
#pragma once

#include <string>
#include <vector>

#include "transpiler/driver/compilation.h"
#include "transpiler/driver/output_files.h"

namespace plcxx::driver {

/// The files that were read: no output may overwrite them.
std::vector<std::string> PathsRead(const Compilation& compilation);

/// With the code that the dialect's specification fixes for it, where it fixes one.
void ReportCannotWrite(const WriteFailure& failure, Compilation& compilation);

}  // namespace plcxx::driver
