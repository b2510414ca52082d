// A function's blocks as nested levels without cycles: the function, and each loop. In a level a loop inside it is one
// node; what goes back to the level's own head, or leaves it, ends the level.
//
// In: a function whose loops are natural. Out: for each level the order of its nodes, and for each node the nearest one
// that every way to it passes. Not its job: conditions.
#pragma once

#include <llvm/Analysis/LoopInfo.h>
#include <llvm/IR/Function.h>

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace plcxx::prove::verify::llvm_ir {

struct FlowLevel;

struct FlowNode {
  const llvm::BasicBlock* block = nullptr;  // of a loop its head
  std::unique_ptr<FlowLevel> loop;          // none: a single block
  uint32_t dominator = 0;                   // the nearest other node on every way here
  bool always = false;                      // whoever passes the dominator comes here, or nowhere in this level
};

struct FlowLevel {
  const llvm::Loop* loop = nullptr;                               // none: the function
  std::vector<FlowNode> nodes;                                    // each after those it is reached from
  std::unordered_map<const llvm::BasicBlock*, uint32_t> node_of;  // blocks of loops inside are their loop's node
};

/// Empty when the function has cycles that are no loops.
std::unique_ptr<FlowLevel> MakeFlow(const llvm::Function& function, const llvm::LoopInfo& loops);

}  // namespace plcxx::prove::verify::llvm_ir
