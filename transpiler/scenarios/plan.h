// The steps of a scenario with their words resolved against one program: locations, values, host functions.
//
// In: a Scenario and the program it drives. Out: a plan that can be run without looking anything up, or all that is
// wrong with the scenario, before anything runs.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/dialects/dialect.h"
#include "transpiler/ir/program.h"
#include "transpiler/scenarios/bound_plant.h"
#include "transpiler/scenarios/scenario.h"

namespace plcxx::scenarios {

/// A location with the value that is written, forced or expected there. A release has no value.
struct PlannedValue {
  MarkedText written;  // the location as the scenario writes it
  dialects::Location location;
  uint64_t value = 0;
  std::string text;  // for a text input
};

struct PlannedArgument {
  uint32_t index = 0;  // of the function's parameters
  uint64_t value = 0;
  bool is_line = false;  // of the source; the call has the statement that stands there
};

struct PlannedCall {
  const ExpectedCall* written = nullptr;
  ir::HostFunctionId function;  // none: the program has no such function, so that the call cannot happen
  std::vector<PlannedArgument> arguments;
};

struct PlannedStep {
  const ScenarioStep* written = nullptr;
  std::vector<PlannedValue> values;  // of set, expect, force, release
  std::vector<PlannedCall> calls;    // of expect_calls
};

struct ScenarioPlan {
  std::vector<PlannedStep> steps;
  std::shared_ptr<const BoundPlant> plant;  // may be none
};

/// The plan refers to `scenario`, which must have steps and outlive it.
std::variant<ScenarioPlan, std::vector<ScenarioError>> PlanScenario(const Scenario& scenario,
                                                                    const dialects::Dialect& dialect,
                                                                    const ir::Program& program);

/// The bits of a value: a whole number, hexadecimal with 0x, true/on/yes and false/off/no, or the dialect's own
/// spelling. A negative number is the two's complement of `type`. A float is the nearest number of its type, nan, inf
/// or -inf; a dialect's own spelling is a whole number there, of 32 bits with a sign. Where the
/// dialect's values wrap, a whole number is taken modulo 2^width. None when the text is no value or does not fit.
std::optional<uint64_t> ParseScenarioValue(std::string_view text, ir::Type type, const dialects::Dialect& dialect);
/// Of a text for which there is none: "value 7 does not fit: 'U4A0' takes 0 to 1".
std::string WhyNoValue(std::string_view text, ir::Type type, std::string_view owner, const dialects::Dialect& dialect);

}  // namespace plcxx::scenarios
