#include "transpiler/driver/test_command.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/driver/engine_choice.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/junit.h"
#include "transpiler/driver/output_files.h"
#include "transpiler/driver/scenario_choice.h"
#include "transpiler/driver/scenario_source.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/scenarios/suite.h"
#include "transpiler/support/listed.h"

namespace plcxx::driver {
namespace {

constexpr const char* kTestFooter = R"(Examples:
  plcxx test                                  the scenarios of plcxx.yaml, in this folder or above
  plcxx test turret.yaml                      the simulator and the generated code, in lockstep
  plcxx test scenarios --junit result.xml     every *.yaml below a directory
  plcxx test turret.yaml --vcd turret.vcd     and look at it with a waveform viewer
  plcxx test turret.yaml --engine cortex-m    the generated code on a Cortex-M4 in QEMU, beside the simulator
  plcxx test scenarios --engine all,riscv/8   one scenario in 8 also on a RISC-V in QEMU; the same ones everywhere

The emulated machines are compiled for with -O2: cortex-m and cortex-m7 (QEMU's mps2-an386, mps2-an500), riscv and
riscv64 (rv32imac, rv64gc; QEMU's virt). With PLCXX_ALL_TARGETS=1 in the environment, NAME/N runs all scenarios.

With --checked a scenario also fails when something does not hold that plcxx has left out code for, or chosen it by; the
kind, the value and the statement are told. Such a failure is a fault of plcxx. --set facts=checked shows these facts in
print and emit; plcxx verify proves them.

Exit codes: 0 all passed, 1 a scenario failed, 2 a scenario cannot be read.)";

struct TestSettings {
  CommonOptions common;  // --set and -W
  std::vector<std::string> paths, sources;
  std::string engine = "all";
  std::string compiler, junit, waveform;
  unsigned jobs = 2;
  unsigned time_limit = 60;
  bool verbose = false;
  bool checked = false;
};

struct Totals {
  size_t passed = 0, failed = 0, unusable = 0;
};

/// Names and texts hold what scenarios and sources hold.
void Report(const scenarios::ScenarioResult& result, const TestSettings& settings, Totals& totals) {
  const scenarios::TestCase& test = result.test;
  const std::string name = diag::Escaped(test.name), text = diag::EscapedLines(test.text);
  switch (test.outcome) {
    case scenarios::TestOutcome::kPassed:
      ++totals.passed;
      std::cout << "passed  " << name;
      if (settings.verbose && !result.ran.empty()) std::cout << "  (" << result.ran << ")";
      std::cout << "\n";
      break;
    case scenarios::TestOutcome::kFailed:
      ++totals.failed;
      std::cout << "FAILED  " << name << "\n" << text << "\n";
      break;
    case scenarios::TestOutcome::kUnusable:
      ++totals.unusable;
      std::cout << "ERROR   " << name << "\n" << std::flush;
      std::cerr << text << "\n";
      break;
  }
  std::cout << std::flush;
}

std::string Summary(const Totals& totals) {
  std::string text = std::to_string(totals.passed) + (totals.passed == 1 ? " scenario passed" : " scenarios passed");
  if (totals.failed > 0) text += ", " + std::to_string(totals.failed) + " failed";
  if (totals.unusable > 0) text += ", " + std::to_string(totals.unusable) + " cannot be run";
  return text;
}

/// kDone, or kWrongUse when a file cannot be written.
int WriteFiles(const TestSettings& settings, const std::vector<scenarios::ScenarioResult>& results,
               const std::vector<std::string>& paths) {
  OutputRequest output;
  output.protected_paths = paths;
  if (settings.common.program) output.protected_paths.push_back(settings.common.project);
  for (const scenarios::ScenarioResult& result : results)
    output.protected_paths.insert(output.protected_paths.end(), result.sources.begin(), result.sources.end());
  if (!settings.junit.empty()) {
    std::vector<scenarios::TestCase> cases;
    for (const scenarios::ScenarioResult& result : results) cases.push_back(result.test);
    output.files.push_back({settings.junit, JunitXml(cases, JunitOf::kScenarios)});
  }
  if (!settings.waveform.empty() && !results.front().waveform.empty()) {
    output.files.push_back({settings.waveform, results.front().waveform});
  }
  if (output.files.empty()) return kDone;
  output.named = {settings.junit, settings.waveform};
  const std::optional<WriteFailure> failure = WriteWithFolders(output);
  return failure ? CannotWrite(*failure) : kDone;
}

/// None when the command line is wrong; reported.
std::optional<scenarios::SuiteOptions> MakeOptions(const TestSettings& settings) {
  const std::optional<compilation::CompilationRequest> request = MakeRequest(settings.common);
  if (!request) return std::nullopt;
  scenarios::SuiteOptions options;
  std::optional<scenarios::ProgramOverrides> programs = OverridesOf(settings.sources, *request, settings.common);
  if (!programs) return std::nullopt;
  options.programs = std::move(*programs);
  options.reach = settings.common.allow_outside ? scenarios::Reach::kAnywhere : scenarios::Reach::kProject;
  if (settings.checked) options.programs.options.emplace_back(compilation::kFactsOption, "checked");
  options.jobs = settings.jobs;
  options.time_limit = settings.time_limit;
  options.waveform = !settings.waveform.empty();
  if (!ChooseEngines(settings.engine, settings.compiler, options)) return std::nullopt;
  return options;
}

int RunTest(const TestSettings& asked) {
  TestSettings settings = asked;
  std::optional<ChosenScenarios> chosen = ChooseScenarios(settings.common, settings.paths);
  if (!chosen) return kWrongUse;
  if (settings.compiler.empty()) settings.compiler = chosen->host_compiler;
  const std::vector<std::string>& paths = chosen->paths;
  if (!settings.waveform.empty() && paths.size() > 1) {
    return UsageError("'--vcd' takes one scenario, not " + std::to_string(paths.size()));
  }
  const std::optional<scenarios::SuiteOptions> options = MakeOptions(settings);
  if (!options || !CanBeWritten({settings.junit, settings.waveform})) return kWrongUse;
  Totals totals;
  const std::vector<scenarios::ScenarioResult> results = scenarios::TestScenarios(
      paths, *options, [&](const scenarios::ScenarioResult& result) { Report(result, settings, totals); });
  std::cout << Summary(totals) << "\n";
  const int written = WriteFiles(settings, results, paths);
  if (written != kDone) return written;
  if (totals.unusable > 0) return kWrongUse;
  return totals.failed > 0 ? kProgramHasErrors : kDone;
}

}  // namespace

void AddTest(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("test", "Run scenarios in the simulator and as compiled C++");
  const auto settings = std::make_shared<TestSettings>();
  command
      ->add_option("SCENARIO", settings->paths,
                   "Scenario files, or directories: all *.yaml in them. None: those of plcxx.yaml")
      ->type_name("");
  command
      ->add_option("--engine", settings->engine,
                   "What runs them, in lockstep: names with commas of " + support::CommaSeparated(EngineNames()) +
                       ". host is the generated code, compiled here; all is sim,host; the others are emulated")
      ->type_name("ENGINE")
      ->default_str("all");
  command->add_option("--cxx", settings->compiler, "C++ compiler for the generated code; else $CXX, c++, g++, clang++")
      ->type_name("COMMAND");
  command->add_option("--sources", settings->sources, "The program, instead of what the scenarios name")
      ->type_name("FILE...");
  command->add_option("--junit", settings->junit, "Write the results as JUnit XML")->type_name("FILE");
  command->add_option("--vcd", settings->waveform, "Write the locations that the scenario names as a waveform")
      ->type_name("FILE");
  command->add_option("-j,--jobs", settings->jobs, "Scenarios that run at a time")
      ->type_name("N")
      ->default_str("2")
      ->check(CLI::Range(1, 64));
  command
      ->add_option("--time-limit", settings->time_limit,
                   "Of real time, at most, for a scenario (60). One that needs more fails, and the others go on")
      ->type_name("SECONDS")
      ->check(CLI::Range(1u, 86'400u));
  command->add_flag("--checked", settings->checked,
                    "Execute what plcxx has decided from as assertions: ranges, bounds, constants in registers");
  command->add_flag("--verbose", settings->verbose, "Tell what each scenario ran in");
  AddSettings(*command, settings->common);
  AddProjectOptions(*command, settings->common);
  command->footer(kTestFooter);
  command->callback([settings, &run] { run = [settings] { return RunTest(*settings); }; });
}

}  // namespace plcxx::driver
