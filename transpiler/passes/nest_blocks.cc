#include "transpiler/passes/nest_blocks.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/uses.h"

namespace plcxx::passes {
namespace {

using ir::IfOrigin;
using ir::Inst;
using ir::InstId;
using ir::OpKind;
using ir::RegionId;

constexpr uint32_t kDeepest = 24;  // of nested ifs: readers and compilers have limits

struct Nester {
  ir::Program& program;
  std::vector<uint32_t> exits;  // by InstId of a block: how many Exits name it, those that became ifs included
  std::vector<uint32_t> left;   // the same: how many still leave it
  bool retargeted = false;      // exits of an outer block were given to an inner one

  void Visit(RegionId region, uint32_t depth);
  bool Nest(InstId block, uint32_t depth);
  void Sink(RegionId region, InstId block);
  void SinkConditional(RegionId region, size_t at);
  void SinkUnconditional(RegionId region, size_t at);
  void SinkIf(RegionId region, size_t at, InstId block);
  void Retarget(RegionId region, size_t at, InstId block);
  bool HasExit(InstId id, InstId block) const;
  bool RegionHasExit(RegionId region, InstId block) const;
  bool EndsWithExit(RegionId region, InstId block) const;
  RegionId TakeRest(RegionId region, size_t from);
  void DropLast(RegionId region);
};

bool Nester::RegionHasExit(RegionId region, InstId block) const {
  if (!region.valid()) return false;
  const std::vector<InstId>& insts = program.regions[region].insts;
  return std::any_of(insts.begin(), insts.end(), [&](InstId id) { return HasExit(id, block); });
}

bool Nester::HasExit(InstId id, InstId block) const {
  const Inst& inst = program[id];
  if (inst.op == OpKind::kExit) return inst.payload == block.index;
  if (!ir::OwnsRegions(inst)) return false;
  const std::vector<RegionId> owned = ir::OwnedRegions(program, inst);
  return std::any_of(owned.begin(), owned.end(), [&](RegionId region) { return RegionHasExit(region, block); });
}

/// Whether every way through the region that reaches its end leaves the block there.
bool Nester::EndsWithExit(RegionId region, InstId block) const {
  if (!region.valid() || program.regions[region].insts.empty()) return false;
  const Inst& last = program[program.regions[region].insts.back()];
  return last.op == OpKind::kExit && last.payload == block.index && !ir::ValueId(last.a).valid();
}

/// The instructions from an index on, as a region of their own.
RegionId Nester::TakeRest(RegionId region, size_t from) {
  std::vector<InstId>& insts = program.regions[region].insts;
  ir::Region rest;
  rest.insts.assign(insts.begin() + static_cast<ptrdiff_t>(from), insts.end());
  insts.resize(from);
  return program.regions.Add(std::move(rest));
}

void Nester::DropLast(RegionId region) {
  const InstId last = program.regions[region].insts.back();
  --left[program[last].payload];
  program.regions[region].insts.pop_back();
  ir::Forget(program[last]);
}

/// `exit if c; rest` becomes `if !c { rest }`; the If takes the place of the Exit.
void Nester::SinkConditional(RegionId region, size_t at) {
  const RegionId rest = TakeRest(region, at + 1);
  const InstId id = program.regions[region].insts[at];
  const Inst exit = program[id];
  --left[exit.payload];
  uint32_t condition = exit.a;
  if (program[ir::ValueId(condition)].op == OpKind::kBitNot) {
    condition = program[ir::ValueId(condition)].a;
  } else {
    const InstId negated =
        program.insts.Add({.op = OpKind::kBitNot, .type = ir::Type::kBit, .range = exit.range, .a = exit.a});
    std::vector<InstId>& insts = program.regions[region].insts;
    insts.insert(insts.end() - 1, negated);
    condition = negated.index;
  }
  program[id] = {.op = OpKind::kIf,
                 .range = exit.range,
                 .payload = static_cast<uint32_t>(IfOrigin::kStays),
                 .a = condition,
                 .b = rest.index};
}

/// `exit; rest`: the rest is never reached, and stays visible as `if false { rest }`.
void Nester::SinkUnconditional(RegionId region, size_t at) {
  const InstId id = program.regions[region].insts[at];
  const RegionId rest = TakeRest(region, at + 1);
  const source::Range range = program[id].range;
  --left[program[id].payload];
  const InstId never =
      program.insts.Add({.op = OpKind::kConst, .type = ir::Type::kBit, .range = range, .a = 0, .b = 0, .c = 10});
  program.regions[region].insts.insert(program.regions[region].insts.end() - 1, never);
  program[id] = {.op = OpKind::kIf,
                 .range = range,
                 .payload = static_cast<uint32_t>(IfOrigin::kStays),
                 .a = never.index,
                 .b = rest.index};
}

/// The rest goes into the arm that does not leave; nothing changes when both arms may go on.
void Nester::SinkIf(RegionId region, size_t at, InstId block) {
  const InstId id = program.regions[region].insts[at];
  const bool tail = at + 1 == program.regions[region].insts.size();
  const bool then_leaves = EndsWithExit(RegionId(program[id].b), block);
  const bool else_leaves = EndsWithExit(RegionId(program[id].c), block);
  // When both leave, the rest is never reached, and no arm is its place.
  if (!tail && then_leaves == else_leaves) return;
  if (then_leaves) DropLast(RegionId(program[id].b));
  if (else_leaves) DropLast(RegionId(program[id].c));
  if (!tail) {
    const RegionId rest = TakeRest(region, at + 1);
    Inst& inst = program[id];
    uint32_t& arm = then_leaves ? inst.c : inst.b;
    if (static_cast<IfOrigin>(inst.payload) == IfOrigin::kSource) {
      inst.payload = static_cast<uint32_t>(then_leaves ? IfOrigin::kJumps : IfOrigin::kStays);
    }
    if (!RegionId(arm).valid()) {
      arm = rest.index;
    } else {
      const std::vector<InstId> insts = std::move(program.regions[rest].insts);
      program.regions[rest].insts.clear();
      std::vector<InstId>& list = program.regions[RegionId(arm)].insts;
      list.insert(list.end(), insts.begin(), insts.end());
    }
  }
  for (const RegionId arm : {RegionId(program[id].b), RegionId(program[id].c)}) {
    if (arm.valid()) Sink(arm, block);
  }
}

/// What ends the block ends with it: an exit of the block from inside leaves the inner one.
void Nester::Retarget(RegionId region, size_t at, InstId block) {
  const InstId id = program.regions[region].insts[at];
  const bool encloses = program[id].op == OpKind::kBlock || program[id].op == OpKind::kLoop;
  if (!encloses || at + 1 != program.regions[region].insts.size()) return;
  for (const RegionId owned : ir::OwnedRegions(program, program[id])) {
    // A guard's region is executed after the loop: an exit there cannot leave it.
    if (program[id].op == OpKind::kLoop && owned == program.loops[ir::LoopId(program[id].payload)].exhausted) continue;
    ir::ForEachInst(program, owned, [&](InstId inner) {
      Inst& exit = program[inner];
      if (exit.op != OpKind::kExit || exit.payload != block.index) return;
      exit.payload = id.index;
      ++exits[id.index];
      ++left[id.index];
      --left[block.index];
      retargeted = true;
    });
  }
}

/// Takes exits of `block` out of a region at whose end the block ends, too.
void Nester::Sink(RegionId region, InstId block) {
  for (size_t at = 0; at < program.regions[region].insts.size(); ++at) {
    const InstId id = program.regions[region].insts[at];
    if (!HasExit(id, block)) continue;
    if (program[id].op == OpKind::kIf) return SinkIf(region, at, block);
    if (program[id].op != OpKind::kExit) return Retarget(region, at, block);
    if (ir::ValueId(program[id].a).valid()) {
      SinkConditional(region, at);
    } else if (at + 1 == program.regions[region].insts.size()) {
      return DropLast(region);
    } else {
      SinkUnconditional(region, at);
    }
    // The If that took the exit's place.
    return Sink(RegionId(program[program.regions[region].insts.back()].b), block);
  }
}

/// Whether the block has no exit any more.
bool Nester::Nest(InstId block, uint32_t depth) {
  if (exits[block.index] > 0 && exits[block.index] <= kMostNestedExits && depth + exits[block.index] <= kDeepest) {
    Sink(RegionId(program[block].a), block);
  }
  return left[block.index] == 0;
}

void Nester::Visit(RegionId region, uint32_t depth) {
  std::vector<InstId> insts = std::move(program.regions[region].insts);
  std::vector<InstId> out;
  out.reserve(insts.size());
  for (const InstId id : insts) {
    if (ir::OwnsRegions(program[id])) {
      for (const RegionId owned : ir::OwnedRegions(program, program[id])) Visit(owned, depth + 1);
    }
    if (program[id].op == OpKind::kBlock && Nest(id, depth)) {
      // Its instructions take its place. Exits that were given to a block in it may nest now.
      const RegionId body(program[id].a);
      if (std::exchange(retargeted, false)) Visit(body, depth);
      const std::vector<InstId> inner = std::move(program.regions[body].insts);
      program.regions[body].insts.clear();
      out.insert(out.end(), inner.begin(), inner.end());
      ir::Forget(program[id]);
      continue;
    }
    out.push_back(id);
  }
  program.regions[region].insts = std::move(out);
}

}  // namespace

void NestBlocks(ir::Program& program) {
  Nester nester{.program = program,
                .exits = std::vector<uint32_t>(program.insts.size()),
                .left = std::vector<uint32_t>(program.insts.size())};
  bool any = false;
  for (const Inst& inst : program.insts) {
    if (inst.op == OpKind::kExit) ++nester.exits[inst.payload];
    any = any || inst.op == OpKind::kBlock;
  }
  if (!any) return;
  const auto count = [&](InstId id) {
    if (program[id].op == OpKind::kExit) ++nester.left[program[id].payload];
  };
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::Routine routine = program.routines[ir::RoutineId(i)];
    for (const RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (!region.valid()) continue;
      ir::ForEachInst(program, region, count);
      nester.Visit(region, 0);
    }
  }
}

}  // namespace plcxx::passes
