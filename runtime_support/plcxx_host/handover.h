// The retentive block on its way from the scan to a thread that writes files.
//
// Three buffers: the writer owns one, the reader another, and the third changes hands in one atomic exchange. Neither
// ever waits, and the reader always gets a whole block, the newest one.
#pragma once

#include <stdint.h>

namespace plcxx::host {

template <uint32_t bytes>
class Handover {
 public:
  /// By the scan: hands the block over where it differs from the last one.
  void Give(const void* block) noexcept {
    if (given_ && __builtin_memcmp(block, last_, bytes) == 0) return;
    given_ = true;
    __builtin_memcpy(last_, block, bytes);
    __builtin_memcpy(buffers_[back()], block, bytes);
    back_ = Swap(static_cast<uint8_t>(back() | kFresh)) & kIndex;
    back_known_ = true;
  }

  /// By the other thread: the newest block, or nullptr when there is none since the last call. Valid until the next.
  const uint8_t* Take() noexcept {
    if ((Middle() & kFresh) == 0) return nullptr;
    front_ = Swap(front()) & kIndex;
    front_known_ = true;
    return buffers_[front()];
  }

 private:
  static constexpr uint8_t kFresh = 4, kIndex = 3;

  // All zero is a valid beginning: the writer owns buffer 1, the reader 2, and 0 is in between.
  uint8_t back() const noexcept { return back_known_ ? back_ : 1; }
  uint8_t front() const noexcept { return front_known_ ? front_ : 2; }
  uint8_t Middle() const noexcept { return __atomic_load_n(&middle_, __ATOMIC_ACQUIRE); }
  uint8_t Swap(uint8_t mine) noexcept { return __atomic_exchange_n(&middle_, mine, __ATOMIC_ACQ_REL); }

  alignas(8) uint8_t buffers_[3][bytes > 0 ? bytes : 1];
  uint8_t last_[bytes > 0 ? bytes : 1];
  uint8_t back_, front_, middle_;
  bool back_known_, front_known_, given_;
};

}  // namespace plcxx::host
