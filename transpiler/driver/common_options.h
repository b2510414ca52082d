// The options that every subcommand with sources takes, and the request that they make.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/driver/diagnostics_output.h"
#include "transpiler/project/project.h"

namespace plcxx::driver {

/// What the chosen subcommand does; gives the exit code.
using Run = std::function<int()>;

struct CommonOptions {
  std::vector<std::string> sources;
  std::string dialect;
  std::string encoding;
  std::vector<std::string> settings;  // --set
  std::vector<std::string> include_directories, system_include_directories, defines, undefines;
  std::vector<std::string> warnings;
  std::string format = "text";
  std::optional<size_t> most_messages;
  bool allow_outside = false;
  std::string project;  // --project: a plcxx.yaml; found upwards from here when no sources are named
  std::vector<std::string> program_names;
  std::string baseline;  // --baseline: instead of the program's
  bool all = false;
  bool is_one_of_several = false;           // the command runs for several programs, one after the other
  std::optional<project::Program> program;  // of the project, where no sources are named: what it says is meant first
};

/// SOURCE..., those of AddProjectOptions, --dialect, --encoding, --set, -I, --system-include, -D, -U, -W,
/// --diagnostics, --max-messages.
void AddCommonOptions(CLI::App& command, CommonOptions& options);
/// The same without SOURCE.
void AddProgramOptions(CLI::App& command, CommonOptions& options);
/// --project, --program, --all, --allow-outside.
void AddProjectOptions(CLI::App& command, CommonOptions& options);
/// --set and -W alone, for commands that have no sources of their own.
void AddSettings(CLI::App& command, CommonOptions& options);

/// The --set options for --help: those of the dialect that is asked for or that plcxx.yaml here says, with what they
/// mean; else the keys alone.
std::string DialectOptionsText(const CommonOptions& options);
/// Those of all dialects, for the manual pages.
std::string AllDialectOptionsText();

/// None when an option is wrong: the error has been printed, the exit code is kWrongUse.
std::optional<compilation::CompilationRequest> MakeRequest(const CommonOptions& options);
MessageStyle MessagesOf(const CommonOptions& options);

/// kDone, kProgramHasErrors, or kWrongUse when the errors are of the command line.
int ExitCodeOf(const compilation::Compilation& compilation);

// The subcommands, one file each.
void AddEmit(CLI::App& app, Run& run);
void AddCheck(CLI::App& app, Run& run);
void AddPrint(CLI::App& app, Run& run);
void AddSim(CLI::App& app, Run& run);
void AddExplain(CLI::App& app, Run& run);
void AddInit(CLI::App& app, Run& run);
void AddCompletion(CLI::App& app, Run& run);
void AddManual(CLI::App& app, Run& run);
void AddReport(CLI::App& app, Run& run);
void AddBuild(CLI::App& app, Run& run);
void AddVerify(CLI::App& app, Run& run);
void AddDiff(CLI::App& app, Run& run);
void AddProve(CLI::App& app, Run& run);
void AddLsp(CLI::App& app, Run& run);
void AddMcp(CLI::App& app, Run& run);
void AddIdentify(CLI::App& app, Run& run);

}  // namespace plcxx::driver
