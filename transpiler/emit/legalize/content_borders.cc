#include "transpiler/emit/legalize/content_borders.h"

#include <algorithm>

#include "transpiler/support/check.h"

namespace plcxx::emit::legalize {
namespace {

struct Finder {
  const std::vector<BorderCandidate>& candidates;
  BorderLimits limits;
  std::vector<uint32_t> ends;  // the weight up to and with each entry
  std::vector<bool> chosen;

  bool Allowed(size_t i) const {
    return candidates[i].border && ends[i] >= limits.least && ends.back() - ends[i] >= limits.least;
  }
  bool IsLeastAround(size_t i) const;
  void CutLongStretches();
};

/// Of equal hashes the first one counts.
bool Finder::IsLeastAround(size_t i) const {
  for (size_t j = i; j > 0 && ends[i] - ends[j - 1] < limits.least; --j)
    if (Allowed(j - 1) && candidates[j - 1].hash <= candidates[i].hash) return false;
  for (size_t j = i + 1; j < ends.size() && ends[j] - ends[i] < limits.least; ++j)
    if (Allowed(j) && candidates[j].hash < candidates[i].hash) return false;
  return true;
}

void Finder::CutLongStretches() {
  size_t first = 0;  // of the stretch
  for (size_t last = 0; last < ends.size();) {
    if (!chosen[last] && last + 1 < ends.size()) {
      ++last;
      continue;
    }
    const uint32_t begin = first == 0 ? 0 : ends[first - 1];
    size_t least = ends.size();
    if (ends[last] - begin > limits.most) {
      for (size_t i = first; i < last; ++i) {
        if (!candidates[i].border || ends[i] - begin < limits.least || ends[last] - ends[i] < limits.least) continue;
        if (least == ends.size() || candidates[i].hash < candidates[least].hash) least = i;
      }
    }
    if (least == ends.size()) {
      first = ++last;
    } else {
      chosen[least] = true;  // and both halves are looked at again
      last = first;
    }
  }
}

}  // namespace

std::vector<size_t> ContentBorders(const std::vector<BorderCandidate>& candidates, BorderLimits limits) {
  PLCXX_CHECK(limits.least > 0);
  if (candidates.empty()) return {};
  Finder finder{.candidates = candidates, .limits = limits, .ends = {}, .chosen = {}};
  uint32_t weight = 0;
  for (const BorderCandidate& candidate : candidates) finder.ends.push_back(weight += candidate.weight);
  finder.chosen.resize(candidates.size());
  for (size_t i = 0; i < candidates.size(); ++i) finder.chosen[i] = finder.Allowed(i) && finder.IsLeastAround(i);
  finder.CutLongStretches();
  std::vector<size_t> borders;
  for (size_t i = 0; i + 1 < candidates.size(); ++i)
    if (finder.chosen[i]) borders.push_back(i);
  return borders;
}

}  // namespace plcxx::emit::legalize
