// The files that emit and build write for a program, and what goes wrong with writing them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "transpiler/driver/compilation.h"
#include "transpiler/driver/output_files.h"
#include "transpiler/emit/cpp_printer.h"

namespace plcxx::driver {

/// C++ and map of a program; names without directory.
std::vector<emit::OutputFile> ProgramFiles(const Compilation& compilation, const emit::Emittable& emittable);

/// The files that were read: no output may overwrite them.
std::vector<std::string> PathsRead(const Compilation& compilation);

/// With the code that the dialect's specification fixes for it, where it fixes one.
void ReportCannotWrite(const WriteFailure& failure, Compilation& compilation);

}  // namespace plcxx::driver
