#include "transpiler/passes/splice_constant_ifs.h"

#include <algorithm>
#include <set>
#include <vector>

#include "transpiler/ir/accesses.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/uses.h"

namespace plcxx::passes {
namespace {

using ir::Inst;
using ir::InstId;
using ir::OpKind;
using ir::RegionId;

struct Splicer {
  ir::Program& program;

  void Visit(RegionId region);
  bool CanSplice(RegionId taken, RegionId other) const;
  bool IsPlain(RegionId region) const;
  bool CallsNothing(RegionId region) const;
  std::set<uint32_t> PlacesOf(RegionId region) const;
  void Drop(RegionId region);
};

/// Neither statements nor jumps.
bool Splicer::IsPlain(RegionId region) const {
  bool plain = true;
  if (!region.valid()) return plain;
  ir::ForEachInst(program, region, [&](InstId id) {
    switch (ir::Info(program[id].op).shape) {
      case ir::Shape::kConst:
      case ir::Shape::kPure:
      case ir::Shape::kLoad:
      case ir::Shape::kStore:
      case ir::Shape::kText:
      case ir::Shape::kStep:
      case ir::Shape::kIf:
      case ir::Shape::kCall:
      case ir::Shape::kHostCall:
        break;
      case ir::Shape::kStatement:
      case ir::Shape::kSwitch:
      case ir::Shape::kLoop:
      case ir::Shape::kBlock:
      case ir::Shape::kExit:
      case ir::Shape::kRepeat:
      case ir::Shape::kJump:
      case ir::Shape::kLabel:
        plain = false;
        break;
    }
  });
  return plain;
}

bool Splicer::CallsNothing(RegionId region) const {
  bool nothing = true;
  if (!region.valid()) return nothing;
  ir::ForEachInst(program, region, [&](InstId id) {
    const ir::Shape shape = ir::Info(program[id].op).shape;
    nothing = nothing && shape != ir::Shape::kCall && shape != ir::Shape::kHostCall && shape != ir::Shape::kStep &&
              shape != ir::Shape::kText;
  });
  return nothing;
}

std::set<uint32_t> Splicer::PlacesOf(RegionId region) const {
  std::set<uint32_t> places;
  if (!region.valid()) return places;
  ir::ForEachInst(program, region, [&](InstId id) {
    ir::ForEachAccess(
        program, program[id], [&](ir::PlaceId place, ir::Access) { places.insert(place.index); }, [](ir::StateId) {});
  });
  return places;
}

bool Splicer::CanSplice(RegionId taken, RegionId other) const {
  return IsPlain(taken) && IsPlain(other) && CallsNothing(other) &&
         std::ranges::includes(PlacesOf(taken), PlacesOf(other));
}

void Splicer::Drop(RegionId region) {
  if (!region.valid()) return;
  for (const InstId id : program.regions[region].insts) {
    for (const RegionId owned : ir::OwnedRegions(program, program[id])) Drop(owned);
    ir::Forget(program[id]);
  }
  program.regions[region].insts.clear();
}

void Splicer::Visit(RegionId region) {
  const std::vector<InstId> insts = program.regions[region].insts;
  std::vector<InstId> kept;
  for (const InstId id : insts) {
    for (const RegionId owned : ir::OwnedRegions(program, program[id])) Visit(owned);
    Inst& inst = program[id];
    const bool constant = inst.op == OpKind::kIf && program[InstId(inst.a)].op == OpKind::kConst;
    const bool holds = constant && ir::ConstantValue(program[InstId(inst.a)]) != 0;
    const RegionId taken(holds ? inst.b : inst.c), other(holds ? inst.c : inst.b);
    if (!constant || !CanSplice(taken, other)) {
      kept.push_back(id);
      continue;
    }
    if (taken.valid()) {
      std::vector<InstId>& arm = program.regions[taken].insts;
      kept.insert(kept.end(), arm.begin(), arm.end());
      arm.clear();
    }
    Drop(other);
    ir::Forget(inst);
  }
  program.regions[region].insts = std::move(kept);
}

}  // namespace

void SpliceConstantIfs(ir::Program& program) {
  Splicer splicer{.program = program};
  for (const ir::Routine& routine : program.routines) {
    for (const RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (region.valid()) splicer.Visit(region);
    }
  }
}

}  // namespace plcxx::passes
