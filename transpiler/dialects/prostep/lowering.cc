// Being written: gives an empty program.
#include "transpiler/dialects/prostep/lowering.h"

namespace plcxx::prostep {

ir::Program Lower(const Program& /*tree*/, const Settings& /*settings*/, const source::SourceManager& /*sources*/,
                  diag::Engine& /*diagnostics*/) {
  return {};
}

}  // namespace plcxx::prostep
