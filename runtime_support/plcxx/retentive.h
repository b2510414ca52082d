// Which stored retentive memory a program accepts: the one whose layout has the same hash.
//
// Implements the last paragraph but one of NC110 4.5: the block is carried with a hash of its layout, so that a stale
// copy is refused and a copy made by another program with the same layout is accepted.
// Not its job: to store the block (the host's), or to describe the layout (the emitter's).
#pragma once

#include <stdint.h>

namespace plcxx {

/// FNV-1a of a layout's description, a string of C; the same on every compiler and processor.
constexpr uint32_t LayoutHash(const char* layout) noexcept {
  uint32_t hash = 2166136261U;
  if (layout == nullptr) return hash;
  for (; *layout != '\0'; ++layout) {
    hash ^= static_cast<uint8_t>(*layout);  // char is signed on some processors only
    hash *= 16777619U;
  }
  return hash;
}

constexpr bool AcceptRetentive(uint32_t stored_hash, uint32_t expected_hash) noexcept {
  return stored_hash == expected_hash;
}

}  // namespace plcxx
