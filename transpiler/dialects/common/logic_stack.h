// The logic of an accumulator language, evaluated while lowering: A / AN / O, brackets, ANB / ORB.
//
//   A I 0.0 ; O( ; A I 0.1 ; AN I 0.2 ; ) ; = O 0.0    ->    O0.0 = I0.0 | (I0.1 & !I0.2)
//
// The lowest level is the status register. Each further one (a bracket, a block of contacts) begins empty and is joined
// with the one below when it is closed. An empty level, and one whose sequence has ended, is "first": the next
// operation loads instead of combining. Alternatives are the AND-before-OR of an `O` without operand: what stands
// before it waits until the string after it ends.
// Not its job: which instruction ends what, and whether a program may do it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "transpiler/dialects/common/register.h"
#include "transpiler/ir/builder.h"

namespace plcxx::dialects {

enum class Join : uint8_t { kAnd, kOr, kXor };

/// One operation on bits.
ir::ValueId Joined(ir::Builder& builder, Join join, ir::ValueId left, ir::ValueId right);
ir::ValueId Inverted(ir::Builder& builder, ir::ValueId value);

class LogicStack {
 public:
  /// `status` outlives the stack. The lowest level is first.
  LogicStack(ir::Builder& builder, Register& status) : builder_(builder), status_(status), levels_(1) {}

  /// Levels above the lowest one.
  size_t depth() const { return levels_.size() - 1; }
  bool first() const { return top().first; }
  /// Does an alternative wait on this level?
  bool has_alternative() const { return top().alternative.valid(); }

  /// What this level has computed; of the lowest one also when it is first: the status as it was left.
  ir::ValueId Value();
  /// Loads when first, else joins. A kOr joins waiting alternatives before it.
  void Operate(Join join, ir::ValueId operand);
  /// The same on the lowest level where only `is_first`, a bit, tells at run time whether the operation loads.
  void OperateUnless(ir::ValueId is_first, Join join, ir::ValueId operand);
  /// The value replaces what was computed here, and waiting alternatives (a comparison).
  void Replace(ir::ValueId value);

  /// What was computed here becomes an alternative; the string after it begins empty.
  void BeginAlternative();
  /// The same where `before` is what was computed.
  void BeginAlternative(ir::ValueId before);
  /// Alternative and string become one value, an empty string counts as 0; afterwards this level is not first.
  /// Returns false when nothing waits.
  bool JoinAlternatives();

  /// The next operation on this level is first; its value stays.
  void EndSequence() { top().first = true; }
  /// The next operation on the lowest level combines with the status as it is.
  void ContinueSequence() { top().first = false; }

  /// A new level begins, empty.
  void Push();
  /// The level ends; its value is joined with the level below as Operate does it. Not on the lowest level, nor on one
  /// that has computed nothing.
  void Pop(Join join);
  /// Ends the level and gives its value to nobody but the caller.
  ir::ValueId Pop();

 private:
  struct Level {
    ir::ValueId value;        // of the lowest level: in the register
    ir::ValueId alternative;  // what stood before an `O` without operand
    bool first = true;
    bool empty_string = false;
  };
  Level& top() { return levels_.back(); }
  const Level& top() const { return levels_.back(); }
  void SetValue(ir::ValueId value);

  ir::Builder& builder_;
  Register& status_;
  std::vector<Level> levels_;
};

}  // namespace plcxx::dialects
