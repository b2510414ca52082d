// The bytes of one address space, of which any bits may be forced.
//
// A forced bit already holds its value, so a write only has to leave it alone: that is all that forcing costs.
// Not its job: byte order and places (place_access.h).
#pragma once

#include <algorithm>
#include <cstddef>
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

  static constexpr uint32_t kKeptForEach = 2;  // bytes that Keep writes for each byte: its value, what is forced of it

  /// Writes `count` bytes from `begin` on to `kept`, forces included. Says how many it wrote.
  size_t Keep(uint32_t begin, uint32_t count, uint8_t* kept) const {
    std::copy_n(bytes_.begin() + begin, count, kept);
    std::copy_n(forced_.begin() + begin, count, kept + count);
    return size_t{kKeptForEach} * count;
  }
  /// They become what Keep wrote again. Says how many it read.
  size_t PutBack(uint32_t begin, uint32_t count, const uint8_t* kept) {
    std::copy_n(kept, count, bytes_.begin() + begin);
    std::copy_n(kept + count, count, forced_.begin() + begin);
    return size_t{kKeptForEach} * count;
  }
  /// They become 0, and free.
  void Renew(uint32_t begin, uint32_t count) {
    std::fill_n(bytes_.begin() + begin, count, uint8_t{0});
    std::fill_n(forced_.begin() + begin, count, uint8_t{0});
  }

 private:
  std::vector<uint8_t> bytes_;
  std::vector<uint8_t> forced_;
};

}  // namespace plcxx::sim
