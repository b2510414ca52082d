// A number made of others, one after the other, for tables and for telling apart what was seen: not written down (that
// is fnv1a.h), and not against people who look for collisions.
#pragma once

#include <cstdint>

namespace plcxx::support {

/// Of what came before and one number more.
constexpr uint64_t Mixed(uint64_t hash, uint64_t value) {
  hash = (hash ^ value) * 0x9E3779B97F4A7C15;
  return hash ^ (hash >> 29);
}

}  // namespace plcxx::support
