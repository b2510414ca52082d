#include "transpiler/ir/builder.h"

#include "transpiler/ir/uses.h"

namespace plcxx::ir {
namespace {

uint32_t Word(ValueId id) { return id.index; }

}  // namespace

InstId Builder::Append(Inst inst) {
  inst.range = range_;
  const InstId id = program_.insts.Add(inst);
  program_.regions[region_].insts.push_back(id);
  return id;
}

ValueId Builder::Constant(Type type, uint64_t value, uint32_t base) {
  const auto low = static_cast<uint32_t>(value), high = static_cast<uint32_t>(value >> 32);
  return Append({.op = OpKind::kConst, .type = type, .a = low, .b = high, .c = base});
}

ValueId Builder::Poison(Type type) { return Append({.op = OpKind::kPoison, .type = type, .a = 0, .b = 0}); }

ValueId Builder::Pure(OpKind op, std::initializer_list<ValueId> operands) {
  const OpInfo& info = Info(op);
  PLCXX_CHECK(info.shape == Shape::kPure && operands.size() == info.operand_count);
  Inst inst{.op = op, .type = info.result};
  uint32_t* words[] = {&inst.a, &inst.b, &inst.c};
  size_t i = 0;
  for (const ValueId operand : operands) {
    PLCXX_CHECK(program_[operand].type == info.operands[i]);
    *words[i++] = Word(operand);
  }
  return Append(inst);
}

ValueId Builder::Load(PlaceId place, ValueId index) {
  PLCXX_CHECK(program_.places[place].indexed == index.valid());
  return Append({.op = OpKind::kLoad, .type = program_.places[place].type, .payload = place.index, .a = Word(index)});
}

void Builder::Store(PlaceId place, ValueId value, ValueId index) {
  PLCXX_CHECK(program_.places[place].indexed == index.valid());
  PLCXX_CHECK(program_[value].type == program_.places[place].type);
  Append({.op = OpKind::kStore, .payload = place.index, .a = Word(value), .b = Word(index)});
}

ValueId Builder::Step(OpKind op, StateId state, std::initializer_list<ValueId> operands) {
  const OpInfo& info = Info(op);
  PLCXX_CHECK(info.shape == Shape::kStep && operands.size() == info.operand_count);
  PLCXX_CHECK(program_.states[state].kind == *info.state);
  Inst inst{.op = op, .type = info.result, .payload = state.index};
  uint32_t* words[] = {&inst.a, &inst.b, &inst.c};
  size_t i = 0;
  for (const ValueId operand : operands) {
    PLCXX_CHECK(program_[operand].type == info.operands[i]);
    *words[i++] = Word(operand);
  }
  return Append(inst);
}

void Builder::UpdateText(StateId flag, StateId inbox, TextId text) {
  Append({.op = OpKind::kUpdateText, .payload = flag.index, .a = inbox.index, .b = text.index});
}

void Builder::Statement(StatementId statement) { Append({.op = OpKind::kStatement, .payload = statement.index}); }

InstId Builder::If(ValueId condition, RegionId then, RegionId otherwise) {
  PLCXX_CHECK(program_[condition].type == Type::kBit);
  return Append({.op = OpKind::kIf, .a = Word(condition), .b = then.index, .c = otherwise.index});
}

InstId Builder::SwitchOn(ValueId selector, Switch cases) {
  const SwitchId id = program_.switches.Add(std::move(cases));
  return Append({.op = OpKind::kSwitch, .payload = id.index, .a = Word(selector)});
}

InstId Builder::LoopWith(Loop loop) {
  const LoopId id = program_.loops.Add(loop);
  return Append({.op = OpKind::kLoop, .payload = id.index, .a = loop.body.index});
}

InstId Builder::Block(RegionId body) { return Append({.op = OpKind::kBlock, .a = body.index}); }

void Builder::Exit(InstId block, ValueId condition) {
  Append({.op = OpKind::kExit, .payload = block.index, .a = Word(condition)});
}

void Builder::Repeat(InstId loop, ValueId condition, RegionId refused) {
  Append({.op = OpKind::kRepeat, .payload = loop.index, .a = Word(condition), .b = refused.index});
}

ValueId Builder::CallRoutine(RoutineId routine, std::vector<ValueId> arguments) {
  const Type result = program_.routines[routine].result;
  const CallId id = program_.calls.Add({.routine = routine, .host = {}, .arguments = std::move(arguments), .out = {}});
  return Append({.op = OpKind::kCall, .type = result, .payload = id.index});
}

ValueId Builder::CallHost(HostFunctionId function, std::vector<ValueId> arguments, PlaceId out) {
  const HostFunction& host = program_.host_functions[function];
  PLCXX_CHECK(host.parameters.size() == arguments.size());
  for (size_t i = 0; i < arguments.size(); ++i) PLCXX_CHECK(program_[arguments[i]].type == host.parameters[i].type);
  const Type result = host.result;
  PLCXX_CHECK(out.valid() == (host.out.type != Type::kNone));
  PLCXX_CHECK(!out.valid() || program_.places[out].type == host.out.type);
  const CallId id =
      program_.calls.Add({.routine = {}, .host = function, .arguments = std::move(arguments), .out = out});
  return Append({.op = OpKind::kHostCall, .type = result, .payload = id.index});
}

void Builder::Jump(uint32_t label, ValueId condition) {
  Append({.op = OpKind::kJump, .payload = label, .a = Word(condition)});
}

void Builder::JumpBack(uint32_t label, ValueId condition, PlaceId budget, RegionId refused) {
  PLCXX_CHECK(program_.places[budget].type == Type::kI32);
  Append({.op = OpKind::kJump, .payload = label, .a = Word(condition), .b = refused.index, .c = budget.index});
}

void Builder::Label(uint32_t label) { Append({.op = OpKind::kLabel, .payload = label}); }

std::vector<RegionId> OwnedRegions(const Program& program, const Inst& inst) {
  std::vector<RegionId> regions;
  const auto add = [&regions](RegionId region) {
    if (region.valid()) regions.push_back(region);
  };
  switch (Info(inst.op).shape) {
    case Shape::kIf:
      add(RegionId(inst.b));
      add(RegionId(inst.c));
      break;
    case Shape::kSwitch:
      for (const SwitchCase& arm : program.switches[SwitchId(inst.payload)].cases) add(arm.region);
      break;
    case Shape::kLoop: {
      const Loop& loop = program.loops[LoopId(inst.payload)];
      add(loop.condition);
      add(loop.body);
      add(loop.step);
      add(loop.exhausted);
      break;
    }
    case Shape::kBlock:
      add(RegionId(inst.a));
      break;
    case Shape::kRepeat:
    case Shape::kJump:
      add(RegionId(inst.b));
      break;
    case Shape::kPure:
    case Shape::kStep:
    case Shape::kConst:
    case Shape::kLoad:
    case Shape::kStore:
    case Shape::kText:
    case Shape::kStatement:
    case Shape::kExit:
    case Shape::kCall:
    case Shape::kHostCall:
    case Shape::kLabel:
      break;
  }
  return regions;
}

std::vector<ValueId> UsedValues(const Program& program, const Inst& inst) {
  std::vector<ValueId> values;
  ForEachUse(program, inst, [&values](uint32_t word) { values.emplace_back(word); });
  return values;
}

}  // namespace plcxx::ir
