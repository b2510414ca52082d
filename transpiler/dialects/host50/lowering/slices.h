// SLICES=SLICED: the slow part cut into as many slices as a slow cycle has ticks (4.3).
//
// Where no jump leaves its slice, the slow routine is a choice by the slice. Otherwise a cursor says which network
// comes next, and the networks come one after the other: jumps go as in the uncut part, in front of each network at
// which a slice may end its tick's part is asked, and at the begin of a tick the cursor's network is gone to.
#pragma once

#include <vector>

#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class Jumps;
class NetworkWriter;
class OwnPlaces;
class Routines;
class StatementWriter;

class Slices : Context {
 public:
  Slices(const Context& context, OwnPlaces& own_places, Routines& routines, Jumps& jumps, StatementWriter& statements,
         NetworkWriter& networks);

  void Lower(const Section& section);

 private:
  using SliceOfNetwork = std::vector<uint32_t>;  // by the network's number within its section

  SliceOfNetwork SliceOfNetworks(const Section& section) const;
  bool JumpsLeaveSlices(const Section& section, const SliceOfNetwork& slices) const;
  void ByChoice(const Section& section, const SliceOfNetwork& slices);
  void ByCursor(const Section& section, const SliceOfNetwork& slices);
  void EndSliceBefore(uint32_t index, uint32_t slice);

  OwnPlaces& own_places_;
  Routines& routines_;
  Jumps& jumps_;
  StatementWriter& statements_;
  NetworkWriter& networks_;
  ir::PlaceId cursor_;  // the network that comes next
};

}  // namespace plcxx::host50
