// Positions on a ring, counted from 0: ROT of HOST50 6.5. Off the ring the results mean nothing, but are what the
// definition below gives.
#include "transpiler/symbolic/meaning/rows.h"

namespace plcxx::meaning {
namespace {

/// Steps upward from one position to the other.
Value StepsForward(Value places, Value from, Value to) {
  return Select(AtMost(from, to), to - from, to - from + places);
}

}  // namespace

Bit OnRing(I32 places, I32 from, I32 to) {
  return SignedLess(places.Same(0), places) & Less(from, places) & Less(to, places);
}

/// Forward when that is not the longer way; already there is forward, too.
Bit RingForward(I32 places, I32 from, I32 to) {
  const Value forward = StepsForward(places, from, to);
  return AtMost(forward, places - forward) | (forward == 0);
}

I32 RingSteps(I32 places, I32 from, I32 to) {
  const Value forward = StepsForward(places, from, to);
  return Select(RingForward(places, from, to), forward, places - forward);
}

/// One step before the target in the direction of travel, wrapped into the ring; there already: the target.
I32 RingBefore(I32 places, I32 from, I32 to) {
  const Value below = Select(to == 0, places - 1, to - 1);
  const Value above = Select(to + 1 == places, places.Same(0), to + 1);
  return Select(from == to, to, Select(RingForward(places, from, to), below, above));
}

}  // namespace plcxx::meaning
