#include "transpiler/compile/measurement.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "transpiler/compile/longest_path.h"
#include "transpiler/compile/runtime_files.h"

namespace plcxx::compile {
namespace {

constexpr uint64_t kThousandths = 1000;

/// N of "at most N rounds" in a line.
std::optional<uint64_t> RoundsInComment(std::string_view line) {
  constexpr std::string_view kWords = "// at most ";
  const size_t at = line.find(kWords);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view number = line.substr(at + kWords.size());
  uint64_t rounds = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), rounds);
  const std::string_view rest = number.substr(static_cast<size_t>(end - number.data()));
  if (error != std::errc() || !rest.starts_with(" rounds")) return std::nullopt;
  return rounds;
}

}  // namespace

void AddRuntimeLoops(LoopRounds& loops) {
  for (const RuntimeFile& header : RuntimeFiles()) {
    uint32_t line = 1;
    for (size_t at = 0; at < header.text.size(); ++line) {
      const size_t end = std::min(header.text.find('\n', at), header.text.size());
      if (const auto rounds = RoundsInComment(header.text.substr(at, end - at))) loops[{header.name, line}] = rounds;
      at = end + 1;
    }
  }
}

Measurement::Measurement(const ProgramCode& code, const LoopRounds& loops)
    : code_(code), loops_(loops), own_(code.function_count()) {}

std::optional<std::optional<uint64_t>> Measurement::Known(uint32_t function, const CodeLine& line) const {
  const std::vector<std::string>& files = code_.Object(function).files;
  if (line.line == 0 || line.file >= files.size()) return std::nullopt;
  const auto known = loops_.find({files[line.file], line.line});
  if (known == loops_.end()) return std::nullopt;
  return known->second;
}

/// By the lines of its instructions: what jumps back to the header has the line of the loop's head with every compiler
/// that was looked at; failing that, the most of all heads whose lines are in the loop.
std::optional<uint64_t> Measurement::RoundsOf(uint32_t function, uint32_t header,
                                              const std::set<uint32_t>& blocks) const {
  const std::vector<CodeBlock>& all = code_.Function(function).blocks;
  std::optional<uint64_t> most;
  bool unknown = false;
  const auto take = [&](const CodeLine& line) {
    const auto known = Known(function, line);
    if (!known) return;
    unknown = unknown || !*known;
    if (*known) most = std::max(most.value_or(0), **known);
  };
  for (const uint32_t block : blocks) {
    const bool latch =
        std::ranges::any_of(all[block].successors, [header](const CodeEdge& edge) { return edge.block == header; });
    if (latch) take(all[block].last);
  }
  if (!most && !unknown) {
    for (const uint32_t block : blocks) std::ranges::for_each(all[block].lines, take);
  }
  return unknown ? std::nullopt : most;
}

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
  const RoundsOfLoop rounds = [&](uint32_t header, const std::set<uint32_t>& blocks) {
    const std::optional<uint64_t> known = RoundsOf(id, header, blocks);
    if (!known) own.not_whole.insert("loop without known bound in " + code_.Name(id) + ": its repetitions are not in");
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
