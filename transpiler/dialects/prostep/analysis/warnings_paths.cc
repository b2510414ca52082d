// What is known of S, AX and the first check on the paths from the scheduler into the modules.
//
// One walk for each module and each state in which it is entered: the state is six facts, each of which holds on some
// path (or on all), so that there are few of them; a called module is walked with the state of its caller and gives the
// state after the call. Calls form no ring. A use is reported once; after it the register counts as set, so that one
// cause gives one message.

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "transpiler/dialects/prostep/analysis/warnings.h"
#include "transpiler/dialects/prostep/parser/parser.h"

namespace plcxx::prostep {
namespace {

/// What AX can hold, as far as it is known: a whole number from 0 to this.
enum class AxLimit : uint8_t { kByte, kCounter, kAny };

struct State {
  bool reached = false;
  // On some path:
  bool s_unset = false;
  bool ax_unset = false;
  bool high_set = false;      // AH may be something else than 0
  bool byte_in_word = false;  // AX was last loaded by a byte, with such an AH
  bool may_load = false;      // by the run-time reading the next operation is the first of its sequence
  bool may_combine = false;
  AxLimit ax_limit = AxLimit::kAny;  // the widest one
  // On all paths:
  bool s_is_0 = false;  // a conditional jump was not taken

  auto operator<=>(const State&) const = default;
};

/// What holds where two paths meet.
State Join(const State& a, const State& b) {
  if (!a.reached) return b;
  if (!b.reached) return a;
  return {.reached = true,
          .s_unset = a.s_unset || b.s_unset,
          .ax_unset = a.ax_unset || b.ax_unset,
          .high_set = a.high_set || b.high_set,
          .byte_in_word = a.byte_in_word || b.byte_in_word,
          .may_load = a.may_load || b.may_load,
          .may_combine = a.may_combine || b.may_combine,
          .ax_limit = std::max(a.ax_limit, b.ax_limit),
          .s_is_0 = a.s_is_0 && b.s_is_0};
}

constexpr State kFromScheduler{.reached = true, .s_unset = true, .ax_unset = true, .may_load = true};

bool IsStep(Op op) { return Info(op).s_use == SUse::kSteps; }

/// S, R, timers and counters: with S = 0 always they do nothing, or the same each time. Not '=', which assigns this 0,
/// nor what asks S whether to go elsewhere: several JC in a row are several ways.
bool ActsOnS(Op op) { return Info(op).s_use == SUse::kActs || IsStep(op); }

/// Where AX may be, against the operand, for the comparison to be 1.
struct Relation {
  Op op;
  bool less, equal, greater;
};
constexpr Relation kRelations[] = {{Op::kEqual, false, true, false},   {Op::kNotEqual, true, false, true},
                                   {Op::kLess, true, false, false},    {Op::kLessEqual, true, true, false},
                                   {Op::kGreater, false, false, true}, {Op::kGreaterEqual, false, true, true}};

struct PathChecker {
  const Program& program;
  const Paths& paths;
  const Settings& settings;
  diag::Engine& diagnostics;
  std::map<std::pair<uint32_t, State>, State> left = {};  // by module and state at its entry: the state at its end
  std::set<std::pair<const void*, uint32_t>> reported = {};

  template <class Message>
  void Report(const Message& message, const Instruction& instruction) {
    if (!reported.emplace(&message, instruction.range.begin).second) return;
    diagnostics.Report(instruction.range, message, ToText(program, instruction));
  }

  State Walk(ModuleId module, const State& entry);
  void Step(const ModulePaths& module, uint32_t number, State& state);
  void Logic(const Instruction& instruction, const TextState& text, State& state);
  void UseS(const Instruction& instruction, State& state);
  void UseAx(const Instruction& instruction, State& state);
  void LoadByte(State& state);
  void Load(const Instruction& instruction, State& state);
  void CompareWithConstant(const Instruction& instruction, const State& state);
  void CheckSigned(const Instruction& instruction, const Operand& constant);
  void Perform(const Instruction& instruction, State& state);
  void Call(const Instruction& instruction, State& state);
};

void PathChecker::UseS(const Instruction& instruction, State& state) {
  if (state.s_unset) Report(diag::ProstepSUnset, instruction);
  state.s_unset = false;
}

void PathChecker::UseAx(const Instruction& instruction, State& state) {
  if (state.ax_unset) Report(diag::ProstepAxUnset, instruction);
  state.ax_unset = false;
}

void PathChecker::LoadByte(State& state) {
  state.ax_unset = false;
  state.byte_in_word = state.high_set;
  state.ax_limit = state.high_set ? AxLimit::kAny : AxLimit::kByte;
}

void PathChecker::Load(const Instruction& instruction, State& state) {
  const Operand& operand = instruction.operand;
  if (instruction.op == Op::kLoad && operand.shape() == Shape::kByte) return LoadByte(state);
  state.ax_unset = state.byte_in_word = false;
  state.ax_limit = instruction.op == Op::kLoadCounter ? AxLimit::kCounter : AxLimit::kAny;
  state.high_set = operand.shape() != Shape::kConstant || operand.value > 0xFF;
}

/// On the lowest level; what is inside brackets has a value of its own.
void PathChecker::Logic(const Instruction& instruction, const TextState& text, State& state) {
  if (text.depth > 0) return;
  const bool differs = text.first ? state.may_combine : state.may_load;
  if (!text.in_string && differs) Report(diag::ProstepFirstDiffers, instruction);
  const bool dynamic = settings.first_check == FirstCheck::kDynamic && !text.in_string;
  const bool combines = dynamic ? state.may_combine : !text.first;
  const bool always = dynamic ? !state.may_load : !text.first;
  if (combines) UseS(instruction, state);
  const bool conjunction =
      instruction.op == Op::kAnd || instruction.op == Op::kAndNot || instruction.op == Op::kOpenAnd;
  if (conjunction && combines && always && state.s_is_0) Report(diag::ProstepAlwaysZero, instruction);
}

/// W43, W44. A constant is compared as a word with a sign.
void PathChecker::CompareWithConstant(const Instruction& instruction, const State& state) {
  const Operand& operand = instruction.operand;
  if (operand.shape() != Shape::kConstant) return;
  CheckSigned(instruction, operand);
  if (state.ax_limit == AxLimit::kAny || state.byte_in_word) return;
  const int32_t most = state.ax_limit == AxLimit::kByte ? 255 : 999;
  const int32_t constant = static_cast<int16_t>(operand.value);
  const auto relation = std::ranges::find(kRelations, instruction.op, &Relation::op);
  if (relation == std::end(kRelations)) return;
  // AX is 0 to `most`.
  const bool can_be_less = constant > 0, can_be_equal = constant >= 0 && constant <= most,
             can_be_greater = constant < most;
  const bool never =
      !(can_be_less && relation->less) && !(can_be_equal && relation->equal) && !(can_be_greater && relation->greater);
  const bool always = !(can_be_less && !relation->less) && !(can_be_equal && !relation->equal) &&
                      !(can_be_greater && !relation->greater);
  if (!always && !never) return;
  if (!reported.emplace(&diag::ProstepComparisonConstant, instruction.range.begin).second) return;
  diagnostics.Report(instruction.range, diag::ProstepComparisonConstant, ToText(program, instruction),
                     always ? "true" : "false", 0, most);
}

/// W44. Not what is written in hexadecimal, or with its minus.
void PathChecker::CheckSigned(const Instruction& instruction, const Operand& constant) {
  if (constant.form != NumberForm::kDecimal || constant.has_minus || constant.value < 0x8000) return;
  if (!reported.emplace(&diag::ProstepReadSigned, constant.range.begin).second) return;
  diagnostics.Report(constant.range, diag::ProstepReadSigned, "K " + std::to_string(constant.value),
                     "K " + std::to_string(static_cast<int16_t>(constant.value)),
                     instruction.function ? ToText(instruction.operand) : std::string(Info(instruction.op).mnemonic));
}

void PathChecker::Perform(const Instruction& instruction, State& state) {
  const Function function = *instruction.function;
  const bool multiplies = function == Function::kMultiply || function == Function::kDivide;
  if (multiplies && settings.muldiv == MulDiv::kSigned) {
    for (uint32_t i = 0; i < 2; ++i) {
      const Operand& factor = program.Argument(instruction, i);
      if (factor.shape() == Shape::kConstant) CheckSigned(instruction, factor);
    }
  }
  if (SetsS(function)) state.s_unset = state.s_is_0 = false;
  const AxUse use = Info(function).ax_use;
  if (use != AxUse::kNone && use != AxUse::kReads) state.ax_limit = AxLimit::kAny;
  switch (use) {
    case AxUse::kNone:
      return;
    case AxUse::kReads:
      return UseAx(instruction, state);
    case AxUse::kChanges: {
      UseAx(instruction, state);
      state.byte_in_word = false;
      const bool masks = function == Function::kBitAnd;
      const bool shifts = function == Function::kShiftRight;
      const Operand* operand = masks || shifts ? &program.Argument(instruction, 0) : nullptr;
      const bool constant = operand != nullptr && operand->shape() == Shape::kConstant;
      const bool clears = constant && (masks ? operand->value <= 0xFF : operand->value >= 8);
      state.high_set = clears ? false : operand == nullptr || constant || state.high_set;
      return;
    }
    case AxUse::kLoadsByte:
      return LoadByte(state);
    case AxUse::kLoadsWord:
      state.ax_unset = state.byte_in_word = false;
      state.high_set = true;
      return;
  }
}

void PathChecker::Call(const Instruction& instruction, State& state) {
  State entry = state;
  entry.s_is_0 = false;
  entry.may_load = true;
  entry.may_combine = false;
  const State behind = Walk(instruction.module, entry);
  if (instruction.op == Op::kCall) {
    state = behind;
  } else {
    state.s_is_0 = false;
    state = Join(state, behind);
  }
}

void PathChecker::Step(const ModulePaths& module, uint32_t number, State& state) {
  const Instruction& instruction = module.At(number);
  const TextState& text = module.Text(number);
  const Role role = Info(instruction.op).role;
  if (Info(instruction.op).s_use != SUse::kNone) UseS(instruction, state);
  if (ActsOnS(instruction.op) && state.s_is_0) {
    Report(diag::ProstepAlwaysSeesZero, instruction);
    state.s_is_0 = false;  // one cause
  }
  switch (role) {
    case Role::kLogic:
    case Role::kClose:
    case Role::kString:
      Logic(instruction, text, state);
      if (text.depth > 0) break;
      if (role != Role::kString) state.s_unset = state.s_is_0 = false;
      state.may_load = false;
      state.may_combine = true;
      break;
    case Role::kOpen:
      // The bracket decides when it is closed; but that it is in vain is seen here.
      if (instruction.op == Op::kOpenAnd && text.depth == 0 && !text.first && state.s_is_0) {
        Report(diag::ProstepAlwaysZero, instruction);
      }
      break;
    case Role::kCompare:
      UseAx(instruction, state);
      if (instruction.operand.shape() == Shape::kConstant && state.byte_in_word) {
        Report(diag::ProstepHighByteUnknown, instruction);
      }
      CompareWithConstant(instruction, state);
      if (text.depth > 0) break;
      state.s_unset = state.s_is_0 = state.may_load = false;
      state.may_combine = true;
      break;
    case Role::kNeutral:
      if (instruction.op != Op::kNop && instruction.op != Op::kUnknown) Load(instruction, state);
      break;
    case Role::kJump:
      break;
    case Role::kEnds:
      if (instruction.op == Op::kTransfer) UseAx(instruction, state);
      if (IsStep(instruction.op)) state.s_unset = state.s_is_0 = false;
      if (instruction.op == Op::kPerform) Perform(instruction, state);
      if (instruction.op == Op::kPerformIf) {
        State done = state;
        Perform(instruction, done);
        state = Join(state, done);
      }
      if (instruction.op == Op::kCall || instruction.op == Op::kCallIf) Call(instruction, state);
      state.may_load = true;
      state.may_combine = false;
      break;
  }
}

State PathChecker::Walk(ModuleId id, const State& entry) {
  const auto [known, is_new] = left.try_emplace({id.index, entry});
  if (!is_new) return known->second;
  const ModulePaths& module = paths[id.index];
  std::vector<State> states(module.size() + 1);
  std::vector<uint32_t> open = {0};
  states[0] = entry;
  const auto flow = [&](uint32_t to, const State& state) {
    const State joined = Join(states[to], state);
    if (joined == states[to]) return;
    states[to] = joined;
    open.push_back(to);
  };
  while (!open.empty()) {
    const uint32_t number = open.back();
    open.pop_back();
    if (number == module.size()) continue;
    State state = states[number];
    Step(module, number, state);
    const Op op = module.At(number).op;
    if (module.Jumps(number)) {
      State taken = state;
      taken.s_is_0 = false;
      flow(module.Target(number), taken);
    }
    if (!module.GoesOn(number)) continue;
    if (op == Op::kJumpIf) state.s_is_0 = true;
    flow(number + 1, state);
  }
  return left[{id.index, entry}] = states[module.size()];
}

void CheckReached(const Program& program, const ModulePaths& module, diag::Engine& diagnostics) {
  bool inside = false;
  for (uint32_t i = 0; i < module.size(); ++i) {
    const bool reached = module.IsReached(i);
    if (!reached && !inside) {
      diagnostics.Report(module.At(i).range, diag::ProstepUnreachable, ToText(program, module.At(i)));
    }
    inside = !reached;
  }
}

}  // namespace

void CheckPaths(const Program& program, const Paths& paths, const Settings& settings, diag::Engine& diagnostics) {
  for (const ModulePaths& module : paths) CheckReached(program, module, diagnostics);
  PathChecker checker{program, paths, settings, diagnostics};
  for (uint32_t number = 0; number < kFirstSubroutine; ++number) {
    if (program.module_of[number].valid()) checker.Walk(program.module_of[number], kFromScheduler);
  }
  // What nothing calls is looked at as if somebody did.
  const std::vector<bool> reached = ReachedFrom(program, 0, kFirstSubroutine - 1);
  for (uint32_t i = 0; i < reached.size(); ++i) {
    if (!reached[i]) checker.Walk(ModuleId(i), {.reached = true, .may_load = true});
  }
}

}  // namespace plcxx::prostep
