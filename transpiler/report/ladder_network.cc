#include "transpiler/report/ladder_network.h"

#include <utility>

#include "transpiler/ir/builder.h"

namespace plcxx::report {
namespace {

/// Does something beside giving a value, so that it is in the picture once, at the rail.
bool IsBlock(ir::Shape shape) {
  return shape == ir::Shape::kStep || shape == ir::Shape::kCall || shape == ir::Shape::kHostCall;
}

Sense Opposite(Sense sense) { return sense == Sense::kPlain ? Sense::kInverted : Sense::kPlain; }
Shape ContactOf(Sense sense) { return sense == Sense::kPlain ? Shape::kContact : Shape::kNotContact; }

Element Plain(Shape shape) {
  Element element;
  element.shape = shape;
  return element;
}

/// What conducts where the bit is 1, or with kInverted where it is 0.
Element WithState(Element element, ir::ValueId value, Sense sense) {
  element.value = value;
  element.inverted = sense == Sense::kInverted;
  return element;
}

/// `parts` in series or in parallel; what is of the same kind already is joined, one part alone stays itself.
Element Join(Shape shape, std::vector<Element> parts) {
  Element joined = Plain(shape);
  for (Element& part : parts) {
    if (part.shape == shape && (shape == Shape::kParallel || !part.rooted || joined.parts.empty())) {
      for (Element& inner : part.parts) joined.parts.push_back(std::move(inner));
    } else if (shape != Shape::kSeries || part.shape != Shape::kWire) {
      joined.parts.push_back(std::move(part));
    }
  }
  if (joined.parts.empty()) return Plain(Shape::kWire);
  if (joined.parts.size() == 1) return std::move(joined.parts.front());
  joined.rooted = joined.parts.front().rooted;
  if (shape == Shape::kParallel) {
    for (const Element& part : joined.parts) joined.rooted = joined.rooted || part.rooted;
  }
  return joined;
}

}  // namespace

Element NetworkBuilder::OfPlace(Shape shape, ir::PlaceId id, ir::ValueId index) const {
  const ir::Place& place = program_.places[id];
  Element element = Plain(shape);
  element.name = text_.Place(id, index);
  if (place.address != place.name && place.address != element.name) element.address = place.address;
  element.signal = uses_.of_place[id.index];
  element.local = !place.is_field() && program_.spaces[place.space].lifetime == ir::Lifetime::kRoutine;
  return element;
}

Element NetworkBuilder::OfLocal(Shape shape, ir::ValueId value) const {
  Element element = Plain(shape);
  element.name = text_.LocalName(value);
  element.local = true;
  return WithState(std::move(element), value, shape == Shape::kNotContact ? Sense::kInverted : Sense::kPlain);
}

/// Is the bit a contact of its own, in either sense?
bool NetworkBuilder::IsContact(ir::ValueId value) const {
  const ir::Inst& inst = program_[value];
  if (text_.IsLocal(value) || inst.op == ir::OpKind::kLoad) return true;
  return inst.op == ir::OpKind::kBitNot && IsContact(ir::ValueId(inst.a));
}

/// Does its network contain a block that needs everything to its left?
bool NetworkBuilder::NeedsRail(ir::ValueId value) const {
  const ir::Inst& inst = program_[value];
  if (text_.IsLocal(value)) return false;
  const ir::Shape shape = ir::Info(inst.op).shape;
  if (IsBlock(shape)) return true;
  if (shape != ir::Shape::kPure) return false;
  for (const ir::ValueId operand : ir::UsedValues(program_, inst)) {
    if (program_[operand].type == ir::Type::kBit && NeedsRail(operand)) return true;
  }
  return false;
}

Element NetworkBuilder::Network(ir::ValueId value) { return Of(value, Sense::kPlain, Position::kAtRail); }
Element NetworkBuilder::Definition(ir::ValueId value) { return OfDefinition(value, Sense::kPlain, Position::kAtRail); }

Element NetworkBuilder::Of(ir::ValueId value, Sense sense, Position position) {
  if (text_.IsLocal(value)) return OfLocal(ContactOf(sense), value);
  return OfDefinition(value, sense, position);
}

Element NetworkBuilder::OfDefinition(ir::ValueId value, Sense sense, Position position) {
  const ir::Inst& inst = program_[value];
  const ir::Shape shape = ir::Info(inst.op).shape;
  if (shape == ir::Shape::kConst && inst.op != ir::OpKind::kPoison) {
    return Plain((ir::ConstantValue(inst) != 0) == (sense == Sense::kPlain) ? Shape::kWire : Shape::kNever);
  }
  if (shape == ir::Shape::kLoad) {
    return WithState(OfPlace(ContactOf(sense), ir::PlaceId(inst.payload), ir::ValueId(inst.a)), value, sense);
  }
  if (shape == ir::Shape::kPure) return OfPure(value, sense, position);
  return IsBlock(shape) ? Rooted(value, sense, position) : Condition(value, sense, position);
}

Element NetworkBuilder::OfPure(ir::ValueId value, Sense sense, Position position) {
  const ir::Inst& inst = program_[value];
  const ir::ValueId a(inst.a), b(inst.b);
  const bool plain = sense == Sense::kPlain;
  if (inst.op == ir::OpKind::kBitNot) return Of(a, Opposite(sense), position);
  if (inst.op == ir::OpKind::kBitAnd) return Chain(plain ? Shape::kSeries : Shape::kParallel, a, b, sense, position);
  if (inst.op == ir::OpKind::kBitOr) return Chain(plain ? Shape::kParallel : Shape::kSeries, a, b, sense, position);
  if (inst.op == ir::OpKind::kBitXor && IsContact(a) && IsContact(b)) return Either(a, b, sense, position);
  if (inst.op == ir::OpKind::kSelect1) {
    Element choice = Choice(inst, sense, position);
    return choice.shape == Shape::kBox ? WithState(std::move(choice), value, sense) : choice;
  }
  return Condition(value, sense, position);
}

/// Two in series or in parallel. In series only the first one can begin at the rail: of two that have to, the second
/// becomes an auxiliary bit; when only the second has to, it comes first (neither changes what the other reads: what
/// generated code evaluates in one expression may be evaluated in any order).
Element NetworkBuilder::Chain(Shape shape, ir::ValueId a, ir::ValueId b, Sense sense, Position position) {
  std::vector<Element> parts;
  if (shape == Shape::kParallel) {
    parts.push_back(Of(a, sense, position));
    parts.push_back(Of(b, sense, position));
    return Join(shape, std::move(parts));
  }
  const bool swapped = position == Position::kAtRail && NeedsRail(b) && !NeedsRail(a);
  parts.push_back(Of(swapped ? b : a, sense, position));
  parts.push_back(Of(swapped ? a : b, sense, Position::kInside));
  return Join(shape, std::move(parts));
}

/// a xor b, both contacts: (a, not b) beside (not a, b).
Element NetworkBuilder::Either(ir::ValueId a, ir::ValueId b, Sense sense, Position position) {
  std::vector<Element> ways;
  for (const Sense first : {Sense::kPlain, Sense::kInverted}) {
    std::vector<Element> way;
    way.push_back(Of(a, first, position));
    way.push_back(Of(b, sense == Sense::kPlain ? Opposite(first) : first, Position::kInside));
    ways.push_back(Join(Shape::kSeries, std::move(way)));
  }
  return Join(Shape::kParallel, std::move(ways));
}

/// c ? a : b as (c, a) beside (not c, b).
Element NetworkBuilder::Choice(const ir::Inst& inst, Sense sense, Position position) {
  const ir::ValueId condition(inst.a);
  if (!IsContact(condition)) {
    Element box = Plain(Shape::kBox);
    box.title = sense == Sense::kPlain ? "IF" : "NOT IF";
    box.lines = {text_.Of(condition), "then " + text_.Of(ir::ValueId(inst.b)), "else " + text_.Of(ir::ValueId(inst.c))};
    return box;
  }
  std::vector<Element> ways;
  for (const Sense chosen : {Sense::kPlain, Sense::kInverted}) {
    std::vector<Element> way;
    way.push_back(Of(condition, chosen, position));
    way.push_back(Of(ir::ValueId(chosen == Sense::kPlain ? inst.b : inst.c), sense, Position::kInside));
    ways.push_back(Join(Shape::kSeries, std::move(way)));
  }
  return Join(Shape::kParallel, std::move(ways));
}

/// A bit that has no contacts: a comparison, or a box with its text.
Element NetworkBuilder::Condition(ir::ValueId value, Sense sense, Position position) {
  const ir::Inst& inst = program_[value];
  const char* sign = sense == Sense::kPlain ? ComparisonSign(inst.op) : OppositeSign(inst.op);
  if (sign != nullptr) {
    Element element = Plain(Shape::kCompare);
    element.name = text_.Of(ir::ValueId(inst.a));
    element.title = sign;
    element.lines = {text_.Of(ir::ValueId(inst.b))};
    const ir::Inst& left = program_[ir::ValueId(inst.a)];
    if (left.op == ir::OpKind::kLoad && !text_.IsLocal(ir::ValueId(inst.a))) {
      element.signal = uses_.of_place[left.payload];
    }
    return WithState(std::move(element), value, sense);
  }
  if (NeedsRail(value) && position == Position::kInside) return Rooted(value, sense, position);
  Element box = Plain(Shape::kBox);
  box.title = sense == Sense::kPlain ? "1 IF" : "0 IF";
  box.lines = {text_.Definition(value)};
  return WithState(std::move(box), value, sense);
}

Element NetworkBuilder::Box(ir::InstId id) const {
  const ir::Inst& inst = program_[id];
  Element box = Plain(Shape::kBox);
  switch (ir::Info(inst.op).shape) {
    case ir::Shape::kStep: {
      box.name = program_.states[ir::StateId(inst.payload)].name;
      box.signal = uses_.of_state[inst.payload];
      box.title = ir::Info(inst.op).function;
      const bool fed = inst.a != kNoWord && program_[ir::ValueId(inst.a)].type == ir::Type::kBit;
      for (const uint32_t word : {fed ? kNoWord : inst.a, inst.b, inst.c}) {
        if (word != kNoWord) box.lines.push_back(text_.Of(ir::ValueId(word)));
      }
      break;
    }
    case ir::Shape::kText:
      box.name = program_.states[ir::StateId(inst.payload)].name;
      box.signal = uses_.of_state[inst.payload];
      box.title = "TEXT =";
      box.lines = {"\"" + program_.texts[ir::TextId(inst.b)] + "\""};
      break;
    case ir::Shape::kCall:
    case ir::Shape::kHostCall: {
      const ir::Call& call = program_.calls[ir::CallId(inst.payload)];
      box.title = call.host.valid() ? "HOST" : "CALL";
      const std::string& name =
          call.host.valid() ? program_.host_functions[call.host].name : program_.routines[call.routine].name;
      box.lines = {name};
      if (const std::string arguments = text_.Arguments(call); !arguments.empty()) box.lines.push_back(arguments);
      if (call.out.valid()) box.lines.push_back("→ " + program_.places[call.out].name);
      break;
    }
    case ir::Shape::kPure:
    case ir::Shape::kConst:
    case ir::Shape::kLoad:
    case ir::Shape::kStore:
    case ir::Shape::kStatement:
    case ir::Shape::kIf:
    case ir::Shape::kSwitch:
    case ir::Shape::kLoop:
    case ir::Shape::kBlock:
    case ir::Shape::kExit:
    case ir::Shape::kRepeat:
    case ir::Shape::kJump:
    case ir::Shape::kLabel:
      box.title = "?";
      box.lines = {text_.Definition(id)};
      break;
  }
  return box;
}

Element NetworkBuilder::Feed(ir::InstId id) {
  const ir::Inst& inst = program_[id];
  const bool fed = ir::Info(inst.op).shape == ir::Shape::kStep && inst.a != kNoWord &&
                   program_[ir::ValueId(inst.a)].type == ir::Type::kBit;
  return fed ? Network(ir::ValueId(inst.a)) : Plain(Shape::kWire);
}

/// A block with an output: its input comes from the rail. Elsewhere it is a rung of its own, and a contact.
Element NetworkBuilder::Rooted(ir::InstId id, Sense sense, Position position) {
  std::vector<Element> parts;
  const ir::Shape shape = ir::Info(program_[id].op).shape;
  if (shape == ir::Shape::kPure) {
    Element box = Plain(Shape::kBox);
    box.title = "1 IF";
    box.lines = {text_.Definition(id)};
    parts.push_back(std::move(box));
  } else {
    parts.push_back(Feed(id));
    parts.push_back(Box(id));
  }
  parts.back().rooted = true;
  parts.back().value = id;
  Element chain = Join(Shape::kSeries, std::move(parts));
  chain.rooted = true;
  if (position == Position::kAtRail) {
    if (sense == Sense::kPlain) return chain;
    std::vector<Element> inverted;
    inverted.push_back(std::move(chain));
    inverted.push_back(Plain(Shape::kInvert));
    inverted.back().rooted = true;
    Element whole = Plain(Shape::kSeries);
    whole.rooted = true;
    for (Element& part : inverted) {
      if (part.shape == Shape::kSeries) {
        for (Element& inner : part.parts) whole.parts.push_back(std::move(inner));
      } else {
        whole.parts.push_back(std::move(part));
      }
    }
    return whole;
  }
  Rung before;
  before.network = std::move(chain);
  Element bit = Plain(Shape::kCoil);
  bit.name = "#" + std::to_string(next_auxiliary_++);
  bit.local = true;
  Element contact = WithState(bit, id, sense);
  contact.shape = ContactOf(sense);
  before.outputs.push_back(std::move(bit));
  before_(std::move(before));
  return contact;
}

}  // namespace plcxx::report
