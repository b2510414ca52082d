#include "transpiler/scenarios/traced_run.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "transpiler/engines/lockstep.h"
#include "transpiler/ir/symbol_names.h"
#include "transpiler/prove/machine/inputs.h"
#include "transpiler/prove/machine/version.h"
#include "transpiler/scenarios/control.h"
#include "transpiler/scenarios/plan.h"
#include "transpiler/scenarios/run.h"
#include "transpiler/sim/clock.h"
#include "transpiler/sim/simulator.h"
#include "transpiler/sim/trace.h"
#include "transpiler/sim/value_text.h"
#include "transpiler/support/low_bits.h"

namespace plcxx::scenarios {
namespace {

using dialects::Location;

/// "table_3_.speed": "table[3].speed", as the file could not have it.
std::string WithBrackets(std::string_view name) {
  std::string text;
  for (size_t i = 0; i < name.size(); ++i) {
    size_t end = i + 1;
    while (name[i] == '_' && end < name.size() && name[end] >= '0' && name[end] <= '9') ++end;
    const bool is_index = end > i + 1 && end < name.size() && name[end] == '_';
    if (!is_index) {
      text += name[i];
      continue;
    }
    text += '[' + std::string(name.substr(i + 1, end - i - 1)) + ']';
    i = end;
  }
  return text;
}

/// Which location a signal of a trace is.
class SignalNames {
 public:
  explicit SignalNames(const compilation::Compilation& compilation) : compilation_(compilation) {
    for (const ir::Documentation& known : compilation.program.documentation) {
      by_vcd_name_.emplace(sim::VcdName(known.address), known.address);
      ir::ForEachSymbolName(known,
                            [this](std::string_view symbol) { by_vcd_name_.emplace(sim::VcdName(symbol), symbol); });
    }
  }

  std::optional<TracedSignal> Find(const sim::VcdSignal& signal, uint32_t number) const {
    std::vector<std::string> spellings{signal.name, WithBrackets(signal.name)};
    if (const auto known = by_vcd_name_.find(signal.name); known != by_vcd_name_.end()) {
      spellings.push_back(known->second);
    }
    for (std::string& spelling : spellings) {
      std::optional<Location> location = compilation_.dialect->locate(names_, spelling);
      if (!location || location->text_input || location->absent) continue;
      return TracedSignal{.name = std::move(spelling), .signal = number, .location = *std::move(location)};
    }
    return std::nullopt;
  }

 private:
  const compilation::Compilation& compilation_;
  const ir::NameIndex names_{compilation_.program};
  std::map<std::string, std::string, std::less<>> by_vcd_name_;
};

/// Whether the machine or the control writes a location, and the program nothing of it.
class Inputs {
 public:
  explicit Inputs(const ir::Program& program)
      : program_(program),
        version_(prove::machine::MakeVersion(program)),
        is_input_(prove::machine::InputsOf(version_)) {}

  bool Has(const TracedSignal& signal) const {
    if (signal.location.cell) {  // the control's own: what the program reads there has a place with this address
      const auto place = std::ranges::find(program_.places, signal.name, &ir::Place::address);
      return place != program_.places.end() && HasPlace(*place);
    }
    if (signal.location.bits.empty()) return HasPlace(signal.location.place);
    return std::ranges::all_of(signal.location.bits, [this](const ir::Place& bit) { return HasPlace(bit); });
  }

 private:
  bool HasPlace(const ir::Place& place) const {
    if (place.indexed || place.is_field() || !place.space.valid() || !execute::IsInside(program_, place)) return false;
    return std::ranges::all_of(execute::CellsOf(program_, version_.cells, place),
                               [this](execute::CellId cell) { return is_input_[cell.index]; });
  }

  const ir::Program& program_;
  prove::machine::Version version_;
  std::vector<bool> is_input_;
};

std::string RealText(double number) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, number);
  return std::string(text, end);
}

/// The value of a change as the bits of the location's type.
uint64_t BitsOf(const sim::VcdSignal& signal, uint64_t value, ir::Type type) {
  if (signal.is_real) {
    const double real = std::bit_cast<double>(value);
    if (type == ir::Type::kF32) return std::bit_cast<uint32_t>(static_cast<float>(real));
    return type == ir::Type::kF64 ? value : static_cast<uint64_t>(static_cast<int64_t>(real));
  }
  const uint32_t width = type == ir::Type::kBit ? 1 : 8 * ir::Bytes(type);
  return value & support::LowBits(width);
}

std::string ScenarioValue(const sim::VcdSignal& signal, uint64_t value, const Location& location) {
  const ir::Type type = location.place.type;
  if (sim::IsFloat(type) && signal.is_real) return RealText(std::bit_cast<double>(value));
  return sim::ValueDigits(type, BitsOf(signal, value, type), SignOf(location));
}

bool PartsEndTheirTime(const ir::Schedule& schedule) { return schedule.period_ends_its_time || schedule.fast_ms != 0; }

/// The scenario's time at which what is so at `time_ms` has to be set: before the part of that time, after the one
/// before it.
uint64_t SetTime(const ir::Schedule& schedule, uint64_t time_ms) {
  const uint64_t grid = sim::UnitMs(schedule);
  if (PartsEndTheirTime(schedule)) return time_ms == 0 ? 0 : (time_ms - 1) / grid * grid;
  return (time_ms + grid - 1) / grid * grid;
}

/// The first time on the grid when every part up to `time_ms` is over.
uint64_t EndTime(const ir::Schedule& schedule, uint64_t time_ms) {
  const uint64_t grid = sim::UnitMs(schedule);
  if (PartsEndTheirTime(schedule)) return std::max(grid, (time_ms + grid - 1) / grid * grid);
  return time_ms / grid * grid + grid;
}

class StepWriter {
 public:
  explicit StepWriter(std::vector<ScenarioStep>& steps) : steps_(steps) {}

  void Set(const std::map<std::string, std::string>& values) {
    SetStep set;
    for (const auto& [name, value] : values) {
      set.assignments.push_back({.location = {.text = name, .mark = {}}, .value = {.text = value, .mark = {}}});
    }
    Add("set", std::move(set));
  }
  void RunTo(uint64_t time_ms) {
    constexpr uint64_t kMostMs = 1'000'000'000;  // in one step; more of them are as good
    for (; now_ms_ < time_ms; now_ms_ += std::min(kMostMs, time_ms - now_ms_)) {
      const auto ms = static_cast<uint32_t>(std::min(kMostMs, time_ms - now_ms_));
      Add("run", RunStep{{{.unit = RunUnit::kMilliseconds, .count = ms}}});
    }
  }

 private:
  void Add(std::string name, StepAction action) {
    steps_.push_back({.number = static_cast<uint32_t>(steps_.size()) + 1,
                      .name = std::move(name),
                      .mark = {},
                      .action = std::move(action)});
  }

  std::vector<ScenarioStep>& steps_;
  uint64_t now_ms_ = 0;
};

void WriteSteps(const ir::Schedule& schedule, const sim::Vcd& trace, TracedRun& run) {
  std::map<uint32_t, const TracedSignal*> inputs;
  for (const TracedSignal& input : run.inputs) inputs.emplace(input.signal, &input);
  // By time of setting: what is set then; of two changes between two parts the later one is what the program sees.
  std::map<uint64_t, std::map<std::string, std::string>> settings;
  for (const sim::VcdChange& change : trace.changes) {
    const auto input = inputs.find(change.signal);
    if (input == inputs.end() || !change.is_known) continue;
    const sim::VcdSignal& signal = trace.signals[change.signal];
    const uint64_t time_ms = change.time_ms < run.begins_ms ? 0 : change.time_ms - run.begins_ms;
    settings[SetTime(schedule, time_ms)][input->second->name] =
        ScenarioValue(signal, change.value, input->second->location);
  }
  StepWriter steps(run.scenario.steps.emplace());
  for (const auto& [time_ms, values] : settings) {
    steps.RunTo(time_ms);
    steps.Set(values);
  }
  steps.RunTo(EndTime(schedule, trace.last_ms - run.begins_ms));
}

/// What the trace says of a signal over time.
class TracedValues {
 public:
  TracedValues(const sim::Vcd& trace, const TracedSignal& traced)
      : signal_(trace.signals[traced.signal]), type_(traced.location.place.type) {
    for (const sim::VcdChange& change : trace.changes) {
      if (change.signal == traced.signal) changes_.push_back(&change);
    }
  }

  /// Whether it has the value somewhen in [first, last], or says nothing about some of that time.
  bool Allows(uint64_t value, uint64_t first_ms, uint64_t last_ms) const {
    auto change = std::ranges::upper_bound(changes_, first_ms, {}, [](const auto* at) { return at->time_ms; });
    if (change == changes_.begin()) return true;
    for (--change; change != changes_.end() && (*change)->time_ms <= last_ms; ++change) {
      if (!(*change)->is_known || BitsOf(signal_, (*change)->value, type_) == value) return true;
    }
    return false;
  }
  uint64_t At(uint64_t time_ms) const {
    const auto change = std::ranges::upper_bound(changes_, time_ms, {}, [](const auto* at) { return at->time_ms; });
    return change == changes_.begin() ? 0 : BitsOf(signal_, (*std::prev(change))->value, type_);
  }

 private:
  const sim::VcdSignal& signal_;
  ir::Type type_;
  std::vector<const sim::VcdChange*> changes_;
};

}  // namespace

TracedRun RunOfTrace(const compilation::Compilation& compilation, const sim::Vcd& trace, const std::string& path) {
  const ir::Schedule& schedule = compilation.program.schedule;
  TracedRun run;
  run.scenario.path = path;
  // A trace that this tool has written begins with the first part, which is not at 0 where parts end their time.
  const uint64_t grid = sim::UnitMs(schedule);
  run.begins_ms = PartsEndTheirTime(schedule) ? (trace.first_ms == 0 ? 0 : (trace.first_ms - 1) / grid * grid)
                                              : trace.first_ms / grid * grid;
  const SignalNames names(compilation);
  const Inputs inputs(compilation.program);
  for (uint32_t i = 0; i < trace.signals.size(); ++i) {
    std::optional<TracedSignal> traced = names.Find(trace.signals[i], i);
    if (!traced) {
      run.left_out.push_back(trace.signals[i].name);
    } else {
      (inputs.Has(*traced) ? run.inputs : run.written).push_back(*std::move(traced));
    }
  }
  WriteSteps(schedule, trace, run);
  return run;
}

std::vector<Departure> Departures(const compilation::Compilation& compilation, const sim::Vcd& trace,
                                  const TracedRun& run) {
  const ir::Program& program = compilation.program;
  auto planned = PlanScenario(run.scenario, *compilation.dialect, program);
  const ScenarioPlan* plan = std::get_if<ScenarioPlan>(&planned);
  if (plan == nullptr || run.written.empty()) return {};
  std::vector<sim::Watched> watched;
  for (const TracedSignal& signal : run.written) {
    watched.push_back(WatchLocation(program, signal.name, signal.location));
  }
  sim::Trace samples(watched);
  std::vector<std::unique_ptr<sim::Engine>> engines;
  engines.push_back(std::make_unique<sim::Simulator>(program));
  engines::Lockstep lockstep(program, std::move(engines));
  RunScenario({.scenario = run.scenario,
               .plan = *plan,
               .dialect = *compilation.dialect,
               .program = program,
               .sources = *compilation.sources,
               .engines = lockstep,
               .stub = StubOf(compilation),
               .trace = &samples});
  const uint64_t period = std::max(1u, program.schedule.period_ms);
  std::vector<Departure> departures;
  for (size_t i = 0; i < run.written.size(); ++i) {
    const TracedValues traced(trace, run.written[i]);
    for (const sim::Sample& sample : samples.samples()) {
      const uint64_t at = sample.time_ms + run.begins_ms;
      if (traced.Allows(sample.values[i], at < period ? 0 : at - period, at + period)) continue;
      const ir::Type type = run.written[i].location.place.type;
      departures.push_back({.name = run.written[i].name,
                            .time_ms = at,
                            .traced = sim::ValueDigits(type, traced.At(at), watched[i].sign),
                            .run = sim::ValueDigits(type, sample.values[i], watched[i].sign)});
      break;
    }
  }
  std::ranges::stable_sort(departures, {}, &Departure::time_ms);
  return departures;
}

}  // namespace plcxx::scenarios
