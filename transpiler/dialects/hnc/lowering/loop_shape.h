// A loop as the proofs that it ends look at it (specification 6.6).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/dialects/hnc/analysis/loop_counts.h"
#include "transpiler/dialects/hnc/analysis/objects.h"
#include "transpiler/dialects/hnc/lowering/jumps.h"

namespace plcxx::hnc {

/// What is iterated: `tests_first` is false of a do loop, whose first iteration is not tested.
struct LoopShape {
  ExprId condition, step;
  std::vector<StatementId> body;
  bool tests_first = true;
  bool holds = true;               // false: it iterates where the condition does not hold
  bool is_statement = true;        // false: a label and the goto back to it
  Span region = {};                // from the label to the goto
  std::vector<StatementId> tests;  // ifs around the goto: their conditions are evaluated in every iteration
};

/// An if around a jump back, which goes on to the jump where its condition is `holds`.
struct RoundTest {
  StatementId test;
  bool holds = true;
  size_t in_front = 0;  // statements of the iteration in front of it
};

/// What is known of a loop that ends.
struct LoopProof {
  LoopCount count;
  Cell counter;
  bool is_entered = false;    // its body is executed at least once
  bool knows_values = false;  // `count` has the counter's values; else its condition changes it
  /// Its limit is in memory, and what has been stored there may be forced: the values are right as long as the
  /// iterations are counted.
  bool rests_on_memory = false;
};

/// How far a proof came: of several candidates the one that came furthest says why there is none.
enum class ProofStep : uint8_t { kNothing, kCounter, kSide, kChange, kLimit, kRange };

/// Why there is no proof.
struct Refusal {
  void Add(ProofStep step, std::string reason, source::Range in_condition = {});

  std::string why;
  source::Range counter;  // in the condition, where one was tried
  ProofStep failed_at = ProofStep::kNothing;
};

}  // namespace plcxx::hnc
