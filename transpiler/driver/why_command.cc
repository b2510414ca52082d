// plcxx why: which conditions make a signal what it is, and whether it can be on at all.
#include "transpiler/driver/why_command.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/driver/accepted_warnings.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/driver/diagnostics_output.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/one_of.h"
#include "transpiler/driver/program_output.h"
#include "transpiler/driver/project_choice.h"
#include "transpiler/driver/scenario_source.h"
#include "transpiler/driver/sim_plan.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/driver/traced_input.h"
#include "transpiler/driver/why_output.h"
#include "transpiler/review/properties/runs.h"
#include "transpiler/scenarios/known_runs.h"
#include "transpiler/scenarios/near_location.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/property_machine.h"
#include "transpiler/scenarios/traced_run.h"
#include "transpiler/scenarios/why.h"
#include "transpiler/sim/read_vcd.h"

namespace plcxx::driver {
namespace {

constexpr const char* kWhyFooter = R"(Examples:
  plcxx why U4A8 --scenario turret.yaml              at the end of the scenario, or where it fails
  plcxx why U4A8 --scenario turret.yaml --step 3     after its third step
  plcxx why U4A8 --scenario turret.yaml --at 1200ms  after the last scan that begins by then
  plcxx why U4A8 --vcd machine.vcd --at 3s           as the machine was when the trace was recorded
  plcxx why U4A8 --can                               can it be on at all? a run that shows it, or a proof that it cannot
  plcxx why U4A8 turret.sym turret.plc --can

The first line has the statement that wrote the signal last; below it are the conditions that make it so, down to inputs,
timers with the time that is left, bits of the control, and what earlier scans left behind. As long as these are what they
are, the signal is what it is, whatever everything else does in that scan. Where one of several conditions would be
enough, one is shown: the one that comes down to fewer inputs.

Of a trace (plcxx sim --vcd, or any logger that writes VCD) the program is run with the inputs that it has, from power-on at
its first time. What else it has is compared: the first moment at which the run is not what the trace says is named for each
signal, for then inputs are missing in it, or the machine had kept something from before.

Exit codes: 0 done, 1 it is not known, the scenario did not get there, or the program has errors, 2 wrong use.)";

constexpr size_t kMaxLines = 60;

struct WhySettings {
  CommonOptions common;
  std::string signal, scenario, waveform, at, form = "text", time = "60s";
  std::optional<uint32_t> step;
  bool can = false;
};

std::optional<dialects::Location> Locate(const WhySettings& settings, const compilation::Compilation& compilation) {
  const std::optional<dialects::Location> location =
      compilation.dialect->locate(ir::NameIndex(compilation.program), settings.signal);
  if (!location) {
    PrintUsageError(scenarios::NoSuchLocation(*compilation.dialect, compilation.program, settings.signal));
    return std::nullopt;
  }
  if (const std::string why = scenarios::CannotBeExplained(compilation, *location); !why.empty()) {
    PrintUsageError("'" + settings.signal + "' cannot be explained: " + why);
    return std::nullopt;
  }
  return location;
}

std::optional<scenarios::Scenario> ReadScenario(const WhySettings& settings) {
  scenarios::ScenarioOrErrors read = scenarios::ReadScenario(
      settings.scenario, settings.common.allow_outside ? scenarios::Reach::kAnywhere : scenarios::Reach::kProject);
  if (const auto* errors = std::get_if<std::vector<scenarios::ScenarioError>>(&read)) {
    for (const scenarios::ScenarioError& error : *errors) std::cerr << ToText(error) << "\n";
    return std::nullopt;
  }
  scenarios::Scenario scenario = std::move(std::get<scenarios::Scenario>(read));
  if (const std::string why = scenarios::WhyNoProgram(scenario, settings.common.sources); !why.empty()) {
    PrintUsageError(why);
    return std::nullopt;
  }
  if (!scenario.steps || scenario.steps->empty()) {
    PrintUsageError(scenario.path + ": no 'steps': nothing runs whose state could be asked about");
    return std::nullopt;
  }
  if (settings.step && (*settings.step == 0 || *settings.step > scenario.steps->size())) {
    PrintUsageError("--step " + std::to_string(*settings.step) + ": " + scenario.path + " has the steps 1 to " +
                    std::to_string(scenario.steps->size()));
    return std::nullopt;
  }
  return scenario;
}

/// None: --at was not given. Wrong words are told, and end the command.
bool TakeTime(const WhySettings& settings, std::optional<uint64_t>& time_ms) {
  if (settings.at.empty()) return true;
  time_ms = ParseDuration(settings.at);
  if (!time_ms) PrintUsageError("'--at " + settings.at + "' is no time: write it as in 1200ms, 3s or 5min");
  return time_ms.has_value();
}

/// A run of a program whose state is asked about.
struct Asked {
  const compilation::Compilation& compilation;
  const scenarios::Scenario& scenario;
  std::optional<uint64_t> time_ms;
  uint64_t origin_ms = 0;                  // what the run's time 0 is for the user
  const TraceComparison* trace = nullptr;  // null: the run is no trace's
};

int Answer(const WhySettings& settings, const Asked& asked, ProgressLine& progress) {
  const std::optional<dialects::Location> location = Locate(settings, asked.compilation);
  if (!location) return kWrongUse;
  auto plan = scenarios::PlanScenario(asked.scenario, *asked.compilation.dialect, asked.compilation.program);
  if (const auto* errors = std::get_if<std::vector<scenarios::ScenarioError>>(&plan)) {
    for (const scenarios::ScenarioError& error : *errors) std::cerr << ToText(error) << "\n";
    return kWrongUse;
  }
  const scenarios::WhyQuestion question{
      .name = settings.signal, .location = *location, .steps = settings.step, .time_ms = asked.time_ms};
  progress.Show("running " + asked.scenario.path);
  scenarios::WhyAnswer answer = scenarios::ExplainInScenario(
      asked.compilation, asked.scenario, std::move(std::get<scenarios::ScenarioPlan>(plan)), question);
  scenarios::ShiftTimes(answer, asked.origin_ms);
  progress.Clear();
  const bool stopped_early = !answer.failure.empty() && (settings.step || asked.time_ms);
  if (settings.form == "json") {
    std::cout << WhyJson(answer, question, asked.compilation, asked.trace);
  } else {
    if (stopped_early) {
      std::cout << "the scenario fails before "
                << (settings.step ? "step " + std::to_string(*settings.step) + " is done" : settings.at)
                << "; the state in which it ends:\n";
    }
    std::cout << diag::EscapedLines(scenarios::WhyText(answer, question, asked.compilation, kMaxLines));
  }
  if (!answer.failure.empty()) std::cerr << diag::EscapedLines(answer.failure) << "\n";
  return answer.refusal.empty() && !stopped_early ? kDone : kProgramHasErrors;
}

int WhyInScenario(const WhySettings& settings) {
  std::optional<scenarios::Scenario> scenario = ReadScenario(settings);
  if (!scenario) return kWrongUse;
  std::optional<uint64_t> time_ms;
  if (!TakeTime(settings, time_ms)) return kWrongUse;
  const std::optional<compilation::CompilationRequest> asked = MakeRequest(settings.common);
  if (!asked) return kWrongUse;
  const std::optional<scenarios::ProgramOverrides> overrides =
      OverridesOf(settings.common.sources, *asked, settings.common);
  if (!overrides) return kWrongUse;
  ProgressLine progress;
  compilation::CompilationRequest request = scenarios::RequestOf(*scenario, *overrides);
  request.progress = [&progress](std::string_view phase) { progress.Show(phase); };
  const compilation::Compilation compilation = compilation::Compile(request);
  progress.Clear();
  if (!compilation.ok()) {
    PrintDiagnosticsBeside(compilation, MessagesOf(settings.common));
    return ExitCodeOf(compilation);
  }
  return Answer(settings, {.compilation = compilation, .scenario = *scenario, .time_ms = time_ms}, progress);
}

int WhyInTrace(const WhySettings& settings) {
  std::optional<uint64_t> time_ms;
  if (!TakeTime(settings, time_ms)) return kWrongUse;
  const std::optional<sim::Vcd> trace = ReadWaveform(settings.waveform);
  if (!trace) return kWrongUse;
  if (time_ms && (*time_ms < trace->first_ms || *time_ms > trace->last_ms)) {
    return UsageError("--at " + settings.at + ": the trace has the times " + std::to_string(trace->first_ms) + " to " +
                      std::to_string(trace->last_ms) + " ms");
  }
  std::optional<compilation::CompilationRequest> request = MakeRequest(settings.common);
  if (!request) return kWrongUse;
  ProgressLine progress;
  request->progress = [&progress](std::string_view phase) { progress.Show(phase); };
  const std::optional<compilation::Compilation> compiled = CompileProgram(settings.common, *request);
  progress.Clear();
  if (!compiled) return kWrongUse;
  if (!compiled->ok()) {
    PrintDiagnosticsBeside(*compiled, MessagesOf(settings.common));
    return ExitCodeOf(*compiled);
  }
  const scenarios::TracedRun run = scenarios::RunOfTrace(*compiled, *trace, settings.waveform);
  TraceComparison compared{.departures = scenarios::Departures(*compiled, *trace, run), .notes = {}};
  compared.notes = TraceNotes(run, compared.departures);
  if (settings.form != "json") PrintTraceNotes(compared.notes);
  return Answer(settings,
                {.compilation = *compiled,
                 .scenario = run.scenario,
                 .time_ms = time_ms.value_or(trace->last_ms) - run.begins_ms,
                 .origin_ms = run.begins_ms,
                 .trace = &compared},
                progress);
}

/// "Never on" as a property: a run that violates it is the answer.
int WhetherItCan(const WhySettings& settings) {
  const std::optional<uint64_t> time_ms = ParseDuration(settings.time);
  if (!time_ms || *time_ms == 0)
    return UsageError("'--time " + settings.time + "' is no time: write it as in 500ms, 60s or 5min");
  std::optional<compilation::CompilationRequest> request = MakeRequest(settings.common);
  if (!request) return kWrongUse;
  if (!settings.scenario.empty()) {
    const std::optional<scenarios::Scenario> scenario = ReadScenario(settings);
    if (!scenario) return kWrongUse;
    const std::optional<scenarios::ProgramOverrides> overrides =
        OverridesOf(settings.common.sources, *request, settings.common);
    if (!overrides) return kWrongUse;
    request = scenarios::RequestOf(*scenario, *overrides);
  }
  ProgressLine progress;
  scenarios::ProveMachine machine;
  scenarios::MakeProveMachine(*request, machine);
  compilation::Compilation& compilation = machine.compilation;
  if (!compilation.ok()) {
    PrintDiagnosticsBeside(compilation, MessagesOf(settings.common));
    return ExitCodeOf(compilation);
  }
  const std::optional<dialects::Location> location = Locate(settings, compilation);
  if (!location) return kWrongUse;
  const bool is_bit = location->place.type == ir::Type::kBit;
  const std::string text = "never '" + settings.signal + "'" + (is_bit ? "" : " != 0") + "\n";
  const prove::properties::Properties parsed = prove::properties::ParseProperties(
      text,
      scenarios::PropertyContextOf(*compilation.dialect, compilation.program, machine.version.cells, machine.timing));
  if (parsed.properties.empty()) return UsageError("'" + settings.signal + "' cannot be proved anything of");
  const prove::properties::Property& property = parsed.properties.front();
  scenarios::NameLocationsOf(property, machine);

  review::properties::PropertyRuns runs(machine, scenarios::KnownRuns(*request));
  CanAnswer answer{.signal = settings.signal, .is_bit = is_bit, .result = {}, .scenario = {}};
  std::vector<review::properties::PropertyScenario> replayed;
  prove::properties::CheckOptions options;
  options.time_ms = *time_ms;
  options.try_runs = [&runs](const prove::properties::RunSearch& search) { return runs.Find(search); };
  options.why_not_shown = [&](const prove::properties::Property& violated,
                              const prove::properties::PropertyResult& result) {
    replayed.push_back(review::properties::MakePropertyScenario(machine, *request, violated, result,
                                                                {.directory = "", .name = "can.yaml"}));
    return replayed.back().reason;
  };
  options.progress = [&progress](const std::string& what) { progress.Show(what); };
  prove::properties::PropertyChecker checker(machine.version, std::move(options));
  if (!checker.refusal().empty()) return UsageError("nothing can be proved: " + checker.refusal());
  answer.result = checker.Check(property);
  if (answer.result.run) answer.scenario = std::move(replayed.at(answer.result.replay));
  progress.Clear();
  std::cout << (settings.form == "json" ? CanJson(answer) : CanText(answer));
  return answer.result.verdict == prove::properties::PropertyVerdict::kUndecided ? kProgramHasErrors : kDone;
}

/// What is wrong where the first word is a file; empty where it is none.
std::string FileForSignal(const WhySettings& settings) {
  const std::filesystem::path path = settings.signal;
  std::error_code error;
  if (!path.has_extension() || !std::filesystem::is_regular_file(path, error)) return {};
  std::string signal = "SIGNAL";
  for (const std::string& source : settings.common.sources) {
    if (!std::filesystem::exists(source, error)) signal = source;
  }
  const std::string form =
      IsScenario(settings.signal) ? " --scenario " + settings.signal : " " + settings.signal + " --can";
  return "'" + settings.signal + "' is a file, and the signal comes first: plcxx why " + signal + form;
}

int RunWhy(const WhySettings& settings) {
  const Result result = settings.form == "json" ? Result::kJson : Result::kUnnamed;
  if (const std::string wrong = FileForSignal(settings); !wrong.empty()) return UsageError(wrong);
  if (!settings.waveform.empty() && (settings.can || settings.step || !settings.scenario.empty())) {
    return UsageError("--vcd names a state by its trace and --at: leave --scenario, --step and --can out");
  }
  if (!settings.waveform.empty()) return RunForPrograms(settings, WhyInTrace, result);
  if (settings.can && (settings.step || !settings.at.empty())) {
    return UsageError("--can asks about all states: leave --step and --at out");
  }
  if (settings.step && !settings.at.empty())
    return UsageError("--step and --at both name a state: leave one of them out");
  if (!settings.can) {
    if (settings.scenario.empty() && IsScenario(settings.common)) {
      return UsageError("why is asked of a state: the run of '" + settings.common.sources.front() +
                        "' is named with --scenario " + settings.common.sources.front());
    }
    if (settings.scenario.empty()) {
      return UsageError(
          "why is asked of a state: name a scenario with --scenario FILE or a trace with --vcd FILE, or ask with --can "
          "whether '" +
          settings.signal + "' can be on at all");
    }
    return WhyInScenario(settings);
  }
  return settings.scenario.empty() ? RunForPrograms(settings, WhetherItCan, result) : WhetherItCan(settings);
}

}  // namespace

void AddWhy(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("why", "Tell which conditions keep a signal off, or on");
  const auto settings = std::make_shared<WhySettings>();
  command->add_option("SIGNAL", settings->signal, "The location: U4A8, a symbol, a word")->type_name("")->required();
  AddCommonOptions(*command, settings->common);
  command->add_option("--scenario", settings->scenario, "The run whose state is asked about")->type_name("FILE");
  command->add_option("--vcd", settings->waveform, "The recorded trace whose state is asked about")->type_name("FILE");
  command->add_option("--step", settings->step, "The state after this step of it; else at its end")
      ->type_name("N")
      ->check(CLI::Range(1L, 1'000'000'000L));
  command->add_option("--at", settings->at, "The state after the last scan that begins by then, as in 1200ms or 3s")
      ->type_name("TIME");
  command->add_flag("--can", settings->can, "Whether it can be on at all: a run that shows it, or a proof");
  command->add_option("--time", settings->time, "Of the proof, as in 500ms, 60s or 5min")
      ->type_name("TIME")
      ->default_str("60s");
  command->add_option("--format", settings->form, "Form of the result: text, json")
      ->type_name("FORM")
      ->default_str("text")
      ->check(OneOf({"text", "json"}));
  command->footer(kWhyFooter);
  command->callback([settings, &run] { run = [settings] { return RunWhy(*settings); }; });
}

}  // namespace plcxx::driver
