#include "transpiler/dialects/technol/analysis/subprogram_groups.h"

#include <algorithm>
#include <utility>

namespace plcxx::technol {
namespace {

class Grouping {
 public:
  explicit Grouping(const Flow& flow)
      : flow_(flow),
        group_of_(flow.subprograms().size()),
        joined_with_(flow.program().instructions.size()),
        seen_(flow.program().instructions.size()) {}

  std::vector<SubprogramGroup> Run();

 private:
  /// Appends the groups of subprograms that share instructions among `subprograms` alone.
  void Join(std::vector<uint32_t> subprograms);
  uint32_t RepresentativeOf(uint32_t instruction);
  /// visit(called subprogram).
  template <class Visit>
  void ForEachCall(const SubprogramGroup& group, Visit&& visit) const;
  /// The groups that call themselves, by way of others, too.
  std::vector<bool> InCircles() const;
  void FindLevels();

  const Flow& flow_;
  std::vector<SubprogramGroup> groups_;
  std::vector<uint32_t> group_of_;     // by subprogram
  std::vector<uint32_t> joined_with_;  // by instruction: another one of its group, itself at last
  std::vector<bool> seen_;
};

uint32_t Grouping::RepresentativeOf(uint32_t instruction) {
  while (joined_with_[instruction] != instruction) {
    joined_with_[instruction] = joined_with_[joined_with_[instruction]];
    instruction = joined_with_[instruction];
  }
  return instruction;
}

void Grouping::Join(std::vector<uint32_t> subprograms) {
  std::ranges::sort(subprograms, {}, [&](uint32_t k) { return flow_.EntryOf(k); });
  std::vector<InstructionId> instructions;
  for (const uint32_t k : subprograms) {
    if (!seen_[flow_.EntryOf(k).index]) flow_.CollectFrom(flow_.EntryOf(k), seen_, instructions);
  }
  for (const InstructionId id : instructions) joined_with_[id.index] = id.index;
  for (const InstructionId id : instructions) {
    flow_.ForEachSuccessor(
        id, [&](InstructionId to, Edge) { joined_with_[RepresentativeOf(to.index)] = RepresentativeOf(id.index); });
  }
  constexpr uint32_t kNoGroup = ~0U;
  std::vector<std::pair<uint32_t, uint32_t>> group_of_representative;
  for (const uint32_t k : subprograms) {
    group_of_representative.emplace_back(RepresentativeOf(flow_.EntryOf(k).index), kNoGroup);
  }
  std::ranges::sort(group_of_representative);
  const auto group_of = [&](uint32_t instruction) -> uint32_t& {
    return std::ranges::lower_bound(group_of_representative, std::pair(RepresentativeOf(instruction), 0U))->second;
  };
  for (const uint32_t k : subprograms) {
    uint32_t& group = group_of(flow_.EntryOf(k).index);
    if (group == kNoGroup) {
      group = static_cast<uint32_t>(groups_.size());
      groups_.emplace_back();
    }
    groups_[group].subprograms.push_back(k);
    group_of_[k] = group;
  }
  std::ranges::sort(instructions);
  for (const InstructionId id : instructions) {
    groups_[group_of(id.index)].instructions.push_back(id);
    seen_[id.index] = false;
  }
}

template <class Visit>
void Grouping::ForEachCall(const SubprogramGroup& group, Visit&& visit) const {
  for (const InstructionId id : group.instructions) {
    const Instruction& call = flow_.program().instructions[id];
    if (call.op != Op::kCall) continue;
    if (const auto callee = flow_.CalleeOf(call)) visit(*callee);
  }
}

/// Takes away what no group left calls, then what calls no group left: circles remain, and what is between circles,
/// which may be split as well.
std::vector<bool> Grouping::InCircles() const {
  std::vector<std::vector<uint32_t>> calls(groups_.size()), callers(groups_.size());
  for (uint32_t g = 0; g < groups_.size(); ++g) {
    ForEachCall(groups_[g], [&](uint32_t callee) {
      calls[g].push_back(group_of_[callee]);
      callers[group_of_[callee]].push_back(g);
    });
  }
  std::vector<bool> left(groups_.size(), true);
  const auto take_away = [&](const auto& incoming, const auto& outgoing) {
    std::vector<size_t> count(groups_.size());
    std::vector<uint32_t> free;
    for (uint32_t g = 0; g < groups_.size(); ++g) {
      count[g] = static_cast<size_t>(std::ranges::count_if(incoming[g], [&](uint32_t other) { return left[other]; }));
      if (left[g] && count[g] == 0) free.push_back(g);
    }
    while (!free.empty()) {
      const uint32_t g = free.back();
      free.pop_back();
      left[g] = false;
      for (const uint32_t other : outgoing[g]) {
        if (--count[other] == 0 && left[other]) free.push_back(other);
      }
    }
  };
  take_away(callers, calls);
  take_away(calls, callers);
  return left;
}

/// Over groups, not over subprograms: one of several entries may be called from deeper than the others.
void Grouping::FindLevels() {
  std::vector<uint32_t> waiting(groups_.size(), 0);
  for (const SubprogramGroup& group : groups_) {
    ForEachCall(group, [&](uint32_t callee) { ++waiting[group_of_[callee]]; });
  }
  std::vector<uint32_t> ready;
  for (uint32_t g = 0; g < groups_.size(); ++g) {
    if (waiting[g] == 0) ready.push_back(g);
  }
  while (!ready.empty()) {
    SubprogramGroup& group = groups_[ready.back()];
    ready.pop_back();
    group.level = std::max(group.level, 1U);
    ForEachCall(group, [&](uint32_t callee) {
      SubprogramGroup& called = groups_[group_of_[callee]];
      called.level = std::max(called.level, group.level + 1);
      if (--waiting[group_of_[callee]] == 0) ready.push_back(group_of_[callee]);
    });
  }
}

std::vector<SubprogramGroup> Grouping::Run() {
  std::vector<uint32_t> all;
  for (uint32_t k = 0; k < flow_.subprograms().size(); ++k) {
    if (flow_.IsReached(flow_.EntryOf(k))) all.push_back(k);
  }
  Join(std::move(all));
  const std::vector<bool> split = InCircles();
  std::vector<SubprogramGroup> whole = std::exchange(groups_, {});
  std::vector<std::vector<uint32_t>> by_level;
  for (uint32_t g = 0; g < whole.size(); ++g) {
    if (!split[g]) {
      for (const uint32_t k : whole[g].subprograms) group_of_[k] = static_cast<uint32_t>(groups_.size());
      groups_.push_back(std::move(whole[g]));
      continue;
    }
    for (const uint32_t k : whole[g].subprograms) {
      const uint32_t level = flow_.subprograms()[k].level;
      if (by_level.size() <= level) by_level.resize(level + 1);
      by_level[level].push_back(k);
    }
  }
  for (std::vector<uint32_t>& subprograms : by_level) Join(std::move(subprograms));
  FindLevels();
  // As they are called first, whichever is written first: so that a new call moves no other routine.
  std::ranges::stable_sort(groups_, {},
                           [](const SubprogramGroup& group) { return std::ranges::min(group.subprograms); });
  return std::move(groups_);
}

}  // namespace

std::vector<SubprogramGroup> GroupSubprograms(const Flow& flow) { return Grouping(flow).Run(); }

}  // namespace plcxx::technol
