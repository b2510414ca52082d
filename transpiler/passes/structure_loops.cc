// Jumps back become loops. See structure.h for the picture.

#include <algorithm>
#include <bit>
#include <unordered_map>
#include <utility>

#include "transpiler/ir/builder.h"
#include "transpiler/passes/structure.h"
#include "transpiler/support/check.h"

namespace plcxx::passes {
namespace {

using ir::Inst;
using ir::InstId;
using ir::OpKind;
using ir::RegionId;

/// A jump of the list or nested in one of its instructions, to a label of the list.
struct LoopJump {
  InstId id;
  size_t at;     // index of the list's instruction that it is, or is nested in
  size_t label;  // index of its label
  size_t head;   // where a loop from that label begins
  bool back() const { return label <= at; }
};

/// Indices into the list, half open.
struct Interval {
  size_t begin, end;
  bool Holds(size_t at) const { return at >= begin && at < end; }
};

class Entries;

struct LoopMaker {
  ir::Program& program;
  std::vector<InstId> insts;
  std::vector<LoopJump> jumps;
  std::vector<Interval> loops;  // two of them are disjoint, or one is in the other
  std::vector<size_t> head_of;  // by label: where a loop from it begins, before the marks and labels directly before it
  std::vector<size_t> end_of;   // by instruction: after the last one of its statement, whose values what follows a
                                // jump back may use
  std::vector<std::vector<const LoopJump*>> own;  // by loop: the jumps back that are its own, not an inner one's
  ir::Builder builder;

  explicit LoopMaker(ir::Program& of) : program(of), builder(of) {}

  void FindJumps();
  void FindLoops(bool only_outermost);
  bool MergeCrossing();
  bool ReachEntries(const Entries& entries);
  void Rebuild(RegionId region);
  void Make(const Interval& interval, RegionId outer);
  void MakeRepeat(const LoopJump& jump, InstId loop, ir::PlaceId resume, uint64_t number);
  void FindStatements();
  void FindOwners();
};

void LoopMaker::FindStatements() {
  const auto is_mark = [&](size_t at) {
    const OpKind op = program[insts[at]].op;
    return op == OpKind::kStatement || op == OpKind::kLabel;
  };
  head_of.resize(insts.size());
  end_of.assign(insts.size() + 1, insts.size());
  for (size_t i = 0; i < insts.size(); ++i) head_of[i] = i > 0 && is_mark(i - 1) ? head_of[i - 1] : i;
  for (size_t i = insts.size(); i-- > 0;) end_of[i] = i + 1 < insts.size() && is_mark(i + 1) ? i + 1 : end_of[i + 1];
}

void LoopMaker::FindJumps() {
  std::unordered_map<uint32_t, size_t> labels;
  for (size_t i = 0; i < insts.size(); ++i) {
    if (program[insts[i]].op == OpKind::kLabel) labels.emplace(program[insts[i]].payload, i);
  }
  if (labels.empty()) return;
  FindStatements();
  for (size_t i = 0; i < insts.size(); ++i) {
    const auto add = [&](InstId id) {
      if (program[id].op != OpKind::kJump) return;
      const auto label = labels.find(program[id].payload);
      if (label != labels.end()) jumps.push_back({id, i, label->second, head_of[label->second]});
    };
    add(insts[i]);
    for (const RegionId owned : ir::OwnedRegions(program, program[insts[i]])) ir::ForEachInst(program, owned, add);
  }
}

/// Joins loops that cross or begin together; whether there was one.
bool LoopMaker::MergeCrossing() {
  std::ranges::sort(loops, {},
                    [](const Interval& loop) { return std::pair(loop.begin, ~loop.end); });  // the longer first
  std::vector<Interval> kept;
  std::vector<size_t> open;  // of `kept`, from the outermost to the innermost
  bool merged = false;
  for (const Interval& loop : loops) {
    while (!open.empty() && kept[open.back()].end <= loop.begin) open.pop_back();
    if (!open.empty() && (kept[open.back()].begin == loop.begin || kept[open.back()].end < loop.end)) {
      kept[open.back()].end = std::max(kept[open.back()].end, loop.end);
      merged = true;
      continue;
    }
    open.push_back(kept.size());
    kept.push_back(loop);
  }
  loops = std::move(kept);
  return merged;
}

/// The least beginning of a jump among those whose heads are in an interval.
class Entries {
 public:
  explicit Entries(const std::vector<LoopJump>& jumps) {
    for (const LoopJump& jump : jumps) {
      if (jump.at < jump.head) by_head_.emplace_back(jump.head, jump.at);
    }
    std::sort(by_head_.begin(), by_head_.end());
    least_.emplace_back();
    for (const auto& [head, at] : by_head_) least_[0].push_back(at);
    for (size_t width = 1; 2 * width <= by_head_.size(); width *= 2) {
      const std::vector<size_t>& half = least_.back();
      std::vector<size_t> whole(by_head_.size() - 2 * width + 1);
      for (size_t i = 0; i < whole.size(); ++i) whole[i] = std::min(half[i], half[i + width]);
      least_.push_back(std::move(whole));
    }
  }

  /// Of heads after `begin` and before `end`; `begin` when there is none, or none that is less.
  size_t Least(size_t begin, size_t end) const {
    const auto first = std::lower_bound(by_head_.begin(), by_head_.end(), std::pair(begin + 1, size_t{0}));
    const auto last = std::lower_bound(first, by_head_.end(), std::pair(end, size_t{0}));
    if (first == last) return begin;
    const auto count = static_cast<size_t>(last - first), from = static_cast<size_t>(first - by_head_.begin());
    const auto level = static_cast<size_t>(std::bit_width(count) - 1);
    const size_t width = size_t{1} << level;
    return std::min({begin, least_[level][from], least_[level][from + count - width]});
  }

 private:
  std::vector<std::pair<size_t, size_t>> by_head_;  // head and place of each jump forward
  std::vector<std::vector<size_t>> least_;          // by power of two: of so many of them from each one on
};

/// Moves the beginning of a loop up to a jump that comes into its middle; whether there was one.
bool LoopMaker::ReachEntries(const Entries& entries) {
  bool moved = false;
  for (Interval& loop : loops) {
    for (size_t least = entries.Least(loop.begin, loop.end); least < loop.begin;
         least = entries.Least(loop.begin, loop.end)) {
      loop.begin = least;
      moved = true;
    }
  }
  return moved;
}

void LoopMaker::FindLoops(bool only_outermost) {
  for (const LoopJump& jump : jumps) {
    if (jump.back()) loops.push_back({jump.head, end_of[jump.at]});
  }
  if (loops.empty()) return;
  const Entries entries(jumps);
  for (bool changed = true; changed;) {
    changed = MergeCrossing();
    changed = ReachEntries(entries) || changed;
  }
  if (only_outermost) {
    size_t end = 0;
    std::erase_if(loops,
                  [&](const Interval& loop) { return loop.begin < std::exchange(end, std::max(end, loop.end)); });
  }
  FindOwners();
}

/// The loop of a jump back is the innermost one that holds the jump and its head.
void LoopMaker::FindOwners() {
  constexpr size_t kNone = ~size_t{0};
  std::vector<size_t> around(loops.size(), kNone);     // by loop: the one that holds it
  std::vector<size_t> innermost(insts.size(), kNone);  // by instruction
  std::vector<size_t> open;
  for (size_t i = 0, next = 0; i < insts.size(); ++i) {
    while (!open.empty() && loops[open.back()].end <= i) open.pop_back();
    for (; next < loops.size() && loops[next].begin == i; ++next) {
      if (!open.empty()) around[next] = open.back();
      open.push_back(next);
    }
    if (!open.empty()) innermost[i] = open.back();
  }
  own.resize(loops.size());
  for (const LoopJump& jump : jumps) {
    if (!jump.back()) continue;
    size_t loop = innermost[jump.head];
    while (!loops[loop].Holds(jump.at)) loop = around[loop];
    own[loop].push_back(&jump);
  }
}

/// `number` tells the choice at the loop's head where to go on, when it has one.
void LoopMaker::MakeRepeat(const LoopJump& jump, InstId loop, ir::PlaceId resume, uint64_t number) {
  const Inst was = program[jump.id];
  if (!resume.valid()) {
    program[jump.id] = {.op = OpKind::kRepeat, .range = was.range, .payload = loop.index, .a = was.a, .b = was.b};
    return;
  }
  // The place is only written when the jump is taken.
  const RegionId taken = builder.NewRegion();
  builder.SetRegion(taken);
  builder.SetRange(was.range);
  builder.Store(resume, builder.Constant(ir::Type::kI32, number));
  builder.Repeat(loop, {}, RegionId(was.b));
  if (ir::ValueId(was.a).valid()) {
    program[jump.id] = {.op = OpKind::kIf,
                        .range = was.range,
                        .payload = static_cast<uint32_t>(ir::IfOrigin::kJumps),
                        .a = was.a,
                        .b = taken.index};
  } else {
    program[jump.id] = {.op = OpKind::kBlock, .range = was.range, .a = taken.index};
  }
}

/// Appends the loop to `outer`.
void LoopMaker::Make(const Interval& interval, RegionId outer) {
  const std::vector<const LoopJump*>& back = own[static_cast<size_t>(&interval - loops.data())];
  std::vector<size_t> middles;  // labels that they reach by way of the head
  for (const LoopJump* jump : back) {
    if (jump->head > interval.begin) middles.push_back(jump->label);
  }
  PLCXX_CHECK(!back.empty());
  std::sort(middles.begin(), middles.end());
  middles.erase(std::unique(middles.begin(), middles.end()), middles.end());

  builder.SetRange(program[back.front()->id].range);
  builder.SetRegion(outer);
  // Who comes from above to the loop's first label comes to the loop.
  size_t first = interval.begin;
  std::vector<InstId> markers;
  for (; first < interval.end; ++first) {
    const OpKind op = program[insts[first]].op;
    if (op == OpKind::kLabel) {
      program.regions[outer].insts.push_back(insts[first]);
    } else if (op == OpKind::kStatement) {
      markers.push_back(insts[first]);
    } else {
      break;
    }
  }
  ir::PlaceId resume;
  if (!middles.empty()) {
    const ir::SpaceId space = program.spaces.Add({.name = "resume",
                                                  .title = "where the next round of a loop begins",
                                                  .bytes = ir::Bytes(ir::Type::kI32),
                                                  .lifetime = ir::Lifetime::kRoutine,
                                                  .own = true});
    resume = program.places.Add({.name = "resume", .type = ir::Type::kI32, .space = space});
    builder.Store(resume, builder.Constant(ir::Type::kI32, 0));
  }
  const RegionId body = builder.NewRegion();
  const InstId loop = builder.LoopWith(
      {.kind = ir::LoopBound::kBudget, .budget = ir::PlaceId(program[back.front()->id].c), .body = body});

  builder.SetRegion(body);
  for (size_t i = 0; i < middles.size(); ++i) {
    const ir::ValueId number = builder.Constant(ir::Type::kI32, i + 1);
    const ir::ValueId chosen = builder.Pure(OpKind::kEqual32, {builder.Load(resume), number});
    builder.Jump(program[insts[middles[i]]].payload, chosen);
  }
  std::vector<InstId>& list = program.regions[body].insts;
  list.insert(list.end(), markers.begin(), markers.end());
  list.insert(list.end(), insts.begin() + static_cast<ptrdiff_t>(first),
              insts.begin() + static_cast<ptrdiff_t>(interval.end));
  for (const LoopJump* jump : back) {
    const auto middle = std::lower_bound(middles.begin(), middles.end(), jump->label);
    const bool to_middle = middle != middles.end() && *middle == jump->label;
    MakeRepeat(*jump, loop, resume, to_middle ? static_cast<uint64_t>(middle - middles.begin()) + 1 : 0);
  }
}

void LoopMaker::Rebuild(RegionId region) {
  size_t end = 0;  // of the last outermost loop
  program.regions[region].insts.clear();
  const auto keep = [&](size_t from, size_t to) {
    std::vector<InstId>& list = program.regions[region].insts;
    list.insert(list.end(), insts.begin() + static_cast<ptrdiff_t>(from), insts.begin() + static_cast<ptrdiff_t>(to));
  };
  for (const Interval& loop : loops) {  // ascending, an outer one before its inner ones
    if (loop.begin < end) continue;
    keep(end, loop.begin);
    Make(loop, region);
    end = loop.end;
  }
  keep(end, insts.size());
}

}  // namespace

void MakeLoops(ir::Program& program, RegionId region, uint32_t loops) {
  LoopMaker maker(program);
  maker.insts = program.regions[region].insts;
  maker.FindJumps();
  maker.FindLoops(loops + 1 >= kDeepestLoops);
  if (!maker.loops.empty()) maker.Rebuild(region);
}

}  // namespace plcxx::passes
