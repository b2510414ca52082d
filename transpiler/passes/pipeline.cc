#include "transpiler/passes/pipeline.h"

#include "transpiler/passes/fold_constants.h"
#include "transpiler/passes/remove_dead.h"

namespace plcxx::passes {

void Optimize(ir::Program& program) {
  FoldConstants(program);  // before RemoveDead: a folded operation leaves dead operands
  RemoveDead(program);     // last: Structure and FoldConstants both leave values that nothing uses
}

}  // namespace plcxx::passes
