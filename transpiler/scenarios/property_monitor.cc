#include "transpiler/scenarios/property_monitor.h"

#include <algorithm>
#include <utility>

#include "transpiler/prove/meaning/meaning.h"
#include "transpiler/prove/properties/condition.h"

namespace plcxx::scenarios {
namespace {

ir::Place PlaceOf(const ir::Program& program, const prove::execute::Cell& cell) {
  ir::Place place;
  if (cell.kind == prove::execute::CellKind::kField) {
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

PropertyMonitor::PropertyMonitor(const ir::Program& program, const prove::execute::Cells& cells,
                                 std::vector<prove::properties::Property> properties)
    : program_(program), properties_(std::move(properties)) {
  std::erase_if(properties_, [](const prove::properties::Property& property) {
    return property.kind == prove::properties::PropertyKind::kNeverStuck;
  });
  for (const prove::properties::Property& property : properties_) {
    window_ = std::max(window_, prove::properties::WindowOf(property));
    for (const prove::properties::PropertyOperand& operand : property.operands) {
      for (const prove::execute::CellId id : operand.cells) {
        if (std::ranges::find(watched_, id, &Watched::cell) != watched_.end()) continue;
        const prove::execute::Cell cell = prove::execute::CellAt(program, cells, id);
        watched_.push_back({id, PlaceOf(program, cell), prove::execute::CellWidth(program, cell)});
      }
    }
  }
  for (const ir::Routine& routine : program.routines) sliced_ = sliced_ || (routine.sliced && routine.slices > 1);
  sliced_ = sliced_ && program.schedule.slow_done.valid();
}

void PropertyMonitor::PowerOn() {
  period_ = 0;
  slow_done_ = 0;
  fast_seen_ms_.reset();
  history_.clear();
}

bool PropertyMonitor::IsEndOfPeriod(sim::Engine& engine, uint32_t now_ms) {
  const ir::Schedule& schedule = program_.schedule;
  if (schedule.fast_ms != 0) {
    // At the time of a slow part a fast one comes first.
    if (now_ms % std::max(1U, schedule.period_ms) != 0) return false;
    if (std::exchange(fast_seen_ms_, now_ms) != now_ms) return false;
    fast_seen_ms_.reset();
    return true;
  }
  if (!sliced_) return true;
  const uint64_t before = std::exchange(slow_done_, engine.Read(program_.places[schedule.slow_done]));
  return slow_done_ != before;
}

void PropertyMonitor::AfterPeriod(sim::Engine& engine, uint32_t now_ms) {
  if (properties_.empty() || violation_ || !IsEndOfPeriod(engine, now_ms)) return;
  ++period_;
  history_.emplace_front();
  for (const Watched& watched : watched_) history_.front()[watched.cell] = engine.Read(watched.place);
  if (history_.size() > window_) history_.pop_back();
  const auto value = [this](prove::execute::CellId cell, uint32_t period) {
    const auto watched = std::ranges::find(watched_, cell, &Watched::cell);
    return terms_.Const(history_[period_ - period].at(cell), watched->width);
  };
  for (const prove::properties::Property& property : properties_) {
    if (terms_.IsTrue(prove::properties::HoldsAfter(terms_, property, period_, value))) continue;
    violation_ = "property '" + property.text + "' does not hold";
    return;
  }
}

}  // namespace plcxx::scenarios
