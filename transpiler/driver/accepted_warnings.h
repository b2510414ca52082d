// Compiling for commands that show warnings: without those that the project's baseline accepts.
#pragma once

#include <optional>

#include "transpiler/compilation/compilation.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/project/baseline.h"

namespace plcxx::driver {

/// The file of accepted warnings; empty: none.
std::string BaselineOf(const CommonOptions& common);

/// As compilation::Compile; none when the baseline cannot be read, which is reported.
std::optional<compilation::Compilation> CompileProgram(const CommonOptions& common,
                                                       const compilation::CompilationRequest& request,
                                                       compilation::Stage until, project::Accepted& accepted);
std::optional<compilation::Compilation> CompileProgram(const CommonOptions& common,
                                                       const compilation::CompilationRequest& request,
                                                       compilation::Stage until = compilation::Stage::kOptimized);

}  // namespace plcxx::driver
