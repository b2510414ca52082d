// A plane: one bit of each machine of a fleet, a lane for each machine. What has one bit in a machine is one plane
// here, and an operation on it is one instruction of the processor for all lanes.
//
// In: PLCXX_FLEET_WORDS, how many words of 64 lanes a plane has: 1, 4 or 8. Not its job: numbers (values.h).
#pragma once

#include <stddef.h>
#include <stdint.h>
#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace plcxx_fleet {

constexpr unsigned kWords = PLCXX_FLEET_WORDS;
constexpr unsigned kLanes = 64 * kWords;

#if PLCXX_FLEET_WORDS == 1
using Plane = uint64_t;
inline uint64_t Word(Plane plane, unsigned) { return plane; }
inline void SetWord(Plane& plane, unsigned, uint64_t word) { plane = word; }
#else
typedef uint64_t Plane __attribute__((vector_size(8 * PLCXX_FLEET_WORDS)));
inline uint64_t Word(const Plane& plane, unsigned w) { return plane[w]; }
inline void SetWord(Plane& plane, unsigned w, uint64_t word) { plane[w] = word; }
#endif

inline Plane Zeros() { return Plane{}; }
inline Plane Ones() { return ~Plane{}; }
inline Plane AllEqual(bool bit) { return bit ? Ones() : Zeros(); }

inline bool Any(const Plane& plane) {
#if PLCXX_FLEET_WORDS == 8 && defined(__AVX512F__)
  return _mm512_test_epi64_mask(reinterpret_cast<__m512i>(plane), reinterpret_cast<__m512i>(plane)) != 0;
#elif PLCXX_FLEET_WORDS == 4 && defined(__AVX2__)
  return _mm256_testz_si256(reinterpret_cast<__m256i>(plane), reinterpret_cast<__m256i>(plane)) == 0;
#else
  uint64_t any = 0;
  for (unsigned w = 0; w < kWords; ++w) any |= Word(plane, w);
  return any != 0;
#endif
}
inline bool IsFull(const Plane& plane) {
  uint64_t all = ~uint64_t{0};
  for (unsigned w = 0; w < kWords; ++w) all &= Word(plane, w);
  return all == ~uint64_t{0};
}

/// The mask of code that every lane executes: what is stored needs no selection then.
struct All {};

inline Plane ToPlane(All) { return Ones(); }
inline const Plane& ToPlane(const Plane& plane) { return plane; }
inline bool Any(All) { return true; }
inline bool IsFull(All) { return true; }

/// Of the lanes of `mask` those where `condition` is 1, or 0.
inline Plane Within(All, const Plane& condition) { return condition; }
inline Plane Within(const Plane& mask, const Plane& condition) { return mask & condition; }
inline Plane Without(All, const Plane& condition) { return ~condition; }
inline Plane Without(const Plane& mask, const Plane& condition) { return mask & ~condition; }

inline Plane Choose(const Plane& condition, const Plane& yes, const Plane& no) {
  return (condition & yes) | (~condition & no);
}
/// What a place holds after `value` was stored into it in the lanes of a mask.
inline Plane Stored(const Plane&, const Plane& value, All) { return value; }
inline Plane Stored(const Plane& before, const Plane& value, const Plane& mask) { return Choose(mask, value, before); }

}  // namespace plcxx_fleet
