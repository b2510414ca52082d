// Frames: branches, choices, loops and blocks, and the ways out of them.

#include <algorithm>

#include "transpiler/report/ladder_build.h"

namespace plcxx::report {

/// Do only plain effects depend on it, so that an enabling network in front of them says it all?
bool LadderBuilder::IsConditional(const ir::Inst& inst) const {
  if (ir::RegionId(inst.c).valid() && !program_.regions[ir::RegionId(inst.c)].insts.empty()) return false;
  bool any = false;
  for (const ir::InstId id : program_.regions[ir::RegionId(inst.b)].insts) {
    const ir::Inst& inner = program_[id];
    if (text_.IsLocal(id)) return false;
    switch (ir::Info(inner.op).shape) {
      case ir::Shape::kConst:
      case ir::Shape::kPure:
      case ir::Shape::kLoad:
        break;
      case ir::Shape::kStore:
        any = true;
        if (program_.places[ir::PlaceId(inner.payload)].type == ir::Type::kBit &&
            program_[ir::ValueId(inner.a)].op != ir::OpKind::kConst) {
          return false;
        }
        break;
      case ir::Shape::kCall:
      case ir::Shape::kHostCall:
        any = true;
        if (text_.IsUsed(id)) return false;
        break;
      case ir::Shape::kStep:
      case ir::Shape::kText:
      case ir::Shape::kStatement:
      case ir::Shape::kIf:
      case ir::Shape::kSwitch:
      case ir::Shape::kLoop:
      case ir::Shape::kBlock:
      case ir::Shape::kExit:
      case ir::Shape::kRepeat:
      case ir::Shape::kJump:
      case ir::Shape::kLabel:
        return false;
    }
  }
  return any;
}

/// The condition's network, and after it what it enables: bits set and cleared, boxes.
void LadderBuilder::Conditional(const ir::Inst& inst) {
  for (const ir::InstId id : program_.regions[ir::RegionId(inst.b)].insts) {
    const ir::Inst& inner = program_[id];
    if (inner.op == ir::OpKind::kStore) {
      const ir::PlaceId place(inner.payload);
      const ir::Inst& value = program_[ir::ValueId(inner.a)];
      const bool bit = program_.places[place].type == ir::Type::kBit;
      const Shape shape = !bit ? Shape::kBox : ir::ConstantValue(value) != 0 ? Shape::kSet : Shape::kReset;
      Element output = networks_.OfPlace(shape, place, ir::ValueId(inner.b));
      if (!bit) {
        output.title = ":=";
        output.lines = {text_.Of(ir::ValueId(inner.a))};
      }
      Output(ir::ValueId(inst.a), std::move(output));
    } else if (inner.op == ir::OpKind::kCall || inner.op == ir::OpKind::kHostCall) {
      Output(ir::ValueId(inst.a), networks_.Box(id));
    }
  }
}

/// The If that an else arm consists of, with or without a statement's marker before it; or none.
ir::InstId LadderBuilder::ChainedIf(ir::RegionId otherwise) const {
  const std::vector<ir::InstId>& insts = program_.regions[otherwise].insts;
  if (insts.empty() || program_[insts.back()].op != ir::OpKind::kIf) return {};
  for (size_t i = 0; i + 1 < insts.size(); ++i) {
    const ir::Shape shape = ir::Info(program_[insts[i]].op).shape;
    const bool value = shape == ir::Shape::kPure || shape == ir::Shape::kLoad || shape == ir::Shape::kConst;
    const bool marker = shape == ir::Shape::kStatement && i == 0;
    if (!marker && (!value || text_.IsLocal(insts[i]))) return {};
  }
  return insts.back();
}

void LadderBuilder::If(const ir::Inst& first) {
  if (IsConditional(first)) {
    Conditional(first);
    return;
  }
  const ir::StatementId outer = statement_;
  const ir::Inst* inst = &first;
  ItemKind kind = ItemKind::kHead;
  for (;;) {
    Rung condition;
    condition.network = kind == ItemKind::kHead ? networks_.Network(ir::ValueId(inst->a)) : Arm(ir::ValueId(inst->a));
    condition.outputs.push_back(Target("THEN"));
    Head(kind == ItemKind::kHead ? "IF" : "ELSE IF", std::move(condition), kind);
    Region(ir::RegionId(inst->b));
    const ir::RegionId otherwise(inst->c);
    if (!otherwise.valid() || program_.regions[otherwise].insts.empty()) break;
    const ir::InstId chained = ChainedIf(otherwise);
    if (!chained.valid()) {
      Section("ELSE");
      Region(otherwise);
      break;
    }
    const ir::Inst& marker = program_[program_.regions[otherwise].insts.front()];
    if (marker.op == ir::OpKind::kStatement) Own(ir::StatementId(marker.payload));
    inst = &program_[chained];
    kind = ItemKind::kSection;
  }
  if (statement_ != outer) Own(outer);
  End();
}

Element LadderBuilder::Arm(ir::ValueId condition) {
  const size_t before = items_.size();
  Element network = networks_.Network(condition);
  if (items_.size() == before) return network;
  items_.resize(before);
  Element box;
  box.shape = Shape::kBox;
  box.title = "1 IF";
  box.lines = {text_.Of(condition)};
  return box;
}

/// Is it what CutSlices makes of a sliced routine?
bool LadderBuilder::IsChoiceOfSlices(const ir::Inst& inst) const {
  const ir::Inst& selector = program_[ir::ValueId(inst.a)];
  if (!routine_->sliced || selector.op != ir::OpKind::kLoad || depth_ != 0) return false;
  for (size_t i = 0; i < routine_->parameters.size(); ++i) {
    if (routine_->parameters[i].name == "slice") return routine_->parameter_places[i].index == selector.payload;
  }
  return false;
}

std::string LadderBuilder::NameOf(ir::InstId frame) {
  const auto found = std::ranges::find(frames_, frame);
  return std::to_string(found - frames_.begin() + 1);
}

void LadderBuilder::Switch(const ir::Inst& inst) {
  const ir::Switch& cases = program_.switches[ir::SwitchId(inst.payload)];
  const bool slices = IsChoiceOfSlices(inst);
  if (!slices) {
    Rung selector;
    selector.network.shape = Shape::kWire;
    selector.outputs.push_back(Target("CASE " + text_.Of(ir::ValueId(inst.a))));
    Head("CASE", std::move(selector));
  }
  for (const ir::SwitchCase& arm : cases.cases) {
    if (slices) {
      Region(arm.region);
      continue;
    }
    std::string label = arm.values.empty() ? "OTHERWISE" : "=";
    for (const uint64_t value : arm.values) label += (label.back() == '=' ? " " : ", ") + std::to_string(value);
    Section(label + (arm.falls_through ? " (and on into the next)" : ""));
    Region(arm.region);
  }
  if (!slices) End();
}

void LadderBuilder::Loop(ir::InstId id, const ir::Inst& inst) {
  const ir::Loop& loop = program_.loops[ir::LoopId(inst.payload)];
  frames_.push_back(id);
  std::string label = "LOOP " + NameOf(id);
  switch (loop.kind) {
    case ir::LoopBound::kProven:
      label += ", at most " + std::to_string(loop.bound) + " rounds";
      break;
    case ir::LoopBound::kGuard:
      label += ", stopped after " + std::to_string(loop.bound) + " rounds";
      break;
    case ir::LoopBound::kBudget:
      label += ", rounds taken from " + program_.places[loop.budget].name;
      break;
  }
  Head(label, {});
  if (loop.condition.valid()) {
    const std::vector<ir::InstId>& insts = program_.regions[loop.condition].insts;
    // The last one is the condition's value: unless it is kept, it is only drawn as what goes on with the loop.
    Insts(insts, 0, insts.size() - (text_.IsLocal(insts.back()) ? 0 : 1));
    Rung condition;
    condition.network = networks_.Network(insts.back());
    condition.outputs.push_back(Target("WHILE"));
    Append(std::move(condition));
  }
  Region(loop.body);
  if (loop.step.valid() && !program_.regions[loop.step].insts.empty()) {
    Section("AFTER EACH ROUND");
    Region(loop.step);
  }
  if (loop.exhausted.valid() && !program_.regions[loop.exhausted].insts.empty()) {
    Section("WHEN STOPPED");
    Region(loop.exhausted);
  }
  End("END OF LOOP " + NameOf(id));
  frames_.pop_back();
}

void LadderBuilder::Block(ir::InstId id, const ir::Inst& inst) {
  frames_.push_back(id);
  Head("BLOCK " + NameOf(id), {});
  Region(ir::RegionId(inst.a));
  End("END OF BLOCK " + NameOf(id));
  frames_.pop_back();
}

void LadderBuilder::Exit(const ir::Inst& inst) {
  const bool loop = program_[ir::InstId(inst.payload)].op == ir::OpKind::kLoop;
  Element target = Target((loop ? "→ END OF LOOP " : "→ END OF BLOCK ") + NameOf(ir::InstId(inst.payload)));
  if (ir::ValueId(inst.a).valid()) {
    Output(ir::ValueId(inst.a), std::move(target));
  } else {
    Always(std::move(target));
  }
}

void LadderBuilder::Repeat(const ir::Inst& inst) {
  Element target = Target("↑ LOOP " + NameOf(ir::InstId(inst.payload)));
  if (ir::ValueId(inst.a).valid()) {
    Output(ir::ValueId(inst.a), std::move(target));
  } else {
    Always(std::move(target));
  }
  const ir::RegionId refused(inst.b);
  if (!refused.valid() || program_.regions[refused].insts.empty()) return;
  Head("WHEN NO ROUND IS LEFT", {});
  Region(refused);
  End();
}

}  // namespace plcxx::report
