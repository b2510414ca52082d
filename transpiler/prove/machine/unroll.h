// A program period by period: its state after each one as terms over the inputs so far.
//
// Inputs (inputs.h) have new values in every period, and where fast and slow part have periods of their own, before
// each part. A term is made when it is asked for: what a question does not depend on costs nothing, however many
// periods there are. Not its job: questions.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "transpiler/prove/machine/inputs.h"
#include "transpiler/prove/machine/relation.h"
#include "transpiler/prove/machine/transition.h"
#include "transpiler/prove/machine/version.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::machine {

enum class Start : uint8_t {
  kPowerOn,          // all memory as the program says; at power-on the host answers 0
  kAnsweredPowerOn,  // the same, whatever the host answers and writes at power-on, but retentive memory
  kAnyRetentive,     // the same with any retentive memory, too
  kAnywhere          // any state at all, at any time
};

class Unrolled {
 public:
  /// `name` distinguishes the variables of several. All arguments by reference outlive it.
  Unrolled(terms::Terms& terms, const Relation& relation, const std::vector<bool>& inputs, Start start,
           std::string name);

  /// One more period.
  void Advance();
  uint32_t periods() const { return static_cast<uint32_t>(inputs_of_.size() - 1); }
  /// Not empty: the program cannot be executed, and why.
  const execute::Refusal& refusal() const { return refusal_; }

  /// After a period; 0: at the start.
  terms::TermId Value(execute::CellId cell, uint32_t period);
  /// The variables of what is free at kAnywhere, as far as they have been asked for; by cell.
  const std::map<execute::CellId, terms::TermId>& start_variables() const { return start_variables_; }

  /// The variables of the inputs of a part of a period, as far as they have been asked for; by cell.
  using Part = std::map<execute::CellId, terms::TermId>;
  const std::vector<Part>& parts(uint32_t period) const { return inputs_of_[period]; }
  /// Parts of each period between which inputs may change.
  uint32_t part_count() const { return fast_parts_ == 0 ? 1 : fast_parts_; }

  /// By cell, before the first Value: bits that the control may take back before a part; empty: none.
  std::vector<bool> taken_back;
  /// By cell: whether it does so before a part of this period, as far as that has been asked for.
  const std::vector<Part>& takes_back(uint32_t period) const { return takes_back_[period]; }
  /// By cell, over what the host has answered: the state when power has come; empty: kAnywhere.
  const std::vector<terms::TermId>& after_power_on() const { return initial_; }

  /// Asked now and then while terms are made; true: the time is over, and what Value gives from then on is anything.
  std::function<bool()> late;

  /// Instead of new variables, inputs are what this gives.
  std::function<terms::TermId(execute::CellId cell, uint32_t period, uint32_t part)> choose_input;
  /// Of kAnywhere, before the first Value: the start is what this gives, at this time, instead of variables.
  void StartFrom(std::function<terms::TermId(execute::CellId cell)> start, terms::TermId time) {
    choose_start_ = std::move(start);
    time_ = time;
  }
  /// The time of period 0 at kAnywhere; of others, that of period `period`.
  terms::TermId TimeAfter(uint32_t period);
  /// The time that the first period sees.
  terms::TermId FirstTime() { return Now(1, 0); }

 private:
  /// What runs one after the other: step 0 is the start; the fast parts of a period come before its slow one.
  struct Step {
    uint32_t period, part;
    bool has_new_inputs, is_fast;
  };
  /// A term of the relation with the values that its variables have before a step.
  struct Instance {
    terms::TermId term;
    uint32_t step = 0;
  };

  uint32_t StepsOfPeriod() const { return fast_parts_ == 0 ? 1 : fast_parts_ + 1; }
  Step StepAt(uint32_t step) const;
  bool IsFresh(execute::CellId cell, const Step& step) const;
  /// The value itself, or none: that of an instance.
  struct Found {
    Instance instance;
    terms::TermId value;
    terms::TermId stays = {};  // valid: 0 where the control has taken the bit back since
  };
  Found Follow(execute::CellId cell, uint32_t step);
  Found FindVariable(const Instance& variable);
  terms::TermId Instantiate(const Instance& root);
  terms::TermId Input(execute::CellId cell, uint32_t period, uint32_t part);
  /// Adds what may have happened to the cell before a step to what is found before it.
  void AddTakingBack(execute::CellId cell, const Step& step, terms::TermId& stays);
  terms::TermId AtStart(execute::CellId cell);
  terms::TermId Now(uint32_t period, uint32_t part);

  terms::Terms& terms_;
  const Relation& relation_;
  const Version& version_;
  const std::vector<bool>& inputs_;
  Start start_;
  std::string name_;
  std::function<terms::TermId(execute::CellId cell)> choose_start_;
  uint32_t fast_parts_ = 0;
  terms::TermId time_;                                              // at the start of kAnywhere
  std::vector<terms::TermId> initial_;                              // by cell; but for kAnywhere
  std::vector<std::vector<Part>> inputs_of_;                        // by period
  std::vector<std::vector<Part>> takes_back_;                       // by period
  std::vector<std::unordered_map<uint32_t, terms::TermId>> known_;  // by step, then by term of the relation
  std::map<execute::CellId, terms::TermId> start_variables_;
  execute::Refusal refusal_;
};

}  // namespace plcxx::prove::machine
