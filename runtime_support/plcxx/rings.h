// Positions on a ring of n places, numbered 0..n-1: turrets, magazines, rotary tables.
//
// Implements HOST50 6.5 (ROT). All numbers are two's complement. Forward is the ascending direction; of two equally
// long ways the forward one counts as the shorter. For positions outside the ring the results mean nothing (but are
// defined): ask OnRing first.
#pragma once

#include <stdint.h>

#include "plcxx/arith.h"
#include "plcxx/compare.h"

namespace plcxx {

/// Whether the ring has at least one place and both positions are on it.
[[gnu::const]] constexpr bool OnRing(uint32_t places, uint32_t from, uint32_t to) noexcept {
  return S32(places) >= 1 && from < places && to < places;
}

/// Steps from one position to another in the ascending direction, 0..places-1.
[[gnu::const]] constexpr uint32_t StepsForward(uint32_t places, uint32_t from, uint32_t to) noexcept {
  return to >= from ? to - from : to - from + places;
}

/// Whether the shorter way leads forward.
[[gnu::const]] constexpr bool RingForward(uint32_t places, uint32_t from, uint32_t to) noexcept {
  const uint32_t forward = StepsForward(places, from, to);
  return forward <= places - forward || forward == 0;
}

/// Steps of the shorter way.
[[gnu::const]] constexpr uint32_t RingSteps(uint32_t places, uint32_t from, uint32_t to) noexcept {
  const uint32_t forward = StepsForward(places, from, to);
  return RingForward(places, from, to) ? forward : places - forward;
}

/// The position one step before the target on the shorter way; the target itself when it is reached already.
[[gnu::const]] constexpr uint32_t RingBefore(uint32_t places, uint32_t from, uint32_t to) noexcept {
  if (from == to) return to;
  if (RingForward(places, from, to)) return to == 0 ? places - 1U : to - 1U;
  return to + 1U == places ? 0U : to + 1U;
}

}  // namespace plcxx
