#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

Modules::Modules(const Program& tree) : called_(tree.modules.size()), routines_(tree.modules.size()) {
  for (const Instruction& instruction : tree.instructions) {
    if (instruction.module.valid()) called_[instruction.module.index] = true;
  }
  for (uint32_t i = 0; i < tree.instructions.size(); ++i) {
    const Instruction& instruction = tree.instructions[InstructionId(i)];
    if (instruction.target.valid() && tree.labels[instruction.target].at.index <= i) loops_ = true;
  }
}

Translation::Translation(const Program& program_tree, const Settings& options, const source::SourceManager& files)
    : TranslationFrame(program_tree, options, files),
      memory(program, options.first_retentive, options.last_retentive) {}

Context::Context(Translation& translation)
    : ContextFrame(translation),
      memory_(translation.memory),
      modules_(translation.modules),
      module_(translation.module) {}

}  // namespace plcxx::prostep
