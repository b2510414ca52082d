// Which programs a command is about: its sources, or programs of plcxx.yaml.
//
// In: the options that every command takes. Out: the command is run once for each program, with the program in its
// options. Not its job: what the file means (transpiler/project).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/driver/common_options.h"
#include "transpiler/project/project.h"

namespace plcxx::driver {

/// The programs that --project, --program and --all choose; none when that cannot be, which is reported. Without them
/// it is the only one, or the only one in whose folder the command runs.
std::optional<std::vector<project::Program>> ChoosePrograms(CommonOptions& options);

/// A folder, or its plcxx.yaml, named where sources are expected, becomes --project.
void NameProject(CommonOptions& common);

/// What a command prints of each program.
enum class Result : uint8_t {
  kNamed,    // it says of which program it is, or is documents of diagnostics
  kUnnamed,  // text that does not say so
  kJson,     // one value each: of several programs an array
  kSarif,    // one log each: of several programs one log
};

/// Runs it with the sources of the command line, or for each program of the project; gives the greatest exit code.
int ForEachProgram(const CommonOptions& options, const std::function<int(const CommonOptions&)>& command,
                   Result result = Result::kNamed);

/// The same for the settings of a command, whose member `common` are these options.
template <class Settings>
int RunForPrograms(const Settings& settings, int (*run)(const Settings& settings), Result result = Result::kNamed) {
  return ForEachProgram(
      settings.common,
      [&](const CommonOptions& common) {
        Settings own = settings;
        own.common = common;
        return run(own);
      },
      result);
}

/// A folder that a command fills: of several programs one below it for each.
std::string FolderOf(const CommonOptions& common, const std::string& folder);

}  // namespace plcxx::driver
