#include "transpiler/ir/reader_state.h"

namespace plcxx::ir {
namespace {

struct BodyReader {
  Reader& reader;
  Program& program;
  std::string statement = "entry";                  // whose values need no prefix
  std::unordered_map<std::string, ValueId> values;  // "s1f.0"
  std::vector<std::pair<std::string, InstId>> enclosing;

  ValueId Value();
  uint32_t ValueWord() { return Value().index; }
  void Access(Inst& inst, uint32_t& index);
  /// How the number that comes next is spelled.
  uint32_t BaseOfNext() const {
    return !reader.AtEnd() && reader.lines[reader.line].tokens[reader.token].text.starts_with("0x") ? 16 : 10;
  }
  std::vector<ValueId> Arguments();
  InstId Append(RegionId region, const Inst& inst) {
    const InstId id = program.insts.Add(inst);
    program.regions[region].insts.push_back(id);
    return id;
  }
  bool NextLine();
  /// The lines up to the one that begins with `}`, which stays the current one, its `}` taken.
  void ReadNested(RegionId region);
  /// The block or loop around the current line that has this label.
  uint32_t EnclosingOf(const std::string& label);
  /// Appends a jump or repeat with its region `refused {`, when there is one.
  void ReadRefused(RegionId region, const Inst& inst);
  RegionId NestedRegion();
  /// `name {` and the lines of a region, up to its `}`; the region of `place` must not have been read before.
  void ReadSection(RegionId& place);
  void ReadLoop(InstId id);
  void ReadSwitch(InstId id);
  /// Numbers start again in each part of a routine.
  void BeginPart() {
    statement = "entry";
    std::erase_if(values, [](const auto& value) { return value.first.starts_with("entry."); });
  }
  void ReadIf(InstId id);
  void ReadInst(RegionId region);
  void ReadConstant(Inst& inst);
  void ReadText(Inst& inst);
  void ReadStatement(Inst& inst);
  void ReadCall(Inst& inst, Shape shape);
  void ReadBlock(InstId id);
  /// The value of an instruction gets its name: none where it has no result.
  void Define(const std::string& name, InstId id);
  void ReadOperation(RegionId region, Inst inst, const std::string& name);
};

ValueId BodyReader::Value() {
  const std::string name = reader.Name();
  if (reader.error) return {};
  if (!name.starts_with('%')) {
    reader.Fail("value expected, found '" + name + "'");
    return {};
  }
  const bool qualified = name.find('.') != std::string::npos;
  const auto found = values.find(qualified ? name.substr(1) : statement + '.' + name.substr(1));
  if (found == values.end()) reader.Fail("unknown value '" + name + "'");
  return found == values.end() ? ValueId() : found->second;
}

void BodyReader::Access(Inst& inst, uint32_t& index) {
  const PlaceId place = reader.Known(reader.places, "place");
  inst.payload = place.index;
  if (inst.op == OpKind::kLoad && place.valid()) inst.type = program.places[place].type;
  if (reader.Accept("[")) {
    index = ValueWord();
    reader.Expect("]");
  }
}

std::vector<ValueId> BodyReader::Arguments() {
  std::vector<ValueId> arguments;
  reader.Expect("(");
  if (reader.Accept(")")) return arguments;
  do arguments.push_back(Value());
  while (reader.Accept(","));
  reader.Expect(")");
  return arguments;
}

bool BodyReader::NextLine() {
  reader.token = 0;
  if (++reader.line < reader.lines.size()) return true;
  --reader.line;
  reader.Fail("'}' expected");
  return false;
}

void BodyReader::ReadNested(RegionId region) {
  reader.Expect("{");
  reader.ExpectEnd();
  while (!reader.error && NextLine()) {
    if (reader.Accept("}")) return;
    ReadInst(region);
  }
}

uint32_t BodyReader::EnclosingOf(const std::string& label) {
  for (auto open = enclosing.rbegin(); open != enclosing.rend(); ++open) {
    if (open->first == label) return open->second.index;
  }
  reader.Fail("no block or loop '" + label + "' around this");
  return 0;
}

void BodyReader::ReadRefused(RegionId region, const Inst& inst) {
  const InstId id = Append(region, inst);
  if (!reader.Accept("refused")) return;
  const RegionId refused = NestedRegion();
  program[id].b = refused.index;
}

RegionId BodyReader::NestedRegion() {
  const RegionId region = program.regions.Add({});
  ReadNested(region);
  return region;
}

void BodyReader::ReadSection(RegionId& place) {
  if (place.valid()) reader.Fail("this part is there already");
  const RegionId region = NestedRegion();
  place = region;
  reader.ExpectEnd();
}

void BodyReader::ReadIf(InstId id) {
  const uint32_t condition = ValueWord();
  IfOrigin origin = IfOrigin::kSource;
  if (reader.Accept("jumps")) origin = IfOrigin::kJumps;
  if (reader.Accept("stays")) origin = IfOrigin::kStays;
  const RegionId then = NestedRegion();
  const RegionId otherwise = reader.Accept("else") ? NestedRegion() : RegionId();
  Inst& inst = program[id];
  inst.payload = static_cast<uint32_t>(origin);
  inst.a = condition;
  inst.b = then.index;
  inst.c = otherwise.index;
}

void BodyReader::ReadSwitch(InstId id) {
  program[id].a = ValueWord();
  reader.Expect("{");
  Switch cases;
  while (!reader.error && NextLine() && !reader.Accept("}")) {
    SwitchCase arm;
    if (!reader.Accept("default")) {
      reader.Expect("case");
      do {
        arm.bases.push_back(BaseOfNext());
        arm.values.push_back(reader.Number());
      } while (!reader.AtEnd() && text::Number(reader.lines[reader.line].tokens[reader.token].text));
    }
    arm.falls_through = reader.Accept("falls_through");
    RegionId region;
    ReadSection(region);
    arm.region = region;
    cases.cases.push_back(std::move(arm));
  }
  program[id].payload = program.switches.Add(std::move(cases)).index;
}

void BodyReader::ReadLoop(InstId id) {
  Loop loop;
  enclosing.emplace_back(reader.Name(), id);
  loop.kind = static_cast<LoopBound>(reader.OneOf(text::kBounds, "kind of bound"));
  loop.bound = reader.Number();
  if (!reader.Accept("{")) {
    loop.budget = reader.Known(reader.places, "place");
    reader.Expect("{");
  }
  while (!reader.error && NextLine() && !reader.Accept("}")) {
    if (reader.Accept("condition")) {
      ReadSection(loop.condition);
    } else if (reader.Accept("body")) {
      ReadSection(loop.body);
    } else if (reader.Accept("step")) {
      ReadSection(loop.step);
    } else {
      reader.Expect("exhausted");
      ReadSection(loop.exhausted);
    }
  }
  enclosing.pop_back();
  program[id].a = loop.body.index;
  program[id].payload = program.loops.Add(loop).index;
}

/// `L7`
uint32_t LabelNumber(Reader& reader) {
  const std::string name = reader.Name();
  const std::optional<uint64_t> number = name.starts_with('L') ? text::Number(name.substr(1)) : std::nullopt;
  if (!number) reader.Fail("label expected, found '" + name + "'");
  return static_cast<uint32_t>(number.value_or(0));
}

void BodyReader::ReadConstant(Inst& inst) {
  inst.type = reader.TypeName();
  const uint32_t base = BaseOfNext();
  const uint64_t value = inst.op == OpKind::kConst ? reader.Number() : 0;
  inst.a = static_cast<uint32_t>(value);
  inst.b = static_cast<uint32_t>(value >> 32);
  if (inst.op == OpKind::kConst) inst.c = base;
}

void BodyReader::ReadText(Inst& inst) {
  inst.payload = reader.Known(reader.states, "state").index;
  inst.a = reader.Known(reader.states, "state").index;
  const std::string string = reader.Name();
  const auto [text, added] = reader.texts.emplace(string, TextId(program.texts.size()));
  if (added) program.texts.Add(string);
  inst.b = text->second.index;
}

void BodyReader::ReadStatement(Inst& inst) {
  const std::string handle = reader.Name();
  const auto known = reader.statements.find(handle);
  const StatementId id = known != reader.statements.end() ? known->second : reader.DeclareStatement(handle);
  inst.payload = id.index;
  statement = handle;
}

void BodyReader::ReadCall(Inst& inst, Shape shape) {
  Call call;
  if (shape == Shape::kCall) {
    call.routine = reader.Known(reader.routines, "routine");
    if (!reader.error) inst.type = program.routines[call.routine].result;
  } else {
    call.host = reader.Known(reader.host_functions, "host function");
    if (!reader.error) inst.type = program.host_functions[call.host].result;
  }
  call.arguments = Arguments();
  if (reader.Accept("out")) call.out = reader.Known(reader.places, "place");
  call.exchange = reader.Accept("exchange");
  inst.payload = program.calls.Add(std::move(call)).index;
}

void BodyReader::ReadBlock(InstId id) {
  enclosing.emplace_back(reader.Name(), id);
  const RegionId body = NestedRegion();
  program[id].a = body.index;
  enclosing.pop_back();
}

void BodyReader::Define(const std::string& name, InstId id) {
  const Type type = program[id].type;
  if (name.empty()) {
    if (type != Type::kNone) reader.Fail("the result needs a name: '%0 = '");
  } else if (type == Type::kNone) {
    reader.Fail("this operation has no result");
  } else if (!values.emplace(statement + '.' + name.substr(1), id).second) {
    reader.Fail("value '" + name + "' is defined twice");
  }
}

void BodyReader::ReadOperation(RegionId region, Inst inst, const std::string& name) {
  const OpInfo& info = Info(inst.op);
  inst.type = info.result;
  uint32_t* const words[] = {&inst.a, &inst.b, &inst.c};
  switch (info.shape) {
    case Shape::kStep:
      inst.payload = reader.Known(reader.states, "state").index;
      [[fallthrough]];
    case Shape::kPure:
      for (size_t i = 0; i < info.operand_count; ++i) *words[i] = ValueWord();
      break;
    case Shape::kConst:
      ReadConstant(inst);
      break;
    case Shape::kLoad:
      Access(inst, inst.a);
      break;
    case Shape::kStore:
      Access(inst, inst.b);
      inst.a = ValueWord();
      break;
    case Shape::kText:
      ReadText(inst);
      break;
    case Shape::kStatement:
      ReadStatement(inst);
      break;
    case Shape::kExit:
      inst.payload = EnclosingOf(reader.Name());
      if (reader.Accept("if")) inst.a = ValueWord();
      break;
    case Shape::kRepeat:
      inst.payload = EnclosingOf(reader.Name());
      if (reader.Accept("if")) inst.a = ValueWord();
      ReadRefused(region, inst);
      return;
    case Shape::kJump:
      inst.payload = LabelNumber(reader);
      if (reader.Accept("if")) inst.a = ValueWord();
      if (reader.Accept("budget")) inst.c = reader.Known(reader.places, "place").index;
      ReadRefused(region, inst);
      return;
    case Shape::kLabel:
      inst.payload = LabelNumber(reader);
      break;
    case Shape::kCall:
    case Shape::kHostCall:
      ReadCall(inst, info.shape);
      break;
    case Shape::kIf:
      ReadIf(Append(region, inst));
      return;
    case Shape::kSwitch:
      ReadSwitch(Append(region, inst));
      return;
    case Shape::kLoop:
      ReadLoop(Append(region, inst));
      return;
    case Shape::kBlock:
      ReadBlock(Append(region, inst));
      return;
  }
  Define(name, Append(region, inst));
}

void BodyReader::ReadInst(RegionId region) {
  std::string name;
  std::string op = reader.Name();
  if (op.starts_with('%')) {
    name = std::move(op);
    if (name.find('.') != std::string::npos) reader.Fail("a value is defined without a statement's name");
    reader.Expect("=");
    op = reader.Name();
  }
  const std::optional<OpKind> kind = OpByText(op);
  if (!kind) reader.Fail("unknown operation '" + op + "'");
  if (!reader.error) ReadOperation(region, {.op = *kind}, name);
  reader.ExpectEnd();
}

}  // namespace

void Reader::ReadBody(RoutineId id) {
  BodyReader body{.reader = *this, .program = program};
  Routine parts;  // regions are added while a reference into routines would be held
  const RegionId direct = program.regions.Add({});
  --line;
  bool sections = false;
  while (!error && body.NextLine()) {
    if (Accept("}")) break;
    const bool section = Accept("prologue") || Accept("body") || Accept("epilogue");
    if (section) {
      const std::string& name = lines[line].tokens[0].text;
      body.BeginPart();
      body.ReadSection(name == "prologue" ? parts.prologue : name == "body" ? parts.body : parts.epilogue);
    } else {
      body.ReadInst(direct);
    }
    sections = sections || section;
  }
  if (sections && !error && !program.regions[direct].insts.empty())
    Fail("instructions beside prologue, body, epilogue");
  Routine& routine = program.routines[id];
  routine.prologue = parts.prologue;
  routine.body = sections ? parts.body : direct;
  routine.epilogue = parts.epilogue;
  ExpectEnd();
}

}  // namespace plcxx::ir
