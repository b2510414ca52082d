#include "tests/reference/runs.h"

#include <fstream>
#include <memory>
#include <utility>
#include <variant>

#include "tests/reference/capricious_control.h"
#include "tests/reference/reference_engine.h"
#include "transpiler/compilation/compilation.h"
#include "transpiler/diagnostics/render.h"
#include "transpiler/engines/lockstep.h"
#include "transpiler/scenarios/plan.h"
#include "transpiler/scenarios/run.h"
#include "transpiler/sim/simulator.h"

namespace plcxx::reference {
namespace {

/// Counts the values that are compared: all that the reference knows, after each piece of execution.
class CountingEngine : public ReferenceEngine {
 public:
  CountingEngine(const ir::Program& program, sim::Simulator& beside, const Make& make, uint64_t& count)
      : ReferenceEngine(program, beside, make), count_(count) {}
  std::vector<uint8_t> Snapshot() override {
    count_ += compared();
    return ReferenceEngine::Snapshot();
  }

 private:
  uint64_t& count_;
};

class RecordingSimulator : public sim::Simulator {
 public:
  RecordingSimulator(const ir::Program& program, std::vector<uint64_t>& trace) : Simulator(program), trace_(trace) {
    for (const ir::Space& space : program.spaces) seen_ += space.host_visible ? space.bytes : 0;
  }
  std::vector<uint8_t> Snapshot() override {
    std::vector<uint8_t> bytes = Simulator::Snapshot();
    uint64_t hash = 14695981039346656037U;
    for (size_t i = 0; i < seen_; ++i) hash = (hash ^ bytes[i]) * 1099511628211U;
    trace_.push_back(hash);
    return bytes;
  }

 private:
  std::vector<uint64_t>& trace_;
  size_t seen_ = 0;  // the first bytes of a snapshot
};

std::string Joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// The control that the scenario meets; none where the dialect has none.
std::unique_ptr<dialects::ControlStub> ControlOf(const scenarios::Scenario& scenario,
                                                 const compilation::Compilation& compilation) {
  std::unique_ptr<dialects::ControlStub> control;
  if (compilation.dialect->make_stub != nullptr)
    control = compilation.dialect->make_stub(compilation.program, compilation.options);
  const std::optional<uint64_t> seed = CapriciousSeed(scenario.path);
  return seed ? MakeCapricious(compilation.program, *seed, std::move(control)) : std::move(control);
}

}  // namespace

RunResult RunBeside(const scenarios::Scenario& scenario, compilation::Compilation& compilation,
                    const ReferenceDialect& dialect) {
  RunResult result;
  if (!scenario.steps || !compilation.ok()) return {Outcome::kNothingToRun, {}, 0};
  const auto plan = scenarios::PlanScenario(scenario, *compilation.dialect, compilation.program);
  if (const auto* errors = std::get_if<std::vector<scenarios::ScenarioError>>(&plan)) {
    return {Outcome::kNothingToRun, yaml::ToText(errors->front()), 0};
  }
  diag::Engine said_before;
  dialects::Request request = compilation.MakeRequest();
  request.diagnostics = &said_before;
  auto simulator = std::make_unique<sim::Simulator>(compilation.program);
  auto reference = std::make_unique<CountingEngine>(
      compilation.program, *simulator, [&](HostCalls host) { return dialect.make(request, std::move(host)); },
      result.compared);
  const ReferenceEngine& beside = *reference;
  if (!beside.reference().unsupported().empty()) {
    return {Outcome::kUnsupported, scenario.path + ": " + Joined(beside.reference().unsupported()), 0};
  }
  std::vector<std::unique_ptr<sim::Engine>> engines;
  engines.push_back(std::move(simulator));
  engines.push_back(std::move(reference));
  engines::Lockstep lockstep(compilation.program, std::move(engines));
  const std::optional<std::string> failure = scenarios::RunScenario({.scenario = scenario,
                                                                     .plan = std::get<scenarios::ScenarioPlan>(plan),
                                                                     .dialect = *compilation.dialect,
                                                                     .program = compilation.program,
                                                                     .sources = *compilation.sources,
                                                                     .engines = lockstep,
                                                                     .writes = nullptr,
                                                                     .stub = ControlOf(scenario, compilation)});
  if (failure) return {Outcome::kDisagrees, *failure, result.compared};
  if (!beside.reference().unsupported().empty()) {  // met while it ran
    return {Outcome::kUnsupported, scenario.path + ": " + Joined(beside.reference().unsupported()), 0};
  }
  if (!beside.mismatches().empty()) {
    return {Outcome::kDisagrees, scenario.path + ": not in both: " + Joined(beside.mismatches()), result.compared};
  }
  return result;
}

std::vector<uint64_t> TraceOf(const scenarios::Scenario& scenario, compilation::Compilation& compilation) {
  const auto plan = scenarios::PlanScenario(scenario, *compilation.dialect, compilation.program);
  if (!std::holds_alternative<scenarios::ScenarioPlan>(plan)) return {};
  std::vector<uint64_t> trace;
  std::vector<std::unique_ptr<sim::Engine>> engines;
  engines.push_back(std::make_unique<sim::Simulator>(compilation.program));
  engines.push_back(std::make_unique<RecordingSimulator>(compilation.program, trace));
  engines::Lockstep lockstep(compilation.program, std::move(engines));
  scenarios::RunScenario({.scenario = scenario,
                          .plan = std::get<scenarios::ScenarioPlan>(plan),
                          .dialect = *compilation.dialect,
                          .program = compilation.program,
                          .sources = *compilation.sources,
                          .engines = lockstep,
                          .writes = nullptr,
                          .stub = ControlOf(scenario, compilation)});
  return trace;
}

scenarios::ScenarioOrErrors WriteRandom(const RandomProgram& program, const ReferenceDialect& dialect,
                                        const std::string& directory) {
  std::string scenario_text;
  for (const RenderedFile& file : Render(program, std::string(dialect.name))) {
    std::ofstream(directory + "/" + file.name, std::ios::binary) << file.text;
    scenario_text = file.text;
  }
  return scenarios::ParseScenario(directory + "/scenario.yaml", scenario_text);
}

RunResult RunRandom(const RandomProgram& program, const ReferenceDialect& dialect, const std::string& directory) {
  const scenarios::ScenarioOrErrors read = WriteRandom(program, dialect, directory);
  if (const auto* errors = std::get_if<std::vector<scenarios::ScenarioError>>(&read)) {
    return {Outcome::kNothingToRun, yaml::ToText(errors->front()), 0};
  }
  const auto& scenario = std::get<scenarios::Scenario>(read);
  compilation::Compilation compilation = compilation::Compile(scenarios::RequestOf(scenario, {}));
  if (!compilation.ok()) {
    std::vector<diag::Diagnostic> errors;
    for (const diag::Diagnostic& diagnostic : compilation.diagnostics.all()) {
      if (diagnostic.severity == diag::Severity::kError) errors.push_back(diagnostic);
    }
    return {Outcome::kNothingToRun, diag::RenderText(*compilation.sources, errors, {}), 0};
  }
  return RunBeside(scenario, compilation, dialect);
}

}  // namespace plcxx::reference
