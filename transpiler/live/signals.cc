#include "transpiler/live/signals.h"

#include "transpiler/sim/value_text.h"

namespace plcxx::live {
namespace {

SignalGroup GroupOf(const report::Signal& signal) {
  if (signal.state.valid()) return SignalGroup::kInstance;
  if (signal.direction == ir::Direction::kInput) return SignalGroup::kInput;
  if (signal.direction == ir::Direction::kOutput) return SignalGroup::kOutput;
  return signal.lifetime == ir::Lifetime::kRetentive ? SignalGroup::kRetentive : SignalGroup::kInternal;
}

/// By the first name that the dialect knows.
std::optional<dialects::Location> LocationOf(const dialects::Dialect& dialect, const ir::NameIndex& names,
                                             LiveSignal& signal) {
  for (const std::string& name : {signal.name, signal.address}) {
    if (name.empty()) continue;
    std::optional<dialects::Location> location = dialect.locate(names, name);
    if (!location || location->text_input || location->absent) continue;
    if (name != signal.name) std::swap(signal.name, signal.address);
    signal.can_be_named = true;
    return location;
  }
  return std::nullopt;
}

}  // namespace

SignalTable MakeSignals(const compilation::Compilation& compilation, const report::CrossReference& uses) {
  SignalTable table;
  const ir::Program& program = compilation.program;
  const ir::NameIndex names(program);
  std::vector<uint32_t> place_of(uses.signals.size(), report::kNoSignal);
  for (uint32_t i = static_cast<uint32_t>(uses.of_place.size()); i-- > 0;) {
    const uint32_t signal = uses.of_place[i];
    if (signal != report::kNoSignal && !program.places[ir::PlaceId(i)].indexed) place_of[signal] = i;
  }
  for (uint32_t i = 0; i < uses.signals.size(); ++i) {
    const report::Signal& used = uses.signals[i];
    table.of_reference.push_back(report::kNoSignal);
    if (used.is_local()) continue;
    LiveSignal signal{.name = used.name,
                      .address = used.address,
                      .words = used.words,
                      .type = used.type,
                      .group = GroupOf(used),
                      .location = {},
                      .state = used.state};
    signal.location = LocationOf(*compilation.dialect, names, signal);
    if (!signal.location && place_of[i] != report::kNoSignal) {
      signal.location = dialects::Location{.place = program.places[ir::PlaceId(place_of[i])]};
    }
    if (!signal.location && !signal.state.valid()) continue;
    if (signal.state.valid() && signal.location && signal.location->place.is_field()) signal.state = {};
    table.of_reference.back() = static_cast<uint32_t>(table.signals.size());
    table.signals.push_back(std::move(signal));
  }
  return table;
}

}  // namespace plcxx::live
