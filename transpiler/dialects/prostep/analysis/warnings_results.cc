// W42: sequences whose result nothing uses.
//
// S is alive in front of an instruction when some path from there on uses it: '=', S, R, timers, counters, conditional
// jumps and calls, and what combines with it. After the end of a module that is called, and in a module that is
// called, it may be used; a module of the scheduler hands it to nobody.

#include <vector>

#include "transpiler/dialects/prostep/analysis/warnings.h"
#include "transpiler/dialects/prostep/parser/parser.h"

namespace plcxx::prostep {
namespace {

struct ResultChecker {
  const Program& program;
  const ModulePaths& paths;
  bool is_called;  // a subroutine
  std::vector<bool> alive = std::vector<bool>(paths.size() + 1, false);

  bool AliveAfter(uint32_t number) const {
    const bool target = paths.Jumps(number) && alive[paths.Target(number)];
    return target || (paths.GoesOn(number) && alive[number + 1]);
  }

  bool AliveBefore(uint32_t number) const {
    const Instruction& instruction = paths.At(number);
    const TextState& text = paths.Text(number);
    const bool after = AliveAfter(number);
    if (text.depth > 0) return after;
    switch (Info(instruction.op).role) {
      case Role::kLogic:
      case Role::kClose:
        return text.in_string || (!text.first && after);
      case Role::kCompare:  // what it discards has a warning of its own
      case Role::kString:
        return true;
      case Role::kOpen:
      case Role::kNeutral:
        return after;
      case Role::kJump:
        return after || instruction.op == Op::kJumpIf;
      case Role::kEnds:
        break;
    }
    if (instruction.op == Op::kTransfer || instruction.op == Op::kEndModule) return after;
    if (instruction.op == Op::kPerform) return after && !SetsS(*instruction.function);
    return true;
  }

  void Run() {
    constexpr uint32_t kMostRuns = 16;
    alive[paths.size()] = is_called;
    bool changed = true;
    for (uint32_t run = 0; changed; ++run) {
      if (run == kMostRuns) {  // many nested loops: nothing is said of them
        alive.assign(alive.size(), true);
        return;
      }
      changed = false;
      for (uint32_t i = paths.size(); i-- > 0;) {
        const bool now = AliveBefore(i);
        changed = changed || now != alive[i];
        alive[i] = now;
      }
    }
  }

  /// Does the instruction make S on the level of the module?
  bool Makes(uint32_t number) const {
    const Role role = Info(paths.At(number).op).role;
    const bool makes = role == Role::kLogic || role == Role::kClose || role == Role::kCompare;
    return makes && paths.Text(number).depth == 0;
  }

  /// Does the sequence go on with another operation that combines?
  bool IsGoneOnWith(uint32_t number) const {
    for (uint32_t i = number + 1; i < paths.size(); ++i) {
      const Role role = Info(paths.At(i).op).role;
      if (paths.Text(i).depth == 0 && role != Role::kNeutral && role != Role::kOpen) {
        return Makes(i) && !paths.Text(i).first;
      }
    }
    return false;
  }

  void Report(diag::Engine& diagnostics) const {
    for (uint32_t i = 0; i < paths.size(); ++i) {
      if (!Makes(i) || !paths.IsReached(i) || AliveAfter(i)) continue;
      if (IsGoneOnWith(i)) continue;  // the last one of the sequence tells
      diagnostics.Report(paths.At(i).range, diag::ProstepSequenceUnused, ToText(program, paths.At(i)));
    }
  }
};

}  // namespace

void CheckResults(const Program& program, const Paths& paths, const Settings& settings, diag::Engine& diagnostics) {
  // With the other first check the text alone does not tell what loads and what combines.
  if (settings.first_check == FirstCheck::kDynamic) return;
  std::vector<bool> is_called(program.modules.size(), false);  // also of the scheduler's modules, which may be called
  for (const Instruction& instruction : program.instructions) {
    if (instruction.module.valid()) is_called[instruction.module.index] = true;
  }
  for (uint32_t number = 0; number < kModules; ++number) {
    const ModuleId id = program.module_of[number];
    if (!id.valid()) continue;
    ResultChecker checker{program, paths[id.index], number >= kFirstSubroutine || is_called[id.index]};
    checker.Run();
    checker.Report(diagnostics);
  }
}

}  // namespace plcxx::prostep
