// Effects as rungs: what is stored, stepped, called; values that are kept; all ladders of a program.

#include "transpiler/report/ladder_build.h"

#include "transpiler/ir/builder.h"

namespace plcxx::report {
namespace {}  // namespace

Element Target(std::string title) {
  Element element;
  element.shape = Shape::kTarget;
  element.title = std::move(title);
  return element;
}

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

/// An output after the network of `driver`; beside the outputs of the rung before when that has the same network.
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

/// After the region, what follows is the outer statement's again.
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
  if (ir::Info(inst.op).shape == ir::Shape::kStep && inst.a != kNoWord &&
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
      } else if (shape == ir::Shape::kStep && inst.a != kNoWord &&
                 program_[ir::ValueId(inst.a)].type == ir::Type::kBit) {
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
