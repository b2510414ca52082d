// Events on their way from the scan to a thread that has time to print them.
//
// A ring of fixed size for one writer, the scan, and one reader. Push takes the same short time whether somebody reads
// or not; what finds no room is counted.
#pragma once

#include <stdint.h>

namespace plcxx::host {

struct Event {
  static constexpr uint32_t kMaxArguments = 8;
  uint32_t what;  // index into the program's table of events; kMessage: an operator message
  uint32_t arguments[kMaxArguments];
  static constexpr uint32_t kMessage = 0xFFFFFFFFU;
};

class EventQueue {
 public:
  void Push(const Event& event) noexcept {
    const uint32_t written = __atomic_load_n(&written_, __ATOMIC_RELAXED);
    if (written - __atomic_load_n(&read_, __ATOMIC_ACQUIRE) == kRoom) {
      __atomic_store_n(&lost_, __atomic_load_n(&lost_, __ATOMIC_RELAXED) + 1, __ATOMIC_RELAXED);
      return;
    }
    events_[written % kRoom] = event;
    __atomic_store_n(&written_, written + 1, __ATOMIC_RELEASE);
  }

  bool Pop(Event& event) noexcept {
    const uint32_t read = __atomic_load_n(&read_, __ATOMIC_RELAXED);
    if (read == __atomic_load_n(&written_, __ATOMIC_ACQUIRE)) return false;
    event = events_[read % kRoom];
    __atomic_store_n(&read_, read + 1, __ATOMIC_RELEASE);
    return true;
  }

  uint32_t lost() const noexcept { return __atomic_load_n(&lost_, __ATOMIC_RELAXED); }

 private:
  static constexpr uint32_t kRoom = 64;
  Event events_[kRoom];
  uint32_t written_, read_, lost_;
};

/// What the arguments of an event mean, for printing.
struct EventArgument {
  const char* name;
  const char* const* words;  // of an enumeration, by its value; else nullptr
  uint32_t word_count;
};
enum class Severity : uint8_t { kFault, kNotice };
struct EventKind {
  const char* name;
  Severity severity;
  const EventArgument* arguments;
  uint32_t argument_count;
};
struct MessageText {
  uint32_t number;
  const char* text;
};

}  // namespace plcxx::host
