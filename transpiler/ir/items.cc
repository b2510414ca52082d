#include "transpiler/ir/items.h"

#include "transpiler/ir/builder.h"

namespace plcxx::ir {
namespace {

/// Whether the loop is in the region; `statement` then is the one whose part it is.
bool FindStatement(const Program& program, RegionId region, InstId loop, StatementId& statement) {
  if (!region.valid()) return false;
  for (const InstId id : program.regions[region].insts) {
    const Inst& inst = program[id];
    if (id == loop) return true;
    if (inst.op == OpKind::kStatement) statement = StatementId(inst.payload);
    for (const RegionId owned : OwnedRegions(program, inst)) {
      StatementId inside = statement;
      if (!FindStatement(program, owned, loop, inside)) continue;
      statement = inside;
      return true;
    }
  }
  return false;
}

}  // namespace

StatementId StatementOfLoop(const Program& program, InstId loop) {
  const Loop& parts = program.loops[LoopId(program[loop].payload)];
  const std::vector<InstId>& body = program.regions[parts.body].insts;
  // A jump back has no head: it repeats the statements from its label on.
  const bool is_jump = !parts.condition.valid() && !body.empty() && program[body.front()].op == OpKind::kStatement;
  if (is_jump) return StatementId(program[body.front()].payload);
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const Routine& routine = program.routines[RoutineId(i)];
    for (const RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      StatementId statement;
      if (FindStatement(program, region, loop, statement)) return statement;
    }
  }
  return {};
}

std::vector<Item> Items(const Program& program, RegionId region) {
  std::vector<Item> items;
  const std::vector<InstId>& insts = program.regions[region].insts;
  for (uint32_t i = 0; i < insts.size(); ++i) {
    const Inst& inst = program[insts[i]];
    const bool marker = inst.op == OpKind::kStatement;
    const StatementId statement = marker ? StatementId(inst.payload) : StatementId();
    if (items.empty() || (marker && !program.statements[statement].closes_block)) {
      items.push_back({i, i + 1, statement});
    } else {
      items.back().end = i + 1;
    }
  }
  return items;
}

}  // namespace plcxx::ir
