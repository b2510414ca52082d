// Variables: names, places, reads and writes.

#include <algorithm>

#include "transpiler/dialects/classicladder/lowering/internal.h"

namespace plcxx::classicladder {
namespace {

using ir::OpKind;
using ir::ValueId;

constexpr uint32_t kLowByte = 0xFF;

std::pair<uint32_t, uint32_t> KeyOf(const Address& address) {
  return {static_cast<uint32_t>(address.kind), address.number};
}

/// Of a number: the engine keeps the preset and the value of old timers in ms, and shows them in their base.
bool IsTime(const VariableInfo& info) { return info.group == Group::kTimers || info.group == Group::kMonostables; }

bool FitsCode(std::string_view symbol) {
  return std::ranges::all_of(symbol, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

}  // namespace

/// Symbols that two variables have, that look like another variable, or that C++ cannot spell name nothing.
void Lowering::NameSymbols() {
  std::map<std::string_view, uint32_t> uses;
  for (const Symbol& symbol : tree_.symbols) ++uses[symbol.name];
  for (const Symbol& symbol : tree_.symbols) {
    if (uses[symbol.name] > 1 || !FitsCode(symbol.name) || AddressByName(symbol.name)) continue;
    const VariableInfo& info = Info(symbol.address.kind);
    for (const VariableInfo& each : Variables()) {
      const bool same = symbol.whole ? each.name == info.name : each.kind == info.kind;
      if (!same || (symbol.whole && each.attribute.empty())) continue;
      std::string name = symbol.name;
      if (symbol.whole) name += "." + std::string(each.attribute);
      names_.emplace(KeyOf({each.kind, symbol.address.number}), std::move(name));
    }
  }
}

std::string Lowering::NameInCode(const Address& address) const {
  const auto symbol = names_.find(KeyOf(address));
  return symbol == names_.end() ? NameOf(address) : symbol->second;
}

ir::PlaceId Lowering::Named(std::string name, ir::Place place) {
  const auto [found, is_new] = places_.try_emplace(name);
  if (is_new) {
    place.name = std::move(name);
    found->second = program_.places.Add(std::move(place));
  }
  return found->second;
}

ir::PlaceId Lowering::PlaceOf(const Address& address) {
  const VariableInfo& info = Info(address.kind);
  used_.insert(KeyOf(address));
  ir::Place place = PlaceAt(info.group, info.part, IndexOf(address, tree_.sizes));
  std::string name = NameInCode(address);
  if (name != NameOf(address)) place.address = NameOf(address);
  return Named(std::move(name), std::move(place));
}

ir::PlaceId Lowering::FieldOf(Group group, Part part, uint32_t number) {
  for (const VariableInfo& info : Variables()) {
    if (info.group == group && info.part == part) return PlaceOf({info.kind, number});
  }
  PLCXX_UNREACHABLE();
}

ir::PlaceId Lowering::HiddenOf(Group group, Hidden part, uint32_t number) {
  constexpr std::string_view kNames[] = {"base", "input_was", "before", "up_was", "down_was", "part_ms", "started"};
  const auto shown = std::ranges::find(Variables(), group, &VariableInfo::group);  // all of a group have its name
  std::string name = NameOf({shown->kind, number});
  name = name.substr(0, name.find('.')) + "." + std::string(kNames[static_cast<size_t>(part)]);
  return Named(std::move(name), HiddenPlace(group, part, number));
}

ir::PlaceId Lowering::NewSystemPlace(std::string name, ir::Type type) {
  ir::Space& space = program_.spaces[SystemSpace()];
  ir::Place place{.name = std::move(name), .type = type, .space = SystemSpace(), .offset = space.bytes};
  if (type == ir::Type::kBit) place.bit = 0;
  space.bytes += ir::Bytes(ir::Type::kI32);
  return program_.places.Add(std::move(place));
}

ir::PlaceId Lowering::NewLocal(std::string name, ir::Type type) {
  ir::Space& space = program_.spaces[RoutineSpace()];
  ir::Place place{.name = std::move(name), .type = type, .space = RoutineSpace(), .offset = space.bytes};
  if (type == ir::Type::kBit) place.bit = 0;
  space.bytes += ir::Bytes(ir::Type::kI32);
  return program_.places.Add(std::move(place));
}

Lowering::Indexed Lowering::IndexOfVariable(const Variable& variable) {
  const VariableInfo& info = Info(variable.address.kind);
  const uint32_t count = CountOf(info.group, tree_.sizes), stride = StrideOf(info.group);
  ir::Place place = PlaceAt(info.group, info.part, IndexOf(variable.address, tree_.sizes));
  if (place.type == ir::Type::kBit) {
    place.type = ir::Type::kI8;
    place.bit = ir::kNoBit;
  }
  place.indexed = true;
  place.stride = stride;
  place.high = count * stride;
  const ValueId index = ReadNumber({.address = *variable.index, .index = {}, .range = variable.range});
  const uint32_t first = IndexOf(variable.address, tree_.sizes);
  const ValueId reached = builder_.Pure(OpKind::kAdd32, {index, Word(first)});
  // Without a sign: what is below 0 is above everything else.
  builder_.When(builder_.Pure(OpKind::kGreaterEqual32, {reached, Word(count)}), [&] { CallFault(Fault::kIndex); });
  const ir::Type type = place.type;
  return {Named(NameOf(variable.address) + "[]", std::move(place)), index, type};
}

ValueId Lowering::ReadNumber(const Variable& variable) {
  const VariableInfo& info = Info(variable.address.kind);
  if (variable.index) {
    const Indexed at = IndexOfVariable(variable);
    const ValueId value = builder_.Load(at.place, at.index);
    if (at.type == ir::Type::kI8) return builder_.Pure(OpKind::kWiden8To32, {value});
    if (!IsTime(info)) return value;
    return builder_.Pure(OpKind::kSignedDiv32, {value, BaseOf(variable, at.index)});
  }
  const ValueId value = builder_.Load(PlaceOf(variable.address));
  if (IsBit(variable.address.kind)) return builder_.Pure(OpKind::kWiden1To32, {value});
  if (!IsTime(info)) return value;
  return builder_.Pure(OpKind::kSignedDiv32, {value, BaseOf(variable, {})});
}

/// Of old timers and monostables, in ms.
ValueId Lowering::BaseOf(const Variable& variable, ValueId index) {
  const Group group = Info(variable.address.kind).group;
  if (!index.valid()) {
    const auto& presets = group == Group::kTimers ? tree_.timers : tree_.monostables;
    const auto found = presets.find(variable.address.number);
    return Word(found == presets.end() ? Preset{}.base_ms : found->second.base_ms);
  }
  ir::Place base = HiddenPlace(group, Hidden::kBase, variable.address.number);
  base.indexed = true;
  base.stride = StrideOf(group);
  base.high = CountOf(group, tree_.sizes) * base.stride;
  const std::string name = NameOf(variable.address);
  return builder_.Load(Named(name.substr(0, name.find('.')) + ".base[]", std::move(base)), index);
}

/// The engine's elements see 8 bits of what they read.
ValueId Lowering::ReadBit(const Variable& variable) {
  if (!variable.index && IsBit(variable.address.kind)) return builder_.Load(PlaceOf(variable.address));
  const ValueId low =
      builder_.Pure(OpKind::kAnd32, {ReadNumber(variable), builder_.Constant(ir::Type::kI32, kLowByte, 16)});
  return builder_.Pure(OpKind::kNotEqual32, {low, Word(0)});
}

void Lowering::WriteNumber(const Variable& variable, ValueId value) {
  const VariableInfo& info = Info(variable.address.kind);
  if (info.access == Access::kRead) return;
  if (IsBit(variable.address.kind)) {
    const ValueId low = builder_.Pure(OpKind::kAnd32, {value, builder_.Constant(ir::Type::kI32, kLowByte, 16)});
    return WriteBit(variable, builder_.Pure(OpKind::kNotEqual32, {low, Word(0)}));
  }
  if (variable.index) {
    const Indexed at = IndexOfVariable(variable);
    if (IsTime(info)) value = builder_.Pure(OpKind::kMul32, {value, BaseOf(variable, at.index)});
    return builder_.Store(at.place, value, at.index);
  }
  if (IsTime(info)) value = builder_.Pure(OpKind::kMul32, {value, BaseOf(variable, {})});
  builder_.Store(PlaceOf(variable.address), value);
}

void Lowering::WriteBit(const Variable& variable, ValueId bit) {
  const VariableInfo& info = Info(variable.address.kind);
  if (info.access == Access::kRead) return;
  if (!IsBit(variable.address.kind)) return WriteNumber(variable, builder_.Pure(OpKind::kWiden1To32, {bit}));
  if (!variable.index) return builder_.Store(PlaceOf(variable.address), bit);
  const Indexed at = IndexOfVariable(variable);
  const ValueId wide = builder_.Pure(OpKind::kWiden1To32, {bit});
  builder_.Store(at.place, builder_.Pure(OpKind::kLowByte32, {wide}), at.index);
}

void Lowering::Initial(const ir::Place& place, uint32_t value) {
  for (uint32_t i = 0; i < ir::Bytes(place.type); ++i) {
    const auto byte = static_cast<uint8_t>(value >> (8 * i));
    if (byte != 0) program_.spaces[place.space].initial.push_back({.offset = place.offset + i, .value = byte});
  }
}

/// Presets; the time left of old timers; 1 for initial steps. What no line declares has 0 in seconds.
void Lowering::InitialValues() {
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

void Lowering::Document() {
  std::map<std::pair<uint32_t, uint32_t>, const Symbol*> symbols;
  for (const Symbol& symbol : tree_.symbols) {
    symbols.emplace(KeyOf(symbol.address), &symbol);
    used_.insert(KeyOf(symbol.address));
    if (!symbol.whole) continue;
    for (const VariableInfo& each : Variables()) {
      if (each.name == Info(symbol.address.kind).name && !each.attribute.empty()) {
        symbols.emplace(KeyOf({each.kind, symbol.address.number}), &symbol);
        used_.insert(KeyOf({each.kind, symbol.address.number}));
      }
    }
  }
  for (const auto& [kind, number] : used_) {
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
