#include "transpiler/driver/accepted_warnings.h"

#include <iostream>
#include <string>
#include <utility>
#include <variant>

namespace plcxx::driver {

std::string BaselineOf(const CommonOptions& common) {
  if (!common.baseline.empty()) return common.baseline;
  return common.program ? common.program->baseline : std::string();
}

std::optional<compilation::Compilation> CompileProgram(const CommonOptions& common,
                                                       const compilation::CompilationRequest& request,
                                                       compilation::Stage until, project::Accepted& accepted) {
  const std::string path = BaselineOf(common);
  if (path.empty()) return compilation::Compile(request, until);
  std::variant<project::Baseline, yaml::Error> baseline = project::ReadBaseline(path);
  if (const auto* error = std::get_if<yaml::Error>(&baseline)) {
    std::cerr << ToText(*error) << '\n';
    return std::nullopt;
  }
  return project::CompileAccepting(request, until, std::get<project::Baseline>(baseline), request.base_directory,
                                   accepted);
}

std::optional<compilation::Compilation> CompileProgram(const CommonOptions& common,
                                                       const compilation::CompilationRequest& request,
                                                       compilation::Stage until) {
  project::Accepted accepted;
  return CompileProgram(common, request, until, accepted);
}

}  // namespace plcxx::driver
