// Names of places and instances.

#include "transpiler/dialects/host50/lowering_internal.h"

namespace plcxx::host50 {

/// The first named one of an address names it; the program's own stand before the control's.
void Lowering::CollectSymbols() {
  for (uint32_t i = 0; i < tree_.symbols.size(); ++i) {
    const Symbol& symbol = tree_.symbols[SymbolId(i)];
    if (!symbol.name.empty()) symbols_.emplace(KeyOf(WithoutAttribute(symbol.address)), SymbolId(i));
  }
}

std::string Lowering::SpelledName(const Address& address) const {
  const auto symbol = symbols_.find(KeyOf(WithoutAttribute(address)));
  if (symbol == symbols_.end()) return NameOf(address);
  const std::string attribute = NameOf(address).substr(NameOf(WithoutAttribute(address)).size());
  return tree_.symbols[symbol->second].name + attribute;
}

std::string Lowering::NameInCode(const Address& address) const {
  return host50::NameInCode(SpelledName(address), address, ChannelsOf(program_));
}

ir::PlaceId Lowering::PlaceOf(const Address& address) {
  const auto [found, is_new] = places_.try_emplace(KeyOf(address));
  if (!is_new) return found->second;
  used_.push_back(address);
  ir::Place place;
  if (const auto field = FieldOf(address)) {
    place.type = field->type;
    place.state = InstanceOf(address);
    place.field = field->field;
  } else {
    place = MemoryPlace(address);
  }
  place.name = NameInCode(address);
  if (place.name != NameOf(address)) place.address = NameOf(address);
  const ir::PlaceId id = program_.places.Add(std::move(place));
  places_[KeyOf(address)] = id;
  return id;
}

void Lowering::Store(const Address& address, ir::ValueId value) {
  if (address.area == Area::kQ && address.number >= kFirstAlarm && address.number < kFirstAlarm + kAlarmCount) {
    driven_alarms_.set(address.number - kFirstAlarm);
  }
  builder_.Store(PlaceOf(address), value);
}

ir::StateId Lowering::InstanceOf(const Address& timer_or_counter) {
  const Address address = WithoutAttribute(timer_or_counter);
  const auto [found, is_new] = instances_.try_emplace(KeyOf(address));
  if (is_new) {
    used_.push_back(address);
    const auto field = FieldOf(address);
    PLCXX_CHECK(field.has_value());
    found->second = program_.states.Add({.kind = field->kind, .name = NameInCode(address)});
  }
  return found->second;
}

/// "START_edge", "POSA_3": empty when the instruction keeps no state of its own.
std::string Lowering::OwnName(const Instruction& instruction) const {
  const InstructionInfo& info = Info(instruction.op);
  if (instruction.operands.count == 0) return {};
  const Operand& operand = OperandOf(tree_, instruction, 0);
  if (info.state == State::kEdge) return NameInCode(operand.address) + "_edge";
  if (info.state != State::kAxis) return {};
  const std::string axis = operand.kind == OperandKind::kConstant ? std::to_string(static_cast<int32_t>(operand.bits))
                                                                  : NameInCode(operand.address);
  return std::string(info.name) + "_" + axis;
}

void Lowering::CountOwnNames() {
  for (const Instruction& instruction : tree_.instructions) {
    if (const std::string name = OwnName(instruction); !name.empty()) ++own_names_[name];
  }
}

ir::StateId Lowering::OwnInstance(InstructionId id) {
  const Instruction& instruction = tree_.instructions[id];
  std::string name = OwnName(instruction);
  if (own_names_.at(name) > 1) name = dialects::NameInStatement(name, now_.statement_id);
  const bool edge = Info(instruction.op).state == State::kEdge;
  const ir::StateKind kind = edge ? ir::StateKind::kEdgeMemory : ir::StateKind::kAxisRequest;
  own_instances_[id.index] = program_.states.Add({.kind = kind, .name = std::move(name)});
  if (edge) edges_.push_back(id);
  return own_instances_[id.index];
}

ir::PlaceId Lowering::NewSystemPlace(std::string name, ir::Type type) {
  ir::Space& space = program_.spaces[SystemSpace()];
  ir::Place place{.name = std::move(name), .type = type, .space = SystemSpace(), .offset = space.bytes};
  if (type == ir::Type::kBit) place.bit = 0;
  space.bytes += ir::Bytes(type);
  return program_.places.Add(std::move(place));
}

ir::PlaceId Lowering::NewLocal(std::string name) {
  ir::Space& space = program_.spaces[RoutineSpace()];
  const ir::Place place{
      .name = std::move(name), .type = ir::Type::kI32, .space = RoutineSpace(), .offset = space.bytes};
  space.bytes += ir::Bytes(place.type);
  return program_.places.Add(place);
}

}  // namespace plcxx::host50
