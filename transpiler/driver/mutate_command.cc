// plcxx mutate: how much do the scenarios notice?
#include "transpiler/driver/mutate_command.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/driver/diagnostics_output.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/mutate_output.h"
#include "transpiler/driver/one_of.h"
#include "transpiler/driver/scenario_choice.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/mutate/mutate.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/scenario.h"

namespace plcxx::driver {
namespace {

constexpr const char* kMutateFooter =
    R"(The program is changed in one place at a time: a contact that is always 0 or always 1, a number that is one more or
less, another operator, an assignment or a call that is left out. With each change the scenarios that execute that
place run in the simulator. A change with which all of them pass is listed: nothing would tell if the program said that.
Some changes make no difference for any input; plcxx diff tells which, of a changed copy of the sources.

Examples:
  plcxx mutate                           the scenarios of plcxx.yaml, in this folder or above
  plcxx mutate scenarios --jobs 8        all *.yaml below a directory
  plcxx mutate turret.yaml --most 200    200 of the changes, spread evenly over the program
  plcxx mutate --least 90                exit code 1 when less than 90 % of the changes are noticed

docs/mutate.md tells more. Exit codes: 0 done, 1 a scenario fails before any change, the program has errors, or less is
noticed than --least says, 2 wrong use.)";

struct MutateSettings {
  CommonOptions common;  // --set and -W
  std::vector<std::string> paths;
  std::string form = "text";
  std::optional<unsigned> least;
  size_t most = 0;
  unsigned jobs = 2;
  unsigned time_limit = 60;
};

/// Scenarios of one program, by scenarios::KeyOf.
struct ProgramScenarios {
  compilation::CompilationRequest request;
  std::vector<scenarios::Scenario> scenarios;
};

/// Those that drive a program, in the order of the paths; none when one cannot be read, which is reported.
std::optional<std::vector<ProgramScenarios>> ReadScenarios(const std::vector<std::string>& paths,
                                                           const MutateSettings& settings) {
  const std::optional<compilation::CompilationRequest> common = MakeRequest(settings.common);
  if (!common) return std::nullopt;
  const scenarios::ProgramOverrides overrides{
      .sources = {}, .program = nullptr, .options = common->options, .warnings = common->warnings};
  const scenarios::Reach reach =
      settings.common.allow_outside ? scenarios::Reach::kAnywhere : scenarios::Reach::kProject;
  std::vector<ProgramScenarios> programs;
  std::map<std::string, size_t> number_of;  // by key
  for (const std::string& path : paths) {
    scenarios::ScenarioOrErrors read = scenarios::ReadScenario(path, reach);
    if (const auto* errors = std::get_if<std::vector<scenarios::ScenarioError>>(&read)) {
      for (const scenarios::ScenarioError& error : *errors) PrintUsageError(yaml::ToText(error));
      return std::nullopt;
    }
    auto& scenario = std::get<scenarios::Scenario>(read);
    if (!scenario.steps || scenario.expect_error) continue;  // nothing is executed
    if (const std::string why = scenarios::WhyNoProgram(scenario, {}); !why.empty()) {
      PrintUsageError(why);
      return std::nullopt;
    }
    compilation::CompilationRequest request = scenarios::RequestOf(scenario, overrides);
    const auto [found, is_new] = number_of.try_emplace(scenarios::KeyOf(request), programs.size());
    if (is_new) programs.push_back({std::move(request), {}});
    programs[found->second].scenarios.push_back(std::move(scenario));
  }
  return programs;
}

/// Of one program; what is found is added to `documents`, or printed.
int MutateProgram(ProgramScenarios& program, const MutateSettings& settings, nlohmann::json& documents) {
  ProgressLine progress;
  compilation::Compilation compilation = compilation::Compile(program.request);
  if (!compilation.ok()) {
    PrintDiagnosticsBeside(compilation, MessagesOf(settings.common));
    return ExitCodeOf(compilation);
  }
  const size_t scenarios = program.scenarios.size();
  const auto outcome =
      mutate::Mutate({.compilation = compilation,
                      .scenarios = std::move(program.scenarios),
                      .most = settings.most,
                      .jobs = settings.jobs,
                      .time_limit = settings.time_limit,
                      .progress = [&progress](size_t done, size_t all) {
                        progress.Show("changes: " + std::to_string(done) + " of " + std::to_string(all));
                      }});
  progress.Clear();
  if (const auto* failing = std::get_if<std::vector<mutate::FailsBefore>>(&outcome)) {
    for (const mutate::FailsBefore& one : *failing) {
      std::cerr << diag::EscapedLines(one.path + " fails before anything is changed; repair it first:\n" + one.text)
                << "\n";
    }
    return kProgramHasErrors;
  }
  const auto& mutated = std::get<mutate::Mutated>(outcome);
  if (settings.form == "json") {
    documents.push_back(MutateJson(mutated, compilation, scenarios));
  } else {
    std::cout << MutateText(mutated, compilation, scenarios) << std::flush;
  }
  if (!settings.least) return kDone;
  const size_t noticed = CountOf(mutated, mutate::Outcome::kNoticed);
  return noticed * kPercent < *settings.least * mutated.results.size() ? kProgramHasErrors : kDone;
}

int RunMutate(MutateSettings settings) {
  const std::optional<ChosenScenarios> chosen = ChooseScenarios(settings.common, settings.paths);
  if (!chosen) return kWrongUse;
  std::optional<std::vector<ProgramScenarios>> programs = ReadScenarios(chosen->paths, settings);
  if (!programs) return kWrongUse;
  if (programs->empty())
    return UsageError("none of the scenarios runs a program: there is nothing that could notice a change");
  nlohmann::json documents = nlohmann::json::array();
  int code = kDone;
  for (ProgramScenarios& program : *programs) {
    code = std::max(code, MutateProgram(program, settings, documents));
  }
  if (settings.form == "json") std::cout << documents.dump(2) << "\n";
  return code;
}

}  // namespace

void AddMutate(CLI::App& app, Run& run) {
  CLI::App* command =
      app.add_subcommand("mutate", "Change the program in one place at a time; which scenario notices?");
  const auto settings = std::make_shared<MutateSettings>();
  command
      ->add_option("SCENARIO", settings->paths,
                   "Scenario files, or directories: all *.yaml in them. None: those of plcxx.yaml")
      ->type_name("");
  command->add_option("--least", settings->least, "Percent of the changes that are to be noticed, else exit code 1")
      ->type_name("PERCENT")
      ->check(CLI::Range(0U, kPercent));
  command->add_option("--most", settings->most, "Changes that are tried, spread evenly over the program; 0: all")
      ->type_name("N")
      ->default_str("0")
      ->check(CLI::Range(0L, 1'000'000'000L));
  command->add_option("-j,--jobs", settings->jobs, "Processes at a time, each with a share of the changes")
      ->type_name("N")
      ->default_str("2")
      ->check(CLI::Range(1, 64));
  command
      ->add_option("--time-limit", settings->time_limit,
                   "Of real time, at most, for the scenarios of one change (60). What needs more is noticed")
      ->type_name("SECONDS")
      ->check(CLI::Range(1U, 86'400U));
  command->add_option("--format", settings->form, "Form of the result: text, json")
      ->type_name("FORM")
      ->default_str("text")
      ->check(OneOf({"text", "json"}));
  AddSettings(*command, settings->common);
  AddProjectOptions(*command, settings->common);
  command->footer(kMutateFooter);
  command->callback([settings, &run] { run = [settings] { return RunMutate(*settings); }; });
}

}  // namespace plcxx::driver
