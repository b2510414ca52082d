// What every part of the lowering works on: the tree and what is known of it, the program that is made, and where in
// both it is.
//
// Every module is a routine. S and AX are registers (dialects/common/register.h) that begin as 0 where only the
// scheduler enters a module; a module that is called shares the places of its caller.
#pragma once

#include <initializer_list>
#include <vector>

#include "transpiler/dialects/common/translation.h"
#include "transpiler/dialects/prostep/machine/memory.h"
#include "transpiler/dialects/prostep/machine/options.h"
#include "transpiler/dialects/prostep/syntax/syntax.h"

namespace plcxx::prostep {

/// The modules as routines.
class Modules {
 public:
  explicit Modules(const Program& tree);

  /// Whether calls enter the module; then S and AX are its caller's.
  bool IsCalled(ModuleId module) const { return called_[module.index]; }
  /// Does the program jump backward somewhere?
  bool loops() const { return loops_; }
  ir::RoutineId& RoutineOf(ModuleId module) { return routines_[module.index]; }

 private:
  std::vector<bool> called_;             // by ModuleId
  std::vector<ir::RoutineId> routines_;  // by ModuleId
  bool loops_ = false;
};

/// One tree on its way to a program.
struct Translation : dialects::TranslationFrame<Program, Settings> {
  Translation(const Program& program_tree, const Settings& options, const source::SourceManager& files);

  Memory memory;
  Modules modules{tree};
  const Module* module = nullptr;  // the one that is lowered
};

/// What a part of the lowering sees of it. Refers to the translation, and may be copied.
class Context : protected dialects::ContextFrame<Program, Settings> {
 public:
  explicit Context(Translation& translation);

 protected:
  const Operand& Argument(const Instruction& instruction, uint32_t index) const {
    return tree_.Argument(instruction, index);
  }
  ModuleId ModuleOf(uint32_t number) const { return tree_.module_of[number]; }
  /// The module that is lowered.
  const Module& module() const { return *module_; }
  ir::ValueId Byte(uint32_t value) const { return builder_.Constant(ir::Type::kI8, value & 0xFF); }
  ir::ValueId Word(uint32_t value) const { return builder_.Constant(ir::Type::kI16, value & 0xFFFF); }
  ir::ValueId Number(uint32_t value) const { return builder_.Constant(ir::Type::kI32, value); }
  ir::ValueId Pure(ir::OpKind op, std::initializer_list<ir::ValueId> operands) const {
    return builder_.Pure(op, operands);
  }

  const Memory& memory_;
  Modules& modules_;
  const Module*& module_;
};

}  // namespace plcxx::prostep
