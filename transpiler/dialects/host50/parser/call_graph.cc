#include "transpiler/dialects/host50/parser/call_graph.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace plcxx::host50 {
namespace {

struct Call {
  InstructionId id;
  SectionId target;
};

/// Of a cycle-free graph: at which depths a section is executed, as bits; bit 0 for SLOW and what nothing calls.
using Depths = uint64_t;
constexpr Depths kTooDeep = Depths{1} << (kMostCallDepth + 1);
constexpr Depths kAllDepths = (kTooDeep << 1) - 1;

class CallGraph {
 public:
  CallGraph(Program& program, diag::Engine& diagnostics)
      : program_(program), diagnostics_(diagnostics), calls_(program.sections.size()) {
    for (uint32_t i = 0; i < program.instructions.size(); ++i) {
      const Instruction& instruction = program.instructions[InstructionId(i)];
      if (instruction.op != Op::kCall || instruction.operands.count == 0) continue;
      const Operand& target = program.operands[instruction.operands.first];
      if (target.kind != OperandKind::kSubroutine) continue;
      const SectionId caller = program.networks[instruction.network].section;
      calls_[caller.index].push_back({InstructionId(i), target.section});
    }
    // Those of a drawing stand in the order of their execution.
    for (std::vector<Call>& calls : calls_) {
      std::ranges::stable_sort(calls, {}, [&](const Call& call) { return RangeOf(call.id).begin; });
    }
  }

  void Check() {
    marks_.assign(calls_.size(), Mark::kNew);
    for (const uint32_t section : Roots()) Visit(section);
    if (!cyclic_) CheckDepth();
  }

 private:
  enum class Mark : uint8_t { kNew, kOpen, kDone };

  source::Range RangeOf(InstructionId id) const { return program_.instructions[id].range; }
  std::string NameOf(uint32_t section) const { return SubroutineName(program_.sections[SectionId(section)].number); }

  /// SLOW, then the subroutines by number.
  std::vector<uint32_t> Roots() const {
    std::vector<uint32_t> roots(calls_.size());
    for (uint32_t i = 0; i < roots.size(); ++i) roots[i] = i;
    std::ranges::stable_sort(roots, {}, [&](uint32_t i) {
      const Section& section = program_.sections[SectionId(i)];
      return section.kind == SectionKind::kSubroutine ? int64_t{section.number} : -1;
    });
    return roots;
  }

  void Fault(InstructionId id, const auto& report) {
    program_.faulty = true;
    if (!std::exchange(program_.instructions[id].faulty, true)) report();
  }

  void Visit(uint32_t section) {
    if (marks_[section] != Mark::kNew) return;
    marks_[section] = Mark::kOpen;
    path_.push_back(section);
    for (const Call& call : calls_[section]) {
      const uint32_t target = call.target.index;
      if (marks_[target] == Mark::kOpen) {
        ReportCycle(call);
      } else {
        Visit(target);
      }
    }
    path_.pop_back();
    marks_[section] = Mark::kDone;
    order_.push_back(section);  // after all that it calls
  }

  void ReportCycle(const Call& call) {
    cyclic_ = true;
    std::string way = NameOf(call.target.index);
    bool on = false;
    for (const uint32_t section : path_) {
      if (on) way += " calls " + NameOf(section);
      on = on || section == call.target.index;
    }
    way += " calls " + NameOf(call.target.index);
    Fault(call.id,
          [&] { diagnostics_.Report(RangeOf(call.id), diag::Host50Recursive, NameOf(call.target.index), way); });
  }

  void CheckDepth() {
    std::vector<bool> called(calls_.size());
    for (const std::vector<Call>& calls : calls_) {
      for (const Call& call : calls) called[call.target.index] = true;
    }
    std::vector<Depths> depths(calls_.size());
    const Call* first = nullptr;
    for (auto section = order_.rbegin(); section != order_.rend(); ++section) {
      if (!called[*section]) depths[*section] = 1;
      const Depths inside = depths[*section] << 1 & kAllDepths;
      for (const Call& call : calls_[*section]) {
        depths[call.target.index] |= inside;
        const bool deep = (inside & kTooDeep) != 0;
        if (deep && (first == nullptr || RangeOf(call.id).begin < RangeOf(first->id).begin)) first = &call;
      }
    }
    if (first == nullptr) return;
    Fault(first->id,
          [&] { diagnostics_.Report(RangeOf(first->id), diag::Host50CallDepth, NameOf(first->target.index)); });
  }

  Program& program_;
  diag::Engine& diagnostics_;
  std::vector<std::vector<Call>> calls_;  // by section, in source order
  std::vector<Mark> marks_;
  std::vector<uint32_t> path_, order_;
  bool cyclic_ = false;
};

}  // namespace

void CheckCalls(Program& program, diag::Engine& diagnostics) { CallGraph(program, diagnostics).Check(); }

}  // namespace plcxx::host50
