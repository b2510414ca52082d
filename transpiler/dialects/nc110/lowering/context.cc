#include "transpiler/dialects/nc110/lowering/context.h"

namespace plcxx::nc110 {

Translation::Translation(const Program& program_tree, const Settings& options, const source::SourceManager& files)
    : TranslationFrame(program_tree, options, files) {
  program.dialect = "nc110";
  const size_t statements = tree.statement_count, exprs = tree.exprs.size();
  program.statements.Reserve(statements);
  program.insts.Reserve(exprs + 4 * statements + 64);
  program.regions.Reserve(2 * size_t{tree.blocks.size()} + tree.mux_inputs.size() + 16);
  AddSpaces(program, settings.processes, settings.t_initial, settings.external);
}

Context::Context(Translation& translation) : ContextFrame(translation), part_(translation.part) {}

}  // namespace plcxx::nc110
