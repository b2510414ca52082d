#include "transpiler/scenarios/plan.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>
#include <type_traits>
#include <utility>

#include "transpiler/scenarios/control.h"
#include "transpiler/scenarios/near_location.h"
#include "transpiler/sim/value_text.h"
#include "transpiler/support/listed.h"
#include "transpiler/support/low_bits.h"

namespace plcxx::scenarios {
namespace {

template <class... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};

/// The largest value of an integer type.
uint64_t Largest(ir::Type type) {
  if (type == ir::Type::kBit) return 1;
  return support::LowBits(8 * ir::Bytes(type));
}

std::optional<uint64_t> Digits(std::string_view digits, int base) {
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  if (digits.empty() || error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

std::optional<uint64_t> Truth(std::string_view text) {
  std::string word;
  for (const char c : text) word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (word == "true" || word == "on" || word == "yes") return 1;
  if (word == "false" || word == "off" || word == "no") return 0;
  return std::nullopt;
}

std::optional<uint64_t> Plain(std::string_view text) {
  if (text.starts_with("0x") || text.starts_with("0X")) return Digits(text.substr(2), 16);
  return Digits(text, 10);
}

/// None for a text that is no number, or too large for the type.
template <class Float>
std::optional<Float> Real(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Float value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || text.empty()) return std::nullopt;
  if (error == std::errc()) return value;
  if constexpr (std::is_same_v<Float, float>) {  // too large, or too small: then it is a 0 or nearly
    const std::optional<double> wide = Real<double>(text);
    if (wide && std::abs(*wide) < 1) return static_cast<float>(*wide);
  }
  return std::nullopt;
}

/// The bits of a number, a whole one in other notations included; "nan" is the quiet one without a sign.
template <class Float, class Bits>
std::optional<uint64_t> FloatBits(std::string_view text, const dialects::Dialect& dialect) {
  if (text == "nan" || text == ".nan") return std::bit_cast<Bits>(std::numeric_limits<Float>::quiet_NaN());
  const bool negative = text.starts_with('-');
  const std::string_view magnitude = negative ? text.substr(1) : text;
  std::optional<Float> value;
  if (magnitude == "inf" || magnitude == ".inf") {
    value = std::numeric_limits<Float>::infinity();
  } else if (!magnitude.starts_with('-') && !magnitude.starts_with("inf") && !magnitude.starts_with("nan")) {
    value = Real<Float>(magnitude);
  }
  if (value) return std::bit_cast<Bits>(negative ? -*value : *value);
  const std::optional<uint64_t> whole = dialect.parse_value(text);
  if (!whole) return std::nullopt;
  return std::bit_cast<Bits>(static_cast<Float>(static_cast<int32_t>(*whole)));
}

/// "0 to 255"
std::string RangeText(ir::Type type) {
  return sim::IsFloat(type) ? "a number" : "0 to " + std::to_string(Largest(type));
}

class ScenarioPlanner {
 public:
  ScenarioPlanner(const Scenario& scenario, const dialects::Dialect& dialect, const ir::Program& program)
      : scenario_(scenario), dialect_(dialect), program_(program) {}

  ScenarioPlan Plan() {
    ScenarioPlan plan;
    if (scenario_.plant) {
      BoundOrErrors bound = BindPlant(scenario_.plant, dialect_, program_);
      if (auto* errors = std::get_if<std::vector<ScenarioError>>(&bound)) {
        errors_ = std::move(*errors);
        return plan;
      }
      plan.plant = std::move(std::get<std::shared_ptr<const BoundPlant>>(bound));
      plant_ = plan.plant.get();
    }
    for (const ScenarioStep& step : *scenario_.steps) {
      PlannedStep planned{&step, {}, {}};
      std::visit(
          Overloaded{[&](const SetStep& set) { planned.values = Values(set.assignments, Use::kSet); },
                     [&](const ExpectStep& expect) { planned.values = Values(expect.expectations, Use::kExpect); },
                     [&](const ForceStep& force) { planned.values = Values(force.assignments, Use::kForce); },
                     [&](const ReleaseStep& release) { planned.values = Released(release); },
                     [&](const ExpectCallsStep& expect) { planned.calls = Calls(expect); },
                     [&](const RunStep& run) { CheckRun(run, step.mark); }, [](const ExpectMessagesStep&) {},
                     [](const PowerCycleStep&) {}},
          step.action);
      plan.steps.push_back(std::move(planned));
    }
    return plan;
  }

  std::vector<ScenarioError>& errors() { return errors_; }

 private:
  enum class Use : uint8_t { kSet, kExpect, kForce, kRelease };

  void Fail(ScenarioMark mark, std::string message) { errors_.push_back({scenario_.path, mark, std::move(message)}); }

  /// None when it is no location, or none for this use; reported.
  std::optional<dialects::Location> Locate(const MarkedText& written, Use use) {
    const std::optional<dialects::Location> location = dialect_.locate(names_, written.text);
    if (!location) {
      Fail(written.mark, "'" + written.text + "' is no location of dialect " + std::string(dialect_.name) +
                             WhichLocations(dialect_, program_, written.text));
    } else if (location->text_input && use != Use::kSet) {
      Fail(written.mark, "'" + written.text + "' can only be set: it sends a text");
      return std::nullopt;
    } else if (location->cell && (use == Use::kForce || use == Use::kRelease)) {
      Fail(written.mark, "'" + written.text + "' can only be set and expected: it is no memory of the program");
      return std::nullopt;
    }
    return location;
  }

  std::vector<PlannedValue> Values(const std::vector<Assignment>& assignments, Use use) {
    std::vector<PlannedValue> values;
    for (const Assignment& assignment : assignments) {
      const std::optional<dialects::Location> location = Locate(assignment.location, use);
      if (!location) continue;
      if (use == Use::kSet) CheckIsFree(assignment.location, *location);
      PlannedValue planned{assignment.location, *location, 0, {}};
      if (location->text_input) {
        planned.text = assignment.value.text;
      } else {
        planned.value =
            FittingField(*location, Value(assignment.value, location->place.type, assignment.location.text));
      }
      values.push_back(std::move(planned));
    }
    return values;
  }

  /// What the plant drives would be overwritten in the next period.
  void CheckIsFree(const MarkedText& written, const dialects::Location& location) {
    if (plant_ == nullptr) return;
    const plant::Driven* const driver = plant_->DriverOf(location);
    if (driver == nullptr) return;
    errors_.push_back({scenario_.path, written.mark,
                       "'" + written.text + "' is driven by the plant: " + DriverText(*driver, plant_->model().path()),
                       "let the plant do it, or hold it with 'force'"});
  }

  std::vector<PlannedValue> Released(const ReleaseStep& release) {
    std::vector<PlannedValue> values;
    for (const MarkedText& written : release.locations) {
      if (const auto location = Locate(written, Use::kRelease)) values.push_back({written, *location, 0, {}});
    }
    return values;
  }

  void CheckRun(const RunStep& run, ScenarioMark mark) {
    const uint32_t period_ms = std::max(1u, program_.schedule.period_ms);
    for (const RunPart& part : run.parts) {
      if (!dialect_.whole_periods || part.unit != RunUnit::kMilliseconds || part.count % period_ms == 0) continue;
      Fail(mark, "a run of " + std::to_string(part.count) + " ms: the time is a multiple of the base cycle of " +
                     std::to_string(period_ms) + " ms");
    }
  }

  uint64_t Value(const MarkedText& text, ir::Type type, const std::string& owner) {
    if (const std::optional<uint64_t> value = ParseScenarioValue(text.text, type, dialect_)) return *value;
    Fail(text.mark, WhyNoValue(text.text, type, owner, dialect_));
    return 0;
  }

  std::vector<PlannedCall> Calls(const ExpectCallsStep& expect) {
    std::vector<PlannedCall> calls;
    for (const ExpectedCall& written : expect.calls) {
      PlannedCall call{&written, {}, {}};
      for (uint32_t i = 0; i < program_.host_functions.size(); ++i) {
        if (program_.host_functions[ir::HostFunctionId(i)].name == written.function.text)
          call.function = ir::HostFunctionId(i);
      }
      if (call.function.valid()) {
        for (const Assignment& argument : written.arguments) PlanArgument(argument, call);
      }
      calls.push_back(std::move(call));
    }
    return calls;
  }

  void PlanArgument(const Assignment& written, PlannedCall& call) {
    const ir::HostFunction& function = program_.host_functions[call.function];
    const auto& parameters = function.parameters;
    const auto found = std::find_if(parameters.begin(), parameters.end(), [&](const ir::Parameter& p) {
      return p.name == written.location.text || (p.is_statement && written.location.text == "line");
    });
    if (found == parameters.end()) {
      Fail(written.location.mark,
           "'" + written.location.text + "' is no parameter of '" + function.name + "'" + Names(parameters));
      return;
    }
    PlannedArgument argument{static_cast<uint32_t>(found - parameters.begin()), 0, {}};
    argument.is_line = found->is_statement && written.location.text == "line";
    const auto& names = found->enumerators;
    const auto name = std::find(names.begin(), names.end(), written.value.text);
    if (name != names.end()) {
      argument.value = static_cast<uint64_t>(name - names.begin());
    } else if (!names.empty() && !Plain(written.value.text)) {
      Fail(written.value.mark, "'" + written.value.text + "' is no value of '" + found->name +
                                   "'; there are: " + support::CommaSeparated(names));
    } else {
      argument.value = Value(written.value, found->type, found->name);
    }
    call.arguments.push_back(argument);
  }

  static std::string Names(const std::vector<ir::Parameter>& parameters) {
    std::vector<std::string> names;
    for (const ir::Parameter& parameter : parameters) names.push_back(parameter.name);
    return names.empty() ? ", which has none" : "; there are: " + support::CommaSeparated(names);
  }

  const Scenario& scenario_;
  const dialects::Dialect& dialect_;
  const ir::Program& program_;
  const BoundPlant* plant_ = nullptr;
  const ir::NameIndex names_{program_};
  std::vector<ScenarioError> errors_;
};

}  // namespace

std::optional<uint64_t> ParseScenarioValue(std::string_view text, ir::Type type, const dialects::Dialect& dialect) {
  if (type == ir::Type::kF32) return FloatBits<float, uint32_t>(text, dialect);
  if (type == ir::Type::kF64) return FloatBits<double, uint64_t>(text, dialect);
  if (dialect.values_wrap && type != ir::Type::kI64) {
    const std::optional<uint64_t> value = ParseScenarioValue(text, ir::Type::kI64, dialect);
    if (!value) return std::nullopt;
    return *value & Largest(type);
  }
  // The language's own reading comes first: 010 is 8 in C and 10 elsewhere.
  const auto whole = [&dialect](std::string_view digits) {
    const std::optional<uint64_t> own = dialect.parse_value(digits);
    return own ? own : Plain(digits);
  };
  if (text.starts_with('-')) {
    const std::optional<uint64_t> magnitude = whole(text.substr(1));
    if (!magnitude || type == ir::Type::kBit || *magnitude > Largest(type) / 2 + 1) return std::nullopt;
    return (~*magnitude + 1) & Largest(type);
  }
  std::optional<uint64_t> value = Truth(text);
  if (!value) value = whole(text);
  if (!value || *value > Largest(type)) return std::nullopt;
  return value;
}

std::string WhyNoValue(std::string_view text, ir::Type type, std::string_view owner, const dialects::Dialect& dialect) {
  const std::string range = "'" + std::string(owner) + "' takes " + RangeText(type);
  if (ParseScenarioValue(text, ir::Type::kI64, dialect)) {
    return "value " + std::string(text) + " does not fit: " + range;
  }
  return "'" + std::string(text) + "' is no value: " + range;
}

std::variant<ScenarioPlan, std::vector<ScenarioError>> PlanScenario(const Scenario& scenario,
                                                                    const dialects::Dialect& dialect,
                                                                    const ir::Program& program) {
  ScenarioPlanner planner(scenario, dialect, program);
  ScenarioPlan plan = planner.Plan();
  if (!planner.errors().empty()) return std::move(planner.errors());
  return plan;
}

}  // namespace plcxx::scenarios
