#include "transpiler/scenarios/property_machine.h"

#include <algorithm>
#include <set>
#include <utility>

#include "transpiler/ir/schedule.h"
#include "transpiler/passes/pipeline.h"
#include "transpiler/scenarios/element_names.h"
#include "transpiler/scenarios/plan.h"
#include "transpiler/sim/clock.h"
#include "transpiler/sim/simulator.h"
#include "transpiler/sim/value_text.h"
#include "transpiler/symbolic/meaning/meaning.h"

namespace plcxx::scenarios {
namespace {

using execute::CellId;
using execute::IsInside;
using prove::properties::PropertyOperand;

prove::properties::LocatedOperand OperandOf(const ir::Program& program, const execute::Cells& cells,
                                            const dialects::Location& location, std::string_view word) {
  if (location.text_input) return std::string("a text input");
  if (location.cell) return std::string("a port of the simulated control");
  const ir::Place& place = location.place;
  if (sim::IsFloat(place.type)) return std::string("a floating-point number");
  PropertyOperand operand{.text = std::string(word)};
  operand.is_bit = place.type == ir::Type::kBit;
  operand.width = meaning::WidthOf(place.type);
  operand.has_sign = location.has_sign;
  if (location.absent) return operand;
  if (!location.bits.empty()) {
    operand.width = static_cast<uint8_t>(location.bits.size());
    for (const ir::Place& bit : location.bits) operand.cells.push_back(execute::CellsOf(program, cells, bit).front());
    return operand;
  }
  if (!IsInside(program, place)) return std::string("outside the program's memory");
  if (!place.is_field() && program.spaces[place.space].lifetime == ir::Lifetime::kRoutine) {
    return std::string("a local name, which has no value between two periods");
  }
  operand.cells = execute::CellsOf(program, cells, place);
  return operand;
}

/// Periods between the ends of two passes; 1 when that cannot be measured.
uint32_t PeriodsOf(const ir::Program& program, const std::function<sim::Step(sim::Clock&)>& pass) {
  sim::Simulator simulator(program);
  sim::Clock clock(program, {&simulator});
  clock.PowerOn();
  if (pass(clock) != sim::Step::kDone) return 1;
  const uint64_t first = clock.time_ms();
  if (pass(clock) != sim::Step::kDone) return 1;
  const uint32_t period_ms = std::max(1U, program.schedule.period_ms);
  return std::max<uint32_t>(1, static_cast<uint32_t>((clock.time_ms() - first + period_ms - 1) / period_ms));
}

/// A name that the dialect reads as exactly this place; empty: there is none.
std::string NameOf(const dialects::Dialect& dialect, const ir::NameIndex& names, const ir::Place& place) {
  for (const std::string* const name : {&place.name, &place.address}) {
    if (name->empty()) continue;
    const std::optional<dialects::Location> location = dialect.locate(names, *name);
    if (!location || location->text_input || location->absent || location->cell || !location->bits.empty()) continue;
    const ir::Place& found = location->place;
    if (!found.is_field() && found.type == place.type && found.space == place.space && found.offset == place.offset &&
        found.bit == place.bit) {
      return *name;
    }
  }
  return {};
}

}  // namespace

prove::properties::PropertyTiming TimingOf(const ir::Program& program) {
  const ir::Schedule& schedule = program.schedule;
  prove::properties::PropertyTiming timing{.period_ms = std::max(1U, schedule.period_ms)};
  if (schedule.fast_ms != 0) {
    timing.fast_per_period = ir::FastPartsOfPeriod(schedule);
    return timing;
  }
  for (const ir::Routine& routine : program.routines) {
    if (!routine.sliced || routine.slices == 1) continue;
    timing.period_ms *= routine.slices;  // the period is a whole slow pass
    return timing;
  }
  timing.slow_periods = PeriodsOf(program, [](sim::Clock& clock) { return clock.RunSlow(1); });
  if (schedule.fast_done.valid()) {
    timing.fast_periods = PeriodsOf(program, [](sim::Clock& clock) { return clock.RunFast(1); });
  }
  return timing;
}

void MakeProveMachine(const compilation::CompilationRequest& request, ProveMachine& machine) {
  machine.compilation = compilation::Compile(request, compilation::Stage::kChecked);
  compilation::Compilation& compilation = machine.compilation;
  if (!compilation.ok() || !compilation.has_program) return;
  ir::Program& program = compilation.program;
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    ir::Routine& routine = program.routines[ir::RoutineId(i)];
    if (!routine.sliced) continue;
    machine.slices = std::max<uint32_t>(machine.slices, routine.slices);
    routine.slices = 1;
  }
  program.schedule.period_ms *= machine.slices;
  passes::Optimize(program);
  machine.version = prove::machine::MakeVersion(program);
  machine.timing = TimingOf(program);
}

prove::properties::PropertyContext PropertyContextOf(const dialects::Dialect& dialect, const ir::Program& program,
                                                     const execute::Cells& cells,
                                                     const prove::properties::PropertyTiming& timing) {
  prove::properties::PropertyContext context;
  context.timing = timing;
  context.locate =
      [&, names = ir::NameIndex(program)](std::string_view word) -> std::optional<prove::properties::LocatedOperand> {
    const std::optional<dialects::Location> location = dialect.locate(names, word);
    if (!location) return std::nullopt;
    return OperandOf(program, cells, *location, word);
  };
  context.number = [&dialect](std::string_view word) -> std::optional<int64_t> {
    const std::optional<uint64_t> value = ParseScenarioValue(word, ir::Type::kI64, dialect);
    if (!value) return std::nullopt;
    return static_cast<int64_t>(*value);
  };
  return context;
}

void NameLocationsOf(const prove::properties::Property& property, ProveMachine& machine) {
  for (const PropertyOperand& operand : property.operands) {
    const bool is_whole = operand.low_bit == 0 && operand.cells.size() == operand.width;
    if (is_whole) machine.named.push_back({.name = operand.text, .cells = operand.cells});
  }
}

std::vector<InputWord> WordsOf(const ProveMachine& machine, const std::vector<CellId>& cells) {
  const ir::Program& program = machine.compilation.program;
  const dialects::Dialect& dialect = *machine.compilation.dialect;
  const ir::NameIndex names(program);
  std::map<CellId, InputWord> word_of;
  // Bits first: a word is only for what has no name of its own.
  for (const bool bits : {true, false}) {
    for (const ir::Place& place : program.places) {
      if (place.is_field() || (place.type == ir::Type::kBit) != bits || !IsInside(program, place)) continue;
      if (program.spaces[place.space].lifetime == ir::Lifetime::kRoutine) continue;
      const std::vector<CellId> own = execute::CellsOf(program, machine.version.cells, place);
      const auto is_open = [&](CellId cell) {
        return std::ranges::find(cells, cell) != cells.end() && !word_of.contains(cell);
      };
      if (std::ranges::none_of(own, is_open)) continue;
      const std::string name = NameOf(dialect, names, place);
      if (name.empty()) continue;
      for (const CellId cell : own) word_of.try_emplace(cell, InputWord{.name = name, .cells = own});
    }
  }
  for (const InputWord& named : machine.named) {
    for (const CellId cell : named.cells) word_of.try_emplace(cell, named);
  }
  // Only after all others: what the program reaches by an index alone.
  for (const CellId id : cells) {
    if (word_of.contains(id)) continue;
    const execute::Cell cell = execute::CellAt(program, machine.version.cells, id);
    if (cell.kind != execute::CellKind::kBit) continue;
    const std::optional<ir::Place> place = NamedElement(names, dialect, cell);
    if (!place || !IsInside(program, *place) || NameOf(dialect, names, *place).empty()) continue;
    const std::vector<CellId> own = execute::CellsOf(program, machine.version.cells, *place);
    for (const CellId one : own) word_of.try_emplace(one, InputWord{.name = place->name, .cells = own});
  }
  std::vector<InputWord> words;
  std::set<std::string> taken;
  for (const CellId cell : cells) {
    const auto found = word_of.find(cell);
    if (found == word_of.end()) {
      words.push_back({.name = {}, .cells = {cell}});
    } else if (taken.insert(found->second.name).second) {
      words.push_back(found->second);
    }
  }
  return words;
}

}  // namespace plcxx::scenarios
