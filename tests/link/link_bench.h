// A machine with a link and both ends of its wire, in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "plcxx/debug_link.h"

namespace plcxx_test {

using Bytes = std::vector<uint8_t>;

inline constexpr uint8_t kIdentity[plcxx::kLinkIdentityBytes] = {'p', 'l', 'c', 'x', 'x', '-', 'i', 'd', 1};

struct ReadOnly : plcxx::LinkSettings {
  static constexpr const uint8_t* kIdentity = plcxx_test::kIdentity;
};
struct Writing : ReadOnly {
  static constexpr bool kCanWrite = true;
  static constexpr uint8_t kForces = 6;
  static constexpr uint32_t kRing = 64;
  static constexpr uint32_t kBytesPerPeriod = 200;
  static constexpr uint32_t kSilentPeriods = 20;
};

struct Machine {
  uint8_t before[16] = {};  // what a link must never touch
  uint8_t bytes[100] = {};
};

struct Wire {
  std::deque<uint8_t> to_machine;
  Bytes from_machine;
  uint32_t moved = 0;  // in this period
  bool is_full = false;

  bool Get(uint8_t& byte) {
    if (to_machine.empty()) return false;
    byte = to_machine.front();
    to_machine.pop_front();
    ++moved;
    return true;
  }
  bool Put(uint8_t byte) {
    if (is_full) return false;
    from_machine.push_back(byte);
    ++moved;
    return true;
  }
};

inline Bytes Frame(uint8_t command, uint32_t offset, const Bytes& payload, uint8_t number = 7) {
  Bytes frame = {plcxx::kLinkStart, static_cast<uint8_t>(payload.size()), command, number};
  for (int i = 0; i < 4; ++i) frame.push_back(static_cast<uint8_t>(offset >> (8 * i)));
  frame.insert(frame.end(), payload.begin(), payload.end());
  const uint16_t crc = plcxx::LinkCrc(frame.data() + 1, static_cast<uint32_t>(frame.size() - 1));
  frame.push_back(static_cast<uint8_t>(crc >> 8));
  frame.push_back(static_cast<uint8_t>(crc));
  return frame;
}
inline Bytes Frame(plcxx::LinkCommand command, uint32_t offset, const Bytes& payload, uint8_t number = 7) {
  return Frame(static_cast<uint8_t>(command), offset, payload, number);
}

template <class Settings>
struct LinkedMachine {
  Machine machine;
  plcxx::DebugLink<Machine, Settings> link;
  Wire wire;

  /// A period whose program does nothing but `program`.
  template <class Program>
  void Period(Program program) {
    wire.moved = 0;
    link.AfterInputs(machine);
    program(machine);
    link.BeforeOutputs(machine, wire);
  }
  void Period() {
    Period([](Machine&) {});
  }

  void Send(const Bytes& bytes) { wire.to_machine.insert(wire.to_machine.end(), bytes.begin(), bytes.end()); }
};

}  // namespace plcxx_test
