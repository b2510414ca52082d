#include "transpiler/scenarios/property_monitor.h"

#include <algorithm>
#include <utility>

#include "transpiler/prove/properties/condition.h"
#include "transpiler/symbolic/meaning/meaning.h"

namespace plcxx::scenarios {
namespace {

ir::Place PlaceOf(const ir::Program& program, const execute::Cell& cell) {
  ir::Place place;
  if (cell.kind == execute::CellKind::kField) {
    place.state = cell.state;
    place.field = cell.field;
    place.type = ir::Info(program.states[cell.state].kind).fields[cell.field].type;
  } else {
    place.space = cell.space;
    place.offset = cell.offset;
    place.bit = cell.bit;
  }
  return place;
}

}  // namespace

PropertyMonitor::PropertyMonitor(const ir::Program& program, const execute::Cells& cells,
                                 std::vector<prove::properties::Property> properties)
    : program_(program), properties_(std::move(properties)) {
  std::erase_if(properties_, [](const prove::properties::Property& property) {
    return property.kind == prove::properties::PropertyKind::kNeverStuck;
  });
  for (const prove::properties::Property& property : properties_) {
    window_ = std::max(window_, prove::properties::WindowOf(property));
    for (const prove::properties::PropertyOperand& operand : property.operands) {
      for (const execute::CellId id : operand.cells) {
        if (std::ranges::find(watched_, id, &Watched::cell) != watched_.end()) continue;
        const execute::Cell cell = execute::CellAt(program, cells, id);
        watched_.push_back({id, PlaceOf(program, cell), execute::CellWidth(program, cell)});
      }
    }
  }
  for (const ir::Routine& routine : program.routines) sliced_ = sliced_ || (routine.sliced && routine.slices > 1);
  sliced_ = sliced_ && program.schedule.slow_done.valid();
}

void PropertyMonitor::PowerOn() {
  period_ = 0;
  slow_done_ = 0;
  fast_ran_alone_ = false;
  history_.clear();
}

void PropertyMonitor::BeginAt(sim::Engine& engine) {
  PowerOn();
  if (sliced_) slow_done_ = engine.Read(program_.places[program_.schedule.slow_done]);
}

bool PropertyMonitor::IsEndOfPeriod(sim::Engine& engine, sim::Clock::Part part) {
  // With a time of its own it runs between the slow parts anyway.
  const bool is_timed = program_.schedule.fast_ms != 0;
  if (part == sim::Clock::Part::kFastOnly) {
    fast_ran_alone_ = fast_ran_alone_ || !is_timed;
    return false;
  }
  if (is_timed || !sliced_) return true;
  const uint64_t before = std::exchange(slow_done_, engine.Read(program_.places[program_.schedule.slow_done]));
  return slow_done_ != before;
}

void PropertyMonitor::AfterPart(sim::Engine& engine, sim::Clock::Part part) {
  if (properties_.empty() || violation_ || !IsEndOfPeriod(engine, part)) return;
  constexpr uint32_t kMostTerms = 1 << 16;  // a machine that runs for days has a value for each of them
  if (terms_.size() > kMostTerms) terms_ = terms::Terms();
  ++period_;
  history_.emplace_front();
  for (const Watched& watched : watched_) history_.front()[watched.cell] = engine.Read(watched.place);
  if (history_.size() > window_) history_.pop_back();
  const auto value = [this](execute::CellId cell, uint32_t period) {
    const auto watched = std::ranges::find(watched_, cell, &Watched::cell);
    return terms_.Const(history_[period_ - period].at(cell), watched->width);
  };
  for (const prove::properties::Property& property : properties_) {
    if (terms_.IsTrue(prove::properties::HoldsAfter(terms_, property, period_, value))) continue;
    violation_ = "property '" + property.text + "' does not hold";
    if (fast_ran_alone_) *violation_ += "; the fast part ran alone before, and a proof is about whole periods";
    return;
  }
}

}  // namespace plcxx::scenarios
