#include "transpiler/passes/remove_dead.h"

#include <algorithm>
#include <ranges>
#include <vector>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/uses.h"

namespace plcxx::passes {
namespace {

using ir::Inst;
using ir::InstId;

struct Remover {
  ir::Program& program;
  std::vector<uint32_t> uses;  // by InstId
  std::vector<bool> dead;      // by InstId

  void Count(ir::RegionId region);
  void CountLoopCondition(const Inst& inst);
  void Sweep(ir::RegionId region);
};

/// The last value of a loop's condition is used by the loop.
void Remover::CountLoopCondition(const Inst& inst) {
  if (inst.op != ir::OpKind::kLoop) return;
  const ir::RegionId condition = program.loops[ir::LoopId(inst.payload)].condition;
  if (condition.valid() && !program.regions[condition].insts.empty()) {
    ++uses[program.regions[condition].insts.back().index];
  }
}

void Remover::Count(ir::RegionId region) {
  for (const InstId id : program.regions[region].insts) {
    const Inst& inst = program[id];
    ir::ForEachUse(program, inst, [this](uint32_t word) { ++uses[word]; });
    if (!ir::OwnsRegions(inst)) continue;
    CountLoopCondition(inst);
    for (const ir::RegionId owned : ir::OwnedRegions(program, inst)) Count(owned);
  }
}

/// Backwards, so that a value's uses are decided before the value.
void Remover::Sweep(ir::RegionId region) {
  std::vector<InstId>& insts = program.regions[region].insts;
  bool any = false;
  for (const InstId id : std::views::reverse(insts)) {
    Inst& inst = program[id];
    if (ir::OwnsRegions(inst)) {
      for (const ir::RegionId owned : std::views::reverse(ir::OwnedRegions(program, inst))) Sweep(owned);
      continue;
    }
    const ir::Effect effect = ir::Info(inst.op).effect;
    if ((effect != ir::Effect::kPure && effect != ir::Effect::kReads) || uses[id.index] != 0) continue;
    ir::ForEachUse(program, inst, [this](uint32_t word) { --uses[word]; });
    ir::Forget(inst);
    dead[id.index] = any = true;
  }
  if (any) std::erase_if(insts, [this](InstId id) { return dead[id.index]; });
}

}  // namespace

void RemoveDead(ir::Program& program) {
  Remover remover{.program = program,
                  .uses = std::vector<uint32_t>(program.insts.size()),
                  .dead = std::vector<bool>(program.insts.size())};
  const auto each_region = [&program](auto visit) {
    for (const ir::Routine& routine : program.routines) {
      for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
        if (region.valid()) visit(region);
      }
    }
  };
  each_region([&remover](ir::RegionId region) { remover.Count(region); });
  each_region([&remover](ir::RegionId region) { remover.Sweep(region); });
}

}  // namespace plcxx::passes
