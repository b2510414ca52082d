// The paths through a technol program: successors, waits with their resume points, subprograms and who calls them, the
// width of DR (specification 6.1, 6.4, 6.7).
//
// Used by the checks of paths (flow_checks.h) and by the lowering. A tree with faults is looked at, too: a faulty
// instruction goes on to the next one.
#pragma once

#include <algorithm>
#include <deque>
#include <optional>
#include <vector>

#include "transpiler/dialects/technol/analysis/effects.h"
#include "transpiler/dialects/technol/syntax/syntax.h"

namespace plcxx::technol {

enum class Edge : uint8_t {
  kOn,      // to the next instruction
  kJump,    // to the label
  kResume,  // a wait: to where the next pass goes on
  kPast,    // past a mechanism that stands in a module
};

/// Where an execution begins.
struct Root {
  InstructionId at;
  UnitId unit;  // module or mechanism
};

/// A label that is called.
struct Subprogram {
  LabelId label;
  uint32_t level = 0;                // the longest chain of calls to it; 1: only from modules and mechanisms
  std::vector<InstructionId> calls;  // of it, in source order
};

class Flow {
 public:
  explicit Flow(const Program& program);

  const Program& program() const { return program_; }
  /// Modules and mechanisms in source order.
  const std::vector<Root>& roots() const { return roots_; }
  /// In the order of their first calls.
  const std::vector<Subprogram>& subprograms() const { return subprograms_; }
  /// Of a CALL; none where it is faulty.
  std::optional<uint32_t> CalleeOf(const Instruction& call) const;
  /// The subprograms, those that are called before their callers. Recursive ones are left out.
  const std::vector<uint32_t>& calls_first() const { return calls_first_; }
  /// CALLs that close a cycle, as 10.4 orders them.
  const std::vector<InstructionId>& recursions() const { return recursions_; }
  /// Where a wait goes on in the next pass (D21); a wait that stands elsewhere than in a mechanism goes on after
  /// itself.
  InstructionId ResumeOf(InstructionId wait) const;
  /// Is it in a unit that may wait?
  bool MayWait(const Instruction& instruction) const;
  /// visit(InstructionId to, Edge).
  template <class Visit>
  void ForEachSuccessor(InstructionId id, Visit&& visit) const;

  /// Of DR before each instruction: 16 or 32; 0 where nothing has been loaded.
  uint32_t WidthBefore(InstructionId id) const { return widths_[id.index]; }
  /// Instructions where paths join that leave DR with different widths.
  const std::vector<InstructionId>& width_joins() const { return width_joins_; }

  /// Is it executed on some path from a root?
  bool IsReached(InstructionId id) const { return reached_[id.index]; }
  /// What holds something that a path after the instruction reads.
  Resources LiveBehind(InstructionId id) const { return live_behind_[id.index]; }
  Resources LiveBefore(InstructionId id) const { return live_before_[id.index]; }
  /// The same for a subprogram as a whole: what it reads of its caller's.
  Resources LiveBeforeSubprogram(uint32_t subprogram) const;

  /// How much lies on the stack of the module, mechanism or subprogram before the instruction.
  uint32_t PushesBefore(InstructionId id) const { return pushes_[id.index]; }
  /// Appends the instructions on paths from `entry` that are not marked as seen, in source order.
  void CollectFrom(InstructionId entry, std::vector<bool>& seen, std::vector<InstructionId>& order) const;
  /// The instructions on paths from `entry`, in source order.
  std::vector<InstructionId> CollectFrom(InstructionId entry) const;
  InstructionId EntryOf(uint32_t subprogram) const { return program_.labels[subprograms_[subprogram].label].at; }

 private:
  void FindSubprograms();
  void VisitCalls(InstructionId from, std::vector<uint8_t>& marks, uint32_t level);
  void FindLevels();
  void FindWidths();
  uint32_t WidthAfter(InstructionId id) const;
  template <class Bring>
  void BringWidths(InstructionId id, const std::vector<uint8_t>& leaves, Bring&& bring) const;
  /// The subprograms to whose end a RET leads, by instruction.
  std::vector<std::vector<uint32_t>> OwnersOfReturns() const;
  void FindReached();
  void FindLive();
  void FindPushes();

  const Program& program_;
  std::vector<Root> roots_;
  std::vector<Subprogram> subprograms_;
  std::vector<std::optional<uint32_t>> subprogram_of_label_;
  std::vector<uint32_t> calls_first_;
  std::vector<InstructionId> recursions_;
  std::vector<uint8_t> widths_;
  std::vector<InstructionId> width_joins_;
  std::vector<bool> reached_;
  std::vector<uint32_t> pushes_;
  std::vector<Resources> live_before_, live_behind_;
  mutable std::vector<bool> seen_;  // by one CollectFrom; all false between them
};

template <class Visit>
void Flow::ForEachSuccessor(InstructionId id, Visit&& visit) const {
  const Instruction& instruction = program_.instructions[id];
  const InstructionId next(id.index + 1);
  const auto target = [&]() -> std::optional<InstructionId> {
    for (uint32_t i = 0; i < instruction.operands.count; ++i) {
      const Operand& operand = program_.OperandOf(instruction, i);
      if (operand.kind == OperandKind::kLabel && operand.label.valid()) return program_.labels[operand.label].at;
    }
    return std::nullopt;
  };
  if (instruction.op == Op::kMechanismBegin) {
    const InstructionId end = program_.units[instruction.mechanism].end;
    if (end.valid()) visit(InstructionId(end.index + 1), Edge::kPast);
    return;
  }
  for (const Op ends : {Op::kMechanismEnd, Op::kModuleEnd, Op::kAreaEnd, Op::kRet}) {
    if (instruction.op == ends) return;
  }
  if (instruction.op == Op::kMechInit && !instruction.faulty) {
    const Operand& operand = program_.OperandOf(instruction, 0);
    if (operand.mechanism.valid() && operand.mechanism == instruction.unit) return;  // leaves it
  }
  if (!instruction.faulty && (IsJump(instruction.op) || IsWait(instruction.op))) {
    if (const auto to = target()) visit(*to, Edge::kJump);
    if (IsUnconditionalJump(instruction.op)) return;
  }
  if (!instruction.faulty && IsWait(instruction.op) && MayWait(instruction)) {
    visit(ResumeOf(id), Edge::kResume);
    if (instruction.op == Op::kEx) return;
  }
  visit(next, Edge::kOn);
}

/// A state for each instruction that a walk has reached. One object serves many walks: each costs what it reaches, not
/// what the program has.
template <class State>
class States {
 public:
  explicit States(const Program& program) : states_(program.instructions.size()) {}

  std::optional<State>& operator[](InstructionId id) { return states_[id.index]; }
  void Clear() {
    for (const InstructionId id : reached_) states_[id.index].reset();
    reached_.clear();
  }
  void AddReached(InstructionId id) { reached_.push_back(id); }
  /// In source order.
  const std::vector<InstructionId>& Reached() {
    std::sort(reached_.begin(), reached_.end());
    return reached_;
  }

 private:
  std::vector<std::optional<State>> states_;
  std::vector<InstructionId> reached_;
};

/// Spreads a state from `entry` until nothing changes: state_at(to) = join over all edges of along(from, state, edge).
/// `states` is by instruction; join(State& into, const State& other) tells whether it changed `into`.
template <class State, class Along, class Join>
void Spread(const Flow& flow, InstructionId entry, const State& initial, States<State>& states, Along&& along,
            Join&& join) {
  std::deque<InstructionId> work;
  states.Clear();
  const auto reach = [&](InstructionId at, const State& state) {
    std::optional<State>& known = states[at];
    if (!known) {
      known = state;
      states.AddReached(at);
    } else if (!join(*known, state)) {
      return;
    }
    work.push_back(at);
  };
  reach(entry, initial);
  while (!work.empty()) {
    const InstructionId id = work.front();
    work.pop_front();
    const State state = *states[id];
    flow.ForEachSuccessor(id, [&](InstructionId to, Edge edge) { reach(to, along(id, state, edge)); });
  }
}

}  // namespace plcxx::technol
