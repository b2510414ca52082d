// What the tests of running scenarios share: a program from text, a dialect that names its places, engines to drive.
#pragma once

#include <gtest/gtest.h>

#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "transpiler/engines/lockstep.h"
#include "transpiler/ir/reader.h"
#include "transpiler/scenarios/plan.h"
#include "transpiler/scenarios/run.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/sim/simulator.h"

namespace plcxx::scenarios {

/// Q0 = I0, Q1 = not kept; messages 1 to 8; a fault when W1 is 3; KEEP asks for retentive storing of T0.
inline constexpr std::string_view kScenarioProgram = R"(
  space M 20 volatile little host_visible
  space T 1 retentive little host_visible
  zone M 0 1 input
  zone M 4 5 input
  place I0 bit M[0].0
  place Q0 bit M[1].0
  place W1 i8 M[2]
  place W2 i16 M[4]
  place DONE i32 M[8]
  place KEEP bit M[12].0
  place MESSAGES i8 M[13]
  place FAST i8 M[14]
  place T0 i8 T[0]
  host now () -> i32 routine_exchange
  host load_all () writes_retentive routine_exchange
  host store_all () reads_retentive
  host fault (kind : i8 = (PARAM_RANGE, LOOP_LIMIT), index : i32)
  routine init init {
    host load_all ()
  }
  routine fast schedule {
    stmt s1
    %f = load FAST
    %one = const i8 1
    %g = add.i8 %f %one
    store FAST %g
  }
  routine period schedule {
    call fast ()
    stmt s2
    %i = load I0
    store Q0 %i
    stmt s3
    %w = load W1
    %three = const i8 3
    %is = eq.i8 %w %three
    if %is {
      %kind = const i8 1
      %index = const i32 20
      host fault (%kind, %index)
    }
    stmt s4
    %done = load DONE
    %wide = const i32 1
    %more = add.i32 %done %wide
    store DONE %more
  }
  message_bits M 13 first 1 count 8
  schedule init init
  schedule period period
  schedule fast_only fast
  schedule slow_done DONE
  schedule now now
  schedule retentive_load load_all
  schedule retentive_store store_all
  schedule retain_at_power_off KEEP
  schedule retention 1
)";

inline std::optional<dialects::Location> LocateByName(const ir::NameIndex& names, std::string_view text) {
  if (text == "OPERATOR_TEXT") return dialects::Location{.place = {}, .text_input = true};
  if (text == "T9U") return dialects::Location{.place = {}, .absent = true};
  if (text == "P3") return dialects::Location{.place = {.name = "P3", .type = ir::Type::kI8}, .cell = 3};
  for (const ir::Place& place : names.program().places) {
    if (place.name == text) return dialects::Location{.place = place};
  }
  return std::nullopt;
}

/// "33H"
inline std::optional<uint64_t> ParseHex(std::string_view text) {
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (error != std::errc() || end + 1 != text.data() + text.size() || *end != 'H') return std::nullopt;
  return value;
}

inline dialects::Dialect TestDialect() {
  dialects::Dialect dialect{};
  dialect.name = "test";
  dialect.locate = LocateByName;
  dialect.parse_value = ParseHex;
  return dialect;
}

/// A simulator under the name of the other engine.
class OtherEngine : public sim::Simulator {
 public:
  using sim::Simulator::Simulator;
  std::string_view name() const override { return "compiled"; }
};

/// A program with its source, so that failures can show statements.
struct ScenarioBench {
  ir::Program program;
  source::SourceManager sources;
  std::unique_ptr<dialects::ControlStub> stub;
  std::optional<ir::Program> other;  // runs in lockstep

  explicit ScenarioBench(std::string_view text = kScenarioProgram) : program(ir::ReadOrDie(text)) {
    const std::string source = "FAST=FAST+1\nQ0=I0  ;; as it is\nfault\n";
    const source::FileId file = sources.AddText("machine.plc", source);
    const source::Offset base = sources.Get(file).base;
    for (ir::Statement& statement : program.statements) {
      if (statement.id == 1) statement.range = {base, base + 11};
      if (statement.id == 2) statement.range = {base + 12, base + 17};
    }
  }

  /// "passed", or the text of the failure or of the scenario's errors.
  std::string Run(const std::string& steps, sim::Trace* trace = nullptr) {
    ScenarioOrErrors read = ParseScenario("s.yaml", "steps:\n" + steps);
    if (const auto* errors = std::get_if<std::vector<ScenarioError>>(&read)) return ToText(errors->front());
    const Scenario& scenario = std::get<Scenario>(read);
    const dialects::Dialect dialect = TestDialect();
    const auto plan = PlanScenario(scenario, dialect, program);
    if (const auto* errors = std::get_if<std::vector<ScenarioError>>(&plan)) {
      std::string text;
      for (const ScenarioError& error : *errors) text += (text.empty() ? "" : "\n") + ToText(error);
      return text;
    }
    auto simulator = std::make_unique<sim::Simulator>(program);
    simulator->RecordLastWrites();
    const sim::LastWrites* writes = simulator->last_writes();
    std::vector<std::unique_ptr<sim::Engine>> engines;
    engines.push_back(std::move(simulator));
    if (other) engines.push_back(std::make_unique<OtherEngine>(*other));
    engines::Lockstep lockstep(program, std::move(engines));
    const std::optional<std::string> failure = RunScenario({.scenario = scenario,
                                                            .plan = std::get<ScenarioPlan>(plan),
                                                            .dialect = dialect,
                                                            .program = program,
                                                            .sources = sources,
                                                            .engines = lockstep,
                                                            .writes = writes,
                                                            .stub = std::move(stub),
                                                            .trace = trace});
    return failure.value_or("passed");
  }
};

/// A text with one passage replaced.
inline std::string Replaced(std::string_view text, std::string_view from, std::string_view to) {
  std::string result(text);
  const size_t at = result.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) result.replace(at, from.size(), to);
  return result;
}

}  // namespace plcxx::scenarios
