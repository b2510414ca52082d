#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {
namespace {

Memory::Sizes SizesOf(const Program& tree) {
  Memory::Sizes sizes{.user = static_cast<uint32_t>(tree.user_data.size()), .mechanisms = 0, .steps = 1};
  for (const Unit& unit : tree.units) {
    if (unit.kind == UnitKind::kMechanism) ++sizes.mechanisms;
    sizes.steps += 2 * (1 + unit.timers);
  }
  return sizes;
}

}  // namespace

Translation::Translation(const Flow& paths, const Settings& options, const source::SourceManager& files)
    : TranslationFrame(paths.program(), options, files), flow(paths), memory(program, SizesOf(paths.program())) {}

Context::Context(Translation& translation)
    : ContextFrame(translation),
      flow_(translation.flow),
      registers_(translation.registers),
      memory_(translation.memory),
      routines_(translation.routines),
      frame_(translation.frame) {}

}  // namespace plcxx::technol
