// From instructions to ladder items: effects are rungs, regions are frames.

#include <algorithm>
#include <utility>

#include "transpiler/ir/builder.h"
#include "transpiler/report/ladder.h"
#include "transpiler/report/ladder_network.h"

namespace plcxx::report {
namespace {

constexpr uint32_t kNone = support::Id<void>::kNone;

Element Target(std::string title) {
  Element element;
  element.shape = Shape::kTarget;
  element.title = std::move(title);
  return element;
}

class LadderBuilder {
 public:
  LadderBuilder(const ProgramInput& input, const CrossReference& uses, const ValueText& text)
      : program_(*input.program),
        text_(text),
        networks_(input, uses, text, [this](Rung rung) { Append(std::move(rung)); }) {}

  std::vector<LadderItem> Run(const ir::Routine& routine) {
    routine_ = &routine;
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) Region(region);
    return std::move(items_);
  }

 private:
  void Region(ir::RegionId region);
  void Insts(const std::vector<ir::InstId>& insts, size_t begin, size_t end);
  void Inst(ir::InstId id);
  void Local(ir::InstId id);
  void Store(const ir::Inst& inst);
  ir::ValueId ConditionOfSet(const ir::Inst& store, Shape& shape) const;
  void If(const ir::Inst& inst);
  bool IsConditional(const ir::Inst& inst) const;
  void Conditional(const ir::Inst& inst);
  ir::InstId ChainedIf(ir::RegionId otherwise) const;
  /// The condition of a later arm; a box with text when it needs rungs before it, which would stand in another arm.
  Element Arm(ir::ValueId condition);
  void Switch(const ir::Inst& inst);
  bool IsChoiceOfSlices(const ir::Inst& inst) const;
  void Loop(ir::InstId id, const ir::Inst& inst);
  void Block(ir::InstId id, const ir::Inst& inst);
  void Exit(const ir::Inst& inst);
  void Repeat(const ir::Inst& inst);

  void Own(ir::StatementId statement);
  /// `driver`: the value that the network is; none: no other rung's outputs may join.
  void Append(Rung rung, ir::ValueId driver = {});
  void Output(ir::ValueId driver, Element output);
  void Always(Element output);
  Element Assignment(const std::string& target, const std::string& value, uint32_t signal) const;
  void Head(std::string label, Rung rung, ItemKind kind = ItemKind::kHead);
  void Section(std::string label) { Head(std::move(label), {}, ItemKind::kSection); }
  void End(std::string label = "");
  std::string NameOf(ir::InstId frame);

  const ir::Program& program_;
  const ValueText& text_;
  NetworkBuilder networks_;
  const ir::Routine* routine_ = nullptr;
  std::vector<LadderItem> items_;
  ir::StatementId statement_;
  uint32_t depth_ = 0;
  ir::ValueId driver_;              // of the rung that was appended last; none: nothing may join it
  std::vector<ir::InstId> frames_;  // blocks and loops around, for names
};

void LadderBuilder::Own(ir::StatementId statement) {
  statement_ = statement;
  driver_ = {};
  LadderItem item;
  item.kind = ItemKind::kStatement;
  item.statement = statement;
  item.depth = depth_;
  items_.push_back(std::move(item));
}

void LadderBuilder::Append(Rung rung, ir::ValueId driver) {
  LadderItem item;
  item.kind = ItemKind::kRung;
  item.rung = std::move(rung);
  item.depth = depth_;
  item.statement = statement_;
  items_.push_back(std::move(item));
  driver_ = driver;
}

/// An output behind the network of `driver`; beside the outputs of the rung before when that has the same network.
void LadderBuilder::Output(ir::ValueId driver, Element output) {
  if (driver_.valid() && driver_ == driver) {
    items_.back().rung.outputs.push_back(std::move(output));
    return;
  }
  Rung rung;
  rung.network = networks_.Network(driver);
  rung.outputs.push_back(std::move(output));
  Append(std::move(rung), driver);
}

void LadderBuilder::Always(Element output) {
  Rung rung;
  rung.network.shape = Shape::kWire;
  rung.outputs.push_back(std::move(output));
  Append(std::move(rung));
}

Element LadderBuilder::Assignment(const std::string& target, const std::string& value, uint32_t signal) const {
  Element box;
  box.shape = Shape::kBox;
  box.title = ":=";
  box.name = target;
  box.lines = {value};
  box.signal = signal;
  return box;
}

void LadderBuilder::Head(std::string label, Rung rung, ItemKind kind) {
  if (kind == ItemKind::kSection) --depth_;
  LadderItem item;
  item.kind = kind;
  item.rung = std::move(rung);
  item.label = std::move(label);
  item.depth = depth_++;
  item.statement = statement_;
  items_.push_back(std::move(item));
  driver_ = {};
}

void LadderBuilder::End(std::string label) {
  LadderItem item;
  item.kind = ItemKind::kEnd;
  item.label = std::move(label);
  item.depth = --depth_;
  item.statement = statement_;
  items_.push_back(std::move(item));
  driver_ = {};
}

void LadderBuilder::Region(ir::RegionId region) {
  if (!region.valid()) return;
  const std::vector<ir::InstId>& insts = program_.regions[region].insts;
  Insts(insts, 0, insts.size());
}

/// Behind the region, what follows is the outer statement's again.
void LadderBuilder::Insts(const std::vector<ir::InstId>& insts, size_t begin, size_t end) {
  const ir::StatementId outer = statement_;
  for (size_t i = begin; i < end; ++i) Inst(insts[i]);
  if (statement_ != outer) Own(outer);
}

/// A value that is kept: a bit as an auxiliary one, a word in a box.
void LadderBuilder::Local(ir::InstId id) {
  if (program_[id].type == ir::Type::kBit) {
    Rung rung;
    rung.network = networks_.Definition(id);
    rung.outputs.push_back(networks_.OfLocal(Shape::kCoil, id));
    Append(std::move(rung), id);
    return;
  }
  const ir::Inst& inst = program_[id];
  if (ir::Info(inst.op).shape == ir::Shape::kStep && inst.a != kNone &&
      program_[ir::ValueId(inst.a)].type == ir::Type::kBit) {
    Element box = networks_.Box(id);
    box.lines.push_back("→ " + text_.LocalName(id));
    Output(ir::ValueId(inst.a), std::move(box));
    return;
  }
  Element box = Assignment(text_.LocalName(id), text_.Definition(id), kNoSignal);
  box.local = true;
  Always(std::move(box));
}

/// An instruction that sets or clears a bit on a condition is `x = x | c` or `x = x & !c`, where the read of x has no
/// text of its own. Gives the condition, which of the two it is in `shape`; none: it is neither.
ir::ValueId LadderBuilder::ConditionOfSet(const ir::Inst& store, Shape& shape) const {
  const ir::ValueId value(store.a);
  const ir::Inst& joined = program_[value];
  if (text_.IsLocal(value) || (joined.op != ir::OpKind::kBitOr && joined.op != ir::OpKind::kBitAnd)) return {};
  const ir::Inst& read = program_[ir::ValueId(joined.a)];
  const bool implied = read.op == ir::OpKind::kLoad && read.payload == store.payload && read.range == store.range &&
                       !program_.places[ir::PlaceId(store.payload)].indexed && !text_.IsLocal(ir::ValueId(joined.a));
  if (!implied) return {};
  if (joined.op == ir::OpKind::kBitOr) {
    shape = Shape::kSet;
    return ir::ValueId(joined.b);
  }
  const ir::Inst& keeps = program_[ir::ValueId(joined.b)];
  if (keeps.op != ir::OpKind::kBitNot || text_.IsLocal(ir::ValueId(joined.b))) return {};
  shape = Shape::kReset;
  return ir::ValueId(keeps.a);
}

void LadderBuilder::Store(const ir::Inst& inst) {
  const ir::PlaceId place(inst.payload);
  const ir::ValueId value(inst.a), index(inst.b);
  if (program_.places[place].type == ir::Type::kBit) {
    Shape shape = Shape::kCoil;
    const ir::ValueId condition = ConditionOfSet(inst, shape);
    Output(condition.valid() ? condition : value, networks_.OfPlace(shape, place, index));
    return;
  }
  Element box = networks_.OfPlace(Shape::kBox, place, index);
  box.title = ":=";
  box.lines = {text_.Of(value)};
  Always(std::move(box));
}

void LadderBuilder::Inst(ir::InstId id) {
  const ir::Inst& inst = program_[id];
  const ir::Shape shape = ir::Info(inst.op).shape;
  switch (shape) {
    case ir::Shape::kConst:
      return;
    case ir::Shape::kPure:
    case ir::Shape::kLoad:
      if (text_.IsLocal(id)) Local(id);
      return;
    case ir::Shape::kStep:
    case ir::Shape::kCall:
    case ir::Shape::kHostCall:
      if (text_.IsLocal(id)) {
        Local(id);
      } else if (inst.type != ir::Type::kNone && text_.IsUsed(id)) {
        return;  // drawn where it is used
      } else if (shape == ir::Shape::kStep && inst.a != kNone && program_[ir::ValueId(inst.a)].type == ir::Type::kBit) {
        Output(ir::ValueId(inst.a), networks_.Box(id));
      } else {
        Always(networks_.Box(id));
      }
      return;
    case ir::Shape::kText:
      Always(networks_.Box(id));
      return;
    case ir::Shape::kStore:
      Store(inst);
      return;
    case ir::Shape::kStatement:
      networks_.Restart();
      Own(ir::StatementId(inst.payload));
      return;
    case ir::Shape::kIf:
      If(inst);
      return;
    case ir::Shape::kSwitch:
      Switch(inst);
      return;
    case ir::Shape::kLoop:
      Loop(id, inst);
      return;
    case ir::Shape::kBlock:
      Block(id, inst);
      return;
    case ir::Shape::kExit:
      Exit(inst);
      return;
    case ir::Shape::kRepeat:
      Repeat(inst);
      return;
    case ir::Shape::kJump:
    case ir::Shape::kLabel:
      Always(Target(std::string(ir::Info(inst.op).text) + " " + std::to_string(inst.payload)));
      return;
  }
}

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
      default:
        return false;
    }
  }
  return any;
}

/// The condition's network, and behind it what it enables: bits set and cleared, boxes.
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

}  // namespace

std::vector<RoutineLadder> MakeLadders(const ProgramInput& input, const CrossReference& uses) {
  const ValueText text(input);
  std::vector<RoutineLadder> ladders;
  for (uint32_t i = 0; i < input.program->routines.size(); ++i) {
    const ir::RoutineId id(i);
    ladders.push_back({id, LadderBuilder(input, uses, text).Run(input.program->routines[id])});
  }
  return ladders;
}

}  // namespace plcxx::report
