#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

Translation::Translation(const Program& program_tree, const Settings& options, const source::SourceManager& files)
    : TranslationFrame(program_tree, options, files) {
  program.dialect = "host50";
  AddSpaces(program, settings.channels);
}

Context::Context(Translation& translation) : ContextFrame(translation), now_(translation.now) {}

const Operand& Context::OperandOf(const Instruction& instruction, uint32_t index) const {
  PLCXX_CHECK(index < instruction.operands.count);
  return tree_.operands[instruction.operands.first + index];
}

}  // namespace plcxx::host50
