#include "transpiler/dialects/nc110/machine/places.h"

#include <string_view>
#include <vector>

#include "transpiler/dialects/nc110/machine/machine.h"

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

const FieldRow* FieldOf(OperandKind kind) {
  for (const FieldRow& row : kFields) {
    if (row.operand == kind) return &row;
  }
  return nullptr;
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

}  // namespace plcxx::nc110
