#include "transpiler/compile/measurement.h"

#include <algorithm>

#include "transpiler/compile/longest_path.h"
#include "transpiler/compile/loop_rounds.h"

namespace plcxx::compile {
namespace {

constexpr uint64_t kThousandths = 1000;

}  // namespace

Measurement::Measurement(const ProgramCode& code, const std::vector<KnownLoop>& loops)
    : code_(code), loops_(loops), own_(code.function_count()) {}

const Measurement::Own& Measurement::Measure(uint32_t id) {
  Own& own = own_[id];
  if (own.done || own.open) return own;
  own.open = true;
  const CodeFunction& function = code_.Function(id);
  std::vector<PathNode> cycles, instructions;
  for (const CodeBlock& block : function.blocks) {
    PathNode node{.cost = block.cycles_k, .successors = {}, .leaves = block.leaves};
    for (const CodeEdge& edge : block.successors) node.successors.push_back({edge.block, edge.cycles_k});
    PathNode counted{.cost = block.instructions, .successors = node.successors, .leaves = block.leaves};
    for (PathEdge& edge : counted.successors) edge.cost = 0;
    for (const CodeCall& call : block.calls) {
      const uint32_t callee = code_.Callee(id, call);
      if (callee == kNoFunction) continue;
      const Path path = Measure(callee).longest;
      node.cost = std::min(node.cost + path.cycles, kMostCost);
      counted.cost = std::min(counted.cost + path.instructions, kMostCost);
    }
    cycles.push_back(std::move(node));
    instructions.push_back(std::move(counted));
  }
  const RoundsOfLoop rounds = [&](const PathLoop& loop) {
    const Rounds known = RoundsOf(code_.Object(id), function, loop, loops_);
    if (!known.most)
      own.not_whole.insert("loop without known bound in " + code_.Name(id) + ": its repetitions are not in");
    return known;
  };
  // Thousandths of cycles until the partition is summed up: `cycles` of a function's own path are thousandths.
  own.longest = {LongestPath(instructions, rounds), LongestPath(cycles, rounds)};
  own.open = false;
  own.done = true;
  return own;
}

uint64_t Measurement::StackOf(uint32_t id) {
  Own& own = own_[id];
  if (own.open) return 0;
  if (own.stack_bytes) return *own.stack_bytes;
  own.open = true;
  const CodeFunction& function = code_.Function(id);
  uint64_t deepest = function.frame_bytes;
  for (const CodeBlock& block : function.blocks) {
    for (const CodeCall& call : block.calls) {
      const uint32_t callee = code_.Callee(id, call);
      if (callee == kNoFunction) continue;
      // What is jumped to as the last thing finds the stack as this function did.
      deepest = std::max(deepest, StackOf(callee) + (call.tail ? 0 : function.frame_bytes));
    }
  }
  own.open = false;
  own.stack_bytes = deepest;
  return deepest;
}

Figures Measurement::From(uint32_t entry) {
  Figures figures;
  figures.longest = Measure(entry).longest;
  figures.longest.cycles = (figures.longest.cycles + kThousandths - 1) / kThousandths;
  figures.stack_bytes = StackOf(entry);
  std::vector<uint32_t> reached = {entry};
  std::vector<bool> seen(code_.function_count());
  seen[entry] = true;
  for (size_t i = 0; i < reached.size(); ++i) {
    const uint32_t id = reached[i];
    const CodeFunction& function = code_.Function(id);
    figures.code_bytes += function.bytes;
    figures.not_whole.insert(own_[id].not_whole.begin(), own_[id].not_whole.end());
    if (!function.frame_known) figures.not_whole.insert("the stack of " + code_.Name(id) + " is not known");
    for (const CodeBlock& block : function.blocks) {
      for (const CodeCall& call : block.calls) {
        const uint32_t callee = code_.Callee(id, call);
        if (callee == kNoFunction) {
          figures.host.insert(NameOf(code_.Symbol(id, call).text));
        } else if (!seen[callee]) {
          seen[callee] = true;
          reached.push_back(callee);
        }
      }
    }
  }
  return figures;
}

}  // namespace plcxx::compile
