// FNV-1a: a hash of bytes that is the same on every machine and in every version, for what is written down. Not against
// people who look for collisions: sha256.h is.
#pragma once

#include <cstdint>
#include <string_view>

namespace plcxx::support {

/// The hash of the bytes that were added so far.
class Fnv1a32 {
 public:
  constexpr void Add(char byte) { value_ = (value_ ^ static_cast<unsigned char>(byte)) * 16777619U; }
  constexpr uint32_t value() const { return value_; }

 private:
  uint32_t value_ = 2166136261U;
};

constexpr uint32_t HashOf32(std::string_view bytes) {
  Fnv1a32 hash;
  for (const char byte : bytes) hash.Add(byte);
  return hash.value();
}

constexpr uint64_t HashOf64(std::string_view bytes) {
  uint64_t value = 0xCBF29CE484222325;
  for (const char byte : bytes) value = (value ^ static_cast<unsigned char>(byte)) * 0x100000001B3;
  return value;
}

}  // namespace plcxx::support
