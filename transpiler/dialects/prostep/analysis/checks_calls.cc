// Calls between modules (specification 4.2).
#include <algorithm>
#include <array>
#include <vector>

#include "transpiler/dialects/prostep/analysis/program_checks.h"

namespace plcxx::prostep {
namespace {

constexpr uint32_t kDeepest = 16;

struct Call {
  ModuleId target;
  source::Range range;
};

bool IsCall(const Instruction& instruction) { return instruction.op == Op::kCall || instruction.op == Op::kCallIf; }

/// The calls of each module in the order of the text, and a walk over them.
class CallGraph {
 public:
  CallGraph(const Program& program, diag::Engine& diagnostics)
      : program_(program), diagnostics_(diagnostics), calls_(program.modules.size()) {
    for (uint32_t m = 0; m < program.modules.size(); ++m) {
      const Module& module = program.modules[ModuleId(m)];
      for (uint32_t i = 0; i < module.instructions.count; ++i) {
        const Instruction& instruction = program.instructions[InstructionId(module.instructions.first + i)];
        if (instruction.module.valid()) calls_[m].push_back({instruction.module, instruction.range});
      }
    }
  }

  /// Depth first, modules and calls in the order of the text: the call that closes a ring is reported.
  bool ReportRings() {
    marks_.assign(calls_.size(), Mark::kNew);
    for (uint32_t m = 0; m < calls_.size(); ++m) Visit(m);
    return found_ring_;
  }

  /// Only without rings.
  void ReportDeepCalls() {
    std::vector<uint32_t> depth(calls_.size());
    std::reverse(finished_.begin(), finished_.end());  // callers before what they call
    for (const uint32_t m : finished_) {
      for (const Call& call : calls_[m]) depth[call.target.index] = std::max(depth[call.target.index], depth[m] + 1);
    }
    for (uint32_t m = 0; m < calls_.size(); ++m) {
      if (depth[m] != kDeepest) continue;  // where it is one too many, not everything below
      for (const Call& call : calls_[m]) {
        diagnostics_.Report(call.range, diag::ProstepDeepCalls, NameOf(call.target.index), kDeepest + 1);
      }
    }
  }

 private:
  enum class Mark : uint8_t { kNew, kOpen, kDone };

  std::string NameOf(uint32_t module) const {
    return "PM " + std::to_string(program_.modules[ModuleId(module)].number);
  }

  /// As deep as there are modules: 100 at most, more only where numbers were given twice.
  void Visit(uint32_t module) {
    if (marks_[module] != Mark::kNew) return;
    marks_[module] = Mark::kOpen;
    for (const Call& call : calls_[module]) {
      if (marks_[call.target.index] == Mark::kOpen) {
        found_ring_ = true;
        diagnostics_.Report(call.range, diag::ProstepRecursion, NameOf(call.target.index));
      } else {
        Visit(call.target.index);
      }
    }
    marks_[module] = Mark::kDone;
    finished_.push_back(module);
  }

  const Program& program_;
  diag::Engine& diagnostics_;
  std::vector<std::vector<Call>> calls_;
  std::vector<Mark> marks_;
  std::vector<uint32_t> finished_;
  bool found_ring_ = false;
};

}  // namespace

void ResolveCalls(Program& program, diag::Engine& diagnostics) {
  // A module whose number is wrong, which is reported, may be the one that is called.
  const bool all_numbered = std::ranges::all_of(program.modules, &Module::numbered);
  for (Instruction& instruction : program.instructions) {
    if (!IsCall(instruction) || !instruction.operand.exists()) continue;
    instruction.module = program.module_of[instruction.operand.number];
    const std::string name = ToText(instruction.operand);
    if (!instruction.module.valid()) {
      instruction.faulty = true;
      if (all_numbered) diagnostics.Report(instruction.range, diag::ProstepModuleUndefined, name);
    } else if (instruction.operand.number < kFirstSubroutine) {
      diagnostics.Report(instruction.range, diag::ProstepSchedulerModuleCalled, name);
    }
  }
  CallGraph graph(program, diagnostics);
  if (!graph.ReportRings()) graph.ReportDeepCalls();
}

void CheckUncalled(const Program& program, diag::Engine& diagnostics) {
  std::vector<bool> called(program.modules.size());
  for (const Instruction& instruction : program.instructions) {
    if (instruction.module.valid()) called[instruction.module.index] = true;
  }
  for (uint32_t m = 0; m < program.modules.size(); ++m) {
    const Module& module = program.modules[ModuleId(m)];
    if (called[m] || module.number < kFirstSubroutine) continue;
    diagnostics.Report(module.open, diag::ProstepNeverCalled, "PM " + std::to_string(module.number));
  }
}

}  // namespace plcxx::prostep
