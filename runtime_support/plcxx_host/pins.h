// What joins a compiled program to the outside: a table of pins, and their values of one period.
//
// NAME_pins.hpp, which `plcxx emit --host` writes, has the table; each host copies values between it and what it knows:
// HAL pins, coils and registers, an integrator's own card.
// Not its job: when a period runs, and what of the outside is where.
#pragma once

#include <stdint.h>

#include <plcxx_host/events.h>
#include <plcxx_host/handover.h>

namespace plcxx::host {

enum class Type : uint8_t { kBit, kS32, kU32, kFloat };
enum class Direction : uint8_t { kIn, kOut, kBoth };
/// A terminal is exchanged with the machine or its control; a parameter is kept at power-off and never stored by the
/// program: what is written to it counts. The others are to be looked at.
enum class Role : uint8_t { kTerminal, kSignal, kEvent, kParameter };

struct Pin {
  const char* name;  // "pump-on", at most 47 characters with the program's name before it
  Type type;
  Direction direction;
  Role role;
  const char* address;  // as the source writes it
  const char* comment;
};

/// Which member counts, the pin's type says.
union Value {
  double real;
  uint32_t u32;
  int32_t s32;
  bool bit;
};

/// A number for a place of 8 or 16 bits: what it cannot hold becomes the greatest that it can.
constexpr uint8_t Fit8(uint32_t value) noexcept { return static_cast<uint8_t>(value < 0xFFU ? value : 0xFFU); }
constexpr uint16_t Fit16(uint32_t value) noexcept { return static_cast<uint16_t>(value < 0xFFFFU ? value : 0xFFFFU); }

/// A port: eight bits, the least significant first.
constexpr uint8_t ByteOf(const Value* bits) noexcept {
  uint32_t byte = 0;
  for (uint32_t i = 0; i < 8; ++i) byte |= (bits[i].bit ? 1U : 0U) << i;
  return static_cast<uint8_t>(byte);
}
inline void PutBits(uint32_t byte, Value* bits) noexcept {
  for (uint32_t i = 0; i < 8; ++i) bits[i].bit = (byte >> i & 1U) != 0;
}

/// What the functions of the program's Host work on. Of one machine; all zero is its state before power-on.
template <uint32_t pin_count, uint32_t retentive_bytes, uint32_t message_count>
struct Exchange {
  Value pins[pin_count > 0 ? pin_count : 1];
  Value shown[pin_count > 0 ? pin_count : 1];  // of parameters: as they were given
  uint64_t time_ms;                            // since power-on, of the period that runs
  uint64_t skipped_ms;                         // that passed without periods: overruns
  bool started;
  bool stored_is_there;  // `stored` was loaded
  alignas(8) uint8_t stored[retentive_bytes > 0 ? retentive_bytes : 1];
  Handover<retentive_bytes> retentive;  // to the thread that writes files
  EventQueue events;                    // to the thread that prints
  bool active[message_count > 0 ? message_count : 1];
};

}  // namespace plcxx::host
