// Proofs that jumps back end (specification 6.6): the loop condition is that of an if around the goto, and a round is
// the path from the label to the goto, straight through blocks and arms of ifs.
//
// Example: in `again: { g++; i++; if (i < 5) goto again; else h++; }` a round is `g++; i++;` and the test `i < 5`.

#include <algorithm>
#include <limits>

#include "transpiler/dialects/hnc/lowering_internal.h"

namespace plcxx::hnc {

/// The statements that are executed from the label on in every round that comes to the jump, and the tests around it;
/// false: the way is not straight.
bool Lowering::PathBack(StatementId label, StatementId jump, std::vector<StatementId>& body,
                        std::vector<RoundTest>& tests) const {
  std::unordered_set<uint32_t> around;
  for (StatementId at = jump; at.valid(); at = ParentOf(at)) around.insert(at.index);
  const auto holds_jump = [&around](StatementId id) { return id.valid() && around.contains(id.index); };
  // Pushes the statements up to the one with the jump in it, which is the result.
  const auto pass = [&](const std::vector<StatementId>& list, size_t from) {
    for (size_t i = from; i < list.size(); ++i) {
      if (holds_jump(list[i])) return list[i];
      body.push_back(list[i]);
    }
    return StatementId();
  };
  StatementId at = unit_.statements[label].then;
  if (!holds_jump(label)) {
    body.push_back(at);
    StatementId first = label;  // with what labels stand in front of this one
    while (ParentOf(first).valid() && unit_.statements[ParentOf(first)].then == first &&
           (unit_.statements[ParentOf(first)].kind == StatementKind::kLabel ||
            IsCase(unit_.statements[ParentOf(first)].kind))) {
      first = ParentOf(first);
    }
    if (!ParentOf(first).valid()) return false;
    const std::vector<StatementId>& list = unit_.statements[ParentOf(first)].body;
    const auto found = std::ranges::lower_bound(list, OrderOf(first), {}, [&](StatementId id) { return OrderOf(id); });
    at = found == list.end() || *found != first ? StatementId()
                                                : pass(list, static_cast<size_t>(found - list.begin()) + 1);
  }
  while (at.valid() && at != jump) {
    const Statement& statement = unit_.statements[at];
    switch (statement.kind) {
      case StatementKind::kCompound:
        at = pass(statement.body, 0);
        break;
      case StatementKind::kLabel:
        at = statement.then;
        break;
      case StatementKind::kIf: {
        const bool then = holds_jump(statement.then);
        tests.push_back({.test = at, .holds = then, .in_front = body.size()});
        at = then ? statement.then : statement.otherwise;
        break;
      }
      default:
        return false;
    }
  }
  return at.valid();
}

/// At most so often the statement behind the label is executed each time that the loop is entered; none: no proof.
std::optional<uint64_t> Lowering::RoundsOfGoto(StatementId label, StatementId jump) {
  std::vector<StatementId> body, heads;
  std::vector<RoundTest> tests;
  if (!PathBack(label, jump, body, tests)) return std::nullopt;
  for (const RoundTest& test : tests) heads.push_back(test.test);
  std::optional<uint64_t> best;
  for (size_t i = 0; i < tests.size(); ++i) {
    const bool is_first = i == 0 && tests[i].in_front == 0;
    const bool is_last = i + 1 == tests.size() && tests[i].in_front == body.size();
    const LoopShape loop{.condition = unit_.statements[tests[i].test].expression,
                         .step = {},
                         .body = body,
                         .tests_first = is_first,
                         .holds = tests[i].holds,
                         .is_statement = false,
                         .region = {OrderOf(label), OrderOf(jump)},
                         .tests = heads};
    const std::optional<LoopProof> proof = IsPassedBy(tests[i].test, loop) ? std::nullopt : Prove(loop);
    if (!proof) continue;
    // The test may come before the first change: one round more at most.
    const uint64_t rounds = proof->count.iterations + (is_first || !is_last ? 1 : 0);
    if (!best || rounds < *best) best = rounds;
  }
  return best;
}

uint32_t Lowering::OrderOf(StatementId id) const {
  const auto found = order_.find(id.index);
  return found == order_.end() ? std::numeric_limits<uint32_t>::max() : found->second;
}

bool Lowering::IsPartOf(StatementId id, const std::vector<StatementId>& statements) const {
  for (StatementId at = id; at.valid(); at = ParentOf(at)) {
    if (std::ranges::find(statements, at) != statements.end()) return true;
  }
  return false;
}

/// Whether a round may come to the jump back without passing the place exactly once: a goto within the region leads
/// over it or back in front of it, or comes from beside the straight path, and so does one from further down.
bool Lowering::IsPassedBy(StatementId place, const LoopShape& loop) const {
  const uint32_t middle = OrderOf(place);
  // To the label itself only the jump back leads, and what enters the loop.
  for (size_t i = loop.region.first + size_t{1}; i <= loop.region.last && i < statements_.size(); ++i) {
    if (unit_.statements[statements_[i]].kind != StatementKind::kLabel) continue;
    for (const StatementId jump : JumpsTo(statements_[i])) {
      const uint32_t from = OrderOf(jump);
      if (from < loop.region.first) continue;
      const bool on_path = from <= loop.region.last && IsPartOf(jump, loop.body);
      if (!on_path || (from < middle) != (i <= middle)) return true;
    }
  }
  return false;
}

}  // namespace plcxx::hnc
