// plcxx sim: runs a program in the simulator and shows what happens.
#include <iostream>
#include <memory>
#include <string>
#include <variant>

#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/driver/accepted_warnings.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/output_files.h"
#include "transpiler/driver/plant_choice.h"
#include "transpiler/driver/program_output.h"
#include "transpiler/driver/project_choice.h"
#include "transpiler/driver/sim_plan.h"
#include "transpiler/driver/sim_run.h"
#include "transpiler/driver/simulated_control.h"
#include "transpiler/driver/terminal.h"

namespace plcxx::driver {
namespace {

constexpr const char* kSimFooter = R"(Examples:
  plcxx sim turret.sym turret.plc --watch U4A8,W2K2
      one second of the machine, a row for each scan
  plcxx sim turret.plc --for 3s --at 100ms:I0A3=1 --at 2s:I0A3=0 --watch I0A3,U4A8 --changes
      press and release a button; rows where something changed
  plcxx sim turret.plc --watch T5D,T5U --trigger rising:U4A8 --delay 20ms --sampling 50ms --samples 20
      a graph that begins with the rising edge of a signal
  plcxx sim turret.plc --force U4A8=1 --disconnect-lines 12,20 --vcd turret.vcd

Times are written 100ms, 3s or 2min; values as in the source or as in C++ (0x12). The control itself answers as the
simulated one does unless --set nc-stub=off.
plcxx emit --help lists what --set takes.
Exit codes: 0 done, 1 the program has errors or the time limit was reached, 2 wrong use, 3 a fault of plcxx.)";

struct SimSettings {
  CommonOptions common;
  SimWords words;
  bool changes = false;
  std::string waveform, plant;
  uint32_t time_limit = 60;
};

/// What is wrong where --at sets what the plant would write again; empty: nothing.
std::string SetOfDriven(const SimPlan& plan, const scenarios::BoundPlant* plant) {
  if (plant == nullptr) return {};
  for (const SimValue& value : plan.at) {
    if (value.location.text_input) continue;
    if (const plant::Driven* const driver = plant->DriverOf(value.location)) {
      return "--at " + value.written + ": the plant drives it, " +
             scenarios::DriverText(*driver, plant->model().path()) +
             "; hold it with --force, or leave the plant out with --plant none";
    }
  }
  return {};
}

void PrintOutcome(const SimSettings& settings, const SimPlan& plan, const SimOutcome& outcome) {
  std::cerr << "ran " << outcome.periods << " periods, " << outcome.time_ms << " ms simulated, " << outcome.slow_cycles
            << " slow cycles\n";
  if (settings.words.watch.empty() && settings.words.trigger.empty())
    std::cerr << "--watch NAME,NAME... shows what happened meanwhile; plcxx report --print-symbols lists the names\n";
  if (plan.graph && outcome.graph == sim::Graph::Phase::kArmed) {
    std::cerr << "plcxx: the trigger '" << settings.words.trigger << "' did not come\n";
  }
  const uint64_t last_scan_ms = outcome.periods == 0 ? 0 : outcome.time_ms - outcome.time_ms / outcome.periods;
  for (const SimValue& value : plan.at) {
    if (!outcome.out_of_time && value.time_ms > last_scan_ms)
      std::cerr << "plcxx: note: '--at " << diag::Escaped(value.written) << "' did not come: it is after the end\n";
  }
  if (outcome.out_of_time) {
    PrintUsageError("stopped after " + std::to_string(settings.time_limit) + " s of real time; see --time-limit");
  }
}

int RunSim(const SimSettings& settings) {
  std::optional<compilation::CompilationRequest> request = MakeRequest(settings.common);
  if (!request) return kWrongUse;
  ProgressLine progress;
  request->progress = [&progress](std::string_view phase) { progress.Show(phase); };
  const std::optional<compilation::Compilation> compiled = CompileProgram(settings.common, *request);
  if (!compiled) return kWrongUse;
  const compilation::Compilation& compilation = *compiled;
  progress.Clear();
  PrintDiagnosticsBeside(compilation, MessagesOf(settings.common));
  if (!compilation.ok()) return ExitCodeOf(compilation);

  if (!settings.waveform.empty() && settings.words.watch.empty()) {
    return UsageError("--vcd needs locations to --watch");
  }
  if (!CanBeWritten({settings.waveform})) return kWrongUse;
  const auto planned = PlanSimulation(settings.words, compilation);
  if (const auto* problem = std::get_if<std::string>(&planned)) {
    return UsageError(*problem);
  }
  const SimPlan& plan = std::get<SimPlan>(planned);
  const auto plant = ChoosePlant(settings.plant, settings.common, compilation);
  if (!plant) return kWrongUse;
  if (const std::string driven = SetOfDriven(plan, plant->get()); !driven.empty()) {
    return UsageError(driven);
  }

  std::map<std::string, std::string> options = compilation.options;
  if (HasStub(*compilation.dialect)) options.emplace(kStubOption, "on");  // off only on request
  SimRunOptions run_options;
  run_options.rows = settings.changes ? Rows::kChangesOnly : Rows::kEveryScan;
  run_options.with_trace = !settings.waveform.empty();
  run_options.seconds = settings.time_limit;
  run_options.plant = *plant;
  const SimOutcome outcome = RunSimulation(compilation, plan, run_options,
                                           compilation.dialect->make_stub(compilation.program, options), std::cout);
  std::cout.flush();
  if (!settings.waveform.empty()) {
    OutputRequest output{
        {}, {{settings.waveform, sim::WriteVcd(outcome.trace, compilation.name)}}, {}, {settings.waveform}};
    output.protected_paths = PathsRead(compilation, settings.common);
    if (*plant) output.protected_paths.push_back((*plant)->model().path());
    if (const auto failure = WriteWithFolders(output)) {
      return CannotWrite(*failure);
    }
  }
  PrintOutcome(settings, plan, outcome);
  return outcome.out_of_time ? kProgramHasErrors : kDone;
}

void AddStimulus(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                 const std::string& placeholder, const std::string& meaning) {
  command.add_option(name, values, meaning)
      ->type_name(placeholder)
      ->allow_extra_args(false)
      ->take_all()
      ->group("Simulation");
}

}  // namespace

void AddSim(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("sim", "Run the program in the simulator and watch it");
  const auto settings = std::make_shared<SimSettings>();
  AddCommonOptions(*command, settings->common);
  SimWords& words = settings->words;
  const auto add = [command](const std::string& name, auto& value, const std::string& placeholder,
                             const std::string& meaning) {
    return command->add_option(name, value, meaning)->type_name(placeholder)->group("Simulation");
  };
  CLI::Option* duration = add("--for", words.duration, "TIME", "Simulated time; 1s if nothing is said");
  add("--cycles", words.cycles, "N", "Instead: until N slow cycles have been completed")
      ->check(CLI::Range(1l, 1'000'000l))
      ->excludes(duration);
  AddStimulus(*command, "--watch", words.watch, "LOC,...", "What to show, up to 16 locations");
  command->add_flag("--changes", settings->changes, "Only rows in which a watched location changed")
      ->group("Simulation");
  AddStimulus(*command, "--at", words.at, "TIME:LOC=VALUE", "Write a location as machine or control would");
  AddStimulus(*command, "--force", words.force, "LOC=VALUE", "Hold a location against every writer");
  AddStimulus(*command, "--disconnect-lines", words.disconnect, "LINES",
              "Switch statements off: 12, or 12,20, or FILE:12,20, or '*'");
  add("--plant", settings->plant, "FILE",
      "What the machine does around the program; else that of plcxx.yaml or the scenario, 'none': nothing");
  add("--trigger", words.trigger, "EDGE:LOC", "Graph instead of table, begun by rising:LOC or falling:LOC");
  add("--delay", words.delay, "TIME", "Of the graph's first sample behind the edge");
  add("--sampling", words.sampling, "TIME", "Between two samples of the graph; else every period");
  add("--samples", words.samples, "N", "The graph is complete after N samples")->check(CLI::Range(1L, 1'000'000'000L));
  add("--vcd", settings->waveform, "FILE", "Write the watched locations as a waveform");
  add("--time-limit", settings->time_limit, "SECONDS", "Of real time, at most (60)")->check(CLI::Range(1u, 86'400u));
  command->footer(kSimFooter);
  command->callback(
      [settings, &run] { run = [settings] { return RunForPrograms(*settings, RunSim, Result::kUnnamed); }; });
}

}  // namespace plcxx::driver
