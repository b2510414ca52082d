#include "transpiler/passes/pipeline.h"

#include "transpiler/passes/fold_constants.h"
#include "transpiler/passes/remove_dead.h"
#include "transpiler/passes/remove_dead_locals.h"
#include "transpiler/passes/splice_constant_ifs.h"

namespace plcxx::passes {

void Optimize(ir::Program& program) {
  FoldConstants(program);      // before RemoveDead: a folded operation leaves dead operands
  SpliceConstantIfs(program);  // before RemoveDead: its condition, and what only the other arm used, are dead
  RemoveDead(program);         // Structure and FoldConstants both leave values that nothing uses
  RemoveDeadLocals(program);
  RemoveDead(program);  // what only a dead local kept
}

}  // namespace plcxx::passes
