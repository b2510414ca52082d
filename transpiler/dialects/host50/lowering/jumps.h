// LBL: forward it goes on there; backward as often as an execution of the section may, then a fault ends the section
// (4.8).
#pragma once

#include <vector>

#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class Faults;
class Logic;
class OwnPlaces;
class Results;

class Jumps : Context {
 public:
  Jumps(const Context& context, OwnPlaces& own_places, Faults& faults, Logic& logic, Results& results);

  void Jump(const Instruction& instruction);
  bool IsTarget(NetworkId network) const { return is_target_[network.index]; }
  /// Something else than an LBL goes there.
  void MakeTarget(NetworkId network) { is_target_[network.index] = true; }
  bool HasWayBack(SectionId section) const { return has_way_back_[section.index]; }
  /// The section's jumps may be refused from here on; an own place for each section that has a way back.
  void Count(ir::Lifetime lifetime);
  void AllowAll() { builder_.Store(now_.jumps_left, Word(kMostJumps)); }
  void ToEnd(ir::ValueId condition = {});

 private:
  static constexpr uint32_t kMostJumps = 10'000;  // backward, for each execution of a section (4.8)

  OwnPlaces& own_places_;
  Faults& faults_;
  Logic& logic_;
  Results& results_;
  std::vector<bool> is_target_;     // by NetworkId: an LBL goes there
  std::vector<bool> has_way_back_;  // by SectionId
};

}  // namespace plcxx::host50
