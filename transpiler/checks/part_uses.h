// How often a part of the program reads and writes each place in one pass, subroutines included.
//
// In: a structured program, the kinds of routines that make a part. Out: for each place at most how often on any path,
// and the first two statements that do it. Loops count as often. Not its job: which places overlap.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::checks {

/// Up to two; more is two.
struct Times {
  uint8_t count = 0;
  source::Range first, second;
};

struct Use {
  Times reads, writes;
};

struct PartUses {
  std::map<uint32_t, Use> places;                 // by index of PlaceId; parameters and locals are left out
  std::map<uint32_t, Times> runs;                 // by index of StateId: operations on the instance
  std::map<uint32_t, source::Range> state_calls;  // by index of HostFunctionId: host calls that get State or Retentive

  bool empty() const { return places.empty() && runs.empty() && state_calls.empty(); }
};

/// Of all routines of these kinds, one after the other.
PartUses CollectUses(const ir::Program& program, const std::vector<ir::RoutineKind>& kinds);

}  // namespace plcxx::checks
