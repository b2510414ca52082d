#include "transpiler/dialects/hnc/analysis/ranges.h"

#include <algorithm>
#include <utility>

namespace plcxx::hnc {

std::optional<Bounds> Flow::Find(const Cell& cell) const {
  const auto found = facts_.find(cell);
  if (found == facts_.end()) return std::nullopt;
  return found->second.bounds;
}

std::optional<Bounds> Flow::FindTested(const Cell& cell) const {
  const auto found = facts_.find(cell);
  if (found == facts_.end() || found->second.origin != Origin::kTested) return std::nullopt;
  return found->second.bounds;
}

void Flow::Learn(const Cell& cell, const Bounds& bounds, Origin origin) {
  if (facts_.size() >= kMostFacts && !facts_.contains(cell)) facts_.clear();
  facts_.insert_or_assign(cell, Fact{bounds, origin});
}

void Flow::Narrow(const Cell& cell, const Bounds& bounds) {
  const auto found = facts_.find(cell);
  Learn(cell, bounds, found == facts_.end() ? Origin::kTested : found->second.origin);
}

void Flow::Forget(const Cell& cell) {
  std::erase_if(facts_, [&cell](const auto& fact) { return fact.first.Overlaps(cell); });
}

void Flow::Forget(ObjectId object) {
  std::erase_if(facts_, [object](const auto& fact) { return fact.first.object == object; });
}

void Flow::JoinWith(const Flow& other) {
  if (!other.reachable) return;
  if (!reachable) {
    *this = other;
    return;
  }
  for (auto fact = facts_.begin(); fact != facts_.end();) {
    const auto found = other.facts_.find(fact->first);
    if (found == other.facts_.end()) {
      fact = facts_.erase(fact);
      continue;
    }
    fact->second.bounds = Join(fact->second.bounds, found->second.bounds);
    fact->second.origin = std::max(fact->second.origin, found->second.origin);
    ++fact;
  }
  if (!critical) critical = other.critical;
  unassigned.insert(other.unassigned.begin(), other.unassigned.end());
}

}  // namespace plcxx::hnc
