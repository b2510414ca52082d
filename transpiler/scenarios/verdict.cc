// One scenario from its program to its verdict.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "transpiler/diagnostics/render.h"
#include "transpiler/engines/compiled_engine.h"
#include "transpiler/engines/lockstep.h"
#include "transpiler/fleet/fleet_engine.h"
#include "transpiler/scenarios/control.h"
#include "transpiler/scenarios/expected_diagnostics.h"
#include "transpiler/scenarios/plan.h"
#include "transpiler/scenarios/property_machine.h"
#include "transpiler/scenarios/property_monitor.h"
#include "transpiler/scenarios/property_places.h"
#include "transpiler/scenarios/run.h"
#include "transpiler/scenarios/suite.h"
#include "transpiler/scenarios/why.h"
#include "transpiler/sim/simulator.h"
#include "transpiler/sim/trace.h"
#include "transpiler/support/fnv1a.h"
#include "transpiler/support/read_file.h"

namespace plcxx::scenarios {
namespace {

using Failure = std::optional<std::string>;

/// The first run of a scenario is as fast as can be: the compiled engines may be some periods behind the simulator, and
/// nobody notes who wrote what, which takes several times as long as the run. Where there is something to be told it is
/// run once more, so that the message and the waveform end where the engines part, and say why.
enum class Attempt : uint8_t { kFirst, kToTell };

struct Engines {
  std::unique_ptr<engines::Lockstep> lockstep;
  const sim::LastWrites* writes = nullptr;
  const sim::Simulator* observed = nullptr;
};

class Test {
 public:
  Test(const Scenario& scenario, const SuiteOptions& options, ScenarioProgram& program)
      : scenario_(scenario), options_(options), program_(program) {
    result_.test = {scenario.path, scenario.directory, TestOutcome::kPassed, {}};
  }

  ScenarioResult Run() {
    std::string no_program = WhyNoProgram(scenario_, options_.programs.sources);
    if (!no_program.empty()) return End(TestOutcome::kUnusable, std::move(no_program));
    const compilation::Compilation& compilation = program_.Compiled();
    if (compilation.wrong_use && !scenario_.expect_error) {  // its options, its dialect
      return End(TestOutcome::kUnusable,
                 WithDiagnostics(scenario_.path + ": the program cannot be compiled as asked for", compilation));
    }
    if (const Failure failure = CheckCompilation(compilation)) return End(TestOutcome::kFailed, *failure);
    if (!scenario_.steps) return std::move(result_);
    const auto plan = PlanScenario(scenario_, *compilation.dialect, compilation.program);
    if (const auto* errors = std::get_if<std::vector<ScenarioError>>(&plan)) {
      return End(TestOutcome::kUnusable, ToText(*errors));
    }
    std::vector<ScenarioError> errors;
    monitor_ = MonitorOf(scenario_, compilation, errors);
    if (!errors.empty()) return End(TestOutcome::kUnusable, ToText(errors));
    Failure failure;
    try {
      failure = RunSteps(compilation, std::get<ScenarioPlan>(plan));
    } catch (const engines::EngineFault& fault) {
      failure = scenario_.path + ": " + fault.message;
    }
    if (failure) return End(TestOutcome::kFailed, *failure);
    return std::move(result_);
  }

 private:
  static std::string ToText(const std::vector<ScenarioError>& errors) {
    std::string text;
    for (const ScenarioError& error : errors) text += (text.empty() ? "" : "\n") + yaml::ToText(error);
    return text;
  }

  ScenarioResult End(TestOutcome outcome, std::string text) {
    result_.test.outcome = outcome;
    result_.test.text = std::move(text);
    return std::move(result_);
  }

  Failure CheckCompilation(const compilation::Compilation& compilation) {
    const diag::Engine& diagnostics = compilation.diagnostics;
    const source::SourceManager& sources = *compilation.sources;
    Failure failure;
    if (scenario_.expect_error) {
      failure = CheckExpectedError(scenario_, diagnostics, sources);
    } else if (!compilation.ok()) {
      failure = scenario_.path + ": the program has errors";
    }
    if (!failure && scenario_.warnings) failure = CheckExpectedWarnings(scenario_, diagnostics, sources);
    if (failure) failure = WithDiagnostics(*failure, compilation);
    return failure;
  }

  static std::string WithDiagnostics(std::string text, const compilation::Compilation& compilation) {
    const diag::Engine& diagnostics = compilation.diagnostics;
    if (!diagnostics.all().empty()) text += "\n" + diag::RenderText(*compilation.sources, diagnostics.all(), {});
    while (text.ends_with('\n')) text.pop_back();
    return text;
  }

  /// Whether a call is one of the regular exchange cannot be told by the generated code where only the call says so.
  static bool NeedsSimulator(const ir::Program& program) {
    return std::any_of(program.calls.begin(), program.calls.end(), [&](const ir::Call& call) {
      return call.exchange && call.host.valid() && !program.host_functions[call.host].routine_exchange;
    });
  }

  /// The engines that were asked for, or why there are none.
  std::variant<Engines, std::string> MakeEngines(const compilation::Compilation& compilation, Attempt attempt) {
    Engines made;
    std::vector<std::unique_ptr<sim::Engine>> engines;
    if (options_.simulator || NeedsSimulator(compilation.program)) {
      auto simulator = std::make_unique<sim::Simulator>(compilation.program);
      if (options_.explains && attempt == Attempt::kToTell) {
        simulator->RecordLastWrites();
        made.writes = simulator->last_writes();
      }
      if (Observation* const seen = options_.observation; seen != nullptr) {
        seen->given.assign(compilation.program.insts.size(), 0);
        simulator->NoteGiven(seen->given);
        simulator->StopWhen([seen, one = simulator.get()] { return one->executed() > seen->most; });
        made.observed = simulator.get();
      }
      engines.push_back(std::move(simulator));
    }
    for (const PlatformUse& use : options_.platforms) {
      if (!RunsOn(use.one_in, scenario_)) continue;
      auto built = program_.On(use.platform, FlavourFor(scenario_));
      if (const auto* failure = std::get_if<engines::CompileFailure>(&built)) return failure->message;
      auto started = engines::StartCompiled(std::get<std::shared_ptr<engines::CompiledProgram>>(built));
      if (const auto* failure = std::get_if<engines::CompileFailure>(&started)) return failure->message;
      engines.push_back(std::move(std::get<std::unique_ptr<sim::Engine>>(started)));
    }
    if (options_.fleet && RunsOn(options_.fleet->one_in, scenario_)) {
      fleet::LibraryRequest request = options_.fleet->library;
      request.forces = FlavourFor(scenario_) == emit::Flavour::kDebug;
      const fleet::LibraryOrFailure built = program_.AsFleet(request);
      if (const auto* failure = std::get_if<std::string>(&built)) return "engine 'fleet': " + *failure;
      engines.push_back(fleet::StartFleet(std::get<std::shared_ptr<const fleet::Library>>(built)));
    }
    if (engines.empty()) engines.push_back(std::make_unique<sim::Simulator>(compilation.program));
    made.lockstep = std::make_unique<engines::Lockstep>(compilation.program, std::move(engines));
    return made;
  }

  Failure RunSteps(const compilation::Compilation& compilation, const ScenarioPlan& plan) {
    bool went_on = false;
    Failure failure = RunSteps(compilation, plan, Attempt::kFirst, went_on);
    const bool has_more_to_tell = failure && options_.explains;
    if (!went_on && !has_more_to_tell) return failure;
    if (monitor_) monitor_->GoOn();
    return RunSteps(compilation, plan, Attempt::kToTell, went_on);
  }

  Failure RunSteps(const compilation::Compilation& compilation, const ScenarioPlan& plan, Attempt attempt,
                   bool& went_on) {
    auto made = MakeEngines(compilation, attempt);
    if (const auto* why = std::get_if<std::string>(&made)) return scenario_.path + ": " + *why;
    Engines& engines = std::get<Engines>(made);
    if (attempt == Attempt::kFirst) engines.lockstep->FollowLater();
    result_.ran = std::to_string(plan.steps.size()) + (plan.steps.size() == 1 ? " step in " : " steps in ");
    for (const auto& engine : engines.lockstep->engines()) {
      result_.ran += (result_.ran.back() == ' ' ? "" : " and ") + std::string(engine->name());
    }
    sim::Trace trace(WatchedLocations(plan, compilation.program));
    std::vector<const PlannedValue*> unmet;
    Failure failure = RunScenario({.scenario = scenario_,
                                   .plan = plan,
                                   .dialect = *compilation.dialect,
                                   .program = compilation.program,
                                   .sources = *compilation.sources,
                                   .engines = *engines.lockstep,
                                   .writes = engines.writes,
                                   .stub = StubOf(compilation),
                                   .trace = options_.waveform ? &trace : nullptr,
                                   .monitor = monitor_.get(),
                                   .unmet = &unmet});
    went_on = engines.lockstep->went_on();
    if (went_on) return failure;
    if (engines.observed != nullptr) {
      options_.observation->executed = engines.observed->executed();
      options_.observation->stopped = engines.observed->stopped();
    }
    if (failure && engines.writes != nullptr) *failure += WhyOf(compilation, plan, unmet);
    if (options_.waveform) result_.waveform = sim::WriteVcd(trace, compilation.program.name);
    return failure;
  }

  /// Why the first bit that is not what was expected is what it is, in a few lines.
  std::string WhyOf(const compilation::Compilation& compilation, const ScenarioPlan& plan,
                    const std::vector<const PlannedValue*>& unmet) const {
    constexpr size_t kMaxLines = 6;
    for (const PlannedValue* value : unmet) {
      const dialects::Location& location = value->location;
      if (location.place.type != ir::Type::kBit || !CannotBeExplained(compilation, location).empty()) continue;
      const auto step = std::ranges::find_if(plan.steps, [value](const PlannedStep& one) {
        return !one.values.empty() && value >= &one.values.front() && value <= &one.values.back();
      });
      const WhyQuestion question{.name = value->written.text,
                                 .location = location,
                                 .steps = static_cast<uint32_t>(step - plan.steps.begin()),
                                 .time_ms = {}};
      const WhyAnswer answer = ExplainInScenario(compilation, scenario_, plan, question);
      if (!answer.refusal.empty() || answer.conditions.empty() || answer.conditions.front().because.empty()) return {};
      std::string text = "\n  why:";
      std::istringstream lines(WhyText(answer, question, compilation, kMaxLines));
      for (std::string line; std::getline(lines, line);) text += "\n    " + line;
      return text;
    }
    return {};
  }

  const Scenario& scenario_;
  const SuiteOptions& options_;
  ScenarioProgram& program_;
  std::unique_ptr<PropertyMonitor> monitor_;
  ScenarioResult result_;
};

}  // namespace

std::unique_ptr<PropertyMonitor> MonitorOf(const Scenario& scenario, const compilation::Compilation& compilation,
                                           std::vector<ScenarioError>& errors) {
  if (scenario.properties.empty()) return nullptr;
  const ir::Program& program = compilation.program;
  const execute::Cells cells = execute::MakeCells(program);
  const dialects::Dialect& dialect = *compilation.dialect;
  return std::make_unique<PropertyMonitor>(
      program, cells,
      WatchedProperties(scenario, dialect.name, PropertyContextOf(dialect, program, cells, TimingOf(program)), errors));
}

bool RunsOn(uint32_t one_in, const Scenario& scenario) {
  if (one_in == 1) return true;
  return support::HashOf32(support::ReadFile(scenario.path).value_or("")) % one_in == 0;
}

ScenarioResult TestScenario(const Scenario& scenario, const SuiteOptions& options, ScenarioProgram& program) {
  return Test(scenario, options, program).Run();
}

}  // namespace plcxx::scenarios
