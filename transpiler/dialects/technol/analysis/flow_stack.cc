// PUSH and POP: what lies on the stack is the same on every path, and nothing stays there (specification 6.9, TE071).

#include <algorithm>

#include "transpiler/dialects/technol/analysis/flow_checks.h"
#include "transpiler/dialects/technol/parser/parser.h"

namespace plcxx::technol {
namespace {

using Stack = std::vector<InstructionId>;  // the PUSHes, the last one on top

class StackChecker {
 public:
  StackChecker(const Flow& flow, diag::Engine& diagnostics)
      : flow_(flow), program_(flow.program()), diagnostics_(diagnostics), reported_(program_.instructions.size()) {}

  void Run() {
    for (const Root& root : flow_.roots()) From(root.at);
    for (uint32_t k = 0; k < flow_.subprograms().size(); ++k) From(flow_.EntryOf(k));
  }

 private:
  const Operand& RegisterOf(InstructionId id) const { return program_.OperandOf(program_.instructions[id], 0); }
  uint32_t WordsOf(InstructionId id) const { return RegisterOf(id).width / 16U; }

  template <class... Args>
  void ReportOnce(InstructionId id, Args&&... args) {
    if (reported_[id.index]) return;
    reported_[id.index] = true;
    Report(diagnostics_, program_, program_.instructions[id], std::forward<Args>(args)...);
  }
  void Open(InstructionId push) { ReportOnce(push, diag::TechnolPushOpen, ToText(program_, RegisterOf(push))); }

  bool Join(const Stack& into, const Stack& other) {
    if (into.size() != other.size()) {
      const Stack& longer = into.size() > other.size() ? into : other;
      Open(longer.back());
      return false;
    }
    for (size_t i = 0; i < into.size(); ++i) {
      if (WordsOf(into[i]) != WordsOf(other[i])) Open(other[i]);
    }
    return false;
  }

  Stack Along(InstructionId id, Stack stack, Edge edge) {
    const Instruction& instruction = program_.instructions[id];
    if (edge == Edge::kResume) return {};
    if (instruction.faulty) return stack;
    if (instruction.op == Op::kPush) {
      stack.push_back(id);
      uint32_t words = 0;
      for (const InstructionId push : stack) words += WordsOf(push);
      if (words > kStackWords) {
        ReportOnce(id, diag::TechnolStackDepth, ToText(program_, RegisterOf(id)), static_cast<int64_t>(kStackWords));
        stack.pop_back();
      }
    } else if (instruction.op == Op::kPop) {
      const std::string reg = ToText(program_, RegisterOf(id));
      if (stack.empty()) {
        ReportOnce(id, diag::TechnolPopWithout, reg);
      } else {
        if (WordsOf(stack.back()) != WordsOf(id)) {
          ReportOnce(id, diag::TechnolPopWidth, reg, ToText(program_, RegisterOf(stack.back())));
        }
        stack.pop_back();
      }
    }
    return stack;
  }

  void From(InstructionId entry) {
    Spread(
        flow_, entry, Stack{}, stacks_,
        [&](InstructionId id, const Stack& stack, Edge edge) { return Along(id, stack, edge); },
        [&](const Stack& into, const Stack& other) { return Join(into, other); });
    for (const InstructionId id : stacks_.Reached()) {
      if (stacks_[id]->empty()) continue;
      bool goes_on = false;
      flow_.ForEachSuccessor(id, [&](InstructionId, Edge) { goes_on = true; });
      const Op op = program_.instructions[id].op;
      if (!goes_on || IsWait(op) || op == Op::kMechanismBegin) Open(stacks_[id]->back());
    }
  }

  const Flow& flow_;
  const Program& program_;
  diag::Engine& diagnostics_;
  States<Stack> stacks_{program_};
  std::vector<bool> reported_;  // by instruction
};

}  // namespace

void CheckStack(const Flow& flow, diag::Engine& diagnostics) { StackChecker(flow, diagnostics).Run(); }

}  // namespace plcxx::technol
