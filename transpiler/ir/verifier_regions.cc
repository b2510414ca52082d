// Control flow: regions and what owns them, markers of statements, exits, jumps.

#include <algorithm>

#include "transpiler/ir/verifier_state.h"

namespace plcxx::ir {

void Verifier::VerifyRegion(RegionId region, uint32_t floor) {
  region_open[region.index] = true;
  if (stage == Stage::kLowered) OpenLabels(region);
  for (const InstId id : program.regions[region].insts) {
    if (id.index >= program.insts.size()) {
      Report(program.routines[routine].name + ": unknown instruction");
      continue;
    }
    const Inst& inst = program[id];
    if (position[id.index] != 0) {
      Report(inst, "stands in two places");
      continue;
    }
    switch (Info(inst.op).shape) {
      case Shape::kStatement:
        if (inst.payload >= program.statements.size()) {
          Report(inst, "unknown statement");
          break;
        }
        if (marked[inst.payload]) Report(inst, "statement " + std::to_string(inst.payload) + " is marked twice");
        marked[inst.payload] = true;
        statement = StatementId(inst.payload);
        floor = now;  // no value lives on
        break;
      case Shape::kJump:
      case Shape::kLabel:
        if (stage == Stage::kStructured) Report(inst, "left over from before structuring");
        if (inst.op == OpKind::kJump) VerifyJump(inst, floor);
        break;
      case Shape::kIf:
        VerifyIf(inst, floor);
        break;
      case Shape::kSwitch:
        VerifySwitch(inst, floor);
        break;
      case Shape::kLoop:
        VerifyLoop(id, inst, floor);
        break;
      case Shape::kBlock:
        VerifyBlock(id, inst, floor);
        break;
      case Shape::kExit:
        VerifyExit(inst, floor);
        break;
      case Shape::kRepeat:
        VerifyRepeat(inst, floor);
        break;
      case Shape::kPure:
      case Shape::kStep:
      case Shape::kConst:
      case Shape::kLoad:
      case Shape::kStore:
      case Shape::kText:
      case Shape::kCall:
      case Shape::kHostCall:
        VerifyInst(inst, floor);
        break;
    }
    position[id.index] = ++now;
    home[id.index] = region;
    if (stage == Stage::kLowered) ++labels.back().at;
  }
  if (stage == Stage::kLowered) labels.pop_back();
  region_open[region.index] = false;
}

void Verifier::VerifyOwned(RegionId region, uint32_t floor, const Inst& owner) {
  if (region.index >= program.regions.size()) {
    Report(owner, "region without body");
    return;
  }
  if (region_owned[region.index]) {
    Report(owner, "its region has another owner");
    return;
  }
  region_owned[region.index] = true;
  VerifyRegion(region, floor);
}

void Verifier::VerifyIf(const Inst& inst, uint32_t floor) {
  VerifyUse(inst, inst.a, Type::kBit, {"condition"}, floor);
  VerifyOwned(RegionId(inst.b), floor, inst);
  if (RegionId(inst.c).valid()) VerifyOwned(RegionId(inst.c), floor, inst);
}

void Verifier::VerifySwitch(const Inst& inst, uint32_t floor) {
  VerifyUse(inst, inst.a, Type::kNone, {"selector"}, floor);
  if (inst.payload >= program.switches.size()) return Report(inst, "unknown switch");
  std::vector<uint64_t> values;
  uint32_t defaults = 0;
  for (const SwitchCase& arm : program.switches[SwitchId(inst.payload)].cases) {
    values.insert(values.end(), arm.values.begin(), arm.values.end());
    defaults += arm.values.empty() ? 1 : 0;
    VerifyOwned(arm.region, floor, inst);
  }
  std::sort(values.begin(), values.end());
  if (std::adjacent_find(values.begin(), values.end()) != values.end() || defaults > 1) {
    Report(inst, "two cases for one value");
  }
}

void Verifier::VerifyLoop(InstId id, const Inst& inst, uint32_t floor) {
  if (inst.payload >= program.loops.size()) return Report(inst, "unknown loop");
  const Loop& loop = program.loops[LoopId(inst.payload)];
  const bool counts = loop.kind != LoopBound::kBudget;
  if (counts && loop.bound == 0) Report(inst, "no bound");
  if (!counts && (loop.condition.valid() || loop.exhausted.valid())) Report(inst, "a budget and a condition");
  const bool budget = loop.budget.index < program.places.size() && program.places[loop.budget].type == Type::kI32;
  if ((loop.kind == LoopBound::kBudget) != budget) Report(inst, budget ? "budget without use" : "no budget place");
  if (loop.body.index != inst.a) Report(inst, "two bodies");
  body_open[id.index] = true;
  if (loop.condition.valid()) {
    VerifyOwned(loop.condition, floor, inst);
    const bool known = loop.condition.index < program.regions.size();
    const bool empty = !known || program.regions[loop.condition].insts.empty();
    if (empty || program[program.regions[loop.condition].insts.back()].type != Type::kBit) {
      Report(inst, "its condition is no bit");
    }
  }
  VerifyOwned(loop.body, floor, inst);
  body_open[id.index] = false;
  if (loop.step.valid()) VerifyStep(inst, loop, floor);
  if (loop.exhausted.valid()) VerifyOwned(loop.exhausted, floor, inst);
}

/// One store at its end, and in front of that nothing but the values it needs.
void Verifier::VerifyStep(const Inst& inst, const Loop& loop, uint32_t floor) {
  VerifyOwned(loop.step, floor, inst);
  if (loop.kind == LoopBound::kBudget) Report(inst, "a budget and a step");
  if (loop.step.index >= program.regions.size()) return;
  const std::vector<InstId>& insts = program.regions[loop.step].insts;
  for (size_t i = 0; i < insts.size(); ++i) {
    if (insts[i].index >= program.insts.size()) return;
    const Shape shape = Info(program[insts[i]].op).shape;
    const bool value = shape == Shape::kConst || shape == Shape::kPure || shape == Shape::kLoad;
    if (i + 1 == insts.size() ? shape != Shape::kStore : !value) return Report(inst, "its step is no single store");
  }
}

void Verifier::VerifyBlock(InstId id, const Inst& inst, uint32_t floor) {
  body_open[id.index] = true;
  VerifyOwned(RegionId(inst.a), floor, inst);
  body_open[id.index] = false;
}

void Verifier::VerifyExit(const Inst& inst, uint32_t floor) {
  if (ValueId(inst.a).valid()) VerifyUse(inst, inst.a, Type::kBit, {"condition"}, floor);
  if (inst.payload >= body_open.size() || !body_open[inst.payload]) Report(inst, "no block or loop around it");
}

void Verifier::VerifyRepeat(const Inst& inst, uint32_t floor) {
  if (ValueId(inst.a).valid()) VerifyUse(inst, inst.a, Type::kBit, {"condition"}, floor);
  if (inst.payload >= body_open.size() || !body_open[inst.payload] ||
      program[InstId(inst.payload)].op != OpKind::kLoop) {
    return Report(inst, "no loop around it");
  }
  const LoopId loop(program[InstId(inst.payload)].payload);
  if (loop.index >= program.loops.size() || program.loops[loop].kind != LoopBound::kBudget) {
    Report(inst, "its loop has no budget");
  }
  if (RegionId(inst.b).valid()) VerifyOwned(RegionId(inst.b), floor, inst);
}

void Verifier::OpenLabels(RegionId region) {
  labels.push_back({});
  std::vector<LabelAt>& found = labels.back().labels;
  const std::vector<InstId>& insts = program.regions[region].insts;
  for (size_t i = 0; i < insts.size(); ++i) {
    if (insts[i].index >= program.insts.size() || program[insts[i]].op != OpKind::kLabel) continue;
    found.push_back({program[insts[i]].payload, i});
  }
  std::stable_sort(found.begin(), found.end(), [](const LabelAt& a, const LabelAt& b) { return a.label < b.label; });
  for (size_t i = 1; i < found.size(); ++i) {
    if (found[i - 1].label == found[i].label) Report(program[insts[found[i].at]], "the label is there twice");
  }
}

void Verifier::VerifyJump(const Inst& inst, uint32_t floor) {
  if (ValueId(inst.a).valid()) VerifyUse(inst, inst.a, Type::kBit, {"condition"}, floor);
  if (stage == Stage::kLowered) VerifyTarget(inst);
  if (RegionId(inst.b).valid()) VerifyOwned(RegionId(inst.b), floor, inst);
}

/// The label stands in the jump's region or in one around it; a way back has a budget.
void Verifier::VerifyTarget(const Inst& inst) {
  const bool has_budget = inst.c < program.places.size() && program.places[PlaceId(inst.c)].type == Type::kI32;
  for (auto open = labels.rbegin(); open != labels.rend(); ++open) {
    const auto label =
        std::lower_bound(open->labels.begin(), open->labels.end(), inst.payload,
                         [](const LabelAt& candidate, uint32_t wanted) { return candidate.label < wanted; });
    if (label == open->labels.end() || label->label != inst.payload) continue;
    const bool back = label->at <= open->at;
    if (back && !has_budget) Report(inst, "goes back to L" + std::to_string(inst.payload) + " without a budget");
    if (!back && (PlaceId(inst.c).valid() || RegionId(inst.b).valid())) Report(inst, "goes forward with a budget");
    return;
  }
  Report(inst, "no label L" + std::to_string(inst.payload) + " in its region");
}

}  // namespace plcxx::ir
