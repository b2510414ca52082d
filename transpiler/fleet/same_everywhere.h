// What is the same in every machine of a fleet, whatever their inputs are: the time, counts of the scheduler, the
// slice.
//
// In: a program whose pieces are always executed by all lanes. Out: which values and bytes of memory are one number for
// the whole fleet, and which on-delay timers all lanes step at the same moments. Such a number is a scalar, a branch on
// it a branch of the processor. Not its job: numbers that happen to be equal.
#pragma once

#include <vector>

#include "transpiler/fleet/local_bytes.h"
#include "transpiler/ir/accesses.h"
#include "transpiler/ir/program.h"

namespace plcxx::fleet {

/// A bit or an integer.
bool IsWhole(ir::Type type);

class SameEverywhere {
 public:
  explicit SameEverywhere(const ir::Program& program);

  bool Value(ir::ValueId id) const { return values_[id.index]; }
  bool Byte(uint32_t space, uint32_t offset) const { return bytes_[space][offset]; }
  /// Not indexed, and all of its bytes are.
  bool Place(ir::PlaceId id) const;
  /// A timer that can be stepped by one clock for all lanes: an on-delay timer whose statements have constant presets
  /// and a common time, and whose state nothing else of the program writes but `hold`; or a timer that counts a common
  /// period, by statements of one kind, of whose state nothing else of the program writes anything or reads the value.
  bool HasClock(ir::StateId id) const { return clocks_[id.index]; }

 private:
  void FindCandidates();
  void WalkRegion(ir::RegionId region, bool diverges);
  void WalkInst(ir::InstId id, bool diverges);
  bool ComputesSame(const ir::Inst& inst) const;
  void Differs(ir::PlaceId id);
  void FindClocks();
  void LookAtStep(const ir::Inst& inst, std::vector<const ir::Inst*>& steps);
  void LookAtField(const ir::Place& place, ir::Access access);

  const ir::Program& program_;
  const LocalBytes* locals_ = nullptr;
  std::vector<bool> values_, diverging_routines_, clocks_;
  std::vector<std::vector<bool>> bytes_;  // by space
  bool changed_ = false;
};

}  // namespace plcxx::fleet
