// The link to plcxx live --link: EXAMPLE_LINK 0 (or nothing) leaves it out, 1 shows the machine, 2 lets write and
// force.
//
// The scan never waits for the wire: between both are two queues, and what empties and fills them is the background.
// Your machine: the interrupts of the serial port, or sockets in a thread of lower priority.
#pragma once

#include <stdint.h>

#include "lathe.hpp"

#ifndef EXAMPLE_LINK
#define EXAMPLE_LINK 0
#endif

#if EXAMPLE_LINK == 0

namespace machine_link {
inline void AfterInputs(lathe::State&) {}
inline void BeforeOutputs(lathe::State&) {}
}  // namespace machine_link

#else

#include <plcxx/debug_link.h>

#include "board.h"
#include "lathe_link.hpp"

namespace machine_link {

/// One writes, the other reads, neither waits.
class Queue {
 public:
  bool Put(uint8_t byte) {
    const uint32_t next = (end_ + 1) % kBytes;
    if (next == begin_) return false;
    bytes_[end_] = byte;
    end_ = next;
    return true;
  }
  bool Get(uint8_t& byte) {
    if (begin_ == end_) return false;
    byte = bytes_[begin_];
    begin_ = (begin_ + 1) % kBytes;
    return true;
  }
  bool HasRoom() const { return (end_ + 1) % kBytes != begin_; }

 private:
  static constexpr uint32_t kBytes = 256;
  volatile uint8_t bytes_[kBytes] = {};
  volatile uint32_t begin_ = 0, end_ = 0;
};
inline Queue from_host, to_host;

struct Port {
  bool Get(uint8_t& byte) { return from_host.Get(byte); }
  bool Put(uint8_t byte) { return to_host.Put(byte); }
};

struct Settings : plcxx::LinkSettings {
  static constexpr bool kCanWrite = EXAMPLE_LINK == 2;
  static constexpr const uint8_t* kIdentity = lathe_link::kIdentity;
};
inline plcxx::DebugLink<lathe::State, Settings> link;

// Your machine: Permit what a key switch says.
inline void AfterInputs(lathe::State& m) {
  link.Permit(EXAMPLE_LINK == 2);
  link.AfterInputs(m);
}

inline void BeforeOutputs(lathe::State& m) {
  Port port;
  link.BeforeOutputs(m, port);
}

/// Of the background: as many bytes as are there, both ways.
inline void MoveBytes() {
  uint8_t byte = 0;
  while (from_host.HasRoom() && board::LinkReceive(byte)) from_host.Put(byte);
  while (board::LinkCanSend() && to_host.Get(byte)) board::LinkSend(byte);
}

}  // namespace machine_link

#endif
