#include "transpiler/passes/complete_facts.h"

#include <vector>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/facts.h"
#include "transpiler/ir/uses.h"

namespace plcxx::passes {
namespace {

using ir::Inst;
using ir::InstId;

struct Completer {
  ir::Program& program;
  ir::Builder builder{program};
  ir::FactChecks facts{builder};

  void Visit(ir::RegionId region, ir::StatementId statement);
  void NameStatement(const Inst& fact, ir::StatementId statement);
  void Guard(const Inst& inst);
};

void Completer::NameStatement(const Inst& fact, ir::StatementId statement) {
  if (!statement.valid()) return;
  const std::vector<ir::ValueId>& arguments = program.calls[ir::CallId(fact.payload)].arguments;
  program[arguments[static_cast<size_t>(ir::FalseFactArgument::kStatement)]].a = program.statements[statement].id;
}

void Completer::Guard(const Inst& inst) {
  ir::Loop& loop = program.loops[ir::LoopId(inst.payload)];
  if (loop.kind != ir::LoopBound::kProven) return;
  loop.kind = ir::LoopBound::kGuard;
  const ir::RegionId exhausted = builder.NewRegion();
  loop.exhausted = exhausted;
  builder.SetRegion(exhausted);
  builder.SetRange(inst.range);
  facts.Fail(ir::FactKind::kLoop, builder.Constant(ir::Type::kI32, loop.bound));
}

/// `statement`: whose the region's first instructions are.
void Completer::Visit(ir::RegionId region, ir::StatementId statement) {
  if (!region.valid()) return;
  const std::vector<InstId> insts = program.regions[region].insts;
  for (const InstId id : insts) {
    const Inst inst = program[id];
    if (inst.op == ir::OpKind::kStatement) statement = ir::StatementId(inst.payload);
    if (ir::IsFalseFact(program, inst)) NameStatement(inst, statement);
    if (inst.op == ir::OpKind::kLoop) Guard(inst);
    if (!ir::OwnsRegions(inst)) continue;
    for (const ir::RegionId owned : ir::OwnedRegions(program, inst)) Visit(owned, statement);
  }
}

}  // namespace

void CompleteFacts(ir::Program& program) {
  Completer completer{.program = program};
  if (!completer.facts.Resume()) return;
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::Routine routine = program.routines[ir::RoutineId(i)];
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) completer.Visit(region, {});
  }
}

}  // namespace plcxx::passes
