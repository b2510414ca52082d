// The routines of a program: which there are, and what a call of each may do to its caller.
#pragma once

#include <unordered_map>
#include <vector>

#include "transpiler/dialects/technol/analysis/flow.h"
#include "transpiler/dialects/technol/lowering/routine.h"
#include "transpiler/dialects/technol/machine/options.h"

namespace plcxx::technol {

class Routines {
 public:
  Routines(const Flow& flow, const Settings& settings);

  /// Modules and mechanisms in source order, then the subprograms.
  std::vector<Routine>& all() { return routines_; }
  const std::vector<Routine>& all() const { return routines_; }
  /// None where the unit is not reached.
  const Routine* OfUnit(UnitId unit) const;
  /// None when the program has no such module.
  const Routine* OfModule(ModuleKind kind) const;
  /// By Flow's number.
  const Routine& OfSubprogram(uint32_t subprogram) const { return routines_[routine_of_subprogram_[subprogram]]; }

 private:
  void FindUnits();
  void FindSubprograms();
  void FindLeaving();
  void FindStopping();
  const Routine& CalleeOf(const Instruction& call) const { return OfSubprogram(*flow_.CalleeOf(call)); }
  /// Does it trap where its index is outside?
  bool CanTrap(const Instruction& instruction) const;
  /// The mechanism that the instruction may stop.
  UnitId StoppedBy(const Instruction& instruction) const;

  const Program& tree_;
  const Flow& flow_;
  const Settings& settings_;
  std::vector<Routine> routines_;
  std::unordered_map<uint32_t, uint32_t> routine_of_unit_;
  std::vector<uint32_t> routine_of_subprogram_;  // by Flow's numbers
};

}  // namespace plcxx::technol
