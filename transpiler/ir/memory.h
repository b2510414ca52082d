// The memory map of a program: address spaces as byte arrays, and places in them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/ir/op.h"
#include "transpiler/ir/types.h"
#include "transpiler/source/source.h"
#include "transpiler/support/ids.h"

namespace plcxx::ir {

using SpaceId = support::Id<struct SpaceTag>;
using PlaceId = support::Id<struct PlaceTag>;
using StateId = support::Id<struct StateTag>;

/// How long bytes live: one execution of a partition, until power-off, or beyond it. Bytes of kRoutine are parameters
/// and named locals: 0 when a partition begins; a subroutine that touches one shares it with its caller.
enum class Lifetime : uint8_t { kRoutine, kVolatile, kRetentive };
enum class ByteOrder : uint8_t { kLittle, kBig };
/// Who writes a range of a space, as the control's documentation draws it.
enum class Direction : uint8_t { kInput, kOutput, kInternal };

struct Zone {
  uint32_t begin = 0;  // bits, half open (zones.h)
  uint32_t end = 0;
  Direction direction = Direction::kInternal;
};

struct ByteRange {
  uint32_t begin = 0, end = 0;  // half open
};

struct InitialByte {
  uint32_t offset = 0;
  uint8_t value = 0;
};

struct Space {
  std::string name;   // "A", "K", "system"
  std::string title;  // "package A: inputs and outputs of the machine"
  uint32_t bytes = 0;
  Lifetime lifetime = Lifetime::kVolatile;
  ByteOrder order = ByteOrder::kLittle;
  /// The host reads and writes any byte between two executions: no store may be dropped, no load may be folded.
  bool host_visible = false;
  /// Of kRoutine: each of its places is used by one routine only, which stores it before it reads it.
  bool own = false;
  /// Of a memory of the control that options cut into parts: its name, and the byte of it with which this part begins.
  /// Empty: it is all of the memory that has its name.
  std::string part_of;
  uint32_t part_begin = 0;
  /// Each zone is an array whose elements are known by their number in it: a program with other sizes has the same
  /// element elsewhere. Else the control knows a byte by its offset.
  bool zones_are_arrays = false;
  std::vector<Zone> zones;
  std::vector<InitialByte> initial;  // ascending; the rest is 0
  /// Tables that the sources declare constant, ascending: the host may look at them, and writes none.
  std::vector<ByteRange> constants;
};

constexpr uint8_t kNoBit = 0xFF;

/// What load and store name: a bit, byte, word or double word of a space, or a field of a state instance.
/// Two places may overlap, and two may be the same with different names: the address decides, never the name.
struct Place {
  std::string name;     // as generated code spells it before it is made safe for C++: "U4A8", "COOLANT", "T5U"
  std::string address;  // as the source writes the address: "U4A8"; empty when it is the name
  Type type = Type::kBit;
  SpaceId space;         // of a memory place
  uint32_t offset = 0;   // its first byte
  uint8_t bit = kNoBit;  // 0..7 of that byte, when type is kBit
  /// Indexed: the access is at offset + index * stride; an access that is not wholly inside [low, high) reads 0 and
  /// writes nothing. The index is an i32 operand of the load or store, read as signed.
  bool indexed = false;
  uint32_t stride = 1, low = 0, high = 0;
  StateId state;      // of a field place
  uint8_t field = 0;  // index into Info(kind).fields

  bool is_field() const { return state.valid(); }
};

/// A timer, counter, one-shot ... that the program uses.
struct StateInstance {
  StateKind kind{};
  std::string name;  // "T5"
};

}  // namespace plcxx::ir
