// Storage of a program's state: which member of the generated struct holds each place, and at which byte.
//
// Bits that no statement touches as part of a word are stored one per byte, because that is what processors load and
// store fastest; a byte that is used both ways stays packed. A value of several bytes that nothing else overlaps is a
// member of its own type; bytes that values of several widths share, or that are indexed, are a stretch: consecutive
// bytes in the order of the addresses. Retentive spaces are one packed block in address order.
// In: a program. Out: the members of State with their offsets, and for each place, instance and byte where it is.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::emit::layout {

enum class Storage : uint8_t {
  kNone,              // nothing in the program touches it
  kBit,               // State::bit[index]
  kByte,              // State::byte[index]
  kPackedBit,         // bit `bit` of State::byte[index]
  kWord16,            // State::word16[index]
  kWord32,            // State::word32[index]
  kWord64,            // State::word64[index]
  kFloat32,           // State::float32[index]
  kFloat64,           // State::float64[index]
  kWide,              // State::byte[index] and those after it, in the space's byte order
  kIndexed,           // values in State::byte from [index] on, which is byte Place::low of the space
  kRetentiveByte,     // State::retentive.bytes[index]
  kRetentiveBit,      // bit `bit` of State::retentive.bytes[index]
  kRetentiveWide,     // as kWide, in State::retentive.bytes
  kRetentiveIndexed,  // as kIndexed, likewise
  kField,             // a field of an instance
  kLocal              // a parameter or named local of the routine
};

/// Where one place is. `offset` is the byte of State that holds it (its first).
struct PlaceStorage {
  Storage storage = Storage::kNone;
  uint32_t index = 0;
  uint8_t bit = 0;
  uint32_t offset = 0;
};

struct StateStorage {
  uint32_t index = 0;   // in the array of its kind
  uint32_t offset = 0;  // byte of State
};

/// How one byte of a space is kept: whole, as up to eight separate bits, or not at all.
struct ByteStorage {
  /// kByte or kRetentiveByte, or the member (kWord16 ... kFloat64) of which it is part; kNone otherwise. `offset` is
  /// the very byte of State where the processor keeps the least significant byte of a word first.
  PlaceStorage whole;
  PlaceStorage bits[8];  // kBit; only when whole is kNone
};

/// Bytes [begin, end) of a space in State::byte, from `index` on.
struct Stretch {
  ir::SpaceId space;
  uint32_t begin = 0, end = 0;
  uint32_t index = 0;
};

/// One array member of State, in the order of the struct.
struct Member {
  std::string name;     // "bit", "on_delay_timer"
  std::string element;  // "bool", "plcxx::OnDelayTimer"
  uint32_t count = 0;
  uint32_t element_bytes = 1;
  uint32_t offset = 0;
};

struct Layout {
  std::vector<Member> members;
  std::vector<PlaceStorage> places;             // by PlaceId
  std::vector<StateStorage> states;             // by StateId
  std::vector<std::vector<ByteStorage>> bytes;  // by SpaceId and byte; empty for spaces of lifetime kRoutine
  std::vector<Stretch> stretches;               // ascending by index, after all single bytes of State::byte
  uint32_t retentive_bytes = 0;
  uint32_t size = 0;  // sizeof(State) of the release flavour
};

Layout MakeLayout(const ir::Program& program);

/// A member word or float: a value with a place in State of its own type.
bool IsWord(Storage storage);
struct WordMember {
  std::string_view name;  // of the array in State, "word16"
  ir::Type type;
};
const WordMember& WordMemberOf(Storage storage);
/// Of an indexed place: the lowest index whose value lies in [low, high), how many there are from there on, and the
/// byte of that first one, counted from `low`.
struct Elements {
  int64_t lowest = 0;
  uint32_t count = 0;
  uint32_t first = 0;
};
Elements ElementsOf(const ir::Place& place);

/// `value`, or the next multiple of `alignment` after it.
constexpr uint32_t RoundUp(uint32_t value, uint32_t alignment) {
  return (value + alignment - 1) / alignment * alignment;
}

/// Bytes and alignment of an instance's struct, and the offset of a field in it.
uint32_t StructBytes(ir::StateKind kind);
uint32_t StructAlignment(ir::StateKind kind);
uint32_t FieldOffset(ir::StateKind kind, uint8_t field);

}  // namespace plcxx::emit::layout
