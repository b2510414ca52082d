#include "transpiler/dialects/classicladder/lowering/declarations.h"

#include <map>
#include <string>

#include "transpiler/dialects/classicladder/machine/places.h"

namespace plcxx::classicladder {

void Declarations::Initial(const ir::Place& place, uint32_t value) {
  for (uint32_t i = 0; i < ir::Bytes(place.type); ++i) {
    const auto byte = static_cast<uint8_t>(value >> (8 * i));
    if (byte != 0) program_.spaces[place.space].initial.push_back({.offset = place.offset + i, .value = byte});
  }
}

void Declarations::AddInitialValues() {
  const auto fill = [&](Group group, const std::map<uint32_t, Preset>& presets, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) {
      const auto found = presets.find(i);
      const Preset preset = found == presets.end() ? Preset{} : found->second;
      const bool in_ms = group == Group::kTimers || group == Group::kMonostables;
      const uint32_t value = static_cast<uint32_t>(preset.preset) * (in_ms ? preset.base_ms : 1);
      Initial(PlaceAt(group, Part::kPreset, i), value);
      if (group == Group::kTimers) Initial(PlaceAt(group, Part::kValue, i), value);
      if (in_ms) Initial(HiddenPlace(group, Hidden::kBase, i), preset.base_ms);
    }
  };
  fill(Group::kTimers, tree_.timers, tree_.sizes.timers);
  fill(Group::kMonostables, tree_.monostables, tree_.sizes.monostables);
  fill(Group::kCounters, tree_.counters, tree_.sizes.counters);
  fill(Group::kTimersIec, tree_.timers_iec, tree_.sizes.timers_iec);
  for (const auto& [index, step] : tree_.steps) {
    if (step.initial) Initial(StepActive(index), 1);
  }
}

void Declarations::AddDocumentation(std::set<VariableKey> used) {
  std::map<VariableKey, const Symbol*> symbols;
  for (const Symbol& symbol : tree_.symbols) {
    symbols.emplace(KeyOf(symbol.address), &symbol);
    used.insert(KeyOf(symbol.address));
    if (!symbol.whole) continue;
    for (const VariableInfo& each : Variables()) {
      if (each.name == Info(symbol.address.kind).name && !each.attribute.empty()) {
        symbols.emplace(KeyOf({each.kind, symbol.address.number}), &symbol);
        used.insert(KeyOf({each.kind, symbol.address.number}));
      }
    }
  }
  for (const auto& [kind, number] : used) {
    const Address address{static_cast<VariableKind>(kind), number};
    ir::Documentation entry{.address = NameOf(address), .symbols = {}, .predefined = {}, .meaning = {}, .help = {}};
    const auto symbol = symbols.find({kind, number});
    if (symbol != symbols.end()) {
      entry.symbols = symbol->second->name;
      if (symbol->second->whole) entry.symbols += "." + std::string(Info(address.kind).attribute);
      entry.meaning = symbol->second->comment;
    }
    program_.documentation.push_back(std::move(entry));
  }
}

}  // namespace plcxx::classicladder
