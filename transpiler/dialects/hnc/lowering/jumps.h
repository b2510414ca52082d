// The statements of one function: which holds which, in which order, and what jumps lead into.
//
// In: a function of the tree. Out: answers until the next one is looked at; jumps that the language refuses are
// reported.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "transpiler/dialects/hnc/analysis/live_jumps.h"
#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

/// Statements of a function by their order.
struct Span {
  uint32_t first = 0, last = 0;
  bool Holds(uint32_t order) const { return first <= order && order <= last; }
};

constexpr bool IsLoop(StatementKind kind) {
  return kind == StatementKind::kWhile || kind == StatementKind::kDo || kind == StatementKind::kFor;
}

constexpr bool IsCase(StatementKind kind) { return kind == StatementKind::kCase || kind == StatementKind::kDefault; }

class Jumps : Context {
 public:
  explicit Jumps(const Context& context) : Context(context) {}

  /// In the order of the source.
  const std::vector<StatementId>& JumpsTo(StatementId label) const;
  /// The statements that can be executed between a label and a jump back to it: those between them in the source, the
  /// loops that begin there, and what leads back into them from further down.
  Span Repeated(LabelId label, const std::vector<StatementId>& jumps) const;
  /// Whether a goto or a switch leads into the statements from outside, past the first of them.
  bool IsEnteredElsewhere(const Span& span) const;
  /// Whether an if or a switch decides if the label is passed before the jump back: one around the label alone, or an
  /// if with both in different arms.
  bool HasChoiceAround(StatementId label, StatementId jump) const;
  /// Whether control can get to the end of the statement, or round the loop by `continue`.
  bool GoesOn(StatementId id, bool& continues) const;
  /// Which statement holds which, and what jumps lead into.
  void Find(const Function& function);
  StatementId ParentOf(StatementId id) const;
  /// The place of a statement in the function's text. What is in no body comes after all: the statement of a label that
  /// is not declared, which was reported.
  uint32_t OrderOf(StatementId id) const;
  bool IsPartOf(StatementId id, const std::vector<StatementId>& statements) const;
  /// Of the function, by their order.
  const std::vector<StatementId>& statements() const { return statements_; }
  /// Ifs and switches that jumps lead into: they become jumps in the list around them.
  bool IsFlat(StatementId id) const { return flat_.contains(id.index); }
  bool IsLive(StatementId jump) const { return live_gotos_.contains(jump.index); }
  /// In the source; ranges do not say it, for all that one use of a macro makes has its range.
  bool IsBefore(StatementId a, StatementId b) const { return OrderOf(a) < OrderOf(b); }
  bool IsEntered(StatementId id) const { return id.valid() && entered_.contains(id.index); }

 private:
  static constexpr uint32_t kNowhere = UINT32_MAX;
  struct Node {
    StatementId parent;
    uint32_t order = kNowhere, last = 0;  // of the statement, and of the last one in it
  };

  bool Continues(StatementId id, StatementId outer) const;
  void FindNodes();
  /// Null: the statement is not in the function.
  const Node* NodeOf(StatementId id) const;
  void FindEntries(const Function& function);
  bool AreInOneArm(StatementId list, StatementId a, StatementId jump) const;
  /// Whether `inner` is `outer` or lies in it.
  bool Holds(StatementId outer, StatementId inner) const;
  void CheckJumps(const Function& function);

  std::unordered_set<uint32_t> flat_;        // by StatementId
  std::unordered_set<uint32_t> live_gotos_;  // by StatementId
  std::unordered_set<uint32_t> entered_;     // by StatementId: a jump from outside leads into it
  std::vector<Node> nodes_;                  // by StatementId, from that of the first on: a function has them in a row
  uint32_t first_node_ = 0;
  std::vector<StatementId> statements_;                              // of the function, by their order
  std::unordered_map<uint32_t, std::vector<StatementId>> jumps_to_;  // gotos by StatementId of their label
};

}  // namespace plcxx::hnc
