// One instruction: its operands are visible values of the right types, what it names exists.

#include "transpiler/ir/verifier_state.h"

namespace plcxx::ir {
namespace {

constexpr uint32_t kNoValue = support::Id<void>::kNone;
constexpr std::string_view kOperandNames[] = {"operand 1", "operand 2", "operand 3"};

/// How many low bits of a constant count.
uint32_t Bits(Type type) { return type == Type::kBit ? 1 : 8 * Bytes(type); }

bool IsKind(const Program& program, uint32_t state, StateKind kind) {
  return state < program.states.size() && program.states[StateId(state)].kind == kind;
}

struct OperandCheck {
  Verifier& verifier;
  const Program& program;
  const Inst& inst;
  uint32_t floor;

  void Use(uint32_t word, Type type, const OperandName& what) { verifier.VerifyUse(inst, word, type, what, floor); }
  void Report(const std::string& finding) { verifier.Report(inst, finding); }

  void Operands(const OpInfo& info) {
    const uint32_t words[] = {inst.a, inst.b, inst.c};
    for (uint32_t i = 0; i < 3; ++i) {
      if (i < info.operand_count) {
        Use(words[i], info.operands[i], {kOperandNames[i]});
      } else if (words[i] != kNoValue) {
        Report("too many operands");
      }
    }
    if (inst.type != info.result) Report("result of another type");
  }

  void Constant() {
    const uint64_t value = ConstantValue(inst);
    if (inst.type == Type::kNone) Report("no type");
    if (Bits(inst.type) < 64 && value >> Bits(inst.type) != 0) Report(std::to_string(value) + " is too large");
  }

  /// The place of a load or store; gives its type.
  Type Access(uint32_t index) {
    if (inst.payload >= program.places.size()) {
      Report("unknown place");
      return Type::kNone;
    }
    const Place& place = program.places[PlaceId(inst.payload)];
    if (place.indexed != (index != kNoValue)) {
      Report(place.name + (place.indexed ? " needs an index" : " has no index"));
    } else if (place.indexed) {
      Use(index, Type::kI32, {"index"});
    }
    return place.type;
  }

  void Arguments(const std::vector<Parameter>& parameters, const std::vector<ValueId>& arguments, Type result) {
    if (parameters.size() != arguments.size()) {
      Report(std::to_string(arguments.size()) + " arguments for " + std::to_string(parameters.size()) + " parameters");
      return;
    }
    for (size_t i = 0; i < arguments.size(); ++i) {
      Use(arguments[i].index, parameters[i].type, {"argument", parameters[i].name});
    }
    if (inst.type != result) Report("result of another type");
  }

  void Call() {
    if (inst.payload >= program.calls.size()) return Report("unknown call");
    const ir::Call& call = program.calls[CallId(inst.payload)];
    if (inst.op == OpKind::kHostCall) {
      if (call.host.index >= program.host_functions.size()) return Report("unknown host function");
      const HostFunction& host = program.host_functions[call.host];
      Arguments(host.parameters, call.arguments, host.result);
      const bool has_out = call.out.index < program.places.size();
      if (has_out != (host.out.type != Type::kNone) || (has_out && program.places[call.out].type != host.out.type)) {
        Report("second result of another type");
      }
      return;
    }
    if (call.routine.index >= program.routines.size()) return Report("unknown routine");
    const Routine& callee = program.routines[call.routine];
    Arguments(callee.parameters, call.arguments, callee.result);
    verifier.callees[verifier.routine.index].push_back(call.routine);
    const bool schedules = program.routines[verifier.routine].kind == RoutineKind::kSchedule;
    if (!schedules && callee.kind != RoutineKind::kSubroutine) Report(callee.name + " is no subroutine");
  }
};

}  // namespace

void Verifier::VerifyUse(const Inst& inst, uint32_t word, Type type, const OperandName& what, uint32_t floor) {
  const auto report = [&](const std::string& finding) {
    Report(inst, std::string(what.role) + (what.name.empty() ? "" : " ") + std::string(what.name) + finding);
  };
  if (word >= program.insts.size()) return report(" is missing");
  if (position[word] == 0) return report(" is used before it is computed");
  if (!region_open[home[word].index]) return report(" is computed in a region that is not around it");
  if (position[word] <= floor) return report(" crosses a statement");
  const Type found = program[ValueId(word)].type;
  if (type == Type::kNone ? found == Type::kNone : found != type) {
    report(" is " + std::string(Name(found)) + (type == Type::kNone ? "" : ", not " + std::string(Name(type))));
  }
}

void Verifier::VerifyInst(const Inst& inst, uint32_t floor) {
  OperandCheck check{.verifier = *this, .program = program, .inst = inst, .floor = floor};
  const OpInfo& info = Info(inst.op);
  switch (info.shape) {
    case Shape::kStep:
      if (!IsKind(program, inst.payload, *info.state)) Report(inst, "state instance of another kind");
      check.Operands(info);
      break;
    case Shape::kPure:
      check.Operands(info);
      break;
    case Shape::kConst:
      check.Constant();
      break;
    case Shape::kLoad:
      if (check.Access(inst.a) != inst.type) Report(inst, "result of another type");
      break;
    case Shape::kStore: {
      const Type type = check.Access(inst.b);
      if (type != Type::kNone) VerifyUse(inst, inst.a, type, {"stored value"}, floor);
      break;
    }
    case Shape::kText:
      if (!IsKind(program, inst.payload, StateKind::kTextFlag)) Report(inst, "no text flag");
      if (!IsKind(program, inst.a, StateKind::kTextInbox)) Report(inst, "no text inbox");
      if (inst.b >= program.texts.size()) Report(inst, "unknown text");
      break;
    case Shape::kCall:
    case Shape::kHostCall:
      check.Call();
      break;
    case Shape::kStatement:
    case Shape::kIf:
    case Shape::kSwitch:
    case Shape::kLoop:
    case Shape::kBlock:
    case Shape::kExit:
    case Shape::kRepeat:
    case Shape::kJump:
    case Shape::kLabel:
      break;  // verifier_regions.cc
  }
}

}  // namespace plcxx::ir
