// The state instances of a program: the structs of runtime_support themselves, with fields that may be forced.
//
// The operations work on whole structs, so a forced field is put back after each of them. All structs lie one behind
// the other, so that a copy is one piece of memory, and a field is a number of bytes at a known place. Not its job:
// what an operation does to an instance (runtime_support), or which statement did it.
#pragma once

#include <cstdint>
#include <cstring>
#include <new>
#include <vector>

#include "plcxx/axis_requests.h"
#include "plcxx/counters.h"
#include "plcxx/decade_counters.h"
#include "plcxx/edges.h"
#include "plcxx/one_shots.h"
#include "plcxx/position_counters.h"
#include "plcxx/texts.h"
#include "plcxx/time_word_timers.h"
#include "plcxx/timers.h"
#include "plcxx/unit_timers.h"
#include "transpiler/ir/program.h"

namespace plcxx::sim {

class Instances {
 public:
  explicit Instances(const ir::Program& program);

  uint32_t size() const { return static_cast<uint32_t>(kinds_.size()); }

  /// The struct itself. Whoever changes it calls Reforce afterwards.
  template <class State>
  State& Get(uint32_t instance) {
    return *std::launder(reinterpret_cast<State*>(BytesAt(at_[instance])));
  }
  /// Puts the forced fields of an instance back.
  void Reforce(uint32_t instance) {
    if (!forced_[instance].empty()) WriteForced(instance);
  }

  /// Fields of one element only; the index is that of ir::Info(kind).fields.
  uint64_t Read(uint32_t instance, uint8_t field) const;
  void Write(uint32_t instance, uint8_t field, uint64_t value);
  void Force(uint32_t instance, uint8_t field, uint64_t value);
  void Release(uint32_t instance, uint8_t field);
  /// Everything 0, except forced fields.
  void Clear();
  /// Appends all fields of all instances, hidden ones included, least significant byte first.
  void AppendTo(std::vector<uint8_t>& bytes) const;
  /// Whether all fields are the same; of one program.
  bool IsAt(const Instances& other) const { return bytes_ == other.bytes_; }
  /// Of all structs; the place of a field counts from here.
  const unsigned char* bytes() const { return bytes_.data(); }
  /// Where a field stands, for FieldAt: the same as long as the program is.
  uint32_t PlaceOf(uint32_t instance, uint8_t field) const;
  /// The field at a place, which has the bytes of T.
  template <class T>
  T FieldAt(uint32_t place) const {
    T value;
    std::memcpy(&value, BytesAt(place), sizeof value);
    return value;
  }
  ir::StateKind KindOf(uint32_t instance) const { return kinds_[instance]; }

 private:
  struct ForcedField {
    uint8_t field;
    uint64_t value;
  };

  unsigned char* BytesAt(uint32_t place) { return bytes_.data() + place; }
  const unsigned char* BytesAt(uint32_t place) const { return bytes_.data() + place; }
  void Set(uint32_t instance, uint8_t field, uint64_t value);
  void WriteForced(uint32_t instance);
  void Zero(uint32_t instance);

  std::vector<ir::StateKind> kinds_;
  std::vector<uint32_t> at_;                      // by instance: its struct, in bytes
  std::vector<unsigned char> bytes_;              // the structs, each at a multiple of eight
  std::vector<std::vector<ForcedField>> forced_;  // by instance
};

}  // namespace plcxx::sim
