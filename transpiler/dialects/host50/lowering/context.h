// What every part of the lowering works on: the tree, the program that is made, and where in both it is.
#pragma once

#include <vector>

#include "transpiler/dialects/common/translation.h"
#include "transpiler/dialects/host50/machine/places.h"
#include "transpiler/dialects/host50/syntax/syntax.h"

namespace plcxx::host50 {

/// What is being lowered.
struct Position {
  SectionId section;
  NetworkId network;
  ir::PlaceId jumps_left;  // none: the section has no way back
  uint32_t end_label = 0;
  bool end_is_used = false;
  uint32_t period_ms = 1;
  uint32_t statement_id = 0;
};

/// One tree on its way to a program.
struct Translation : dialects::TranslationFrame<Program, Settings> {
  Translation(const Program& program_tree, const Settings& options, const source::SourceManager& files);

  Position now;
};

/// What a part of the lowering sees of it. Refers to the translation, and may be copied.
class Context : protected dialects::ContextFrame<Program, Settings> {
 public:
  explicit Context(Translation& translation);

 protected:
  const Operand& OperandOf(const Instruction& instruction, uint32_t index) const;
  /// The instructions whose results an instruction takes.
  template <class Visit>
  void ForEachTaken(const Instruction& instruction, Visit&& visit) const;
  ir::ValueId Word(uint32_t value) const { return builder_.Constant(ir::Type::kI32, value); }

  Position& now_;
};

/// One number for each address.
constexpr uint32_t KeyOf(const Address& address) {
  return static_cast<uint32_t>(address.area) << 20 | static_cast<uint32_t>(address.attribute) << 18 | address.number;
}

template <class Visit>
void Context::ForEachTaken(const Instruction& instruction, Visit&& visit) const {
  for (uint32_t i = 0; i < instruction.input.results.count; ++i) {
    if (instruction.input.kind == InputKind::kResults) visit(tree_.results[instruction.input.results.first + i]);
  }
  if (instruction.other.valid()) visit(instruction.other);
  for (uint32_t i = 0; i < instruction.pins.count; ++i) {
    const Pin& pin = tree_.pins[instruction.pins.first + i];
    if (pin.from_stack) visit(pin.result);
  }
}

}  // namespace plcxx::host50
