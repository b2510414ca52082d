#include "transpiler/dialects/prostep/lowering.h"

#include <utility>

#include "transpiler/dialects/prostep/lowering_internal.h"
#include "transpiler/dialects/prostep/warnings.h"

namespace plcxx::prostep {
namespace {

constexpr ir::RoutineKind KindOf(uint32_t module) {
  if (module == 0 || module >= kFirstSubroutine) return ir::RoutineKind::kSubroutine;
  return module < kFirstLoopModule ? ir::RoutineKind::kFast : ir::RoutineKind::kSlow;
}

std::string CommentOf(uint32_t module) {
  const std::string name = "PM " + std::to_string(module);
  if (module == 0) return name + ": initialisation, once after power-on.";
  if (module < kFirstLoopModule)
    return name + ": interrupt module, in every tick while F 250." + std::to_string(module - 1) + " is 1.";
  if (module < kFirstSubroutine) {
    return name + ": loop module, while F 251." + std::to_string(module - kFirstLoopModule) + " is 1.";
  }
  return name + ": subroutine.";
}

}  // namespace

Lowering::Lowering(const Program& tree, const Settings& settings, const source::SourceManager& sources)
    : tree_(tree),
      settings_(settings),
      sources_(sources),
      memory_(program_, settings.first_retentive, settings.last_retentive) {}

void Lowering::InitialData() {
  const auto bytes = prostep::InitialData(tree_);
  for (uint32_t address = 0; address < bytes.size(); ++address) {
    if (bytes[address] == 0) continue;
    const Cell cell = memory_.At(Space::kD, address);
    program_.spaces[cell.space].initial.push_back({.offset = cell.offset, .value = bytes[address]});
  }
}

void Lowering::FindCalledModules() {
  called_.assign(tree_.modules.size(), false);
  for (const Instruction& instruction : tree_.instructions) {
    if (instruction.module.valid()) called_[instruction.module.index] = true;
  }
  for (uint32_t i = 0; i < tree_.instructions.size(); ++i) {
    const Instruction& instruction = tree_.instructions[InstructionId(i)];
    if (instruction.target.valid() && tree_.labels[instruction.target].at.index <= i) loops_ = true;
  }
}

void Lowering::AddModuleRoutines() {
  routines_.resize(tree_.modules.size());
  for (uint32_t i = 0; i < tree_.modules.size(); ++i) {
    const ModuleId id(i);
    const uint32_t number = tree_.modules[id].number;
    if (number == 0 && !IsCalled(id)) {
      routines_[i] = init_;  // its instructions are what power-on ends with
      continue;
    }
    const ir::RoutineKind kind = IsCalled(id) ? ir::RoutineKind::kSubroutine : KindOf(number);
    routines_[i] = builder_.AddRoutine("PM" + std::to_string(number), kind, CommentOf(number));
  }
}

void Lowering::LowerModule(ModuleId id) {
  const Module& module = tree_.modules[id];
  dialects::Register s(builder_, PlaceOf(ScalarPlace::kS), facts_), ax(builder_, PlaceOf(ScalarPlace::kAx), facts_);
  std::optional<dialects::Register> first;
  if (settings_.first_check == FirstCheck::kDynamic) first.emplace(builder_, PlaceOf(ScalarPlace::kFirst), facts_);
  dialects::LogicStack logic(builder_, s);
  module_ = &module;
  s_ = &s;
  ax_ = &ax;
  first_ = first ? &*first : nullptr;
  logic_ = &logic;
  end_is_used_ = false;

  builder_.SetRegion(program_.routines[routines_[id.index]].body);
  builder_.SetRange({});
  if (!IsCalled(id)) {  // from the scheduler only: 4.2
    s.Set(builder_.Bit(0));
    ax.Set(Word(0));
    s.EndStatement();
    ax.EndStatement();
  }
  if (first) {
    Decided(1);
    first->EndStatement();
  }

  label_at_.assign(module.instructions.count + 1, false);
  for (uint32_t i = 0; i < module.labels.count; ++i) {
    const Label& label = tree_.labels[LabelId(module.labels.first + i)];
    if (label.uses > 0) label_at_[label.at.index - module.begin_of().index] = true;
  }
  CutStatements(module);
  dialects::AddComments(tree_.comments, module.comments.first, module.comments.count, CommentPlace::kLeading,
                        waiting_comments_);
  waiting_comments_.push_back(dialects::LinesOf(sources_, module.open.begin, module.open.end));
  for (uint32_t i = module.begin_of().index; i < module.end_of().index; ++i) Execute(InstructionId(i));
  Fold();  // END ends a sequence, too: its S is the caller's
  EndComments(module);
  builder_.SetRange({});
  SpillAll();
  if (end_is_used_) builder_.Label(kEndLabel);
}

void Lowering::Execute(InstructionId id) {
  const uint32_t offset = id.index - module_->begin_of().index;
  const Instruction& instruction = tree_.instructions[id];
  if (label_at_[offset]) {
    SpillAll();
    builder_.Label(LabelBefore(id));
    ForgetAll();
  }
  if (begins_statement_[offset]) {
    s_->EndStatement();
    ax_->EndStatement();
    if (first_ != nullptr) first_->EndStatement();
    uint32_t end = offset + 1;
    while (end < begins_statement_.size() && !begins_statement_[end]) ++end;
    BeginStatement(id, InstructionId(module_->begin_of().index + end));
  }
  builder_.SetRange(instruction.range);
  const bool ends = Info(instruction.op).role == Role::kEnds;
  if (ends) Fold();
  Dispatch(id, instruction);
  if (!ends) return;
  logic_->EndSequence();
  Decided(1);
}

void Lowering::Dispatch(InstructionId id, const Instruction& instruction) {
  using dialects::Join;
  using ir::OpKind;
  switch (instruction.op) {
    case Op::kAnd:
      return Operate(Join::kAnd, ReadBit(instruction.operand));
    case Op::kAndNot:
      return Operate(Join::kAnd, dialects::Inverted(builder_, ReadBit(instruction.operand)));
    case Op::kOr:
      return Operate(Join::kOr, ReadBit(instruction.operand));
    case Op::kOrNot:
      return Operate(Join::kOr, dialects::Inverted(builder_, ReadBit(instruction.operand)));
    case Op::kOrString:
      return BeginString();
    case Op::kOpenAnd:
      return Open(Join::kAnd);
    case Op::kOpenOr:
      return Open(Join::kOr);
    case Op::kClose:
      return Close();
    case Op::kAssign:
      return Assign(instruction.operand);
    case Op::kSet:
      return SetOrReset(instruction.operand, true);
    case Op::kReset:
      return SetOrReset(instruction.operand, false);
    case Op::kCountUp:
      return Count(instruction, OpKind::kCountUp);
    case Op::kCountDown:
      return Count(instruction, OpKind::kCountDown);
    case Op::kSetCounter:
      return SetCounter(instruction);
    case Op::kResetCounter: {
      const ir::ValueId condition = logic_->Value();
      builder_.Step(OpKind::kZeroCounter, CounterOf(instruction.operand.number), {condition});
      return;
    }
    case Op::kPulse:
      return StartTimer(instruction, OpKind::kStartPulse);
    case Op::kExtendedPulse:
      return StartTimer(instruction, OpKind::kStartExtended);
    case Op::kOnDelay:
      return StartTimer(instruction, OpKind::kStartOnDelay);
    case Op::kLatchedOnDelay:
      return StartTimer(instruction, OpKind::kStartLatchedDelay);
    case Op::kOffDelay:
      return StartTimer(instruction, OpKind::kStartOffDelay);
    case Op::kResetTimer:
      builder_.Step(OpKind::kResetTimer, TimerOf(instruction.operand.number), {logic_->Value()});
      return;
    case Op::kEqual:
    case Op::kNotEqual:
    case Op::kLess:
    case Op::kLessEqual:
    case Op::kGreater:
    case Op::kGreaterEqual:
      return Compare(instruction);
    case Op::kLoad:
      return Load(instruction);
    case Op::kLoadCounter:
      return ax_->Set(builder_.Load(ValueOf(instruction.operand.number)));
    case Op::kLoadCounterBcd:
      return ax_->Set(builder_.Pure(OpKind::kToBcd16, {builder_.Load(ValueOf(instruction.operand.number))}));
    case Op::kLoadTimer:
      return ax_->Set(builder_.Step(OpKind::kTimeLeft, TimerOf(instruction.operand.number), {}));
    case Op::kLoadTimerBcd:
      return ax_->Set(builder_.Step(OpKind::kTimeLeftCoded, TimerOf(instruction.operand.number), {}));
    case Op::kTransfer:
      return Transfer(instruction.operand);
    case Op::kJump:
      return Jump(id, instruction, false);
    case Op::kJumpIf:
      return Jump(id, instruction, true);
    case Op::kCall:
      return Call(instruction, false);
    case Op::kCallIf:
      return Call(instruction, true);
    case Op::kPerform:
      return Perform(instruction, false);
    case Op::kPerformIf:
      return Perform(instruction, true);
    case Op::kEndModule:
      return EndModule(id, false);
    case Op::kEndModuleIf:
      return EndModule(id, true);
    case Op::kNop:
    case Op::kUnknown:
      return;
  }
}

ir::Program Lowering::Run() {
  program_.dialect = "prostep";
  InitialData();
  FindCalledModules();
  AddScheduleRoutines();
  AddModuleRoutines();
  Init();
  for (uint32_t i = 0; i < tree_.modules.size(); ++i) LowerModule(ModuleId(i));
  Document();
  Fast();
  Slow();
  Advance();
  RefreshInputs();
  RefreshOutputs();
  Tick();
  SlowPass();
  SlowStep();
  Periods();
  FillSchedule();
  Messages();
  MFunctions();
  return std::move(program_);
}

ir::Program Lower(const Program& tree, const Settings& settings, const source::SourceManager& sources,
                  diag::Engine& diagnostics) {
  if (diagnostics.HasErrors()) return {};
  CheckWhatIsExecuted(tree, settings, diagnostics);
  return Lowering(tree, settings, sources).Run();
}

}  // namespace plcxx::prostep
