#include "transpiler/scenarios/property_monitor.h"

#include <bit>
#include <functional>
#include <map>
#include <utility>

#include "transpiler/ir/schedule.h"
#include "transpiler/prove/properties/condition.h"
#include "transpiler/symbolic/meaning/meaning.h"
#include "transpiler/symbolic/terms/evaluate.h"

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
    : program_(program) {
  std::erase_if(properties, [](const prove::properties::Property& property) {
    return property.kind == prove::properties::PropertyKind::kNeverStuck;
  });
  std::map<execute::CellId, terms::TermId> variables;
  for (const prove::properties::Property& property : properties) {
    for (const prove::properties::PropertyOperand& operand : property.operands) {
      for (const execute::CellId id : operand.cells) {
        const auto [known, is_new] = variables.try_emplace(id);
        if (!is_new) continue;
        const execute::Cell cell = execute::CellAt(program, cells, id);
        known->second = terms_.Variable("cell", execute::CellWidth(program, cell));
        places_.push_back(PlaceOf(program, cell));
      }
    }
  }
  const auto value = [&variables](execute::CellId cell) { return variables.at(cell); };
  for (const prove::properties::Property& property : properties) {
    Watched& watched = properties_.emplace_back(Watched{.text = property.text, .kind = property.kind});
    watched.holds = prove::properties::HoldsByCounting(
        terms_, property, value, [&](uint32_t most, const std::function<terms::TermId(terms::TermId)>& next) {
          const uint32_t variable = terms_.variable_count();
          const terms::TermId before = terms_.Variable("count", static_cast<uint8_t>(std::bit_width(most)));
          watched.counts.push_back({variable, next(before)});
          return watched.counts.back().next;
        });
  }
  for (const ir::Routine& routine : program.routines) sliced_ = sliced_ || (routine.sliced && routine.slices > 1);
  sliced_ = sliced_ && program.schedule.slow_done.valid();
  PowerOn();
}

void PropertyMonitor::PowerOn() {
  slow_done_ = 0;
  fast_since_slow_ = 0;
  is_off_schedule_ = false;
  values_.assign(terms_.variable_count(), 0);
}

void PropertyMonitor::Exchange(Moment& other) {
  std::swap(values_, other.values);
  std::swap(slow_done_, other.slow_done);
  std::swap(fast_since_slow_, other.fast_since_slow);
  std::swap(is_off_schedule_, other.is_off_schedule);
  violation_.reset();
}

void PropertyMonitor::BeginAt(sim::Engine& engine) {
  PowerOn();
  if (sliced_) slow_done_ = engine.Read(program_.places[program_.schedule.slow_done]);
}

bool PropertyMonitor::IsEndOfPeriod(sim::Engine& engine, sim::Clock::Part part) {
  if (part == sim::Clock::Part::kFastOnly) {
    if (IsTimed()) {
      ++fast_since_slow_;
    } else {
      is_off_schedule_ = true;
    }
    return false;
  }
  if (IsTimed()) {
    const uint32_t ran = std::exchange(fast_since_slow_, 0);
    is_off_schedule_ = is_off_schedule_ || ran != ir::FastPartsOfPeriod(program_.schedule);
    return true;
  }
  if (!sliced_) return true;
  const uint64_t before = std::exchange(slow_done_, engine.Read(program_.places[program_.schedule.slow_done]));
  return slow_done_ != before;
}

void PropertyMonitor::AfterPart(sim::Engine& engine, sim::Clock::Part part) {
  if (properties_.empty() || violation_ || !IsEndOfPeriod(engine, part)) return;
  for (size_t i = 0; i < places_.size(); ++i) values_[i] = engine.Read(places_[i]);
  const std::vector<uint64_t> after = terms::EvaluateAll(terms_, values_, terms::TermId(terms_.size() - 1));
  for (const Watched& watched : properties_) {
    for (const Count& count : watched.counts) values_[count.variable] = after[count.next.index];
    if (violation_ || after[watched.holds.index] != 0) continue;
    violation_ = "property '" + watched.text + "' does not hold";
    if (is_off_schedule_) {
      *violation_ +=
          IsTimed() ? "; the slow part ran without the fast parts of its period" : "; the fast part ran alone before";
      *violation_ += ", and a proof is about whole periods";
    }
    // Who asked waits no longer.
    if (watched.kind == prove::properties::PropertyKind::kResponse && !watched.counts.empty())
      values_[watched.counts.back().variable] = 0;
  }
}

}  // namespace plcxx::scenarios
