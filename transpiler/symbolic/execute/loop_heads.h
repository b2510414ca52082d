// Loops whose number of rounds only the state knows, executed for one round that stands for each.
//
// Such a loop is not unrolled: what it writes becomes, at its head, whatever somebody says who knows what all rounds
// have in common; one round is executed from there, and execution goes on after the loop as if that round were the
// last one. In: the first rounds, as samples. Out: the state at the head, and later whether another round follows and
// what the next head would be. Not its job: to show that the state at the head stands for all rounds (the one who
// gives it has to).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "transpiler/symbolic/execute/cells.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::execute {

/// A loop as the execution came to its head.
struct ProgramLoop {
  ir::InstId loop;
  std::vector<CellId> cells;  // that a round may write, ascending
  struct Head {
    terms::TermId when;                 // execution comes here
    std::vector<terms::TermId> values;  // of the cells
    terms::TermId round;                // how many were before
  };
  /// The first ones; of those after the entry there may be none.
  Head entry;
  std::vector<Head> samples;
  /// It ends after so many rounds at the latest; 0: it does not count them.
  uint64_t bound = 0;
  /// By CellId, at the entry; none: nobody has asked for the cell by then.
  std::vector<terms::TermId> memory;
};

class LoopHeads {
 public:
  LoopHeads() = default;
  LoopHeads(const LoopHeads&) = delete;
  LoopHeads& operator=(const LoopHeads&) = delete;
  virtual ~LoopHeads() = default;

  /// The first iterations are about to be executed: they are all, or Open follows, and they have been samples only.
  virtual void BeginSamples() {}
  /// A loop begins; loops inside it are opened and closed before it is closed.
  virtual void Open() = 0;
  /// What the cells and the number of rounds are at the head of any round. Asked again with more cells where the round
  /// wrote others: what came since Open is forgotten then.
  virtual ProgramLoop::Head AtHead(const ProgramLoop& loop) = 0;
  /// Holds at every head by the way in which the loop is executed.
  virtual void Holds(terms::TermId condition) = 0;
  /// `again`: since the head, whether another round follows; the cells then, the number of rounds is one more.
  virtual void Close(terms::TermId again, std::span<const terms::TermId> values) = 0;
};

/// What is done with loops of which it is not known whether they go on.
struct LoopPolicy {
  uint32_t rounds = 4;         // that are unrolled, or samples
  LoopHeads* heads = nullptr;  // none: what goes round more often is left out
  /// Told by the execution: when something was left out; whether some loop has not been unrolled.
  terms::TermId left_out;
  bool has_heads = false;
};

}  // namespace plcxx::execute
