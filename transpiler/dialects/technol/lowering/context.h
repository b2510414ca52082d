// What every part of the lowering works on: the tree and what is known of it, the program that is made, and where in
// both it is.
//
// RLO, registers and flags are registers in the sense of dialects/common: modules and mechanisms begin with zeros in
// them, subprograms share those of their callers.
#pragma once

#include <initializer_list>

#include "transpiler/dialects/common/translation.h"
#include "transpiler/dialects/technol/analysis/flow.h"
#include "transpiler/dialects/technol/lowering/register_file.h"
#include "transpiler/dialects/technol/lowering/routines.h"
#include "transpiler/dialects/technol/lowering/value_builder.h"
#include "transpiler/dialects/technol/machine/memory.h"
#include "transpiler/dialects/technol/machine/options.h"

namespace plcxx::technol {

/// The instruction that is being lowered, and where it is.
struct Frame {
  const Routine* routine = nullptr;  // none: the schedule around them
  InstructionId now;
  uint32_t width = 16;         // of DR before it
  Resources wanted_flags = 0;  // read on some path after it
  ir::StatementId statement;
};

/// One operation in its three widths.
struct ByWidth {
  ir::OpKind narrow, word, wide;
  ir::OpKind At(uint32_t width) const { return width == 8 ? narrow : width == 16 ? word : wide; }
};

/// Which way a shift or a rotation goes.
enum class Turn : uint8_t { kLeft, kRight };

/// One tree on its way to a program.
struct Translation : dialects::TranslationFrame<Program, Settings, ValueBuilder> {
  Translation(const Flow& paths, const Settings& options, const source::SourceManager& files);

  const Flow& flow;
  RegisterFile registers{builder, facts};
  Memory memory;
  Routines routines{flow, settings};
  Frame frame;
};

/// What a part of the lowering sees of it. Refers to the translation, and may be copied.
class Context : protected dialects::ContextFrame<Program, Settings, ValueBuilder> {
 public:
  explicit Context(Translation& translation);

 protected:
  const Operand& OperandOf(const Instruction& instruction, uint32_t index) const {
    return tree_.OperandOf(instruction, index);
  }
  ir::ValueId Pure(ir::OpKind op, std::initializer_list<ir::ValueId> operands) const {
    return builder_.Pure(op, operands);
  }
  bool IsMechanism(const Routine& routine) const {
    return routine.unit.valid() && tree_.units[routine.unit].kind == UnitKind::kMechanism;
  }

  const Flow& flow_;
  RegisterFile& registers_;
  const Memory& memory_;
  Routines& routines_;
  Frame& frame_;
};

}  // namespace plcxx::technol
