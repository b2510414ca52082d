#include "transpiler/compile/measurement.h"

#include <algorithm>

#include "transpiler/compile/longest_path.h"
#include "transpiler/compile/loop_rounds.h"

namespace plcxx::compile {
namespace {

constexpr uint64_t kThousandths = 1000;

/// Of an endless sum: saturates.
uint64_t Repeated(uint64_t cost, uint64_t times) {
  return times != 0 && cost > kMostCost / times ? kMostCost : cost * times;
}

std::string Unbounded(const std::string& function, const std::string& where) {
  return "loop without known bound in " + function + (where.empty() ? "" : " (" + where + ")") +
         ": its repetitions are not in";
}

}  // namespace

Measurement::Measurement(const ProgramCode& code, const LoopBounds& bounds, std::vector<bool> impossible)
    : code_(code), bounds_(bounds), impossible_(std::move(impossible)), own_(code.function_count()) {
  impossible_.resize(code.function_count());
}

bool Measurement::IsPossible(uint32_t caller, const CodeBlock& block) const {
  return std::ranges::none_of(block.calls, [&](const CodeCall& call) {
    const uint32_t callee = code_.Callee(caller, call);
    return callee != kNoFunction && impossible_[callee];
  });
}

const Measurement::Own& Measurement::Measure(uint32_t id) {
  Own& own = own_[id];
  if (own.done || own.open) return own;
  own.open = true;
  const CodeFunction& function = code_.Function(id);
  std::vector<PathNode> cycles, instructions;
  for (const CodeBlock& block : function.blocks) {
    if (!IsPossible(id, block)) {  // no path leads through it: nothing is behind it, and it does not leave
      cycles.emplace_back();
      instructions.emplace_back();
      continue;
    }
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
    Rounds known = RoundsOf(code_.Object(id), function, loop, bounds_);
    if (!known.most && !known.budget) own.not_whole.insert(Unbounded(code_.Name(id), known.where));
    if (known.budget) own.budget_loops.emplace(*known.budget, Unbounded(code_.Name(id), known.where));
    return known;
  };
  // Thousandths of cycles until the partition is summed up: `cycles` of a function's own path are thousandths.
  own.longest = {LongestPath(instructions, rounds, &own.round_instructions),
                 LongestPath(cycles, rounds, &own.round_cycles)};
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
    if (!IsPossible(id, block)) continue;
    for (const CodeCall& call : block.calls) {
      const uint32_t callee = code_.Callee(id, call);
      if (callee == kNoFunction) continue;
      // What is jumped to as the last thing finds the stack as this function did.
      const uint64_t bytes = StackOf(callee) + (call.tail ? 0 : function.frame_bytes);
      if (bytes > deepest) own.deepest_callee = callee;
      deepest = std::max(deepest, bytes);
    }
  }
  own.open = false;
  own.stack_bytes = deepest;
  return deepest;
}

Figures Measurement::From(uint32_t entry, const std::map<uint32_t, uint64_t>& budgets) {
  Figures figures;
  figures.longest = Measure(entry).longest;
  figures.stack_bytes = StackOf(entry);
  for (uint32_t id = entry; id != kNoFunction && figures.deepest.size() < code_.function_count();
       id = own_[id].deepest_callee) {
    figures.deepest.push_back({code_.Name(id), code_.Function(id).frame_bytes});
  }
  std::map<uint32_t, Path> dearest;  // round, by budget
  std::set<std::pair<const ObjectFacts*, uint32_t>> constants;
  std::vector<uint32_t> reached = {entry};
  std::vector<bool> seen(code_.function_count());
  seen[entry] = true;
  for (size_t i = 0; i < reached.size(); ++i) {
    const uint32_t id = reached[i];
    const CodeFunction& function = code_.Function(id);
    figures.code_bytes += function.bytes;
    for (const uint32_t section : function.constants) {
      const ObjectFacts& object = code_.Object(id);
      if (constants.emplace(&object, section).second) figures.constant_bytes += object.sections[section].bytes;
    }
    figures.not_whole.insert(own_[id].not_whole.begin(), own_[id].not_whole.end());
    for (const auto& [budget, cost] : own_[id].round_instructions)
      dearest[budget].instructions = std::max(dearest[budget].instructions, cost);
    for (const auto& [budget, cost] : own_[id].round_cycles)
      dearest[budget].cycles = std::max(dearest[budget].cycles, cost);
    for (const auto& [budget, words] : own_[id].budget_loops)
      if (!budgets.contains(budget)) figures.not_whole.insert(words);
    if (!function.frame_known) figures.not_whole.insert("the stack of " + code_.Name(id) + " is not known");
    for (const CodeBlock& block : function.blocks) {
      if (!IsPossible(id, block)) continue;
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
  for (const auto& [budget, round] : dearest) {
    const auto most = budgets.find(budget);
    if (most == budgets.end()) continue;
    Path& longest = figures.longest;
    figures.shared_rounds += most->second;
    longest.instructions = std::min(longest.instructions + Repeated(round.instructions, most->second), kMostCost);
    longest.cycles = std::min(longest.cycles + Repeated(round.cycles, most->second), kMostCost);
  }
  figures.longest.cycles = (figures.longest.cycles + kThousandths - 1) / kThousandths;
  return figures;
}

}  // namespace plcxx::compile
