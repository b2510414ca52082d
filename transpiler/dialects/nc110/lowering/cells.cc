#include "transpiler/dialects/nc110/lowering/cells.h"

#include <utility>

#include "transpiler/dialects/nc110/machine/places.h"

namespace plcxx::nc110 {
namespace {

/// I becomes U: they are one bit.
constexpr Operand AsOutput(Operand operand) {
  if (operand.kind == OperandKind::kInput) operand.kind = OperandKind::kOutput;
  return operand;
}

}  // namespace

Cells::Cells(const Context& context) : Context(context) {
  for (uint32_t i = 0; i < tree_.symbols.size(); ++i) {
    const Operand& operand = tree_.symbols[SymbolId(i)].operand;
    symbols_.emplace(KeyOf(operand), SymbolId(i));
    bit_symbols_.emplace(KeyOf(AsOutput(operand)), SymbolId(i));
  }
}

Operand Cells::AsNamed(const Operand& operand) const {
  if (symbols_.contains(KeyOf(operand))) return operand;
  const auto found = bit_symbols_.find(KeyOf(AsOutput(operand)));
  return found == bit_symbols_.end() ? operand : tree_.symbols[found->second].operand;
}

ir::Place Cells::MakePlace(const Operand& operand) {
  ir::Place place;
  if (IsMemory(operand)) {
    place = MemoryPlace(operand);
  } else {
    const auto field = FieldOfOperand(operand);
    PLCXX_CHECK(field.has_value());
    place.state = InstanceOf(operand);
    place.field = field->field;
    place.type = operand.kind == OperandKind::kCounterValue ? ir::Type::kI8 : ir::Type::kBit;
  }
  place.name = ToText(operand);
  const auto symbol = symbols_.find(KeyOf(operand));
  if (symbol != symbols_.end()) {
    place.address = tree_.symbols[symbol->second].name;
    std::swap(place.name, place.address);
  }
  return place;
}

ir::PlaceId Cells::PlaceOf(const Operand& spelled) {
  const Operand operand = AsNamed(spelled);
  const auto [found, is_new] = places_.try_emplace(KeyOf(operand));
  if (is_new) found->second = program_.places.Add(MakePlace(operand));
  return found->second;
}

ir::StateId Cells::InstanceOf(const Operand& operand) {
  const auto field = FieldOfOperand(operand);
  PLCXX_CHECK(field.has_value());
  const uint32_t key = static_cast<uint32_t>(field->kind) << 16 | operand.number;
  const auto [found, is_new] = instances_.try_emplace(key);
  if (is_new) found->second = program_.states.Add({.kind = field->kind, .name = field->instance});
  return found->second;
}

}  // namespace plcxx::nc110
