#include "transpiler/dialects/technol/analysis/flow_checks.h"

#include <algorithm>

#include "transpiler/dialects/technol/analysis/resume_points.h"
#include "transpiler/dialects/technol/parser/parser.h"

namespace plcxx::technol {
namespace {

bool IsMark(Op op) {
  return op == Op::kMechanismBegin || op == Op::kMechanismEnd || op == Op::kModuleEnd || op == Op::kAreaEnd;
}

std::string SubprogramName(const Program& program, const Subprogram& subprogram) {
  return program.labels[subprogram.label].name;
}

void CheckCalls(const Flow& flow, diag::Engine& diagnostics) {
  const Program& program = flow.program();
  for (const InstructionId id : flow.recursions()) {
    const Instruction& call = program.instructions[id];
    Report(diagnostics, program, call, diag::TechnolRecursion, ToText(program, program.OperandOf(call, 0)));
  }
  if (!flow.recursions().empty()) return;
  for (const Subprogram& subprogram : flow.subprograms()) {
    if (subprogram.level != kCallDepth + 1) continue;  // the first one that is too deep
    // The call that makes it so deep stands in one that is itself as deep as allowed.
    std::vector<bool> deepest(program.instructions.size());
    for (uint32_t k = 0; k < flow.subprograms().size(); ++k) {
      std::vector<InstructionId> order;
      if (flow.subprograms()[k].level == kCallDepth) flow.CollectFrom(flow.EntryOf(k), deepest, order);
    }
    for (const InstructionId id : subprogram.calls) {
      if (!deepest[id.index]) continue;
      Report(diagnostics, program, program.instructions[id], diag::TechnolCallDepth,
             SubprogramName(program, subprogram), static_cast<int64_t>(kCallDepth + 1));
      break;
    }
  }
}

/// From every label of the subprogram area, called or not.
void CheckReturns(const Flow& flow, diag::Engine& diagnostics) {
  const Program& program = flow.program();
  std::vector<bool> seen(program.instructions.size());
  for (const Subprogram& subprogram : flow.subprograms()) {
    if (program.instructions[program.labels[subprogram.label].at].op != Op::kAreaEnd) continue;
    const Instruction& call = program.instructions[subprogram.calls.front()];
    Report(diagnostics, program, call, diag::TechnolMissingRet, SubprogramName(program, subprogram));
  }
  for (const Label& label : program.labels) {
    const Instruction& entry = program.instructions[label.at];
    if (!entry.unit.valid() || program.units[entry.unit].kind != UnitKind::kSubprograms) continue;
    std::vector<InstructionId> order;
    if (!seen[label.at.index]) flow.CollectFrom(label.at, seen, order);
    for (const InstructionId id : order) {
      const Instruction& instruction = program.instructions[id];
      bool past = false;
      flow.ForEachSuccessor(id, [&](InstructionId to, Edge) { past |= program.instructions[to].op == Op::kAreaEnd; });
      if (past && !instruction.faulty) {
        Report(diagnostics, program, instruction, diag::TechnolMissingRet, ToText(program, instruction));
      }
    }
  }
}

}  // namespace

void CheckPaths(const Flow& flow, diag::Engine& diagnostics) {
  const Program& program = flow.program();
  CheckCalls(flow, diagnostics);
  CheckReturns(flow, diagnostics);
  for (const Instruction& instruction : program.instructions) {
    if (IsWait(instruction.op) && !instruction.faulty && !flow.MayWait(instruction)) {
      Report(diagnostics, program, instruction, diag::TechnolWaitOutside, ToText(program, instruction));
    }
  }
}

void CheckResumePoints(const Flow& flow, diag::Engine& diagnostics) {
  const Program& program = flow.program();
  for (const Root& root : flow.roots()) {
    const std::vector<InstructionId> instructions = InstructionsOf(flow, root);
    if (instructions.size() <= kMostResumePoints) continue;
    const std::vector<InstructionId> points = ResumePointsOf(flow, instructions).points;
    if (points.size() <= kMostResumePoints) continue;
    // The wait that goes on there shows more of the fault than what stands behind it.
    const InstructionId first = points[kMostResumePoints];
    const auto wait = std::ranges::find_if(instructions, [&](InstructionId id) {
      return IsWait(program.instructions[id].op) && flow.ResumeOf(id) == first;
    });
    const Instruction& at = program.instructions[wait == instructions.end() ? first : *wait];
    Report(diagnostics, program, at, diag::TechnolTooManyWaits, program.units[root.unit].name,
           static_cast<int64_t>(kMostResumePoints));
  }
}

void WarnOfPaths(const Flow& flow, diag::Engine& diagnostics) {
  const Program& program = flow.program();
  bool was_reached = true;
  for (uint32_t i = 0; i < program.instructions.size(); ++i) {
    const InstructionId id(i);
    const Instruction& instruction = program.instructions[id];
    if (IsMark(instruction.op)) {
      was_reached = true;
      continue;
    }
    const bool reached = flow.IsReached(id);
    if (!reached && was_reached) {  // the first one of a stretch speaks for all
      Report(diagnostics, program, instruction, diag::TechnolUnreachable, ToText(program, instruction));
    }
    was_reached = reached;
    if (!reached) continue;
    const bool tests = ComparesDr(instruction.op) || instruction.op == Op::kLdr;
    if (tests && (flow.LiveBehind(id) & kRlo) == 0) {
      Report(diagnostics, program, instruction, diag::TechnolResultUnused, ToText(program, instruction));
    }
    if (instruction.op != Op::kSto) continue;
    const Operand& target = program.OperandOf(instruction, 0);
    if (flow.WidthBefore(id) == 32 && target.width < 32) {
      Report(diagnostics, program, instruction, diag::TechnolStoreNarrow, ToText(program, target),
             static_cast<int64_t>(target.width));
    }
  }
  for (const InstructionId id : flow.width_joins()) {
    if ((flow.LiveBefore(id) & PartsOfDr(32)) == 0) continue;
    const Instruction& instruction = program.instructions[id];
    if (IsMark(instruction.op)) continue;
    Report(diagnostics, program, instruction, diag::TechnolWidthJoin, ToText(program, instruction));
  }
}

}  // namespace plcxx::technol
