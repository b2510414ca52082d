// W05, W06, W09, W16, W19, N05: sections, jumps and calls.
#include <algorithm>
#include <vector>

#include "transpiler/dialects/host50/analysis/warnings.h"

namespace plcxx::host50 {
namespace {

class FlowChecks {
 public:
  FlowChecks(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics)
      : program_(program),
        sources_(sources),
        diagnostics_(diagnostics),
        targets_(program.networks.size()),
        calls_(program.sections.size()) {
    for (uint32_t i = 0; i < program.instructions.size(); ++i) AddJump(InstructionId(i));
  }

  void Check() {
    for (uint32_t i = 0; i < program_.sections.size(); ++i) CheckSection(SectionId(i));
    CheckSlow();
  }

 private:
  void AddJump(InstructionId id) {
    const Instruction& instruction = program_.instructions[id];
    if (instruction.operands.count != 1) return;
    const Operand& operand = program_.operands[instruction.operands.first];
    if (operand.kind == OperandKind::kNetwork) {
      targets_[operand.network.index] = true;
      if (operand.network <= instruction.network) {
        diagnostics_.Report(instruction.range, diag::Host50BackwardJump, sources_.Text(operand.range));
      }
    } else if (operand.kind == OperandKind::kSubroutine) {
      calls_[operand.section.index].push_back(id);
    }
  }

  template <class Predicate>
  bool Any(const Section& section, Predicate predicate) const {
    for (uint32_t n = 0; n < section.networks.count; ++n) {
      const Span& span = program_.networks[NetworkId(section.networks.first + n)].instructions;
      for (uint32_t i = 0; i < span.count; ++i) {
        if (predicate(Info(program_.instructions[InstructionId(span.first + i)].op))) return true;
      }
    }
    return false;
  }

  void CheckSection(SectionId id) {
    const Section& section = program_.sections[id];
    if (section.kind == SectionKind::kSubroutine) CheckCalls(id);
    bool reachable = true;
    for (uint32_t n = 0; n < section.networks.count; ++n) {
      const NetworkId network_id(section.networks.first + n);
      const Network& network = program_.networks[network_id];
      const bool target = targets_[network_id.index];
      reachable = reachable || target;
      if (!reachable) diagnostics_.Report(network.range, diag::Host50NeverReached);
      if (network.has_label && !target) {
        diagnostics_.Report(network.range, diag::Host50LabelUnused, "L" + std::to_string(network.number));
      }
      if (EndsWithJump(network)) reachable = false;
    }
  }

  /// Is the last rung LD 1 and LBL alone? In a drawing: is the last action an LBL at the rail?
  bool EndsWithJump(const Network& network) const {
    const Instruction* jump = nullptr;
    const Instruction* before = nullptr;
    for (uint32_t i = network.instructions.count; i > 0 && before == nullptr; --i) {
      const Instruction& instruction = program_.instructions[InstructionId(network.instructions.first + i - 1)];
      const RungEffect effect = Info(instruction.op).effect;
      const bool ignored = effect == RungEffect::kNothing || (effect == RungEffect::kClose && jump == nullptr);
      if (!ignored) (jump == nullptr ? jump : before) = &instruction;
    }
    if (jump == nullptr || jump->op != Op::kLbl) return false;
    if (jump->input.kind == InputKind::kRail) return true;
    if (network.is_drawing || before == nullptr || before->op != Op::kLd) return false;
    const Operand& operand = program_.operands[before->operands.first];
    return operand.kind == OperandKind::kConstant && operand.bits == 1;
  }

  /// W05, W16.
  void CheckCalls(SectionId id) {
    const Section& section = program_.sections[id];
    std::vector<InstructionId>& calls = calls_[id.index];
    if (calls.empty()) {
      diagnostics_.Report(section.range, diag::Host50NeverCalled, SubroutineName(section.number));
    }
    const bool stateful = Any(section, [](const InstructionInfo& info) { return info.state != State::kStateless; });
    if (!stateful || calls.size() < 2) return;
    std::ranges::stable_sort(calls, {}, [&](InstructionId call) { return program_.instructions[call].range.begin; });
    for (size_t i = 1; i < calls.size(); ++i) {
      const Instruction& call = program_.instructions[calls[i]];
      const Operand& name = program_.operands[call.operands.first];
      diagnostics_.Report(call.range, diag::Host50StatefulCalledTwice, sources_.Text(name.range));
    }
  }

  /// W19.
  void CheckSlow() {
    const bool has_tables =
        !program_.title.empty() || !program_.symbols.empty() || !program_.alarms.empty() || !program_.mcodes.empty();
    if (program_.sections.empty() && has_tables) return;
    const SectionId slow = FindSection(program_, SectionKind::kSlow);
    if (!slow.valid()) {
      const source::File& file = sources_.Get(program_.files.front());
      const auto length = static_cast<source::Offset>(sources_.Line(program_.files.front(), 1).size());
      diagnostics_.Report({file.base, file.base + length}, diag::Host50SlowMissing);
      return;
    }
    const auto acts = [](const InstructionInfo& info) {
      return info.effect != RungEffect::kNothing && info.effect != RungEffect::kClose;
    };
    const SectionId fast = FindSection(program_, SectionKind::kFast);
    const bool empty = !Any(program_.sections[slow], acts) && (!fast.valid() || !Any(program_.sections[fast], acts));
    if (empty) diagnostics_.Report(program_.sections[slow].range, diag::Host50NothingToDo);
  }

  const Program& program_;
  const source::SourceManager& sources_;
  diag::Engine& diagnostics_;
  std::vector<bool> targets_;                      // by network
  std::vector<std::vector<InstructionId>> calls_;  // by section
};

}  // namespace

void CheckFlow(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics) {
  FlowChecks(program, sources, diagnostics).Check();
}

}  // namespace plcxx::host50
