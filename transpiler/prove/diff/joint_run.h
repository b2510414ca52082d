// Both versions executed beside each other with concrete values, on the terms that their parts were executed to.
//
// In: a comparison; what it takes for equal is one variable, the rest is one for each version. Out: what every variable
// becomes. The host answers nothing, and memory that is kept without power is 0. Not its job: what the states are
// for. A run of one version: invariants/concrete_run.h.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "transpiler/prove/diff/comparison.h"

namespace plcxx::prove::diff {

/// Where the bits of a cell are.
struct VariablePart {
  uint32_t variable;
  uint8_t low, width;
};

class JointRun {
 public:
  explicit JointRun(Comparison& comparison) : comparison_(comparison), terms_(comparison.terms) {}

  /// Executes power-on and the parts over the pairing as it is; false: not in time.
  bool Prepare();
  /// From now on only what these are computed from is executed, however many periods that takes; false: it is too
  /// large.
  bool Restrict(std::span<const VariablePart> looked_at);

  void PowerOn();
  /// Goes on from a state that both were seen in.
  void Take(const invariants::CellValues& of_old, const invariants::CellValues& of_new, uint64_t seen_ms);
  /// The part of that number of PartsOf(), the period last.
  void Execute(size_t part);
  void SetInput(size_t input, uint64_t value);

  size_t part_count() const { return parts_.size(); }
  size_t input_count() const { return inputs_.size(); }
  /// Of terms in all parts.
  size_t size() const { return size_; }
  uint64_t ValueOf(const VariablePart& part) const;
  /// None: the cell is a constant.
  std::optional<VariablePart> PartOf(Which which, execute::CellId cell);

  uint64_t now_ms = 0;

 private:
  struct Assignment {
    VariablePart to;
    terms::TermId value;
  };
  struct Step {
    std::vector<Assignment> assignments;
    std::vector<terms::TermId> cone;
  };
  Step StepOf(std::span<const machine::Transition* const> sides);
  void Execute(const Step& step);

  struct Memory {
    Which which;
    execute::CellId cell;
    VariablePart part;
  };

  Comparison& comparison_;
  terms::Terms& terms_;
  Step init_;
  std::vector<Step> parts_;
  std::vector<VariablePart> inputs_;
  std::vector<Memory> memory_;       // of both versions; of an equal pair that of the old one comes last
  std::vector<uint64_t> variables_;  // by variable
  std::vector<bool> is_answer_;      // by variable: of the host, or it is not known
  std::vector<uint64_t> values_;     // by term
  uint64_t step_ = 0;                // that is executed: answers differ from one to the next
  size_t size_ = 0;
};

}  // namespace plcxx::prove::diff
