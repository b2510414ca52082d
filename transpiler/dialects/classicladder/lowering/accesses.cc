#include "transpiler/dialects/classicladder/lowering/accesses.h"

#include <string>

namespace plcxx::classicladder {

using ir::OpKind;
using ir::ValueId;

namespace {

constexpr uint32_t kLowByte = 0xFF;

/// Of a number: the engine keeps the preset and the value of old timers in ms, and shows them in their base.
bool IsTime(const VariableInfo& info) { return info.group == Group::kTimers || info.group == Group::kMonostables; }

}  // namespace

Accesses::Indexed Accesses::At(const Variable& variable) {
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
  builder_.When(builder_.Pure(OpKind::kGreaterEqual32, {reached, Word(count)}), [&] { faults_.Report(Fault::kIndex); });
  const ir::Type type = place.type;
  return {places_.Named(NameOf(variable.address) + "[]", std::move(place)), index, type};
}

ValueId Accesses::ReadNumber(const Variable& variable) {
  const VariableInfo& info = Info(variable.address.kind);
  if (variable.index) {
    const Indexed at = At(variable);
    const ValueId value = builder_.Load(at.place, at.index);
    if (at.type == ir::Type::kI8) return builder_.Pure(OpKind::kWiden8To32, {value});
    if (!IsTime(info)) return value;
    return builder_.Pure(OpKind::kSignedDiv32, {value, BaseOf(variable, at.index)});
  }
  const ValueId value = builder_.Load(places_.Of(variable.address));
  if (IsBit(variable.address.kind)) return builder_.Pure(OpKind::kWiden1To32, {value});
  if (!IsTime(info)) return value;
  return builder_.Pure(OpKind::kSignedDiv32, {value, BaseOf(variable, {})});
}

/// Of old timers and monostables, in ms.
ValueId Accesses::BaseOf(const Variable& variable, ValueId index) {
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
  return builder_.Load(places_.Named(name.substr(0, name.find('.')) + ".base[]", std::move(base)), index);
}

/// The engine's elements see 8 bits of what they read.
ValueId Accesses::ReadBit(const Variable& variable) {
  if (!variable.index && IsBit(variable.address.kind)) return builder_.Load(places_.Of(variable.address));
  const ValueId low =
      builder_.Pure(OpKind::kAnd32, {ReadNumber(variable), builder_.Constant(ir::Type::kI32, kLowByte, 16)});
  return builder_.Pure(OpKind::kNotEqual32, {low, Word(0)});
}

void Accesses::WriteNumber(const Variable& variable, ValueId value) {
  const VariableInfo& info = Info(variable.address.kind);
  if (info.access == Access::kRead) return;
  if (IsBit(variable.address.kind)) {
    const ValueId low = builder_.Pure(OpKind::kAnd32, {value, builder_.Constant(ir::Type::kI32, kLowByte, 16)});
    return WriteBit(variable, builder_.Pure(OpKind::kNotEqual32, {low, Word(0)}));
  }
  if (variable.index) {
    const Indexed at = At(variable);
    if (IsTime(info)) value = builder_.Pure(OpKind::kMul32, {value, BaseOf(variable, at.index)});
    return builder_.Store(at.place, value, at.index);
  }
  if (IsTime(info)) value = builder_.Pure(OpKind::kMul32, {value, BaseOf(variable, {})});
  builder_.Store(places_.Of(variable.address), value);
}

void Accesses::WriteBit(const Variable& variable, ValueId bit) {
  const VariableInfo& info = Info(variable.address.kind);
  if (info.access == Access::kRead) return;
  if (!IsBit(variable.address.kind)) return WriteNumber(variable, builder_.Pure(OpKind::kWiden1To32, {bit}));
  if (!variable.index) return builder_.Store(places_.Of(variable.address), bit);
  const Indexed at = At(variable);
  const ValueId wide = builder_.Pure(OpKind::kWiden1To32, {bit});
  builder_.Store(at.place, builder_.Pure(OpKind::kLowByte32, {wide}), at.index);
}

}  // namespace plcxx::classicladder
