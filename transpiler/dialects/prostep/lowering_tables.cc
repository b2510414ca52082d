// What declarations become: messages, menu texts, M functions with the NC's part of them (specification 8.2, 8.3, 9).

#include "transpiler/dialects/prostep/lowering_internal.h"

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

void Lowering::Messages() {
  program_.message_bits.push_back(
      {.space = memory_[SpaceKey::kF], .offset = kFirstMessageByte, .first_number = 1, .count = kMessages});
  const bool as_mazovia = settings_.text_encoding == TextEncoding::kMazovia;
  program_.text_encoding = as_mazovia ? source::Encoding::kMazovia : source::Encoding::kUtf8;
  for (const Text& text : tree_.messages) program_.messages.push_back({.number = text.number, .text = text.text});
  for (const Text& text : tree_.menu_texts) program_.menu_texts.push_back({.number = text.number, .text = text.text});
}

void Lowering::SetDeclaredBits(ir::ValueId number, bool value, bool also_static) {
  ir::Switch arms;
  for (const MFunction& function : tree_.m_functions) {
    const ir::RegionId arm = builder_.RegionOf([&] {
      if (also_static && function.static_bit != 0) {
        builder_.Store(BitPlace(Flag(kFirstStaticByte, function.static_bit - 1u)), builder_.Bit(value ? 1 : 0));
      }
      if (function.dynamic_bit != 0) {
        builder_.Store(BitPlace(Flag(kFirstDynamicByte, function.dynamic_bit - 1u)), builder_.Bit(value ? 1 : 0));
      }
    });
    if (!program_.regions[arm].insts.empty()) arms.cases.push_back({.values = {function.number}, .region = arm});
  }
  arms.cases.push_back({.values = {}, .region = builder_.NewRegion()});
  if (arms.cases.size() > 1) builder_.SwitchOn(number, std::move(arms));
}

/// The table, and what a host calls that plays the NC.
void Lowering::MFunctions() {
  if (tree_.m_functions.empty()) return;
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

  const ir::RoutineId begin = builder_.AddRoutine(
      "m_begin", ir::RoutineKind::kSchedule, "The NC begins to send an M function: number, strobe and declared bits.");
  const ir::PlaceId begun = AddParameter(begin, "number", Type::kI8);
  builder_.SetRange({});
  builder_.SetRegion(program_.routines[begin].body);
  const ir::ValueId number = builder_.Load(begun);
  StoreAt(Space::kF, kMNumberByte, Type::kI8, builder_.Pure(OpKind::kToBcd8, {number}));
  builder_.Store(BitPlace(Flag(kMStrobeByte, 0)), builder_.Bit(1));
  SetDeclaredBits(number, true, true);

  const ir::RoutineId end = builder_.AddRoutine(
      "m_end", ir::RoutineKind::kSchedule,
      "The NC has sent an M function: strobe and dynamic bit go, a static bit is cleared by the program.");
  const ir::PlaceId ended = AddParameter(end, "number", Type::kI8);
  builder_.SetRegion(program_.routines[end].body);
  builder_.Store(BitPlace(Flag(kMStrobeByte, 0)), builder_.Bit(0));
  SetDeclaredBits(builder_.Load(ended), false, false);
}

}  // namespace plcxx::prostep
