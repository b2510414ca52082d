#include "transpiler/dialects/host50/lowering.h"

namespace plcxx::host50 {

ir::Program Lower(const Program& tree, const Settings& settings, const source::SourceManager& sources) {
  static_cast<void>(tree), static_cast<void>(settings), static_cast<void>(sources);
  return {};
}

}  // namespace plcxx::host50
