#include "transpiler/passes/pipeline.h"

#include "transpiler/passes/fold_constants.h"
#include "transpiler/passes/remove_dead.h"
#include "transpiler/passes/remove_dead_locals.h"

namespace plcxx::passes {

void Optimize(ir::Program& program) {
  FoldConstants(program);  // before RemoveDead: a folded operation leaves dead operands
  RemoveDead(program);     // Structure and FoldConstants both leave values that nothing uses
  RemoveDeadLocals(program);
  RemoveDead(program);  // what only a dead local kept
}

}  // namespace plcxx::passes
