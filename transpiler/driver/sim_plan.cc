#include "transpiler/driver/sim_plan.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <set>
#include <utility>

#include "transpiler/scenarios/control.h"
#include "transpiler/scenarios/near_location.h"
#include "transpiler/scenarios/plan.h"

namespace plcxx::driver {
namespace {

struct Unit {
  std::string_view name;
  uint64_t ms;
};
constexpr std::array<Unit, 3> kUnits = {{{"ms", 1}, {"s", 1000}, {"min", 60'000}}};
constexpr std::string_view kDurationForm = "write a number with ms, s or min, such as 100ms";

std::optional<uint64_t> ParseNumber(std::string_view text) {
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value > UINT32_MAX) return std::nullopt;
  return value;
}

std::string Quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

/// Fills a plan; the first problem ends it.
class Planner {
 public:
  Planner(const SimWords& words, const compilation::Compilation& compilation)
      : words_(words), compilation_(compilation) {}

  std::variant<SimPlan, std::string> Make() {
    if (Length() && Watch() && At() && Forced() && Graph() && Disconnected()) return std::move(plan_);
    return std::move(problem_);
  }

 private:
  bool Fail(std::string problem) {
    problem_ = std::move(problem);
    return false;
  }
  bool Length();
  bool Watch();
  bool At();
  bool Forced();
  bool Graph();
  bool Disconnected();

  bool TakeDuration(std::string_view option, std::string_view text, uint64_t& ms);
  bool TakeLocation(std::string_view text, dialects::Location& location);
  bool TakeAssignment(std::string_view text, SimValue& value);
  bool TakeLines(std::string_view text);

  const SimWords& words_;
  const compilation::Compilation& compilation_;
  const ir::NameIndex names_{compilation_.program};
  SimPlan plan_;
  std::string problem_;
};

bool Planner::TakeDuration(std::string_view option, std::string_view text, uint64_t& ms) {
  const std::optional<uint64_t> parsed = ParseDuration(text);
  if (!parsed) return Fail(Quoted(text) + " of " + std::string(option) + " is no time: " + std::string(kDurationForm));
  ms = *parsed;
  return true;
}

bool Planner::TakeLocation(std::string_view text, dialects::Location& location) {
  const std::optional<dialects::Location> found = compilation_.dialect->locate(names_, text);
  if (!found) return Fail(scenarios::NoSuchLocation(*compilation_.dialect, compilation_.program, text));
  location = *found;
  return true;
}

bool Planner::TakeAssignment(std::string_view text, SimValue& value) {
  const size_t equals = text.find('=');
  if (equals == std::string_view::npos) return Fail(Quoted(text) + " has no value: write LOCATION=VALUE");
  dialects::Location& location = value.location;
  if (!TakeLocation(text.substr(0, equals), location)) return false;
  const std::string_view written = text.substr(equals + 1);
  value.text = written;
  if (location.text_input) return true;
  if (location.absent) return Fail(Quoted(text.substr(0, equals)) + " does not exist in this program");
  const std::optional<uint64_t> parsed =
      scenarios::ParseScenarioValue(written, location.place.type, *compilation_.dialect);
  if (!parsed) {
    return Fail(scenarios::WhyNoValue(written, location.place.type, text.substr(0, equals), *compilation_.dialect));
  }
  value.value = scenarios::FittingField(location, *parsed);
  return true;
}

bool Planner::Length() {
  constexpr std::string_view kDefault = "1s";
  if (words_.cycles) {
    if (*words_.cycles == 0 || *words_.cycles > kMostPeriods) return Fail("--cycles takes 1 to 1000000");
    plan_.slow_cycles = *words_.cycles;
    return true;
  }
  uint64_t ms = 0;
  if (!TakeDuration("--for", words_.duration.empty() ? kDefault : std::string_view(words_.duration), ms)) return false;
  const uint64_t period_ms = std::max(1u, compilation_.program.schedule.period_ms);
  plan_.periods = (ms + period_ms - 1) / period_ms;
  if (plan_.periods == 0) return Fail("--for takes a time above 0");
  if (plan_.periods > kMostPeriods) {
    return Fail(words_.duration + " is too long: at most 1000000 periods of " + std::to_string(period_ms) + " ms");
  }
  return true;
}

bool Planner::Watch() {
  std::vector<std::string> names;
  for (const std::string& text : words_.watch) {
    const size_t before = names.size();
    for (size_t begin = 0; begin <= text.size();) {
      const size_t end = std::min(text.find(',', begin), text.size());
      if (end > begin) names.push_back(text.substr(begin, end - begin));
      begin = end + 1;
    }
    if (names.size() == before)
      return Fail("'--watch " + text + "' names no location: write them with ',' between them");
  }
  for (const std::string& name : names) {
    dialects::Location location;
    if (!TakeLocation(name, location)) return false;
    if (location.text_input) return Fail(Quoted(name) + " cannot be read");
    if (location.absent) return Fail(Quoted(name) + " does not exist in this program");
    plan_.watched.push_back(scenarios::WatchLocation(compilation_.program, name, location));
  }
  if (plan_.watched.size() > kMostWatched) return Fail("--watch takes up to 16 locations");
  return true;
}

bool Planner::At() {
  for (const std::string& text : words_.at) {
    const size_t colon = text.find(':');
    if (colon == std::string::npos) return Fail(Quoted(text) + " has no time: write TIME:LOCATION=VALUE");
    SimValue value;
    if (!TakeDuration("--at", std::string_view(text).substr(0, colon), value.time_ms)) return false;
    if (!TakeAssignment(std::string_view(text).substr(colon + 1), value)) return false;
    value.written = text;
    plan_.at.push_back(std::move(value));
  }
  std::ranges::stable_sort(plan_.at, {}, &SimValue::time_ms);
  return true;
}

bool Planner::Forced() {
  std::set<std::string> names;
  for (const std::string& text : words_.force) {
    SimValue value;
    if (!TakeAssignment(text, value)) return false;
    if (value.location.text_input || value.location.cell) return Fail(Quoted(text) + " cannot be forced");
    const std::string name = text.substr(0, text.find('='));
    if (!names.insert(name).second) return Fail(Quoted(name) + " is forced twice");
    plan_.forced.push_back(std::move(value));
  }
  return true;
}

bool Planner::Graph() {
  if (words_.trigger.empty()) {
    if (!words_.delay.empty() || !words_.sampling.empty() || words_.samples != 0) {
      return Fail("--delay, --sampling and --samples need a --trigger");
    }
    return true;
  }
  const size_t colon = words_.trigger.find(':');
  const std::string edge = words_.trigger.substr(0, std::min(colon, words_.trigger.size()));
  if (colon == std::string::npos || (edge != "rising" && edge != "falling")) {
    return Fail(Quoted(words_.trigger) + " is no trigger: write rising:LOCATION or falling:LOCATION");
  }
  const std::string name = words_.trigger.substr(colon + 1);
  dialects::Location location;
  if (!TakeLocation(name, location)) return false;
  if (location.text_input || location.absent || location.place.type != ir::Type::kBit) {
    return Fail(Quoted(name) + " is no signal of this program");
  }
  if (plan_.watched.empty()) return Fail("--trigger needs locations to --watch");
  uint64_t delay_ms = 0, sampling_ms = std::max(1u, compilation_.program.schedule.period_ms);
  if (!words_.delay.empty() && !TakeDuration("--delay", words_.delay, delay_ms)) return false;
  if (!words_.sampling.empty() && !TakeDuration("--sampling", words_.sampling, sampling_ms)) return false;
  if (sampling_ms == 0) return Fail("--sampling takes a time above 0");
  plan_.graph = sim::Graph::Options{.trigger = scenarios::WatchLocation(compilation_.program, name, location),
                                    .edge = edge == "rising" ? sim::Edge::kRising : sim::Edge::kFalling,
                                    .sampling_ms = static_cast<uint32_t>(std::min<uint64_t>(sampling_ms, UINT32_MAX)),
                                    .delay_ms = static_cast<uint32_t>(std::min<uint64_t>(delay_ms, UINT32_MAX)),
                                    .samples = words_.samples};
  return true;
}

bool Planner::Disconnected() {
  return std::ranges::all_of(words_.disconnect, [this](const std::string& text) { return TakeLines(text); });
}

/// "12", "12,20", "turret.plc:12,20" or "*"; a statement belongs to the line on which it begins.
bool Planner::TakeLines(std::string_view text) {
  const source::SourceManager& sources = *compilation_.sources;
  const std::string whole(text);
  source::FileId file;
  if (const size_t colon = text.rfind(':'); colon != std::string_view::npos) {
    const std::string_view name = text.substr(0, colon);
    for (const source::FileId candidate : compilation_.files) {
      const std::string& path = sources.Get(candidate).path;
      if (path == name || std::filesystem::path(path).filename() == name) file = candidate;
    }
    if (!file.valid()) return Fail(Quoted(name) + " is no source of this program");
    text.remove_prefix(colon + 1);
  }
  uint64_t first = 1, last = UINT32_MAX;
  if (text != "*") {
    const size_t comma = text.find(',');
    const std::optional<uint64_t> low = ParseNumber(text.substr(0, comma));
    const std::optional<uint64_t> high = comma == std::string_view::npos ? low : ParseNumber(text.substr(comma + 1));
    if (!low || !high || *low == 0 || *high < *low) {
      return Fail(Quoted(whole) +
                  " names no lines: write 12, or 12,20, or '*', with FILE: in front where there are several");
    }
    if (!file.valid() && compilation_.files.size() > 1) {
      return Fail(Quoted(whole) + " does not tell the source: write FILE:LINE,LINE");
    }
    if (!file.valid()) file = compilation_.files.front();
    first = *low;
    last = *high;
    if (last > sources.LineCount(file)) {
      return Fail("line " + std::to_string(last) + " is outside the program, which has " +
                  std::to_string(sources.LineCount(file)) + " lines there");
    }
  }
  const size_t before = plan_.disconnected.size();
  for (uint32_t i = 0; i < compilation_.program.statements.size(); ++i) {
    const source::Position at = sources.Locate(compilation_.program.statements[ir::StatementId(i)].range.begin);
    if (file.valid() && at.file != file) continue;
    if (at.line >= first && at.line <= last) plan_.disconnected.push_back(ir::StatementId(i));
  }
  if (plan_.disconnected.size() == before) return Fail("no statement begins on the lines " + Quoted(whole));
  return true;
}

}  // namespace

std::optional<uint64_t> ParseDuration(std::string_view text) {
  const size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const std::optional<uint64_t> number = ParseNumber(text.substr(0, digits));
  if (!number) return std::nullopt;
  for (const Unit& unit : kUnits) {
    if (text.substr(digits) == unit.name) return *number * unit.ms;
  }
  return std::nullopt;
}

std::variant<SimPlan, std::string> PlanSimulation(const SimWords& words, const compilation::Compilation& compilation) {
  return Planner(words, compilation).Make();
}

}  // namespace plcxx::driver
