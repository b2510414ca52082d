// Operands as places of the memory map, timers and counters as state instances.

#include "transpiler/dialects/nc110/lowering_internal.h"

namespace plcxx::nc110 {
namespace {

struct FieldRow {
  OperandKind operand;
  ir::StateKind state;
  std::string_view field;
};
constexpr FieldRow kFields[] = {
    {OperandKind::kTimerInput, ir::StateKind::kOnDelayTimer, "input"},
    {OperandKind::kTimerHold, ir::StateKind::kOnDelayTimer, "hold"},
    {OperandKind::kTimerElapsed, ir::StateKind::kOnDelayTimer, "done"},
    {OperandKind::kTimerRunning, ir::StateKind::kOnDelayTimer, "timing"},
    {OperandKind::kCounterInput, ir::StateKind::kRingCounter, "input"},
    {OperandKind::kCounterCarry, ir::StateKind::kRingCounter, "carry"},
    {OperandKind::kCounterReset, ir::StateKind::kRingCounter, "reset"},
    {OperandKind::kCounterDown, ir::StateKind::kRingCounter, "down"},
    {OperandKind::kCounterValue, ir::StateKind::kRingCounter, "count"},
    {OperandKind::kOneShot, ir::StateKind::kOneShot, "pulse"},
};

struct SystemRow {
  SystemPlace place;
  std::string_view name;
  ir::Type type;
  uint32_t offset;
  uint8_t bit;
};
constexpr SystemRow kSystem[] = {
    {SystemPlace::kNow, "now", ir::Type::kI32, 0, ir::kNoBit},
    {SystemPlace::kSlowCycle, "slow_cycle", ir::Type::kI32, 4, ir::kNoBit},
    {SystemPlace::kSlowDone, "slow_done", ir::Type::kI32, 8, ir::kNoBit},
    {SystemPlace::kFastCount, "fast_count", ir::Type::kI32, 12, ir::kNoBit},
    {SystemPlace::kSlice, "next_slice", ir::Type::kI8, 16, ir::kNoBit},
    {SystemPlace::kSlowOpen, "slow_open", ir::Type::kI8, 17, ir::kNoBit},
    {SystemPlace::kPowerWas, "u10k0_was", ir::Type::kBit, 18, 0},
    {SystemPlace::kSaveWas, "u10n4_was", ir::Type::kBit, 18, 1},
};

const FieldRow* FieldOf(OperandKind kind) {
  for (const FieldRow& row : kFields) {
    if (row.operand == kind) return &row;
  }
  return nullptr;
}

/// "START 1" -> "TEXT_START_1"; texts that differ only in what a name cannot hold are told apart by a hash.
std::string NameOfText(std::string_view text) {
  std::string name = "TEXT_";
  bool exact = true;
  dialects::TextHash hash;
  for (const char c : text) {
    hash.Add(c);
    const bool safe = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    exact = exact && safe;
    name.push_back(safe ? c : '_');
  }
  if (exact) return name;
  return dialects::NameInStatement(name, hash.value());
}

}  // namespace

std::optional<InstanceField> FieldOfOperand(const Operand& operand) {
  const FieldRow* row = FieldOf(operand.kind);
  if (row == nullptr) return std::nullopt;
  static const std::vector<uint8_t> fields = [] {
    std::vector<uint8_t> indices;
    for (const FieldRow& each : kFields) indices.push_back(ir::FieldIndex(each.state, each.field));
    return indices;
  }();
  const char letter = row->state == ir::StateKind::kOnDelayTimer ? 'T'
                      : row->state == ir::StateKind::kOneShot    ? 'P'
                                                                 : 'C';
  return InstanceField{.kind = row->state,
                       .field = fields[static_cast<size_t>(row - kFields)],
                       .instance = letter + std::to_string(operand.number)};
}

ir::Place MemoryPlace(const Operand& operand) {
  const bool word = operand.kind == OperandKind::kWord;
  return {.type = word ? ir::Type::kI8 : ir::Type::kBit,
          .space = SpaceOf(operand.package),
          .offset = ByteOf(operand),
          .bit = word ? ir::kNoBit : static_cast<uint8_t>(operand.index % 8)};
}

void Lowering::CollectSymbols() {
  for (uint32_t i = 0; i < tree_.symbols.size(); ++i) {
    const Operand& operand = tree_.symbols[SymbolId(i)].operand;
    symbols_.emplace(KeyOf(operand), SymbolId(i));
    bit_symbols_.emplace(KeyOf(AsOutput(operand)), SymbolId(i));
  }
}

Operand Lowering::AsNamed(const Operand& operand) const {
  if (symbols_.contains(KeyOf(operand))) return operand;
  const auto found = bit_symbols_.find(KeyOf(AsOutput(operand)));
  return found == bit_symbols_.end() ? operand : tree_.symbols[found->second].operand;
}

ir::Place Lowering::MakePlace(const Operand& operand) {
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

ir::PlaceId Lowering::PlaceOf(const Operand& spelled) {
  const Operand operand = AsNamed(spelled);
  const auto [found, is_new] = places_.try_emplace(KeyOf(operand));
  if (is_new) found->second = program_.places.Add(MakePlace(operand));
  return found->second;
}

bool Lowering::HasLatchedCopy(const Operand& operand) const {
  return settings_.latch_slow_inputs && sliced() && IsMemory(operand) &&
         DirectionOf(operand.package, operand.number, settings_.processes) == ir::Direction::kInput;
}

ir::PlaceId Lowering::LatchedPlaceOf(const Operand& spelled) {
  const Operand operand = AsNamed(spelled);
  const auto [found, is_new] = latched_.try_emplace(KeyOf(operand));
  if (is_new) {
    ir::Place place = program_.places[PlaceOf(operand)];
    place.name += "_latched";
    place.address = ToText(operand);
    place.space = SpaceOf(SpaceIndex::kLatched);
    place.offset += PackageBase(operand.package);
    found->second = program_.places.Add(std::move(place));
    latch_order_.push_back(operand);
  }
  return found->second;
}

ir::PlaceId Lowering::ReadPlaceOf(const Operand& operand) {
  return part_ == Part::kSlow && HasLatchedCopy(operand) ? LatchedPlaceOf(operand) : PlaceOf(operand);
}

ir::StateId Lowering::InstanceOf(const Operand& operand) {
  const auto field = FieldOfOperand(operand);
  PLCXX_CHECK(field.has_value());
  const uint32_t key = static_cast<uint32_t>(field->kind) << 16 | operand.number;
  const auto [found, is_new] = instances_.try_emplace(key);
  if (is_new) found->second = program_.states.Add({.kind = field->kind, .name = field->instance});
  return found->second;
}

ir::PlaceId Lowering::FlagOf(LiteralId literal) {
  ir::PlaceId& flag = flags_[literal.index];
  if (flag.valid()) return flag;
  if (!program_.text_inbox.valid()) {
    program_.text_inbox = program_.states.Add({.kind = ir::StateKind::kTextInbox, .name = "operator_text"});
  }
  std::string name = NameOfText(sources_.Text(tree_.literals[literal].range));
  const ir::StateId state = program_.states.Add({.kind = ir::StateKind::kTextFlag, .name = name});
  ir::Place place{.name = std::move(name), .type = ir::Type::kBit, .state = state};
  place.field = ir::FieldIndex(ir::StateKind::kTextFlag, "flag");
  flag = program_.places.Add(std::move(place));
  return flag;
}

ir::PlaceId Lowering::SystemPlaceOf(SystemPlace place) {
  ir::PlaceId& id = system_[static_cast<size_t>(place)];
  if (!id.valid()) {
    const SystemRow& row = kSystem[static_cast<size_t>(place)];
    PLCXX_CHECK(row.place == place);
    id = program_.places.Add({.name = std::string(row.name),
                              .type = row.type,
                              .space = SpaceOf(SpaceIndex::kSystem),
                              .offset = row.offset,
                              .bit = row.bit});
  }
  return id;
}

}  // namespace plcxx::nc110
