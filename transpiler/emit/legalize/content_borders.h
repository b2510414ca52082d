// Where to cut a list so that an edit of it moves few cuts: the borders depend on the contents near them only.
//
//   weights 1 1 1 ..., hashes of the contents   ->   after which entries to cut
//
// A border lies after an entry whose hash is the least of all within `least` on both sides, so that the entries
// farther away have no say in it; a stretch that is longer than `most` is cut again after the least hash in it. Rules
// that count from the last border, "the next one after at least 25", would let an edit move all borders after it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace plcxx::emit::legalize {

struct BorderCandidate {
  uint32_t weight = 1;
  uint32_t hash = 0;   // of its content; spread over all 32 bits
  bool border = true;  // whether a border may lie after it
};

struct BorderLimits {
  uint32_t least = 1;  // weight between two borders, and between a border and an end; not 0
  uint32_t most = 1;   // more only where entries are heavier or no border is allowed
};

/// Indices of the entries after which a border lies, ascending; never the last one's.
std::vector<size_t> ContentBorders(const std::vector<BorderCandidate>& candidates, BorderLimits limits);

/// Spreads what is a hash in some of its bits only, and makes orders by `seed` that have nothing to do with each other.
constexpr uint32_t SpreadHash(uint32_t hash, uint32_t seed) {
  hash ^= seed;
  hash = (hash ^ hash >> 16) * 0x7FEB352Du;
  hash = (hash ^ hash >> 15) * 0x846CA68Bu;
  return hash ^ hash >> 16;
}

}  // namespace plcxx::emit::legalize
