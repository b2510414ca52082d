// What the text of a sequence tells: conditions that a comparison discards, strings that are empty, jumps that go back.

#include "transpiler/dialects/prostep/analysis/warnings.h"
#include "transpiler/dialects/prostep/parser/parser.h"

namespace plcxx::prostep {
namespace {

/// One bracket level of the sequence.
struct Level {
  bool first = true;
  bool unused = false;  // something was computed that no jump has used yet
  bool in_string = false;
  bool empty_string = false;
  bool reported = false;  // the operand-less O that began the string
  source::Range string;
};

struct SequenceChecker {
  const Program& program;
  const ModulePaths& paths;
  diag::Engine& diagnostics;
  std::vector<Level> levels = std::vector<Level>(1);

  void Fold() {
    Level& level = levels.back();
    if (!level.in_string) return;
    if (level.empty_string && !level.reported) diagnostics.Report(level.string, diag::ProstepStringEmpty);
    level.in_string = false;
    level.first = false;
    level.unused = true;
  }

  void Computed() {
    Level& level = levels.back();
    level.first = false;
    level.unused = true;
    level.empty_string = false;
  }

  void String(const Instruction& instruction) {
    Fold();
    Level& level = levels.back();
    level.reported = level.first;
    if (level.first) diagnostics.Report(instruction.range, diag::ProstepStringFirst);
    level.in_string = level.empty_string = level.first = true;
    level.string = instruction.range;
  }

  void Compare(const Instruction& instruction) {
    Level& level = levels.back();
    const bool drops = level.in_string && !(level.reported && level.empty_string);
    if (drops || (!level.first && level.unused)) {
      diagnostics.Report(instruction.range, diag::ProstepComparisonDiscards, ToText(program, instruction));
    }
    level.in_string = false;
    Computed();
  }

  void Check(uint32_t number) {
    const Instruction& instruction = paths.At(number);
    switch (Info(instruction.op).role) {
      case Role::kLogic:
        if (instruction.op == Op::kOr || instruction.op == Op::kOrNot) Fold();
        return Computed();
      case Role::kCompare:
        return Compare(instruction);
      case Role::kString:
        return String(instruction);
      case Role::kOpen:
        if (instruction.op == Op::kOpenOr) Fold();
        levels.emplace_back();
        return;
      case Role::kClose:
        Fold();
        levels.pop_back();
        return Computed();
      case Role::kNeutral:
        return;
      case Role::kJump:
        Fold();
        levels.back().unused = false;
        if (paths.Target(number) <= number) {
          diagnostics.Report(instruction.range, diag::ProstepBackwardJump, program.labels[instruction.target].name);
        }
        return;
      case Role::kEnds:
        Fold();
        levels.back() = {};
        return;
    }
  }
};

}  // namespace

void CheckSequences(const Program& program, const Paths& paths, diag::Engine& diagnostics) {
  for (const ModulePaths& module : paths) {
    SequenceChecker checker{program, module, diagnostics};
    for (uint32_t i = 0; i < module.size(); ++i) checker.Check(i);
    checker.Fold();
  }
}

void CheckWhatIsExecuted(const Program& program, const Settings& settings, diag::Engine& diagnostics) {
  Paths paths;
  paths.reserve(program.modules.size());
  for (uint32_t i = 0; i < program.modules.size(); ++i) paths.emplace_back(program, ModuleId(i));
  CheckSequences(program, paths, diagnostics);
  CheckPaths(program, paths, settings, diagnostics);
  CheckResults(program, paths, settings, diagnostics);
  CheckCoils(program, paths, diagnostics);
  CheckMemory(program, diagnostics);
}

bool SetsS(Function function) {
  return function == Function::kToBcd || (function >= Function::kAddLong && function <= Function::kLessSigned);
}

std::vector<bool> ReachedFrom(const Program& program, uint32_t first, uint32_t last) {
  std::vector<bool> reached(program.modules.size(), false);
  std::vector<ModuleId> open;
  for (uint32_t number = first; number <= last; ++number) {
    if (program.module_of[number].valid()) open.push_back(program.module_of[number]);
  }
  while (!open.empty()) {
    const ModuleId id = open.back();
    open.pop_back();
    if (reached[id.index]) continue;
    reached[id.index] = true;
    const Module& module = program.modules[id];
    for (uint32_t i = module.begin_of().index; i < module.end_of().index; ++i) {
      const ModuleId called = program.instructions[InstructionId(i)].module;
      if (called.valid()) open.push_back(called);
    }
  }
  return reached;
}

}  // namespace plcxx::prostep
