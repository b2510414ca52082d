// Jumps back become loops. See structure.h for the picture.

#include <algorithm>
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
  size_t length() const { return end - begin; }
};

struct LoopMaker {
  ir::Program& program;
  std::vector<InstId> insts;
  std::vector<LoopJump> jumps;
  std::vector<Interval> loops;  // two of them are disjoint, or one is in the other
  ir::Builder builder;

  explicit LoopMaker(ir::Program& of) : program(of), builder(of) {}

  void FindJumps();
  void FindLoops();
  bool MergeCrossing();
  bool ReachEntries();
  void Rebuild(RegionId region);
  void Make(const Interval& interval, RegionId outer);
  void MakeRepeat(const LoopJump& jump, InstId loop, ir::PlaceId resume, uint64_t number);
  size_t HeadOf(size_t label) const;
  size_t EndOfStatement(size_t at) const;
  const Interval* LoopOf(const LoopJump& jump) const;
};

/// Where a loop from this label begins: before the markers and labels that stand directly before it.
size_t LoopMaker::HeadOf(size_t label) const {
  size_t at = label;
  while (at > 0) {
    const OpKind before = program[insts[at - 1]].op;
    if (before != OpKind::kStatement && before != OpKind::kLabel) break;
    --at;
  }
  return at;
}

/// Behind the last instruction of the statement: what follows a jump back there may use its values.
size_t LoopMaker::EndOfStatement(size_t at) const {
  for (++at; at < insts.size(); ++at) {
    if (program[insts[at]].op == OpKind::kStatement || program[insts[at]].op == OpKind::kLabel) break;
  }
  return at;
}

void LoopMaker::FindJumps() {
  std::unordered_map<uint32_t, size_t> labels;
  for (size_t i = 0; i < insts.size(); ++i) {
    if (program[insts[i]].op == OpKind::kLabel) labels.emplace(program[insts[i]].payload, i);
  }
  if (labels.empty()) return;
  for (size_t i = 0; i < insts.size(); ++i) {
    const auto add = [&](InstId id) {
      if (program[id].op != OpKind::kJump) return;
      const auto label = labels.find(program[id].payload);
      if (label != labels.end()) jumps.push_back({id, i, label->second, HeadOf(label->second)});
    };
    add(insts[i]);
    for (const RegionId owned : ir::OwnedRegions(program, program[insts[i]])) ir::ForEachInst(program, owned, add);
  }
}

/// Joins loops that cross or begin together; whether there was one.
bool LoopMaker::MergeCrossing() {
  std::sort(loops.begin(), loops.end(), [](const Interval& a, const Interval& b) {
    return a.begin != b.begin ? a.begin < b.begin : a.end > b.end;
  });
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

/// Moves the beginning of a loop up to a jump that comes into its middle; whether there was one.
bool LoopMaker::ReachEntries() {
  bool moved = false;
  for (Interval& loop : loops) {
    for (const LoopJump& jump : jumps) {
      if (jump.at >= loop.begin || jump.head <= loop.begin || jump.head >= loop.end) continue;
      loop.begin = jump.at;
      moved = true;
    }
  }
  return moved;
}

void LoopMaker::FindLoops() {
  for (const LoopJump& jump : jumps) {
    if (jump.back()) loops.push_back({jump.head, EndOfStatement(jump.at)});
  }
  for (bool changed = !loops.empty(); changed;) {
    changed = MergeCrossing();
    changed = ReachEntries() || changed;
  }
}

/// The innermost loop that holds the jump and its label.
const Interval* LoopMaker::LoopOf(const LoopJump& jump) const {
  const Interval* innermost = nullptr;
  for (const Interval& loop : loops) {
    if (!loop.Holds(jump.at) || !loop.Holds(jump.head)) continue;
    if (innermost == nullptr || loop.length() < innermost->length()) innermost = &loop;
  }
  return innermost;
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
  std::vector<const LoopJump*> own;  // jumps back that are this loop's, not an inner one's
  std::vector<size_t> middles;       // labels that they reach by way of the head
  for (const LoopJump& jump : jumps) {
    if (!jump.back() || LoopOf(jump) != &interval) continue;
    own.push_back(&jump);
    if (jump.head > interval.begin) middles.push_back(jump.label);
  }
  PLCXX_CHECK(!own.empty());
  std::sort(middles.begin(), middles.end());
  middles.erase(std::unique(middles.begin(), middles.end()), middles.end());

  builder.SetRange(program[own.front()->id].range);
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
      {.kind = ir::LoopBound::kBudget, .budget = ir::PlaceId(program[own.front()->id].c), .body = body});

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
  for (const LoopJump* jump : own) {
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

void MakeLoops(ir::Program& program, RegionId region) {
  LoopMaker maker(program);
  maker.insts = program.regions[region].insts;
  maker.FindJumps();
  maker.FindLoops();
  if (!maker.loops.empty()) maker.Rebuild(region);
}

}  // namespace plcxx::passes
