#include "transpiler/prove/verify/llvm_ir/flow_graph.h"

#include <llvm/IR/CFG.h>
#include <llvm/IR/Instructions.h>

#include <algorithm>
#include <utility>

namespace plcxx::prove::verify::llvm_ir {
namespace {

constexpr uint32_t kNone = 0xFFFFFFFF;

/// The edges of one level by its nodes' numbers.
struct Edges {
  std::vector<std::vector<uint32_t>> from, to;
  std::vector<bool> ends;  // the node leaves the level, too
};

/// Nearest common dominators (Cooper, Harvey, Kennedy): `order` has every node after one that it is reached from.
std::vector<uint32_t> Dominators(const std::vector<uint32_t>& order, const std::vector<std::vector<uint32_t>>& from) {
  std::vector<uint32_t> rank(from.size(), kNone), dominator(from.size(), kNone);
  for (uint32_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
  dominator[order.front()] = order.front();
  for (size_t i = 1; i < order.size(); ++i) {
    uint32_t found = kNone;
    for (uint32_t node : from[order[i]]) {
      if (rank[node] == kNone || dominator[node] == kNone) continue;
      if (found == kNone) {
        found = node;
        continue;
      }
      while (node != found) {
        uint32_t& later = rank[node] > rank[found] ? node : found;
        later = dominator[later];
      }
    }
    dominator[order[i]] = found;
  }
  return dominator;
}

class LevelBuilder {
 public:
  LevelBuilder(const llvm::Function& function, const llvm::LoopInfo& loops) : function_(function), loops_(loops) {}

  std::unique_ptr<FlowLevel> Build(const llvm::Loop* loop);

 private:
  /// The node of a block in this level: itself, or the outermost loop inside that it belongs to.
  const llvm::BasicBlock* HeadOf(const llvm::BasicBlock* block, const llvm::Loop* level) const;
  std::vector<const llvm::BasicBlock*> Order(const llvm::Loop* level, const llvm::BasicBlock* entry,
                                             bool& cyclic) const;
  std::vector<const llvm::BasicBlock*> Followers(const llvm::BasicBlock* head, const llvm::Loop* level,
                                                 bool& ends) const;

  const llvm::Function& function_;
  const llvm::LoopInfo& loops_;
};

const llvm::BasicBlock* LevelBuilder::HeadOf(const llvm::BasicBlock* block, const llvm::Loop* level) const {
  const llvm::Loop* inner = loops_.getLoopFor(block);
  if (inner == level) return block;
  while (inner->getParentLoop() != level) inner = inner->getParentLoop();
  return inner->getHeader();
}

std::vector<const llvm::BasicBlock*> LevelBuilder::Followers(const llvm::BasicBlock* head, const llvm::Loop* level,
                                                             bool& ends) const {
  std::vector<const llvm::BasicBlock*> followers;
  const auto add = [&](const llvm::BasicBlock* next) {
    if (level != nullptr && (!level->contains(next) || next == level->getHeader())) {
      ends = true;
      return;
    }
    const llvm::BasicBlock* node = HeadOf(next, level);
    if (std::ranges::find(followers, node) == followers.end()) followers.push_back(node);
  };
  const llvm::Loop* inner = loops_.getLoopFor(head);
  if (inner == level) {
    if (llvm::isa<llvm::ReturnInst>(head->getTerminator())) ends = true;
    for (const llvm::BasicBlock* next : llvm::successors(head)) add(next);
    return followers;
  }
  for (const llvm::BasicBlock* block : inner->blocks()) {
    for (const llvm::BasicBlock* next : llvm::successors(block)) {
      if (!inner->contains(next)) add(next);
    }
    if (llvm::isa<llvm::ReturnInst>(block->getTerminator())) ends = true;
  }
  return followers;
}

std::vector<const llvm::BasicBlock*> LevelBuilder::Order(const llvm::Loop* level, const llvm::BasicBlock* entry,
                                                         bool& cyclic) const {
  enum class Mark : uint8_t { kOpen, kDone };
  std::unordered_map<const llvm::BasicBlock*, Mark> marks;
  std::vector<const llvm::BasicBlock*> order;
  struct Frame {
    const llvm::BasicBlock* block;
    std::vector<const llvm::BasicBlock*> followers;
    size_t next = 0;
  };
  std::vector<Frame> frames;
  const auto open = [&](const llvm::BasicBlock* block) {
    marks.emplace(block, Mark::kOpen);
    bool ends = false;
    frames.push_back({block, Followers(block, level, ends)});
  };
  open(entry);
  while (!frames.empty()) {
    Frame& frame = frames.back();
    if (frame.next == frame.followers.size()) {
      marks[frame.block] = Mark::kDone;
      order.push_back(frame.block);
      frames.pop_back();
      continue;
    }
    const llvm::BasicBlock* next = frame.followers[frame.next++];
    const auto mark = marks.find(next);
    if (mark == marks.end()) {
      open(next);
    } else if (mark->second == Mark::kOpen) {
      cyclic = true;
    }
  }
  std::ranges::reverse(order);
  return order;
}

std::unique_ptr<FlowLevel> LevelBuilder::Build(const llvm::Loop* loop) {
  bool cyclic = false;
  const llvm::BasicBlock* entry = loop == nullptr ? &function_.getEntryBlock() : loop->getHeader();
  const std::vector<const llvm::BasicBlock*> order = Order(loop, entry, cyclic);
  if (cyclic) return nullptr;
  auto level = std::make_unique<FlowLevel>();
  level->loop = loop;
  level->nodes.resize(order.size());
  for (uint32_t i = 0; i < order.size(); ++i) {
    FlowNode& node = level->nodes[i];
    node.block = order[i];
    const llvm::Loop* inner = loops_.getLoopFor(order[i]);
    if (inner == loop) {
      level->node_of.emplace(order[i], i);
      continue;
    }
    while (inner->getParentLoop() != loop) inner = inner->getParentLoop();
    node.loop = Build(inner);
    if (node.loop == nullptr) return nullptr;
    for (const llvm::BasicBlock* block : inner->blocks()) level->node_of.emplace(block, i);
  }
  // One more node stands for the end of the level, so that ways that part for good do not look joined.
  const auto count = static_cast<uint32_t>(order.size());
  std::vector<std::vector<uint32_t>> from(count + 1), to(count + 1);
  for (uint32_t i = 0; i < count; ++i) {
    bool ends = false;
    const std::vector<const llvm::BasicBlock*> followers = Followers(order[i], loop, ends);
    for (const llvm::BasicBlock* next : followers) {
      const uint32_t number = level->node_of.at(next);
      from[number].push_back(i);
      to[i].push_back(number);
    }
    if (ends) {
      from[count].push_back(i);
      to[i].push_back(count);
    }
  }
  std::vector<uint32_t> forward, backward;
  for (uint32_t i = 0; i < count; ++i) forward.push_back(i);
  for (uint32_t i = count + 1; i-- > 0;) backward.push_back(i);
  const std::vector<uint32_t> before = Dominators(forward, from);
  const std::vector<uint32_t> behind = Dominators(backward, to);
  for (uint32_t i = 1; i < count; ++i) {
    level->nodes[i].dominator = before[i];
    for (uint32_t at = before[i]; at != kNone && at != count && !level->nodes[i].always;) {
      at = behind[at];
      level->nodes[i].always = at == i;
    }
  }
  return level;
}

}  // namespace

std::unique_ptr<FlowLevel> MakeFlow(const llvm::Function& function, const llvm::LoopInfo& loops) {
  return LevelBuilder(function, loops).Build(nullptr);
}

}  // namespace plcxx::prove::verify::llvm_ir
