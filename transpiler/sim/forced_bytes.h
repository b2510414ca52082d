// The bytes of one address space, of which any bits may be forced.
//
// A forced bit already holds its value, so a write only has to leave it alone: that is all that forcing costs.
// Not its job: byte order and places (place_access.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace plcxx::sim {

class ForcedBytes {
 public:
  explicit ForcedBytes(uint32_t size) : bytes_(size), forced_(size) {}

  uint32_t size() const { return static_cast<uint32_t>(bytes_.size()); }
  uint8_t operator[](uint32_t offset) const { return bytes_[offset]; }
  const std::vector<uint8_t>& bytes() const { return bytes_; }

  /// The bits of `mask` become those of `value`, except the forced ones.
  void Write(uint32_t offset, uint8_t mask, uint8_t value) {
    const int free = mask & ~forced_[offset];
    bytes_[offset] = static_cast<uint8_t>((bytes_[offset] & ~free) | (value & free));
  }
  /// The bits of `mask` keep the values that they have now.
  void Force(uint32_t offset, uint8_t mask) { forced_[offset] = static_cast<uint8_t>(forced_[offset] | mask); }
  /// The bits keep their values until something writes them.
  void Release(uint32_t offset, uint8_t mask) { forced_[offset] = static_cast<uint8_t>(forced_[offset] & ~mask); }
  void Clear() {
    for (uint32_t i = 0; i < size(); ++i) bytes_[i] = static_cast<uint8_t>(bytes_[i] & forced_[i]);
  }

  /// The first `count` bytes, forces included.
  ForcedBytes First(uint32_t count) const {
    ForcedBytes first(0);
    first.bytes_.assign(bytes_.begin(), bytes_.begin() + count);
    first.forced_.assign(forced_.begin(), forced_.begin() + count);
    return first;
  }
  /// They become those of `first` again.
  void PutBack(const ForcedBytes& first) {
    std::copy(first.bytes_.begin(), first.bytes_.end(), bytes_.begin());
    std::copy(first.forced_.begin(), first.forced_.end(), forced_.begin());
  }
  /// They become 0, and free.
  void Renew(uint32_t count) {
    std::fill_n(bytes_.begin(), count, uint8_t{0});
    std::fill_n(forced_.begin(), count, uint8_t{0});
  }

 private:
  std::vector<uint8_t> bytes_;
  std::vector<uint8_t> forced_;
};

}  // namespace plcxx::sim
