#include "transpiler/passes/structure.h"

#include <algorithm>
#include <vector>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/uses.h"

namespace plcxx::passes {
namespace {

using ir::Inst;
using ir::InstId;
using ir::OpKind;
using ir::RegionId;

/// A jump of a list or nested in one of its instructions, to a label of the list.
struct JumpIn {
  InstId id;
  size_t at;  // index of the list's instruction that it is, or is nested in
  uint32_t label;
  bool nested;
};

/// What one label's jumps become: a block or an if around the instructions [begin, end) of the list.
struct Span {
  size_t begin, end;
  uint32_t label;
  bool is_if;    // one conditional jump at `begin`, nothing else refers to the label
  InstId block;  // known when it is opened
};

struct Structurer {
  ir::Program& program;

  /// Gives the jumps that lead out of the region, which is in so many loops.
  std::vector<InstId> Visit(RegionId region, uint32_t loops = 0);
  std::vector<Span> FindSpans(const std::vector<InstId>& insts, const std::vector<JumpIn>& jumps) const;
  void Rebuild(RegionId region, std::vector<Span> spans, const std::vector<JumpIn>& jumps);
  RegionId Open(Span& span, const std::vector<InstId>& insts, RegionId outer);
  InstId Append(RegionId region, Inst inst);
};

InstId Structurer::Append(RegionId region, Inst inst) {
  const InstId id = program.insts.Add(inst);
  program.regions[region].insts.push_back(id);
  return id;
}

/// Where the block of the label at `at` ends: before the markers that stand directly before the label. A jump, or what
/// it is nested in, is in front of them.
size_t EndOf(const ir::Program& program, const std::vector<InstId>& insts, size_t at) {
  for (;; --at) {
    const OpKind before = program[insts[at - 1]].op;
    if (before != OpKind::kStatement && before != OpKind::kLabel) return at;
  }
}

/// The jumps to one label: the first one's place, their number, and whether the first one stands in the list itself.
struct JumpsTo {
  uint32_t label;
  size_t first;
  uint32_t count;
  bool nested;
};

/// By label, ascending.
std::vector<JumpsTo> ByLabel(const std::vector<JumpIn>& jumps) {
  std::vector<JumpsTo> groups;
  groups.reserve(jumps.size());
  for (const JumpIn& jump : jumps) groups.push_back({jump.label, jump.at, 1, jump.nested});
  std::stable_sort(groups.begin(), groups.end(), [](const JumpsTo& a, const JumpsTo& b) { return a.label < b.label; });
  size_t kept = 0;
  for (size_t i = 0; i < groups.size(); ++i) {
    if (kept > 0 && groups[kept - 1].label == groups[i].label) {
      ++groups[kept - 1].count;
    } else {
      groups[kept++] = groups[i];
    }
  }
  groups.resize(kept);
  return groups;
}

/// Spans that nest properly, by the order of their labels.
std::vector<Span> Structurer::FindSpans(const std::vector<InstId>& insts, const std::vector<JumpIn>& jumps) const {
  const std::vector<JumpsTo> groups = ByLabel(jumps);
  std::vector<Span> spans;
  std::vector<size_t> outermost;  // of `spans`, those that no other one holds so far
  for (size_t at = 0; at < insts.size(); ++at) {
    const Inst& label = program[insts[at]];
    if (label.op != OpKind::kLabel) continue;
    const auto found = std::lower_bound(groups.begin(), groups.end(), label.payload,
                                        [](const JumpsTo& group, uint32_t wanted) { return group.label < wanted; });
    if (found == groups.end() || found->label != label.payload) continue;
    PLCXX_CHECK(found->first < at);
    Span span{.begin = found->first, .end = EndOf(program, insts, at), .label = label.payload, .is_if = false};
    // A jump that is nested in an instruction which the label's markers precede: the block holds it all the same.
    span.end = std::max(span.end, found->first + 1);
    while (!outermost.empty() && spans[outermost.back()].end > span.begin) {
      span.begin = std::min(span.begin, spans[outermost.back()].begin);
      outermost.pop_back();
    }
    const bool conditional = ir::ValueId(program[insts[found->first]].a).valid();
    span.is_if = !found->nested && conditional && found->count == 1 && span.begin == found->first;
    outermost.push_back(spans.size());
    spans.push_back(span);
  }
  return spans;
}

/// Appends the block or the if to `outer`; gives the region that the span's instructions go to.
RegionId Structurer::Open(Span& span, const std::vector<InstId>& insts, RegionId outer) {
  const RegionId inner = program.regions.Add({});
  const Inst jump = program[insts[span.begin]];
  if (!span.is_if) {
    span.block = Append(outer, {.op = OpKind::kBlock, .range = jump.range, .a = inner.index});
    return inner;
  }
  uint32_t condition = jump.a;
  const Inst& computed = program[ir::ValueId(condition)];
  if (computed.op == OpKind::kBitNot) {
    condition = computed.a;
  } else {
    condition =
        Append(outer, {.op = OpKind::kBitNot, .type = ir::Type::kBit, .range = jump.range, .a = condition}).index;
  }
  Append(outer, {.op = OpKind::kIf,
                 .range = jump.range,
                 .payload = static_cast<uint32_t>(ir::IfOrigin::kStays),
                 .a = condition,
                 .b = inner.index});
  return inner;
}

void Structurer::Rebuild(RegionId region, std::vector<Span> spans, const std::vector<JumpIn>& jumps) {
  const std::vector<InstId> insts = std::move(program.regions[region].insts);
  program.regions[region].insts.clear();
  std::stable_sort(spans.begin(), spans.end(),
                   [](const Span& a, const Span& b) { return a.begin != b.begin ? a.begin < b.begin : a.end > b.end; });
  struct Target {
    size_t end;
    RegionId region;
  };
  std::vector<Target> open = {{insts.size() + 1, region}};
  std::vector<std::pair<uint32_t, size_t>> by_label;  // label and index of its span
  for (size_t i = 0; i < spans.size(); ++i) by_label.emplace_back(spans[i].label, i);
  std::sort(by_label.begin(), by_label.end());
  const auto block_of = [&](uint32_t label) {
    const auto target = std::lower_bound(by_label.begin(), by_label.end(), std::pair(label, size_t{0}));
    PLCXX_CHECK(target != by_label.end() && target->first == label && spans[target->second].block.valid());
    return spans[target->second].block;
  };
  size_t next = 0, next_jump = 0;
  for (size_t i = 0; i < insts.size(); ++i) {
    while (open.back().end <= i) open.pop_back();
    bool consumed = false;
    for (; next < spans.size() && spans[next].begin == i; ++next) {
      Span& span = spans[next];
      const bool over_nothing = span.end == i + 1 && program[insts[i]].op == OpKind::kJump;  // decides nothing
      consumed = consumed || span.is_if || over_nothing;
      if (over_nothing) continue;
      open.push_back({span.end, Open(span, insts, open.back().region)});
    }
    Inst& inst = program[insts[i]];
    if (inst.op == OpKind::kLabel || consumed) {
      ir::Forget(inst);
      for (; next_jump < jumps.size() && jumps[next_jump].at == i; ++next_jump) PLCXX_CHECK(!jumps[next_jump].nested);
      continue;
    }
    for (; next_jump < jumps.size() && jumps[next_jump].at == i; ++next_jump) {
      Inst& jump = program[jumps[next_jump].id];
      const uint32_t block = block_of(jump.payload).index;
      jump = {.op = OpKind::kExit, .range = jump.range, .payload = block, .a = jump.a};
    }
    program.regions[open.back().region].insts.push_back(insts[i]);
  }
}

std::vector<InstId> Structurer::Visit(RegionId region, uint32_t loops) {
  MakeLoops(program, region, loops);
  std::vector<InstId> leading_out;
  std::vector<JumpIn> jumps;
  bool labels = false;
  // By index: Rebuild of a nested region adds regions.
  for (size_t i = 0; i < program.regions[region].insts.size(); ++i) {
    const InstId id = program.regions[region].insts[i];
    const Inst& inst = program[id];
    if (inst.op == OpKind::kJump) jumps.push_back({id, i, inst.payload, false});
    labels = labels || inst.op == OpKind::kLabel;
    if (!ir::OwnsRegions(inst)) continue;
    const uint32_t inside = loops + (inst.op == OpKind::kLoop ? 1 : 0);
    for (const RegionId owned : ir::OwnedRegions(program, inst)) {
      for (const InstId jump : Visit(owned, inside)) jumps.push_back({jump, i, program[jump].payload, true});
    }
  }
  if (!labels) {
    for (const JumpIn& jump : jumps) leading_out.push_back(jump.id);
    return leading_out;
  }
  // Only those to the list's own labels; the others are for a region around this one.
  std::vector<uint32_t> own;
  for (const InstId id : program.regions[region].insts) {
    if (program[id].op == OpKind::kLabel) own.push_back(program[id].payload);
  }
  std::sort(own.begin(), own.end());
  std::erase_if(jumps, [&](const JumpIn& jump) {
    if (std::binary_search(own.begin(), own.end(), jump.label)) return false;
    leading_out.push_back(jump.id);
    return true;
  });
  Rebuild(region, FindSpans(program.regions[region].insts, jumps), jumps);
  return leading_out;
}

}  // namespace

void Structure(ir::Program& program) {
  Structurer structurer{program};
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::Routine routine = program.routines[ir::RoutineId(i)];
    for (const RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (region.valid()) PLCXX_CHECK(structurer.Visit(region).empty());
    }
  }
}

}  // namespace plcxx::passes
