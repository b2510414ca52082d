#include "transpiler/compile/longest_path.h"

#include <algorithm>

namespace plcxx::compile {
namespace {

constexpr uint32_t kNone = 0xFFFFFFFF;

uint64_t Sum(uint64_t a, uint64_t b) { return std::min(a + b, kMostCost); }
uint64_t Product(uint64_t cost, uint64_t times) {
  return times != 0 && cost > kMostCost / times ? kMostCost : cost * times;
}

using Nodes = std::set<uint32_t>;

/// Strongly connected components in topological order, by Tarjan's algorithm without recursion: a generated function
/// may have thousands of blocks in a row.
class Components {
 public:
  Components(const std::vector<PathNode>& nodes, const Nodes& inside, uint32_t cut)
      : nodes_(nodes),
        inside_(inside),
        cut_(cut),
        index_(nodes.size(), kNone),
        low_(nodes.size()),
        on_stack_(nodes.size()) {}

  std::vector<std::vector<uint32_t>> Run(uint32_t entry) {
    Visit(entry);
    std::ranges::reverse(found_);
    return std::move(found_);
  }

 private:
  void Open(uint32_t node) {
    index_[node] = low_[node] = next_++;
    stack_.push_back(node);
    on_stack_[node] = true;
    calls_.push_back({node, 0});
  }

  void Visit(uint32_t entry) {
    Open(entry);
    while (!calls_.empty()) {
      auto& [node, edge] = calls_.back();
      if (edge < nodes_[node].successors.size()) {
        const uint32_t to = nodes_[node].successors[edge++].to;
        if (to == cut_ || !inside_.contains(to)) continue;
        if (index_[to] == kNone) {
          Open(to);
        } else if (on_stack_[to]) {
          low_[node] = std::min(low_[node], index_[to]);
        }
        continue;
      }
      const uint32_t done = node;
      calls_.pop_back();
      if (!calls_.empty()) low_[calls_.back().first] = std::min(low_[calls_.back().first], low_[done]);
      if (low_[done] != index_[done]) continue;
      std::vector<uint32_t> component;
      for (uint32_t top = kNone; top != done;) {
        top = stack_.back();
        stack_.pop_back();
        on_stack_[top] = false;
        component.push_back(top);
      }
      found_.push_back(std::move(component));
    }
  }

  const std::vector<PathNode>& nodes_;
  const Nodes& inside_;
  uint32_t cut_;  // edges to it do not count
  std::vector<uint32_t> index_, low_;
  std::vector<bool> on_stack_;
  std::vector<uint32_t> stack_;
  std::vector<std::pair<uint32_t, size_t>> calls_;
  std::vector<std::vector<uint32_t>> found_;
  uint32_t next_ = 0;
};

class Finder {
 public:
  Finder(const std::vector<PathNode>& nodes, const RoundsOfLoop& rounds, std::map<uint32_t, uint64_t>* shared_rounds)
      : nodes_(nodes), rounds_(rounds), shared_rounds_(shared_rounds) {}

  /// The longest way from `entry` to the end of each node of `inside`; within a loop without going back to `entry`.
  std::vector<std::optional<uint64_t>> Distances(const Nodes& inside, uint32_t entry, PathLoop* around) {
    const bool cut = around != nullptr;
    std::vector<std::optional<uint64_t>> arrival(nodes_.size()), done(nodes_.size());
    arrival[entry] = 0;
    for (const std::vector<uint32_t>& component : Components(nodes_, inside, cut ? entry : kNone).Run(entry)) {
      Settle(component, entry, around, arrival, done);
      for (const uint32_t node : component) {
        if (!done[node]) continue;
        for (const PathEdge& edge : nodes_[node].successors) {
          if ((cut && edge.to == entry) || !inside.contains(edge.to)) continue;
          arrival[edge.to] = std::max(arrival[edge.to].value_or(0), Sum(*done[node], edge.cost));
        }
      }
    }
    return done;
  }

 private:
  void Settle(const std::vector<uint32_t>& component, uint32_t entry, PathLoop* around,
              const std::vector<std::optional<uint64_t>>& arrival, std::vector<std::optional<uint64_t>>& done) {
    const uint32_t first = component.front();
    const auto goes_to = [&](uint32_t from, uint32_t to) {
      return std::ranges::any_of(nodes_[from].successors, [to](const PathEdge& edge) { return edge.to == to; });
    };
    const bool repeats = component.size() > 1 || (goes_to(first, first) && !(around != nullptr && first == entry));
    if (!repeats) {
      done[first] = Sum(arrival[first].value_or(0), nodes_[first].cost);
      return;
    }
    PathLoop loop{.header = kNone, .nodes = Nodes(component.begin(), component.end()), .around = around};
    const Nodes& blocks = loop.nodes;
    uint32_t& header = loop.header;
    uint64_t begin = 0;
    for (const uint32_t node : blocks) {
      if (!arrival[node]) continue;
      if (header == kNone) header = node;
      begin = std::max(begin, *arrival[node]);
    }
    const auto inner = Distances(blocks, header, &loop);
    const Rounds rounds = rounds_(loop);
    if (rounds.same_as_around) around->shared = true;
    uint64_t round = 0;
    for (const uint32_t node : blocks) {
      if (!inner[node]) continue;
      for (const PathEdge& edge : nodes_[node].successors) {
        // With several ways back, a round begins anywhere, and ends wherever one of them does.
        if (edge.to == header || loop.shared) round = std::max(round, Sum(*inner[node], edge.cost));
      }
    }
    if (rounds.budget && shared_rounds_ != nullptr) {
      uint64_t& dearest = (*shared_rounds_)[*rounds.budget];
      dearest = std::max(dearest, round);
    }
    begin = Sum(begin, Product(round, rounds.same_as_around ? 0 : rounds.most.value_or(0)));
    for (const uint32_t node : blocks) {
      if (inner[node]) done[node] = Sum(begin, *inner[node]);
    }
  }

  const std::vector<PathNode>& nodes_;
  const RoundsOfLoop& rounds_;
  std::map<uint32_t, uint64_t>* shared_rounds_;
};

}  // namespace

uint64_t LongestPath(const std::vector<PathNode>& nodes, const RoundsOfLoop& rounds,
                     std::map<uint32_t, uint64_t>* shared_rounds) {
  if (nodes.empty()) return 0;
  Nodes all;
  for (uint32_t i = 0; i < nodes.size(); ++i) all.insert(all.end(), i);
  const auto distances = Finder(nodes, rounds, shared_rounds).Distances(all, 0, nullptr);
  uint64_t longest = 0;
  for (uint32_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].leaves && distances[i]) longest = std::max(longest, *distances[i]);
  }
  return longest;
}

}  // namespace plcxx::compile
