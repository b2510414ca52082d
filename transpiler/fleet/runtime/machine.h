// The State of a fleet: each byte that the program uses is eight planes, or a row with a byte for each lane; fields of
// state instances are planes. Loads and stores of both, under the mask of the lanes that execute them.
//
// In: PLCXX_FLEET_PLANES, _ROWS, _CLOCKS and _SCALARS, how many there are; PLCXX_FLEET_FORCES, 1 when bits may be
// forced. transpiler/fleet/layout.h says which place is where, and fleet.cc relies on the order of the members.
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

/// The times of an on-delay timer that all lanes step together; see clocks.h.
struct Clock {
  uint32_t last, oldest, waiting, runs;
};

struct alignas(64) State {
  Plane planes[PLCXX_FLEET_PLANES];
  uint8_t rows[PLCXX_FLEET_ROWS][kLanes];
#if PLCXX_FLEET_FORCES
  Plane forced[PLCXX_FLEET_PLANES];               // 1: the bit keeps its value
  uint8_t forced_rows[PLCXX_FLEET_ROWS][kLanes];  // likewise
#endif
  Clock clocks[PLCXX_FLEET_CLOCKS];
  uint8_t scalars[PLCXX_FLEET_SCALARS];  // bytes that are the same in every machine
  const Host* host;
};

template <class M>
inline void PutPlane(State& m, unsigned at, const Plane& value, const M& active) {
#if PLCXX_FLEET_FORCES
  m.planes[at] = Stored(m.planes[at], value, Without(active, m.forced[at]));
#else
  m.planes[at] = Stored(m.planes[at], value, active);
#endif
}

inline void PutRow(State& m, unsigned row, const uint8_t* bytes, All) {
#if PLCXX_FLEET_FORCES
  for (unsigned lane = 0; lane < kLanes; ++lane) {
    const uint8_t kept = m.forced_rows[row][lane];
    m.rows[row][lane] = static_cast<uint8_t>((m.rows[row][lane] & kept) | (bytes[lane] & ~kept));
  }
#else
  __builtin_memcpy(m.rows[row], bytes, kLanes);
#endif
}
inline void PutRow(State& m, unsigned row, const uint8_t* bytes, const Plane& active) {
  uint8_t on[kLanes];
  PlaneToBytes(active, on);
  for (unsigned lane = 0; lane < kLanes; ++lane) {
    auto free = static_cast<uint8_t>(0 - on[lane]);
#if PLCXX_FLEET_FORCES
    free = static_cast<uint8_t>(free & ~m.forced_rows[row][lane]);
#endif
    m.rows[row][lane] = static_cast<uint8_t>((m.rows[row][lane] & ~free) | (bytes[lane] & free));
  }
}

// --- bytes of places that do not move: Planes<first> or Row<row>
// ---------------------------------------------------------

template <unsigned kFirst>
struct Planes {
  static const Plane* Load(const State& m, Plane*) { return &m.planes[kFirst]; }
  template <class Number, class M>
  static void Store(State& m, const Number& value, unsigned from, const M& active) {
    PLCXX_UNROLL
    for (unsigned i = 0; i < 8; ++i) PutPlane(m, kFirst + i, value.Bit(from + i), active);
  }
};
template <unsigned kRow>
struct Row {
  static const Plane* Load(const State& m, Plane* planes) {
    BytesToPlanes(m.rows[kRow], planes);
    return planes;
  }
  template <class Number, class M>
  static void Store(State& m, const Number& value, unsigned from, const M& active) {
    uint8_t bytes[kLanes];
    PlanesToBytes([&](unsigned i) { return value.Bit(from + i); }, bytes);
    PutRow(m, kRow, bytes, active);
  }
};

/// The bytes of a number, least significant first.
template <class... Byte>
inline Bits<8 * sizeof...(Byte)> LoadBytes(const State& m) {
  Bits<8 * sizeof...(Byte)> number;
  unsigned at = 0;
  const auto load = [&](auto byte) {
    Plane room[8];
    const Plane* const planes = decltype(byte)::Load(m, room);
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

/// All bytes are rows: no planes on the way.
template <class T, unsigned... kRow>
inline Lanes<T> LoadRows(const State& m) {
  constexpr unsigned rows[] = {kRow...};
  Lanes<T> number;
  for (unsigned lane = 0; lane < kLanes; ++lane) {
    T value = 0;
    PLCXX_UNROLL
    for (unsigned b = 0; b < sizeof(T); ++b) value = static_cast<T>(value | T{m.rows[rows[b]][lane]} << (8 * b));
    number.v[lane] = value;
  }
  return number;
}
template <class T, unsigned... kRow, class Rows, class M>
inline void StoreRows(State& m, const Rows& value, const M& active) {
  constexpr unsigned rows[] = {kRow...};
  uint8_t bytes[kLanes];
  for (unsigned b = 0; b < sizeof(T); ++b) {
    for (unsigned lane = 0; lane < kLanes; ++lane) bytes[lane] = static_cast<uint8_t>(value[lane] >> (8 * b));
    PutRow(m, rows[b], bytes, active);
  }
}

inline Plane LoadRowBit(const State& m, unsigned row, unsigned bit) {
  uint8_t bytes[kLanes];
  for (unsigned lane = 0; lane < kLanes; ++lane) bytes[lane] = m.rows[row][lane] >> bit & 1;
  return BytesToPlane(bytes);
}
template <class M>
inline void StoreRowBit(State& m, unsigned row, unsigned bit, const Plane& value, const M& active) {
  uint8_t ones[kLanes], bytes[kLanes];
  PlaneToBytes(value, ones);
  for (unsigned lane = 0; lane < kLanes; ++lane)
    bytes[lane] = static_cast<uint8_t>((m.rows[row][lane] & ~(1U << bit)) | static_cast<unsigned>(ones[lane]) << bit);
  PutRow(m, row, bytes, active);
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

// --- elements at an index: the bytes [low, high) of a space are rows from `row` on -----------------------------------

struct Element {
  uint32_t offset, stride, low, high, row;
  bool big_endian;
  /// The row of its first byte; false: it is not wholly inside the bounds.
  bool Find(uint32_t index, unsigned bytes, uint32_t& first) const {
    const int64_t at = int64_t{offset} + int64_t{static_cast<int32_t>(index)} * int64_t{stride};
    if (at < int64_t{low} || at + bytes > int64_t{high}) return false;
    first = row + static_cast<uint32_t>(at - low);
    return true;
  }
};

template <class T, class Index>
inline Lanes<T> LoadElement(const State& m, const Element& element, const Index& index) {
  Lanes<T> number;
  for (unsigned lane = 0; lane < kLanes; ++lane) {
    uint32_t first = 0;
    T value = 0;
    if (element.Find(index[lane], sizeof(T), first)) {
      for (unsigned b = 0; b < sizeof(T); ++b) {
        const unsigned significance = element.big_endian ? sizeof(T) - 1 - b : b;
        value = static_cast<T>(value | T{m.rows[first + b][lane]} << (8 * significance));
      }
    }
    number.v[lane] = value;
  }
  return number;
}
inline void PutByte(State& m, uint32_t row, unsigned lane, unsigned mask, unsigned value) {
#if PLCXX_FLEET_FORCES
  mask &= ~static_cast<unsigned>(m.forced_rows[row][lane]);
#endif
  m.rows[row][lane] = static_cast<uint8_t>((m.rows[row][lane] & ~mask) | (value & mask));
}
template <class T, class Index, class Number, class M>
inline void StoreElement(State& m, const Element& element, const Index& index, const Number& value, const M& active) {
  uint8_t on[kLanes];
  PlaneToBytes(ToPlane(active), on);
  for (unsigned lane = 0; lane < kLanes; ++lane) {
    uint32_t first = 0;
    if (on[lane] == 0 || !element.Find(index[lane], sizeof(T), first)) continue;
    for (unsigned b = 0; b < sizeof(T); ++b) {
      const unsigned significance = element.big_endian ? sizeof(T) - 1 - b : b;
      PutByte(m, first + b, lane, 0xFF, static_cast<uint8_t>(value[lane] >> (8 * significance)));
    }
  }
}
template <class Index>
inline Plane LoadElementBit(const State& m, const Element& element, unsigned bit, const Index& index) {
  uint8_t bytes[kLanes];
  for (unsigned lane = 0; lane < kLanes; ++lane) {
    uint32_t first = 0;
    bytes[lane] = element.Find(index[lane], 1, first) ? m.rows[first][lane] >> bit & 1 : 0;
  }
  return BytesToPlane(bytes);
}
template <class Index, class M>
inline void StoreElementBit(State& m, const Element& element, unsigned bit, const Index& index, const Plane& value,
                            const M& active) {
  uint8_t on[kLanes], ones[kLanes];
  PlaneToBytes(ToPlane(active), on);
  PlaneToBytes(value, ones);
  for (unsigned lane = 0; lane < kLanes; ++lane) {
    uint32_t first = 0;
    if (on[lane] == 0 || !element.Find(index[lane], 1, first)) continue;
    PutByte(m, first, lane, 1U << bit, static_cast<unsigned>(ones[lane]) << bit);
  }
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
template <class M>
inline void ClearRow(State& m, unsigned row, const M& active) {
  const uint8_t zeros[kLanes] = {};
  PutRow(m, row, zeros, active);
}
inline void KeepPlanes(const State& m, unsigned first, unsigned count, Plane* kept) {
  for (unsigned i = 0; i < count; ++i) kept[i] = m.planes[first + i];
}
/// No other lanes have changed them meanwhile.
inline void PutBackPlanes(State& m, unsigned first, unsigned count, const Plane* kept) {
  for (unsigned i = 0; i < count; ++i) m.planes[first + i] = kept[i];
}

inline Uniform<uint32_t> Now(const State& m) { return {m.host->now}; }

/// A call of a host function by the lanes of a mask.
template <unsigned kArguments>
struct HostCall {
  Lanes<uint64_t> arguments[kArguments > 0 ? kArguments : 1];
  Lanes<uint64_t> results, seconds;
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
    for (unsigned lane = 0; lane < kLanes; ++lane) results.v[lane] = seconds.v[lane] = 0;
    m.host->call(m.host->context, function, mask, arguments[0].v, results.v, seconds.v, has_second);
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
    return Narrow<N>(results);
  }
  template <unsigned N>
  Bits<N> Second() const {
    return Narrow<N>(seconds);
  }
  template <class M>
  Plane HasSecond(const M& active) const {
    Plane mask{};
    for (unsigned w = 0; w < kWords; ++w) SetWord(mask, w, has_second[w]);
    return Within(active, mask);
  }
};

}  // namespace plcxx_fleet
