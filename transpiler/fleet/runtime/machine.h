// The State of a fleet: each bit that the program uses is a plane, eight of them a byte; fields of state instances are
// planes, too. Loads and stores, under the mask of the lanes that execute them.
//
// In: PLCXX_FLEET_PLANES, _CLOCKS and _SCALARS, how many there are; _RETENTIVE, how many of the planes are retentive
// memory, the first ones; PLCXX_FLEET_FORCES, 1 when bits may be forced. transpiler/fleet/layout.h says which place is
// where, and fleet.cc relies on the order of the members.
#pragma once

#include "transpiler/fleet/runtime/operations.h"

namespace plcxx_fleet {

/// What generated code asks of whoever runs it.
struct Host {
  void* context;
  /// One host function for all lanes of `mask` (kWords words): arguments and answers are raw bits, a row of lanes each.
  void (*call)(void* context, uint32_t function, const uint64_t* mask, const uint64_t* arguments, uint64_t* results,
               uint64_t* seconds, uint64_t* has_second);
  uint32_t now;
};

/// The times of a timer that all lanes step together; see clocks.h and unit_timers.h.
struct Clock {
  uint32_t last, oldest, waiting, runs;
  uint32_t next, preset, unit_ms, counts_by_input;
};

/// The first planes are those of retentive memory; who stores it looks at the blocks that were written.
constexpr unsigned kPlanesOfABlock = 64;

struct alignas(64) State {
  Plane planes[PLCXX_FLEET_PLANES];
#if PLCXX_FLEET_FORCES
  Plane forced[PLCXX_FLEET_PLANES];  // 1: the bit keeps its value
#endif
  Clock clocks[PLCXX_FLEET_CLOCKS];
  uint8_t scalars[PLCXX_FLEET_SCALARS];                          // bytes that are the same in every machine
  uint8_t touched[PLCXX_FLEET_RETENTIVE / kPlanesOfABlock + 1];  // 1: the block was written after it was stored
  const Host* host;
};

template <class M>
inline void PutPlane(State& m, unsigned at, const Plane& value, const M& active) {
  if (at < PLCXX_FLEET_RETENTIVE) m.touched[at / kPlanesOfABlock] = 1;
#if PLCXX_FLEET_FORCES
  m.planes[at] = Stored(m.planes[at], value, Without(active, m.forced[at]));
#else
  m.planes[at] = Stored(m.planes[at], value, active);
#endif
}

// --- bytes of places that do not move -------------------------------------------------------------------------------

template <unsigned kFirst>
struct Planes {
  static const Plane* Load(const State& m) { return &m.planes[kFirst]; }
  template <class Number, class M>
  static void Store(State& m, const Number& value, unsigned from, const M& active) {
    PLCXX_UNROLL
    for (unsigned i = 0; i < 8; ++i) PutPlane(m, kFirst + i, value.Bit(from + i), active);
  }
};

/// The bytes of a number, least significant first.
template <class... Byte>
inline Bits<8 * sizeof...(Byte)> LoadBytes(const State& m) {
  Bits<8 * sizeof...(Byte)> number;
  unsigned at = 0;
  const auto load = [&](auto byte) {
    const Plane* const planes = decltype(byte)::Load(m);
    PLCXX_UNROLL
    for (unsigned i = 0; i < 8; ++i) number.p[at + i] = planes[i];
    at += 8;
  };
  (load(Byte{}), ...);
  return number;
}
template <class... Byte, class Number, class M>
inline void StoreBytes(State& m, const Number& value, const M& active) {
  const auto& number = Sliced(value);
  unsigned from = 0;
  ((Byte::Store(m, number, from, active), from += 8), ...);
}

// --- bytes that are the same in every machine -----------------------------------------------------------------------

template <class T, bool kBigEndian>
inline Uniform<T> LoadScalar(const State& m, unsigned at) {
  uint64_t value = 0;
  PLCXX_UNROLL
  for (unsigned b = 0; b < sizeof(T); ++b)
    value |= uint64_t{m.scalars[at + b]} << (8 * (kBigEndian ? sizeof(T) - 1 - b : b));
  return {static_cast<T>(value)};
}
template <class T, bool kBigEndian>
inline void StoreScalar(State& m, unsigned at, T value) {
  PLCXX_UNROLL
  for (unsigned b = 0; b < sizeof(T); ++b)
    m.scalars[at + b] = static_cast<uint8_t>(uint64_t{value} >> (8 * (kBigEndian ? sizeof(T) - 1 - b : b)));
}
inline Uniform<bool> LoadScalarBit(const State& m, unsigned at, unsigned bit) {
  return {(m.scalars[at] >> bit & 1) != 0};
}
inline void StoreScalarBit(State& m, unsigned at, unsigned bit, bool value) {
  m.scalars[at] = static_cast<uint8_t>((m.scalars[at] & ~(1U << bit)) | static_cast<unsigned>(value) << bit);
}

// --- elements at an index: the bytes [low, high) of a space are planes from `plane` on ------------------------------

struct Element {
  uint32_t offset, stride, low, high, plane;
  bool big_endian;
  /// The first plane of its byte of the lowest address; false: it is not wholly inside the bounds.
  bool Find(uint32_t index, unsigned bytes, uint32_t& first) const {
    const int64_t at = int64_t{offset} + int64_t{static_cast<int32_t>(index)} * int64_t{stride};
    if (at < int64_t{low} || at + bytes > int64_t{high}) return false;
    first = plane + 8 * static_cast<uint32_t>(at - low);
    return true;
  }
  /// Where the plane of a number's bit is, from the first one on.
  unsigned PlaneOf(unsigned bit, unsigned bytes) const {
    return big_endian ? 8 * (bytes - 1 - bit / 8) + bit % 8 : bit;
  }
};

inline unsigned FirstLane(const Plane& lanes) {
  unsigned w = 0;
  while (Word(lanes, w) == 0) ++w;
  return 64 * w + static_cast<unsigned>(__builtin_ctzll(Word(lanes, w)));
}

/// Calls `visit(index, lanes)` for each index that lanes have: machines that execute one program mostly want the same
/// few elements.
template <class Visit>
inline void ForEachIndex(const Bits<32>& index, Plane lanes, Visit&& visit) {
  const unsigned bits = UsedBits(index);
  while (Any(lanes)) {
    const unsigned lane = FirstLane(lanes);
    uint32_t number = 0;
    Plane differs{};
    for (unsigned i = 0; i < bits; ++i) {
      const bool one = (Word(index.p[i], lane / 64) >> (lane % 64) & 1) != 0;
      number |= static_cast<uint32_t>(one) << i;
      differs |= one ? ~index.p[i] : index.p[i];
    }
    visit(number, lanes & ~differs);
    lanes &= differs;
  }
}

template <unsigned N>
[[gnu::noinline]] Bits<N> LoadElements(const State& m, const Element& element, const Bits<32>& index,
                                       const Plane& active) {
  Bits<N> number{};
  ForEachIndex(index, active, [&](uint32_t one, const Plane& lanes) {
    uint32_t first = 0;
    if (!element.Find(one, N / 8, first)) return;
    for (unsigned i = 0; i < N; ++i) number.p[i] |= lanes & m.planes[first + element.PlaneOf(i, N / 8)];
  });
  return number;
}
template <unsigned N>
[[gnu::noinline]] void StoreElements(State& m, const Element& element, const Bits<32>& index, const Bits<N>& number,
                                     const Plane& active) {
  ForEachIndex(index, active, [&](uint32_t one, const Plane& lanes) {
    uint32_t first = 0;
    if (!element.Find(one, N / 8, first)) return;
    for (unsigned i = 0; i < N; ++i) PutPlane(m, first + element.PlaneOf(i, N / 8), number.p[i], lanes);
  });
}
[[gnu::noinline]] inline Plane LoadElementBits(const State& m, const Element& element, unsigned bit,
                                               const Bits<32>& index, const Plane& active) {
  Plane bits{};
  ForEachIndex(index, active, [&](uint32_t one, const Plane& lanes) {
    uint32_t first = 0;
    if (element.Find(one, 1, first)) bits |= lanes & m.planes[first + bit];
  });
  return bits;
}
[[gnu::noinline]] inline void StoreElementBits(State& m, const Element& element, unsigned bit, const Bits<32>& index,
                                               const Plane& value, const Plane& active) {
  ForEachIndex(index, active, [&](uint32_t one, const Plane& lanes) {
    uint32_t first = 0;
    if (element.Find(one, 1, first)) PutPlane(m, first + bit, value, lanes);
  });
}

/// What lanes load that are not in the mask, nobody asks.
template <unsigned N, class Index, class M>
inline Bits<N> LoadElement(const State& m, const Element& element, const Index& index, const M& active) {
  return LoadElements<N>(m, element, Held<32>(index), ToPlane(active));
}
template <unsigned N, class M>
inline Bits<N> LoadElement(const State& m, const Element& element, const Uniform<uint32_t>& index, const M&) {
  Bits<N> number{};
  uint32_t first = 0;
  if (!element.Find(index.value, N / 8, first)) return number;
  PLCXX_UNROLL
  for (unsigned i = 0; i < N; ++i) number.p[i] = m.planes[first + element.PlaneOf(i, N / 8)];
  return number;
}
template <unsigned N, class Index, class Number, class M>
inline void StoreElement(State& m, const Element& element, const Index& index, const Number& value, const M& active) {
  StoreElements<N>(m, element, Held<32>(index), Held<N>(value), ToPlane(active));
}
template <unsigned N, class Number, class M>
inline void StoreElement(State& m, const Element& element, const Uniform<uint32_t>& index, const Number& value,
                         const M& active) {
  uint32_t first = 0;
  if (!element.Find(index.value, N / 8, first)) return;
  const auto& number = Sliced(value);
  PLCXX_UNROLL
  for (unsigned i = 0; i < N; ++i) PutPlane(m, first + element.PlaneOf(i, N / 8), number.Bit(i), active);
}
template <class Index, class M>
inline Plane LoadElementBit(const State& m, const Element& element, unsigned bit, const Index& index, const M& active) {
  return LoadElementBits(m, element, bit, Held<32>(index), ToPlane(active));
}
template <class M>
inline Plane LoadElementBit(const State& m, const Element& element, unsigned bit, const Uniform<uint32_t>& index,
                            const M&) {
  uint32_t first = 0;
  return element.Find(index.value, 1, first) ? m.planes[first + bit] : Zeros();
}
template <class Index, class M>
inline void StoreElementBit(State& m, const Element& element, unsigned bit, const Index& index, const Plane& value,
                            const M& active) {
  StoreElementBits(m, element, bit, Held<32>(index), value, ToPlane(active));
}
template <class M>
inline void StoreElementBit(State& m, const Element& element, unsigned bit, const Uniform<uint32_t>& index,
                            const Plane& value, const M& active) {
  uint32_t first = 0;
  if (element.Find(index.value, 1, first)) PutPlane(m, first + bit, value, active);
}

// --- what routines need
// -----------------------------------------------------------------------------------------------

/// Calls `routine` with the mask, as All when it is every lane: the code for that stores without selecting.
template <class Routine>
inline void Run(All, Routine&& routine) {
  routine(All{});
}
template <class Routine>
inline void Run(const Plane& active, Routine&& routine) {
  if (IsFull(active)) {
    routine(All{});
  } else {
    routine(ToPlane(active));
  }
}

template <class M>
inline void ClearPlanes(State& m, unsigned first, unsigned count, const M& active) {
  for (unsigned i = 0; i < count; ++i) PutPlane(m, first + i, Zeros(), active);
}
inline void KeepPlanes(const State& m, unsigned first, unsigned count, Plane* kept) {
  for (unsigned i = 0; i < count; ++i) kept[i] = m.planes[first + i];
}
/// No other lanes have changed them meanwhile.
inline void PutBackPlanes(State& m, unsigned first, unsigned count, const Plane* kept) {
  for (unsigned i = 0; i < count; ++i) m.planes[first + i] = kept[i];
}

inline Uniform<uint32_t> Now(const State& m) { return {m.host->now}; }

/// By the function of the C library: the compiler has instructions of its own for a known size, which begin slowly.
[[gnu::noipa]] inline void ClearBytes(void* bytes, size_t size) { __builtin_memset(bytes, 0, size); }

/// What a host function gives.
enum class Gives { kNothing, kResult, kSecond, kBoth };

/// A call of a host function by the lanes of a mask.
template <unsigned kArguments, Gives kGives>
struct HostCall {
  static constexpr bool kHasResult = kGives == Gives::kResult || kGives == Gives::kBoth;
  static constexpr bool kHasSecond = kGives == Gives::kSecond || kGives == Gives::kBoth;
  Lanes<uint64_t> arguments[kArguments > 0 ? kArguments : 1];
  Lanes<uint64_t> results[kHasResult ? 1 : 0], seconds[kHasSecond ? 1 : 0];
  uint64_t has_second[kWords];

  template <class T, class Rows>
  void Argument(unsigned number, const Rows& rows) {
    for (unsigned lane = 0; lane < kLanes; ++lane) arguments[number].v[lane] = ToRaw<T>(rows[lane]);
  }
  template <class M>
  void Make(const State& m, uint32_t function, const M& active) {
    uint64_t mask[kWords];
    for (unsigned w = 0; w < kWords; ++w) {
      mask[w] = Word(ToPlane(active), w);
      has_second[w] = 0;
    }
    if constexpr (kHasResult) ClearBytes(results, sizeof results);
    if constexpr (kHasSecond) ClearBytes(seconds, sizeof seconds);
    m.host->call(m.host->context, function, mask, arguments[0].v, kHasResult ? results->v : nullptr,
                 kHasSecond ? seconds->v : nullptr, has_second);
  }
  template <unsigned N>
  static Bits<N> Narrow(const Lanes<uint64_t>& rows) {
    Bits<(N + 7) / 8 * 8> number;
    uint8_t bytes[kLanes];
    for (unsigned b = 0; 8 * b < N; ++b) {
      for (unsigned lane = 0; lane < kLanes; ++lane) bytes[lane] = static_cast<uint8_t>(rows.v[lane] >> (8 * b));
      BytesToPlanes(bytes, number.p + 8 * b);
    }
    return Held<N>(number);
  }
  template <unsigned N>
  Bits<N> Result() const {
    return Narrow<N>(*results);
  }
  template <unsigned N>
  Bits<N> Second() const {
    return Narrow<N>(*seconds);
  }
  template <class M>
  Plane HasSecond(const M& active) const {
    Plane mask{};
    for (unsigned w = 0; w < kWords; ++w) SetWord(mask, w, has_second[w]);
    return Within(active, mask);
  }
};

}  // namespace plcxx_fleet
