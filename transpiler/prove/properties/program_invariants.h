// The invariants that the checks of a property assume, all of them proved.
#pragma once

#include <vector>

#include "transpiler/prove/invariants/invariants.h"
#include "transpiler/prove/properties/checked_program.h"
#include "transpiler/prove/properties/run_trials.h"

namespace plcxx::prove::properties {

class ProgramInvariants {
 public:
  ProgramInvariants(CheckedProgram& checked, RunTrials& trials) : checked_(checked), trials_(trials) {}

  void Clear() { found_.clear(); }
  /// Around the cells on which the nearest periods of the property depend.
  void FindFor(const Property& property);
  void FindAround(const std::vector<execute::CellId>& cells);
  const std::vector<invariants::Invariant>& found() const { return found_; }
  /// What they say of a state.
  std::vector<terms::TermId> ConditionsOf(const std::function<terms::TermId(execute::CellId)>& value) const;

 private:
  CheckedProgram& checked_;
  RunTrials& trials_;
  std::vector<invariants::Invariant> found_;
};

}  // namespace plcxx::prove::properties
