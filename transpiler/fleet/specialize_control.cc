// Regions: branches on constants, loops of so many rounds, and what is known behind each.

#include <algorithm>

#include "transpiler/fleet/specializer.h"
#include "transpiler/ir/accesses.h"
#include "transpiler/ir/builder.h"
#include "transpiler/support/check.h"

namespace plcxx::fleet {
namespace {

constexpr uint64_t kMostRounds = 64;
constexpr size_t kMostUnrolled = 3000;  // instructions of one loop

/// What both know, and the same.
Known Common(const Known& a, const Known& b) {
  Known common;
  for (const auto& [place, value] : a) {
    if (const auto other = b.find(place); other != b.end() && other->second == value) common.emplace(place, value);
  }
  return common;
}

}  // namespace

bool Specializer::WalkInto(ir::RegionId region, Known& known) {
  const std::vector<ir::InstId> insts = program_.regions[region].insts;
  ++depth_;
  const bool reached = std::ranges::all_of(insts, [&](ir::InstId id) { return WalkInst(id, known); });
  --depth_;
  return reached;
}

Specializer::Apart Specializer::WalkApart(ir::RegionId region, Known& known) {
  if (!region.valid()) return {};
  const ir::RegionId out = out_, made = program_.regions.Add({});
  out_ = made;
  const bool reached = WalkInto(region, known);
  out_ = out;
  return {made, reached};
}

void Specializer::ForgetWritten(const std::vector<ir::RegionId>& regions, Known& known) const {
  for (const ir::RegionId region : regions) {
    ir::ForEachInst(program_, region, [&](ir::InstId id) {
      ir::ForEachAccess(
          program_, program_[id],
          [&](ir::PlaceId place, ir::Access access) {
            if (access != ir::Access::kRead) known.erase(place.index);
          },
          [](ir::StateId) {});
    });
  }
}

bool Specializer::WalkInst(ir::InstId id, Known& known) {
  ir::Inst inst = program_[id];
  switch (ir::Info(inst.op).shape) {
    case ir::Shape::kPure:
      WalkPure(id, inst);
      return true;
    case ir::Shape::kConst:
    case ir::Shape::kStep:
    case ir::Shape::kText:
      Map(inst);
      now_[id.index] = Write(inst).index;
      return true;
    case ir::Shape::kLoad:
      WalkLoad(id, inst, known);
      return true;
    case ir::Shape::kStore:
      WalkStore(inst, known);
      return true;
    case ir::Shape::kStatement:
      // Pieces begin at the statements of a routine's outermost region, and no value crosses them.
      if (depth_ == 1) Write(inst);
      return true;
    case ir::Shape::kIf:
      return WalkIf(inst, known);
    case ir::Shape::kSwitch:
      return WalkSwitch(inst, known);
    case ir::Shape::kLoop:
      return WalkLoop(id, inst, known);
    case ir::Shape::kBlock:
      return WalkBlock(id, inst, known);
    case ir::Shape::kExit:
      return WalkExit(inst);
    case ir::Shape::kRepeat:
      WalkRepeat(inst, known);
      return true;
    case ir::Shape::kCall:
      WalkCall(id, inst);
      return true;
    case ir::Shape::kHostCall:
      WalkHostCall(id, inst, known);
      return true;
    case ir::Shape::kJump:
    case ir::Shape::kLabel:
      PLCXX_UNREACHABLE();  // structuring has replaced both
  }
  PLCXX_UNREACHABLE();
}

bool Specializer::WalkIf(ir::Inst inst, Known& known) {
  Map(inst);
  const ir::RegionId then(inst.b), otherwise(inst.c);
  if (const std::optional<uint64_t> condition = Constant(inst.a)) {
    const ir::RegionId taken = *condition != 0 ? then : otherwise;
    return !taken.valid() || WalkInto(taken, known);
  }
  Known then_known = known, else_known = known;
  const Apart then_arm = WalkApart(then, then_known), else_arm = WalkApart(otherwise, else_known);
  inst.b = then_arm.region.index;
  inst.c = else_arm.region.index;
  Write(inst);
  known = !then_arm.reached ? else_known : !else_arm.reached ? then_known : Common(then_known, else_known);
  return then_arm.reached || else_arm.reached;
}

bool Specializer::WalkSwitch(ir::Inst inst, Known& known) {
  Map(inst);
  const std::vector<ir::SwitchCase> cases = program_.switches[ir::SwitchId(inst.payload)].cases;
  if (const std::optional<uint64_t> selector = Constant(inst.a)) {
    auto taken = std::ranges::find_if(
        cases, [&](const ir::SwitchCase& one) { return std::ranges::find(one.values, *selector) != one.values.end(); });
    if (taken == cases.end())
      taken = std::ranges::find_if(cases, [](const ir::SwitchCase& one) { return one.values.empty(); });
    for (; taken != cases.end(); ++taken) {
      if (taken->region.valid() && !WalkInto(taken->region, known)) return false;
      if (!taken->falls_through) break;
    }
    return true;
  }
  for (const ir::SwitchCase& one : cases) ForgetWritten({one.region}, known);
  ir::Switch made;
  for (const ir::SwitchCase& one : cases) {
    Known inside = known;
    ir::SwitchCase& copy = made.cases.emplace_back(one);
    copy.region = WalkApart(one.region, inside).region;
  }
  inst.payload = program_.switches.Add(std::move(made)).index;
  Write(inst);
  return true;
}

bool Specializer::EndBlock(const ir::Inst& block, ir::InstId id, ir::RegionId inside, bool reached) {
  if (left_.contains(id.index)) {
    program_[id] = block;
    program_[id].a = inside.index;
    program_.regions[out_].insts.push_back(id);
    return true;
  }
  const std::vector<ir::InstId> insts = program_.regions[inside].insts;
  auto& all = program_.regions[out_].insts;
  all.insert(all.end(), insts.begin(), insts.end());
  return reached;
}

bool Specializer::WalkBlock(ir::InstId id, ir::Inst inst, Known& known) {
  const ir::RegionId region(inst.a), out = out_;
  const ir::InstId block = program_.insts.Add(ir::Inst(inst));
  now_[id.index] = block.index;
  Known inside = known;
  out_ = program_.regions.Add({});
  const bool reached = WalkInto(region, inside);
  const ir::RegionId made = out_;
  out_ = out;
  if (left_.contains(block.index)) {
    ForgetWritten({region}, known);
  } else {
    known = inside;
  }
  return EndBlock(inst, block, made, reached);
}

std::optional<bool> Specializer::Unroll(ir::InstId id, const ir::Inst& inst, Known& known) {
  const ir::Loop loop = program_.loops[ir::LoopId(inst.payload)];
  if (loop.kind == ir::LoopBound::kBudget || !loop.condition.valid()) return std::nullopt;
  const ir::ValueId condition(program_.regions[loop.condition].insts.back());
  const uint64_t most = std::min(loop.bound, kMostRounds);
  const ir::Inst block{.op = ir::OpKind::kBlock, .range = inst.range};
  const ir::InstId made = program_.insts.Add(ir::Inst(block));
  now_[id.index] = made.index;
  const ir::RegionId out = out_, inside = program_.regions.Add({});
  const size_t before = written_;
  Known local = known;
  bool ends = false, fits = true, reached = true;
  out_ = inside;
  for (uint64_t round = 0; !ends && fits && reached; ++round) {
    WalkInto(loop.condition, local);
    const std::optional<uint64_t> again = Constant(now_[condition.index]);
    fits = again && (*again == 0 || round < most) && written_ - before < kMostUnrolled;
    ends = again && *again == 0;
    if (!fits || ends) break;
    reached = WalkInto(loop.body, local);
    if (reached && loop.step.valid()) WalkInto(loop.step, local);
  }
  out_ = out;
  if (!fits) {
    written_ = before;
    return std::nullopt;
  }
  if (left_.contains(made.index)) {
    ForgetWritten({loop.condition, loop.body, loop.step}, known);
  } else {
    known = local;
  }
  return EndBlock(block, made, inside, reached);
}

bool Specializer::WalkLoop(ir::InstId id, ir::Inst inst, Known& known) {
  if (const std::optional<bool> reached = Unroll(id, inst, known)) return *reached;
  ir::Loop loop = program_.loops[ir::LoopId(inst.payload)];
  ForgetWritten({loop.condition, loop.body, loop.step, loop.exhausted}, known);
  known.erase(loop.budget.index);
  const ir::InstId made = program_.insts.Add(ir::Inst(inst));
  now_[id.index] = made.index;
  // Exits may be found before the loop's own row is written.
  const ir::LoopId copy = program_.loops.Add(ir::Loop(loop));
  program_[made].payload = copy.index;
  for (ir::RegionId* const region : {&loop.condition, &loop.body, &loop.step, &loop.exhausted}) {
    Known inside = known;
    *region = WalkApart(*region, inside).region;
  }
  program_.loops[copy] = loop;
  program_.regions[out_].insts.push_back(made);
  return true;
}

bool Specializer::WalkExit(ir::Inst inst) {
  Map(inst);
  const std::optional<uint64_t> condition = Constant(inst.a);
  if (condition && *condition == 0) return true;
  if (condition) inst.a = ir::ValueId().index;
  inst.payload = now_[inst.payload];
  left_.insert(inst.payload);
  Write(inst);
  return ir::ValueId(inst.a).valid();
}

void Specializer::WalkRepeat(ir::Inst inst, Known& known) {
  Map(inst);
  inst.payload = now_[inst.payload];
  known.erase(program_.loops[ir::LoopId(program_[ir::InstId(inst.payload)].payload)].budget.index);
  Known inside = known;
  inst.b = WalkApart(ir::RegionId(inst.b), inside).region.index;
  Write(inst);
}

}  // namespace plcxx::fleet
