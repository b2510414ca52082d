// Storage of a program's state: which member of the generated struct holds each place, and at which byte.
//
// Bits that no statement touches as part of a word are stored one per byte, because that is what processors load and
// store fastest; a byte that is used both ways stays packed; retentive spaces are one packed block in address order.
// In: a program. Out: the members of State with their offsets, and for each place, instance and byte where it is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::emit {

enum class Storage : uint8_t {
  kNone,           // nothing in the program touches it
  kBit,            // State::bit[index]
  kByte,           // State::byte[index]
  kPackedBit,      // bit `bit` of State::byte[index]
  kWord16,         // State::word16[index]
  kWord32,         // State::word32[index]
  kWord64,         // State::word64[index]
  kRetentiveByte,  // State::retentive.bytes[index]
  kRetentiveBit,   // bit `bit` of State::retentive.bytes[index]
  kField,          // a field of an instance
  kLocal           // a parameter of the routine
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
  PlaceStorage whole;    // kByte / kRetentiveByte, or a wider word that contains it; kNone otherwise
  PlaceStorage bits[8];  // kBit; only when whole is kNone
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
  std::vector<uint32_t> retentive_base;         // by SpaceId: first byte in State::retentive.bytes
  uint32_t retentive_bytes = 0;
  uint32_t size = 0;  // sizeof(State) of the release flavour
};

Layout MakeLayout(const ir::Program& program);

/// Bytes and alignment of an instance's struct, and the offset of a field in it.
uint32_t StructBytes(ir::StateKind kind);
uint32_t StructAlignment(ir::StateKind kind);
uint32_t FieldOffset(ir::StateKind kind, uint8_t field);

}  // namespace plcxx::emit
