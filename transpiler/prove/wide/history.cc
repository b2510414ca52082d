#include "transpiler/prove/wide/history.h"

#include <bit>

namespace plcxx::prove::wide {
namespace {

constexpr uint32_t kMostLanesNear = 128;  // in more of them it is no news

}  // namespace

uint32_t CountLanes(const terms::Plane& lanes) {
  uint32_t count = 0;
  for (const uint64_t word : lanes.words) count += static_cast<uint32_t>(std::popcount(word));
  return count;
}

std::vector<uint32_t> WayOf(std::span<const Period> history, uint32_t lane, uint32_t end) {
  std::vector<uint32_t> way(end);
  for (uint32_t i = end; i-- > 0;) {
    way[i] = lane;
    if (const uint32_t copied = history[i].copy_of[lane / 64]; copied != kNoLane) lane = copied;
  }
  return way;
}

std::vector<std::pair<execute::CellId, terms::Plane>> DrawDone(std::span<const execute::CellId> requests,
                                                               terms::Random& random) {
  std::vector<std::pair<execute::CellId, terms::Plane>> done;
  for (const execute::CellId request : requests) {
    terms::Plane where;
    for (uint64_t& word : where.words) word = random.Next() & random.Next();
    done.emplace_back(request, where);
  }
  return done;
}

void AddScore(const terms::Plane& lanes, float weight, Scores& scores) {
  const uint32_t count = CountLanes(lanes);
  if (count == 0 || count > kMostLanesNear) return;
  ForEachLane(lanes, [&](uint32_t lane) { scores[lane] += weight / static_cast<float>(count); });
}

CopyOf DrawCopies(Scores& scores, terms::Random& random) {
  constexpr uint32_t kWords = terms::Plane::kWords, kLanes = terms::Plane::kLanes;
  CopyOf copy_of = NoCopies();
  for (uint32_t word = 0; word < kWords; ++word) {
    if (word == kWords - 1 || random.OneIn(8)) continue;  // these go their own ways
    constexpr int kTries = 100;
    uint32_t best = kNoLane;
    for (int i = 0; i < kTries; ++i) {
      const auto lane = static_cast<uint32_t>((random.Next() >> 20) % kLanes);
      if (scores[lane] > 0 && (best == kNoLane || scores[lane] > scores[best])) best = lane;
    }
    if (best == kNoLane) continue;
    copy_of[word] = best;
    scores[best] /= 4;
  }
  return copy_of;
}

}  // namespace plcxx::prove::wide
