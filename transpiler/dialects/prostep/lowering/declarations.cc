#include "transpiler/dialects/prostep/lowering/declarations.h"

#include <utility>

#include "transpiler/dialects/prostep/lowering/cells.h"
#include "transpiler/dialects/prostep/lowering/locals.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::Type;

namespace {

constexpr uint32_t kMStrobeByte = 200, kMNumberByte = 201;           // F 200.0, FB 201
constexpr uint32_t kFirstStaticByte = 208, kFirstDynamicByte = 211;  // F 208.0, F 211.0 are function 1

constexpr Operand Flag(uint32_t first_byte, uint32_t index) {
  return {.kind = OperandClass::kF,
          .bit = static_cast<uint8_t>(index % 8),
          .number = static_cast<uint16_t>(first_byte + index / 8)};
}

}  // namespace

void Declarations::AddInitialData() {
  const auto bytes = InitialData(tree_);
  for (uint32_t address = 0; address < bytes.size(); ++address) {
    if (bytes[address] == 0) continue;
    const Cell cell = memory_.At(Space::kD, address);
    program_.spaces[cell.space].initial.push_back({.offset = cell.offset, .value = bytes[address]});
  }
}

void Declarations::AddMessages() {
  program_.message_bits.push_back(
      {.space = memory_[SpaceKey::kF], .offset = kFirstMessageByte, .first_number = 1, .count = kMessages});
  const bool as_mazovia = settings_.text_encoding == TextEncoding::kMazovia;
  program_.text_encoding = as_mazovia ? source::Encoding::kMazovia : source::Encoding::kUtf8;
  for (const Text& text : tree_.messages) program_.messages.push_back({.number = text.number, .text = text.text});
  for (const Text& text : tree_.menu_texts) program_.menu_texts.push_back({.number = text.number, .text = text.text});
}

/// An arm for each one for which `fill` does something.
template <class Fill>
void Declarations::ForEachFunction(ir::ValueId number, Fill&& fill) {
  ir::Switch arms;
  for (const MFunction& function : tree_.m_functions) {
    const ir::RegionId arm = builder_.RegionOf([&] { fill(function); });
    if (!program_.regions[arm].insts.empty()) arms.cases.push_back({.values = {function.number}, .region = arm});
  }
  arms.cases.push_back({.values = {}, .region = builder_.NewRegion()});
  if (arms.cases.size() > 1) builder_.SwitchOn(number, std::move(arms));
}

void Declarations::SetBits(ir::ValueId number) {
  ForEachFunction(number, [&](const MFunction& function) {
    if (function.static_bit != 0) {
      builder_.Store(cells_.Bit(Flag(kFirstStaticByte, function.static_bit - 1u)), builder_.Bit(1));
    }
    if (function.dynamic_bit != 0) {
      builder_.Store(cells_.Bit(Flag(kFirstDynamicByte, function.dynamic_bit - 1u)), builder_.Bit(1));
    }
  });
}

void Declarations::ClearDynamicBit(ir::ValueId number) {
  ForEachFunction(number, [&](const MFunction& function) {
    if (function.dynamic_bit == 0) return;
    builder_.Store(cells_.Bit(Flag(kFirstDynamicByte, function.dynamic_bit - 1u)), builder_.Bit(0));
  });
}

void Declarations::AddMFunctions() {
  if (tree_.m_functions.empty()) return;
  AddTable();
  AddBegin();
  AddEnd();
}

void Declarations::AddTable() {
  ir::Table table{.name = "m_functions",
                  .comment =
                      "M functions: sent after the move of the block, static bit 1 to 24 (F 208.0 ...), dynamic bit "
                      "1 to 16 (F 211.0 ...), 0 = none.",
                  .columns = {{.name = "number", .type = Type::kI8, .enumerators = {}},
                              {.name = "after_move", .type = Type::kBit, .enumerators = {}},
                              {.name = "static_bit", .type = Type::kI8, .enumerators = {}},
                              {.name = "dynamic_bit", .type = Type::kI8, .enumerators = {}}},
                  .cells = {}};
  for (const MFunction& function : tree_.m_functions) {
    table.cells.insert(table.cells.end(),
                       {function.number, function.after_move ? 1u : 0u, function.static_bit, function.dynamic_bit});
  }
  program_.tables.push_back(std::move(table));
}

void Declarations::AddBegin() {
  const ir::RoutineId begin = builder_.AddRoutine(
      "m_begin", ir::RoutineKind::kSchedule, "The NC begins to send an M function: number, strobe and declared bits.");
  const ir::PlaceId begun = locals_.AddParameter(begin, "number", Type::kI8);
  builder_.SetRange({});
  builder_.SetRegion(program_.routines[begin].body);
  const ir::ValueId number = builder_.Load(begun);
  cells_.Store(Space::kF, kMNumberByte, Type::kI8, Pure(OpKind::kToBcd8, {number}));
  builder_.Store(cells_.Bit(Flag(kMStrobeByte, 0)), builder_.Bit(1));
  SetBits(number);
}

void Declarations::AddEnd() {
  const ir::RoutineId end = builder_.AddRoutine(
      "m_end", ir::RoutineKind::kSchedule,
      "The NC has sent an M function: strobe and dynamic bit go, a static bit is cleared by the program.");
  const ir::PlaceId ended = locals_.AddParameter(end, "number", Type::kI8);
  builder_.SetRegion(program_.routines[end].body);
  builder_.Store(cells_.Bit(Flag(kMStrobeByte, 0)), builder_.Bit(0));
  ClearDynamicBit(builder_.Load(ended));
}

}  // namespace plcxx::prostep
