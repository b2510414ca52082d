// Modules, mechanisms and subprograms as routines.

#include <algorithm>
#include <utility>

#include "transpiler/dialects/technol/lowering/internal.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::Type;

std::string Lowering::CommentOf(const Body& body) const {
  if (!body.unit.valid()) return "Subprogram.";
  const Unit& unit = tree_.units[body.unit];
  if (unit.kind == UnitKind::kMechanism) return "Mechanism " + unit.name + ": goes on where it waits.";
  switch (unit.module) {
    case ModuleKind::kInit:
      return "Once at power-on.";
    case ModuleKind::kMain:
      return "The continuous branch: in every slow pass.";
    case ModuleKind::kFast:
      return "In every fast period.";
    case ModuleKind::kClear:
      return "Once for every annulment.";
    case ModuleKind::kHalt:
      return "While REQ_PIS_HALT is 1.";
    case ModuleKind::kPripravne:
      return "Preparatory functions: from the start of a block to their end.";
    case ModuleKind::kZaverecne:
      return "Closing functions: from the end of a block's motion to their end.";
    case ModuleKind::kOther:
      break;
  }
  return "Unknown to the control's scheduler: for the host to call.";
}

void Lowering::AddBodyRoutines() {
  using Kind = ir::RoutineKind;
  for (Body& body : bodies_) {
    if (!body.unit.valid()) {
      body.routine = builder_.AddRoutine(tree_.labels[flow_.subprograms()[body.subprograms.front()].label].name,
                                         Kind::kSubroutine, CommentOf(body));
      ir::Routine& routine = program_.routines[body.routine];
      if (body.subprograms.size() > 1) {
        body.entry = AddLocal("entry", Type::kI8);
        routine.parameters.push_back({.name = "entry", .type = Type::kI8, .enumerators = {}});
        routine.parameter_places.push_back(body.entry);
      }
      if (body.leaves) {
        routine.result = Type::kBit;
        routine.result_place = Local("left", Type::kBit);
      }
      continue;
    }
    const Unit& unit = tree_.units[body.unit];
    if (unit.kind == UnitKind::kMechanism) {
      ActivationPlace(body.unit);  // scenarios name it, whether the program does or not
      body.routine = builder_.AddRoutine("mech_" + unit.name, Kind::kSubroutine, CommentOf(body));
    } else if (unit.module == ModuleKind::kInit) {
      body.routine = init_;
    } else if (unit.module == ModuleKind::kFast) {
      body.routine = fast_;
    } else if (unit.module == ModuleKind::kOther) {
      std::string name = unit.name;
      for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
      body.routine = builder_.AddRoutine(std::move(name), Kind::kInterrupt, CommentOf(body));
    } else {
      body.routine = builder_.AddRoutine(unit.name, Kind::kSubroutine, CommentOf(body));
    }
  }
}

/// What the routine begins with: zeros, the jumps back that it may take, the choice of its waiting point.
void Lowering::BeginBody(Body& body) {
  builder_.SetRegion(program_.routines[body.routine].body);
  builder_.SetRange({});
  registers_.Begin([this](std::string_view name, Type type) { return Local(name, type); });
  if (body.unit.valid()) {
    registers_.Zero();
    if (body.loops) builder_.Store(Local("rounds_left", Type::kI32), builder_.Number(settings_.loop_limit));
  } else if (body.leaves) {
    builder_.Store(Local("left", Type::kBit), builder_.Bit(0));
  }
  stretches_.clear();
  loop_ = {};
  if (body.stretches_are_cases) return BeginStretches(body);
  const ir::ValueId selector = ChosenEntry(body);
  if (!selector.valid()) {
    // Its only entry may be below code that it jumps back to.
    const bool begins_below =
        body.subprograms.size() == 1 && flow_.EntryOf(body.subprograms.front()) != body.instructions.front();
    if (begins_below) builder_.Jump(flow_.EntryOf(body.subprograms.front()).index + 1);
    return;
  }
  ir::Switch choice;
  const auto choose = [&](uint64_t value, InstructionId at) {
    builder_.AddArm(choice, {value}, [&] { builder_.Jump(at.index + 1); });
  };
  for (size_t i = 0; i < body.entries.size(); ++i) choose(i + 1, body.entries[i]);
  for (size_t i = 0; body.entry.valid() && i < body.subprograms.size(); ++i) {
    if (flow_.EntryOf(body.subprograms[i]) != body.instructions.front()) choose(i, flow_.EntryOf(body.subprograms[i]));
  }
  choice.cases.push_back({.values = {}, .region = builder_.NewRegion()});
  builder_.SwitchOn(selector, std::move(choice));
}

ir::ValueId Lowering::ChosenEntry(const Body& body) {
  if (body.entry.valid()) return builder_.Load(body.entry);
  if (body.entries.empty()) return {};
  registers_.Spill();
  if (!body.goes_back) return builder_.Load(StepPlace(body.unit));
  // The step itself stays until a wait: a mechanism that the guard leaves keeps the one with which it came (6.4).
  chosen_ = OwnLocal("step", Type::kI16);
  builder_.Store(chosen_, builder_.Load(StepPlace(body.unit)));
  const ir::RegionId round = builder_.NewRegion();
  loop_ =
      builder_.LoopWith({.kind = ir::LoopBound::kBudget, .budget = Local("rounds_left", Type::kI32), .body = round});
  builder_.SetRegion(round);
  return builder_.Load(chosen_);
}

/// The first stretch is the default: step 0.
void Lowering::BeginStretches(const Body& body) {
  const ir::RegionId around = builder_.region();
  const ir::ValueId step = ChosenEntry(body);
  ir::Switch choice;
  const auto add = [&](std::vector<uint64_t> values, InstructionId first, InstructionId end) {
    const ir::RegionId region = builder_.NewRegion();
    stretches_[first].region = region;
    bool runs_on = false, jumps_on = false;
    const auto& all = body.instructions;
    for (auto at = std::ranges::lower_bound(all, first); at != all.end() && *at < end; ++at) {
      flow_.ForEachSuccessor(*at, [&](InstructionId to, Edge edge) {
        runs_on |= to == end && edge == Edge::kOn;
        jumps_on |= to == end && edge == Edge::kJump;
      });
    }
    stretches_[end].is_jumped_to |= jumps_on;
    choice.cases.push_back({.values = std::move(values), .region = region, .falls_through = runs_on || jumps_on});
  };
  const std::vector<InstructionId>& entries = body.entries;
  add({}, body.instructions.front(), entries.front());
  for (size_t i = 0; i + 1 < entries.size(); ++i) add({i + 1}, entries[i], entries[i + 1]);
  add({entries.size()}, entries.back(), entries.back());
  choice.cases.back().falls_through = false;
  builder_.SwitchOn(step, std::move(choice));
  if (body.tail) stretches_[*body.tail].region = body.tail_goes_back ? builder_.region() : around;
  registers_.Forget();
}

/// A label that begins a stretch also ends the one before it, for the jumps in that.
void Lowering::EnterStretch(InstructionId id) {
  const auto found = stretches_.find(id);
  if (found == stretches_.end()) return;
  registers_.Spill();
  if (found->second.is_jumped_to) builder_.Label(EndOfStretch(id));
  builder_.SetRegion(found->second.region);
  registers_.Forget();
}

void Lowering::LowerBody(Body& body) {
  body_ = &body;
  end_is_used_ = false;
  own_locals_.clear();
  // What other bodies have left in it nobody asks for: to clear it for each body would take as long as the program is.
  index_in_body_.resize(tree_.instructions.size());
  for (size_t i = 0; i < body.instructions.size(); ++i) index_in_body_[body.instructions[i].index] = i;
  BeginBody(body);

  label_at_.assign(body.instructions.size(), false);
  const auto mark = [&](InstructionId id) { label_at_[index_in_body_[id.index]] = true; };
  for (const InstructionId id : body.instructions) {
    flow_.ForEachSuccessor(id, [&](InstructionId to, Edge edge) {
      if (edge == Edge::kJump) mark(to);
    });
  }
  for (const InstructionId entry : body.entries) {
    if (!body.stretches_are_cases) mark(entry);
  }
  for (const uint32_t k : body.subprograms) {
    if (body.subprograms.size() > 1 || flow_.EntryOf(k) != body.instructions.front()) mark(flow_.EntryOf(k));
  }
  CutStatements(body);
  if (body.unit.valid() && tree_.units[body.unit].kind == UnitKind::kModule) {
    const Unit& unit = tree_.units[body.unit];
    dialects::AddComments(tree_.comments, unit.comments.first, unit.comments.count, CommentPlace::kLeading,
                          waiting_comments_);
    waiting_comments_.push_back(dialects::LinesOf(sources_, unit.open.begin, unit.open.end));
  }
  for (const InstructionId id : body.instructions) Execute(id);
  EndComments(body);
  builder_.SetRange({});
  builder_.SetRegion(program_.routines[body.routine].body);
  if (end_is_used_) builder_.Label(kEndLabel);
}

void Lowering::Execute(InstructionId id) {
  const Instruction& instruction = tree_.instructions[id];
  const size_t index = index_in_body_[id.index];
  now_ = id;
  width_ = flow_.WidthBefore(id) == 0 ? 16 : flow_.WidthBefore(id);
  const Effects effects = EffectsOf(tree_, instruction, width_);
  wanted_flags_ = flow_.LiveBehind(id) & kFlags;
  EnterStretch(id);
  if (label_at_[index]) {
    registers_.Spill();
    builder_.Label(id.index + 1);
    registers_.Forget();
  }
  const bool ends_module = instruction.op == Op::kModuleEnd && !Info(tree_.units[body_->unit].module).waits;
  if (ends_module) {
    dialects::AddComments(tree_.comments, instruction.comments.first, instruction.comments.count,
                          CommentPlace::kLeading, waiting_comments_);
    return;
  }
  if (begins_statement_[index]) {  // as each label does
    registers_.EndStatement();
    compared_ = {};
    size_t end = index + 1;
    while (end < begins_statement_.size() && !begins_statement_[end]) ++end;
    BeginStatement(index, end);
  }
  builder_.SetRange(instruction.range);
  if (((effects.writes | effects.undefines) & kFlags) != 0) compared_ = {};
  // What jumps takes undefined flags along; assembler instructions read some that they leave undefined.
  const bool assembler = Info(instruction.op).assembler;
  if (!assembler) UndefineFlags(effects.undefines);
  Dispatch(instruction);
  if (assembler) UndefineFlags(effects.undefines);
}

void Lowering::CallMechanism(const Body& body) {
  const bool shares_rounds = body_ != nullptr && body_->loops && body.loops && body_->calls && body.calls;
  const auto run = [&] {
    if (!shares_rounds) {
      builder_.CallRoutine(body.routine, {});
      return;
    }
    const ir::PlaceId rounds = Local("rounds_left", Type::kI32), own = Local("rounds_of_module", Type::kI32);
    builder_.Store(own, builder_.Load(rounds));
    builder_.CallRoutine(body.routine, {});
    builder_.Store(rounds, builder_.Load(own));
  };
  builder_.When(builder_.Load(ActivationPlace(body.unit)), run);
}

void Lowering::Dispatch(const Instruction& instruction) {
  using dialects::Join;
  const auto combine = [&](Join join) {
    const ir::ValueId operand = ReadBit(tree_.OperandOf(instruction, 0));
    registers_.rlo().Set(dialects::Joined(builder_, join, registers_.rlo().Get(), operand));
  };
  if (Info(instruction.op).assembler) return Assemble(instruction);
  switch (instruction.op) {
    case Op::kLdr:
      return registers_.rlo().Set(ReadBit(tree_.OperandOf(instruction, 0)));
    case Op::kLa:
      return combine(Join::kAnd);
    case Op::kLo:
      return combine(Join::kOr);
    case Op::kLx:
      return combine(Join::kXor);
    case Op::kWr:
      return WriteBit(tree_.OperandOf(instruction, 0), registers_.rlo().Get());
    case Op::kFl:
    case Op::kFl1:
    case Op::kFl0:
      return SetFlag(instruction);
    case Op::kJum:
      return Jump(TargetOf(instruction), {});
    case Op::kJl1:
      return JumpIfRlo(instruction, true);
    case Op::kJl0:
      return JumpIfRlo(instruction, false);
    case Op::kCall:
      return Call(instruction);
    case Op::kRet:
      return Return();
    case Op::kEx:
      return Wait();
    case Op::kEx0:
      return WaitFor(instruction, 1);
    case Op::kEx1:
      return WaitFor(instruction, 0);
    case Op::kTex0:
      return WaitAtMost(instruction, 1);
    case Op::kTex1:
      return WaitAtMost(instruction, 0);
    case Op::kTim:
      return Delay(instruction);
    case Op::kMechInit:
      return InitMechanism(instruction);
    case Op::kLod:
      return Load(instruction);
    case Op::kSto:
      return StoreData(instruction);
    case Op::kAd:
      return Combine(instruction, {OpKind::kAdd8, OpKind::kAdd16, OpKind::kAdd32});
    case Op::kSu:
      return Combine(instruction, {OpKind::kSub8, OpKind::kSub16, OpKind::kSub32});
    case Op::kAnd:
      return Combine(instruction, {OpKind::kAnd8, OpKind::kAnd16, OpKind::kAnd32});
    case Op::kOr:
      return Combine(instruction, {OpKind::kOr8, OpKind::kOr16, OpKind::kOr32});
    case Op::kXor:
      return Combine(instruction, {OpKind::kXor8, OpKind::kXor16, OpKind::kXor32});
    case Op::kMulb:
    case Op::kMulw:
      return MultiplyData(instruction);
    case Op::kDivb:
    case Op::kDivw:
      return DivideData(instruction);
    case Op::kRl:
    case Op::kRr:
      return RotateData(instruction);
    case Op::kBcd:
      return ToBcd();
    case Op::kBin:
      return FromBcd();
    case Op::kEq:
      return Compare(instruction, OpKind::kEqual32);
    case Op::kNe:
      return Compare(instruction, OpKind::kNotEqual32);
    case Op::kLt:
      return Compare(instruction, OpKind::kLess32);
    case Op::kLe:
      return Compare(instruction, OpKind::kLessEqual32);
    case Op::kGt:
      return Compare(instruction, OpKind::kGreater32);
    case Op::kGe:
      return Compare(instruction, OpKind::kGreaterEqual32);
    case Op::kEset:
      return RaiseError(instruction);
    case Op::kMechanismBegin:
      CallMechanism(*BodyOfMechanism(instruction.mechanism));
      return registers_.Zero();
    case Op::kMechanismEnd:
      return EndMechanism(body_->unit);
    case Op::kModuleEnd:
      if (Info(tree_.units[body_->unit].module).waits) EndMechanism(body_->unit);
      return;
      // The marks of an area's end are after a RET; assembler instructions are dispatched above.
#define TECHNOL_INSTRUCTION(...)
#define TECHNOL_ASSEMBLER(Key, ...) case Op::k##Key:
#include "transpiler/dialects/technol/machine.def"
    case Op::kAreaEnd:
    case Op::kUnknown:
      PLCXX_UNREACHABLE();
  }
}

}  // namespace plcxx::technol
