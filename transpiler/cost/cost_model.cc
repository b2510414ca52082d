#include "transpiler/cost/cost_model.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/items.h"
#include "transpiler/ir/uses.h"

namespace plcxx::cost {
namespace {

using ir::CostClass;
using ir::Inst;
using ir::InstId;
using ir::RegionId;
using ir::RoutineId;

constexpr uint64_t kNsPerCycle = 10;
constexpr uint64_t kMostTime = uint64_t{1} << 56;  // so that sums of some items cannot overflow

constexpr Cost Price(CostClass cost) {
  switch (cost) {
#define PLCXX_PRICE(Class, Cycles, Bytes) \
  case CostClass::Class:                  \
    return {(Cycles) * kNsPerCycle, Bytes};
#include "transpiler/cost/prices.def"
#undef PLCXX_PRICE
  }
  PLCXX_UNREACHABLE();
}

uint64_t Times(uint64_t time, uint64_t rounds) {
  return rounds != 0 && time > kMostTime / rounds ? kMostTime : time * rounds;
}

void Add(Cost& sum, const Cost& cost) {
  sum.time_ns = std::min(sum.time_ns + cost.time_ns, kMostTime);
  sum.code_bytes += cost.code_bytes;
}

struct Estimator {
  const ir::Program& program;
  RoutineTimes& routine_time;
  std::vector<StatementCost>* listing = nullptr;  // none while a callee is priced

  uint64_t TimeOf(RoutineId routine);
  Cost Region(RegionId region);
  Cost Stretch(std::span<const InstId> insts);
  /// An instruction without what it owns.
  Cost Own(const Inst& inst);
  /// The regions that an instruction owns, on their longest path.
  Cost Owned(const Inst& inst);
  Cost OwnedBySwitch(const ir::Switch& cases);
  Cost OwnedByLoop(const ir::Loop& loop);
};

uint64_t Estimator::TimeOf(RoutineId id) {
  std::optional<uint64_t>& known = routine_time[id.index];
  if (!known) {
    known = 0;  // a cycle is the verifier's to find; here it must only end
    std::vector<StatementCost>* const own = std::exchange(listing, nullptr);
    Cost sum;
    const ir::Routine& routine = program.routines[id];
    for (const RegionId region : {routine.prologue, routine.body, routine.epilogue}) Add(sum, Region(region));
    listing = own;
    known = sum.time_ns;
  }
  return *known;
}

Cost Estimator::Own(const Inst& inst) {
  Cost cost = Price(ir::Info(inst.op).cost);
  const ir::Shape shape = ir::Info(inst.op).shape;
  if (shape == ir::Shape::kCall) {
    cost.time_ns = std::min(cost.time_ns + TimeOf(program.calls[ir::CallId(inst.payload)].routine), kMostTime);
  }
  const bool access = shape == ir::Shape::kLoad || shape == ir::Shape::kStore;
  if (access && program.places[ir::PlaceId(inst.payload)].indexed) {
    // The address, and the comparison with both bounds.
    for (const CostClass part : {CostClass::kArithmetic, CostClass::kCompare, CostClass::kCompare}) {
      Add(cost, Price(part));
    }
  }
  return cost;
}

Cost Estimator::OwnedBySwitch(const ir::Switch& cases) {
  Cost sum;
  uint64_t path = 0;  // entered at the first of the arms that run on into this one
  for (const ir::SwitchCase& arm : cases.cases) {
    const Cost cost = Region(arm.region);
    path = std::min(path + cost.time_ns, kMostTime);
    sum.time_ns = std::max(sum.time_ns, path);
    sum.code_bytes += cost.code_bytes;
    if (!arm.falls_through) path = 0;
  }
  return sum;
}

Cost Estimator::OwnedByLoop(const ir::Loop& loop) {
  const Cost condition = Region(loop.condition), exhausted = Region(loop.exhausted);
  Cost body = Region(loop.body);
  Add(body, Region(loop.step));
  const Cost back = Price(CostClass::kBranch);
  // A budget is for faults, and shared: what is typical is that such a loop is not taken back at all.
  const uint64_t rounds = loop.kind == ir::LoopBound::kBudget ? 1 : loop.bound;
  Cost cost{.time_ns = Times(std::min(condition.time_ns + body.time_ns + back.time_ns, kMostTime), rounds),
            .code_bytes = condition.code_bytes + body.code_bytes + back.code_bytes};
  Add(cost, {.time_ns = condition.time_ns, .code_bytes = 0});  // the round that ends it
  Add(cost, exhausted);
  return cost;
}

Cost Estimator::Owned(const Inst& inst) {
  switch (ir::Info(inst.op).shape) {
    case ir::Shape::kIf: {
      const Cost then = Region(RegionId(inst.b)), otherwise = Region(RegionId(inst.c));
      return {std::max(then.time_ns, otherwise.time_ns), then.code_bytes + otherwise.code_bytes};
    }
    case ir::Shape::kSwitch:
      return OwnedBySwitch(program.switches[ir::SwitchId(inst.payload)]);
    case ir::Shape::kLoop:
      return OwnedByLoop(program.loops[ir::LoopId(inst.payload)]);
    case ir::Shape::kBlock:
      return Region(RegionId(inst.a));
    case ir::Shape::kRepeat:
      return Region(RegionId(inst.b));
    case ir::Shape::kPure:
    case ir::Shape::kStep:
    case ir::Shape::kConst:
    case ir::Shape::kLoad:
    case ir::Shape::kStore:
    case ir::Shape::kText:
    case ir::Shape::kStatement:
    case ir::Shape::kExit:
    case ir::Shape::kCall:
    case ir::Shape::kHostCall:
    case ir::Shape::kJump:
    case ir::Shape::kLabel:
      return {};
  }
  PLCXX_UNREACHABLE();
}

/// Some instructions of one region, one after the other. What nests in them counts as theirs where no statement of its
/// own is inside.
Cost Estimator::Stretch(std::span<const InstId> insts) {
  Cost sum;
  std::optional<size_t> row;  // of the listing: the statement whose marker stood last in this region
  for (const InstId id : insts) {
    const Inst& inst = program[id];
    if (listing != nullptr && inst.op == ir::OpKind::kStatement) {
      row = listing->size();
      listing->push_back({.statement = ir::StatementId(inst.payload), .own = {}, .nested = {}});
    }
    const Cost own = Own(inst);
    Add(sum, own);
    if (row) Add((*listing)[*row].own, own);
    if (!ir::OwnsRegions(inst)) continue;
    const size_t rows = listing != nullptr ? listing->size() : 0;
    const Cost owned = Owned(inst);
    Add(sum, owned);
    if (row) Add(listing->size() > rows ? (*listing)[*row].nested : (*listing)[*row].own, owned);
  }
  return sum;
}

Cost Estimator::Region(RegionId region) { return region.valid() ? Stretch(program.regions[region].insts) : Cost(); }

}  // namespace

Estimate EstimateRoutine(const ir::Program& program, RoutineId id) {
  RoutineTimes known;
  return EstimateRoutine(program, id, known);
}

Estimate EstimateRoutine(const ir::Program& program, RoutineId id, RoutineTimes& known) {
  known.resize(program.routines.size());
  Estimate estimate;
  Estimator estimator{.program = program, .routine_time = known, .listing = &estimate.statements};
  const ir::Routine& routine = program.routines[id];
  Add(estimate.total, estimator.Region(routine.prologue));
  const std::span<const InstId> insts = program.regions[routine.body].insts;
  for (const ir::Item& item : ir::Items(program, routine.body)) {
    const Cost cost = estimator.Stretch(insts.subspan(item.begin, item.end - item.begin));
    estimate.item_weights.push_back(cost.time_ns);
    Add(estimate.total, cost);
  }
  Add(estimate.total, estimator.Region(routine.epilogue));
  return estimate;
}

uint8_t SlicesFor(uint64_t slow_us, uint32_t slot_ms) {
  if (slot_ms == 0) return kMostSlices;
  const uint64_t slot_us = uint64_t{1000} * slot_ms;
  const uint64_t slices = slow_us / slot_us + (slow_us % slot_us != 0 ? 1 : 0);
  return static_cast<uint8_t>(std::clamp<uint64_t>(slices, 1, kMostSlices));
}

}  // namespace plcxx::cost
