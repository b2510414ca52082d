#include "transpiler/driver/prove_output.h"
#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/support/counted.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

namespace plcxx::driver {
namespace {

using prove::properties::PropertyVerdict;

std::string_view NameOf(PropertyVerdict verdict) {
  switch (verdict) {
    case PropertyVerdict::kProved:
      return "proved";
    case PropertyVerdict::kViolated:
      return "violated";
    case PropertyVerdict::kUndecided:
      return "not decided";
  }
  PLCXX_UNREACHABLE();
}

/// What a run says of the machine, where a plant is given.
std::string PlantLine(const ProvedProperty& proved) {
  if (proved.result.run->has_plant) return "the plant (" + proved.plant + ") moves in this run";
  if (proved.placed.property.kind == prove::properties::PropertyKind::kNeverStuck) {
    return "the plant does not move in this run: what is stuck is asked of every input";
  }
  return "the plant does not move in this run; with it no run was found";
}

/// The lines below the property's own, without indentation.
std::vector<std::string> DetailsOf(const ProvedProperty& proved) {
  const prove::properties::PropertyResult& result = proved.result;
  switch (result.verdict) {
    case PropertyVerdict::kProved: {
      const bool is_stuck = proved.placed.property.kind == prove::properties::PropertyKind::kNeverStuck;
      std::string text = is_stuck ? "within " + support::Counted(result.periods, "period") + " from every state"
                                  : "by induction over " + support::Counted(result.periods, "period");
      if (result.invariants > 0) text += ", with " + support::Counted(result.invariants, "invariant");
      std::vector<std::string> lines{std::move(text)};
      if (!result.remark.empty()) lines.push_back("note: " + result.remark);
      return lines;
    }
    case PropertyVerdict::kViolated: {
      std::vector<std::string> lines{"after " + support::Counted(result.periods, "period") + ": " +
                                     proved.scenario.steps};
      if (!proved.plant.empty()) lines.push_back(PlantLine(proved));
      if (!result.reason.empty()) lines.push_back(result.reason);
      if (!result.remark.empty()) lines.push_back("note: " + result.remark);
      if (!proved.file.empty()) lines.push_back("scenario: " + proved.file);
      return lines;
    }
    case PropertyVerdict::kUndecided:
      if (result.run && !proved.scenario.steps.empty()) return {result.reason, "the run: " + proved.scenario.steps};
      if (result.searched == 0) return {result.reason};
      return {result.reason, "no run of up to " + support::Counted(result.searched, "period") + " violates it"};
  }
  PLCXX_UNREACHABLE();
}

size_t CountOf(const std::vector<ProvedProperty>& all, PropertyVerdict verdict) {
  return static_cast<size_t>(
      std::ranges::count_if(all, [verdict](const ProvedProperty& one) { return one.result.verdict == verdict; }));
}

}  // namespace

std::string ProveText(const ProvedProperty& proved, Colours colours) {
  constexpr size_t kWidth = 13;
  std::string name(NameOf(proved.result.verdict));
  std::string_view colour = "\x1b[32m";
  if (proved.result.verdict == PropertyVerdict::kViolated) {
    name = "VIOLATED";
    colour = "\x1b[31m";
  } else if (proved.result.verdict == PropertyVerdict::kUndecided) {
    colour = "\x1b[33m";
  }
  const std::string padding(kWidth - name.size(), ' ');
  if (colours == Colours::kTerminal) name = std::string(colour) + name + "\x1b[0m";
  std::string text = name + padding + proved.placed.property.text + "\n";
  for (const std::string& line : DetailsOf(proved)) text += std::string(kWidth, ' ') + line + "\n";
  return text;
}

std::string ProveSummary(const std::vector<ProvedProperty>& all, const std::string& plant) {
  std::string text = std::to_string(all.size()) + (all.size() == 1 ? " property: " : " properties: ") +
                     std::to_string(CountOf(all, PropertyVerdict::kProved)) + " proved";
  for (const PropertyVerdict verdict : {PropertyVerdict::kViolated, PropertyVerdict::kUndecided}) {
    const size_t count = CountOf(all, verdict);
    if (count > 0) text += ", " + std::to_string(count) + " " + std::string(NameOf(verdict));
  }
  if (!plant.empty()) {
    text += "\nProofs hold for every input, whatever the plant (" + plant + ") does; runs in which it moves say so.";
  }
  return text;
}

std::string ProveJson(const std::vector<ProvedProperty>& all, const std::string& plant) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ProvedProperty& proved : all) {
    const prove::properties::PropertyResult& result = proved.result;
    nlohmann::ordered_json one;
    one["property"] = proved.placed.property.text;
    one["file"] = proved.placed.path;
    one["line"] = proved.placed.property.line;
    one["column"] = proved.placed.property.column;
    one["verdict"] = NameOf(result.verdict);
    one["searchedPeriods"] = result.searched;
    if (!result.remark.empty()) one["note"] = result.remark;
    switch (result.verdict) {
      case PropertyVerdict::kProved:
        one["periods"] = result.periods;
        one["invariants"] = result.invariants;
        break;
      case PropertyVerdict::kViolated:
        one["periods"] = result.periods;
        one["steps"] = proved.scenario.steps;
        if (!plant.empty()) one["plantMoves"] = result.run->has_plant;
        one["replayed"] = true;  // what the simulation does not show is not decided
        one["scenario"] = proved.scenario.yaml;
        if (!proved.file.empty()) one["scenarioFile"] = proved.file;
        break;
      case PropertyVerdict::kUndecided:
        one["reason"] = result.reason;
        break;
    }
    list.push_back(std::move(one));
  }
  nlohmann::ordered_json report;
  if (!plant.empty()) report["plant"] = plant;
  report["properties"] = std::move(list);
  return diag::JsonForTerminals(report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) + "\n";
}

std::vector<scenarios::TestCase> ProveCases(const std::vector<ProvedProperty>& all) {
  std::vector<scenarios::TestCase> cases;
  for (const ProvedProperty& proved : all) {
    scenarios::TestCase test{.name = proved.placed.property.text, .group = proved.placed.path, .text = {}};
    if (proved.result.verdict != PropertyVerdict::kProved) {
      test.outcome = proved.result.verdict == PropertyVerdict::kViolated ? scenarios::TestOutcome::kFailed
                                                                         : scenarios::TestOutcome::kUnusable;
      test.text = std::string(NameOf(proved.result.verdict));
      for (const std::string& line : DetailsOf(proved)) test.text += "\n" + line;
    }
    cases.push_back(std::move(test));
  }
  return cases;
}

}  // namespace plcxx::driver
