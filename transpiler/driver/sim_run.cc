#include "transpiler/driver/sim_run.h"

#include <algorithm>
#include <chrono>
#include <ostream>
#include <utility>
#include <vector>

#include "transpiler/engines/lockstep.h"
#include "transpiler/scenarios/control.h"
#include "transpiler/sim/clock.h"
#include "transpiler/sim/simulator.h"
#include "transpiler/source/columns.h"

namespace plcxx::driver {
namespace {

constexpr size_t kTimeWidth = 9;
constexpr size_t kByteBits = 8;

/// A word as the control's monitor shows it: binary digits and decimal value.
std::string MonitorText(const sim::Watched& watched, uint64_t value) {
  if (watched.place.type != ir::Type::kI8) return sim::ValueDigits(watched.place.type, value, watched.sign);
  std::string digits;
  for (size_t bit = kByteBits; bit-- > 0;) digits += ((value >> bit) & 1) != 0 ? '1' : '0';
  return digits + source::RightAligned(std::to_string(value), 4);
}

size_t ColumnWidth(const sim::Watched& watched) {
  const size_t value = watched.place.type == ir::Type::kBit   ? 1
                       : watched.place.type == ir::Type::kI8  ? kByteBits + 4
                       : watched.place.type == ir::Type::kI16 ? 5
                                                              : 10;
  return std::max(value, source::ColumnsOf(watched.name));
}

class Table {
 public:
  Table(std::vector<sim::Watched> watched, Rows rows, std::ostream& out)
      : watched_(std::move(watched)), rows_(rows), out_(out) {
    if (watched_.empty()) return;
    out_ << source::RightAligned("time ms", kTimeWidth);
    for (const sim::Watched& column : watched_) out_ << "  " << source::RightAligned(column.name, ColumnWidth(column));
    out_ << '\n';
  }

  void Row(uint64_t time_ms, const sim::ReadWatched& read) {
    if (watched_.empty()) return;
    std::vector<uint64_t> values;
    for (const sim::Watched& column : watched_) values.push_back(read(column));
    if (rows_ == Rows::kChangesOnly && values == last_) return;
    out_ << source::RightAligned(std::to_string(time_ms), kTimeWidth);
    for (size_t i = 0; i < values.size(); ++i) {
      out_ << "  " << source::RightAligned(MonitorText(watched_[i], values[i]), ColumnWidth(watched_[i]));
    }
    out_ << '\n';
    last_ = std::move(values);
  }

  void Event(uint64_t time_ms, const std::string& text) {
    out_ << source::RightAligned(std::to_string(time_ms), kTimeWidth) << "  " << text << '\n';
  }

 private:
  std::vector<sim::Watched> watched_;
  Rows rows_;
  std::ostream& out_;
  std::vector<uint64_t> last_;
};

std::string MessageLine(const scenarios::ShownMessage& message) {
  return "message " + std::to_string(message.number) + (message.shown.empty() ? "" : ": " + message.shown);
}

/// Writes what --at asks for at its time, before the period.
class TimedValues {
 public:
  TimedValues(const std::vector<SimValue>& values, sim::Engine& engine, scenarios::ScenarioControl& control)
      : values_(values), engine_(engine), control_(control) {}

  void Apply(uint64_t now_ms) {
    for (; next_ < values_.size() && values_[next_].time_ms <= now_ms; ++next_) {
      const SimValue& value = values_[next_];
      if (value.location.text_input) {
        engine_.SendText(value.text);
      } else {
        control_.Set(value.location, value.value);
      }
    }
  }

 private:
  const std::vector<SimValue>& values_;
  sim::Engine& engine_;
  scenarios::ScenarioControl& control_;
  size_t next_ = 0;
};

}  // namespace

SimOutcome RunSimulation(const compilation::Compilation& compilation, const SimPlan& plan, const SimRunOptions& options,
                         std::unique_ptr<dialects::ControlStub> stub, std::ostream& out) {
  const ir::Program& program = compilation.program;
  sim::Simulator simulator(program);
  scenarios::ScenarioControl control(program, *compilation.dialect, simulator, std::move(stub));
  if (options.plant) control.Attach(options.plant);
  const sim::ReadWatched read = control.Reader();
  TimedValues timed(plan.at, simulator, control);
  sim::Clock clock(program, {&simulator});
  Table table(plan.graph ? std::vector<sim::Watched>() : plan.watched, options.rows, out);
  SimOutcome outcome;
  outcome.trace = sim::Trace(plan.watched);
  sim::Graph graph(plan.watched, plan.graph.value_or(sim::Graph::Options{}));

  clock.before_period = [&](uint32_t now_ms) {
    timed.Apply(clock.time_ms());
    control.BeforePeriod(now_ms);
  };
  clock.after_period = [&](uint32_t now_ms) {
    control.AfterPeriod(now_ms);
    if (simulator.stopped()) return;  // a period half done has no row
    table.Row(clock.time_ms(), read);
    for (const sim::HostEvent& event : simulator.TakeEvents()) {
      if (!event.exchange) table.Event(clock.time_ms(), "host call " + engines::ToText(program, event));
    }
    for (const scenarios::ShownMessage& message : control.TakeMessages())
      table.Event(clock.time_ms(), MessageLine(message));
    if (options.with_trace) outcome.trace.Record(clock.time_ms(), read);
    if (plan.graph) graph.Observe(clock.time_ms(), read);
    // Fast parts of their own are no periods: --for and --cycles count what the period is made of.
    if (clock.last_part() == sim::Clock::Part::kWholePeriod) ++outcome.periods;
  };
  const auto slow_cycles = [&]() -> uint64_t {
    const ir::PlaceId count = program.schedule.slow_done;
    return count.valid() ? simulator.Read(program.places[count]) : outcome.periods;
  };

  for (const SimValue& forced : plan.forced) {
    for (const auto& [place, value] : scenarios::WritesTo(forced.location, forced.value)) simulator.Force(place, value);
  }
  for (const ir::StatementId statement : plan.disconnected) simulator.EnableStatement(statement, false);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(options.seconds);
  const auto out_of_time = [end] { return std::chrono::steady_clock::now() > end; };
  simulator.StopWhen(out_of_time);
  clock.interrupted = [&simulator] { return simulator.stopped(); };
  clock.PowerOn();
  control.PowerOn();
  const uint64_t periods = plan.periods != 0 ? plan.periods : kMostPeriods;
  while (outcome.periods < periods && (plan.slow_cycles == 0 || slow_cycles() < plan.slow_cycles)) {
    if (graph.phase() == sim::Graph::Phase::kComplete) break;
    if (simulator.stopped() || out_of_time()) {
      outcome.out_of_time = true;
      break;
    }
    clock.RunMs(std::max(1u, program.schedule.period_ms));
  }

  outcome.time_ms = clock.time_ms();
  outcome.slow_cycles = slow_cycles();
  outcome.graph = graph.phase();
  if (plan.graph) out << sim::WriteTable(graph.trace());
  return outcome;
}

}  // namespace plcxx::driver
