#include "transpiler/driver/why_output.h"

#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>

#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/support/check.h"
#include "transpiler/support/counted.h"

namespace plcxx::driver {
namespace {

using Json = nlohmann::ordered_json;
using explanation::Condition;
using explanation::ConditionKind;
using prove::properties::PropertyVerdict;

std::string Dump(const Json& json) {
  return diag::JsonForTerminals(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

std::string_view NameOfKind(ConditionKind kind) {
  switch (kind) {
    case ConditionKind::kWritten:
      return "written";
    case ConditionKind::kInput:
      return "input";
    case ConditionKind::kKept:
      return "kept";
    case ConditionKind::kState:
      return "state";
    case ConditionKind::kForced:
      return "forced";
    case ConditionKind::kAnswer:
      return "answer";
  }
  PLCXX_UNREACHABLE();
}

void AddStatement(ir::StatementId statement, const compilation::Compilation& compilation, Json& json) {
  if (!statement.valid()) return;
  const source::Range range = compilation.program.statements[statement].range;
  if (range == source::Range{} || compilation.sources->size() == 0) return;
  const source::Position position = compilation.sources->Locate(range.begin);
  json["statement"] = {{"file", compilation.sources->Get(position.file).path},
                       {"line", position.line},
                       {"column", position.column},
                       {"text", compilation.sources->Text(range)}};
}

Json JsonOf(const Condition& condition, const compilation::Compilation& compilation) {
  Json json;
  json["signal"] = condition.label;
  json["name"] = condition.name;
  json["value"] = condition.text;
  json["kind"] = NameOfKind(condition.kind);
  json["origin"] = scenarios::OriginText(condition, compilation.program, *compilation.sources);
  ir::StatementId statement = condition.statement;
  if (condition.last_write) {
    json["sinceMs"] = condition.last_write->first_ms;
    if (!statement.valid()) statement = condition.last_write->statement;
  }
  AddStatement(statement, compilation, json);
  json["because"] = condition.because;
  return json;
}

/// The run alone, and that the signal is on after it: as a property it was written to fail.
std::string RunOf(const CanAnswer& answer) {
  std::istringstream lines(answer.scenario.yaml);
  std::string run, line;
  bool in_properties = false;
  while (std::getline(lines, line)) {
    in_properties =
        line.starts_with("properties:") || (in_properties && (line.starts_with("-") || line.starts_with(" ")));
    if (in_properties || line.starts_with("#")) continue;
    run += line + "\n";
  }
  if (answer.is_bit) run += "- expect: {\"" + answer.signal + "\": 1}\n";
  return run;
}

}  // namespace

std::string WhyJson(const scenarios::WhyAnswer& answer, const scenarios::WhyQuestion& question,
                    const compilation::Compilation& compilation, const TraceComparison* trace) {
  Json json;
  json["signal"] = question.name;
  json["value"] = answer.value;
  if (answer.has_run) json["timeMs"] = answer.time_ms;
  if (!answer.refusal.empty()) json["unknown"] = answer.refusal;
  if (!answer.failure.empty()) json["failure"] = answer.failure;
  json["conditions"] = Json::array();
  for (const Condition& condition : answer.conditions) json["conditions"].push_back(JsonOf(condition, compilation));
  if (trace != nullptr) {
    json["notes"] = trace->notes;
    json["departures"] = Json::array();
    for (const scenarios::Departure& departure : trace->departures) {
      json["departures"].push_back({{"signal", departure.name},
                                    {"timeMs", departure.time_ms},
                                    {"inTrace", departure.traced},
                                    {"inRun", departure.run}});
    }
  }
  return Dump(json);
}

std::string CanText(const CanAnswer& answer) {
  switch (answer.result.verdict) {
    case PropertyVerdict::kProved:
      return answer.signal + " is never on: proved by induction over " +
             support::Counted(answer.result.periods, "period") +
             (answer.result.remark.empty() ? "" : "\nnote: " + answer.result.remark) + "\n";
    case PropertyVerdict::kViolated:
      return answer.signal + " can be on, after " + support::Counted(answer.result.periods, "period") + ": " +
             answer.scenario.steps + (answer.result.remark.empty() ? "" : "\nnote: " + answer.result.remark) +
             "\nas a scenario:\n\n" + RunOf(answer);
    case PropertyVerdict::kUndecided:
      return "whether " + answer.signal + " can be on is not decided: " + answer.result.reason +
             "\nit is not in any run of up to " + support::Counted(answer.result.searched, "period") + "\n";
  }
  PLCXX_UNREACHABLE();
}

std::string CanJson(const CanAnswer& answer) {
  Json json;
  json["signal"] = answer.signal;
  switch (answer.result.verdict) {
    case PropertyVerdict::kProved:
      json["can"] = "never";
      break;
    case PropertyVerdict::kViolated:
      json["can"] = "shown";
      json["periods"] = answer.result.periods;
      json["steps"] = answer.scenario.steps;
      json["scenario"] = RunOf(answer);
      break;
    case PropertyVerdict::kUndecided:
      json["can"] = "undecided";
      json["reason"] = answer.result.reason;
      json["searchedPeriods"] = answer.result.searched;
      break;
  }
  if (!answer.result.remark.empty()) json["note"] = answer.result.remark;
  return Dump(json);
}

}  // namespace plcxx::driver
