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

constexpr size_t kNotFound = SIZE_MAX;

/// What one label's jumps become: a block or an if around the instructions [begin, end) of the list.
struct Span {
  size_t begin, end;
  uint32_t label;
  bool is_if;    // one conditional jump at `begin`, nothing else refers to the label
  InstId block;  // known when it is opened
};

struct Structurer {
  ir::Program& program;

  void Visit(RegionId region);
  std::vector<Span> FindSpans(const std::vector<InstId>& insts) const;
  void Rebuild(RegionId region, std::vector<Span> spans);
  RegionId Open(Span& span, const std::vector<InstId>& insts, RegionId outer);
  InstId Append(RegionId region, Inst inst);
};

InstId Structurer::Append(RegionId region, Inst inst) {
  const InstId id = program.insts.Add(inst);
  program.regions[region].insts.push_back(id);
  return id;
}

/// Where the block of the label at `at` ends: before the markers that stand directly before the label.
size_t EndOf(const ir::Program& program, const std::vector<InstId>& insts, size_t at) {
  while (at > 0) {
    const OpKind before = program[insts[at - 1]].op;
    if (before != OpKind::kStatement && before != OpKind::kLabel) break;
    --at;
  }
  return at;
}

/// The jumps of one list, by label: the first one's place and their number.
struct JumpsTo {
  uint32_t label;
  size_t first;
  uint32_t count;
};

std::vector<JumpsTo> FindJumps(const ir::Program& program, const std::vector<InstId>& insts) {
  std::vector<JumpsTo> jumps;
  for (size_t i = 0; i < insts.size(); ++i) {
    if (program[insts[i]].op == OpKind::kJump) jumps.push_back({program[insts[i]].payload, i, 1});
  }
  std::stable_sort(jumps.begin(), jumps.end(), [](const JumpsTo& a, const JumpsTo& b) { return a.label < b.label; });
  size_t kept = 0;
  for (size_t i = 0; i < jumps.size(); ++i) {
    if (kept > 0 && jumps[kept - 1].label == jumps[i].label) {
      ++jumps[kept - 1].count;
    } else {
      jumps[kept++] = jumps[i];
    }
  }
  jumps.resize(kept);
  return jumps;
}

/// Spans that nest properly, by the order of their labels.
std::vector<Span> Structurer::FindSpans(const std::vector<InstId>& insts) const {
  const std::vector<JumpsTo> jumps = FindJumps(program, insts);
  std::vector<Span> spans;
  std::vector<size_t> outermost;  // of `spans`, those that no other one holds so far
  for (size_t at = 0; at < insts.size(); ++at) {
    const Inst& label = program[insts[at]];
    if (label.op != OpKind::kLabel) continue;
    const auto found = std::lower_bound(jumps.begin(), jumps.end(), label.payload,
                                        [](const JumpsTo& jump, uint32_t wanted) { return jump.label < wanted; });
    if (found == jumps.end() || found->label != label.payload) continue;
    PLCXX_CHECK(found->first < at);
    Span span{.begin = found->first, .end = EndOf(program, insts, at), .label = label.payload, .is_if = false};
    while (!outermost.empty() && spans[outermost.back()].end > span.begin) {
      span.begin = std::min(span.begin, spans[outermost.back()].begin);
      outermost.pop_back();
    }
    const bool conditional = ir::ValueId(program[insts[found->first]].a).valid();
    span.is_if = conditional && found->count == 1 && span.begin == found->first;
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
  Append(outer, {.op = OpKind::kIf, .range = jump.range, .a = condition, .b = inner.index});
  return inner;
}

void Structurer::Rebuild(RegionId region, std::vector<Span> spans) {
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
  size_t next = 0;
  for (size_t i = 0; i < insts.size(); ++i) {
    while (open.back().end <= i) open.pop_back();
    bool consumed = false;
    for (; next < spans.size() && spans[next].begin == i; ++next) {
      Span& span = spans[next];
      const bool over_nothing = span.end == i + 1;  // decides nothing
      consumed = consumed || span.is_if || over_nothing;
      if (over_nothing) continue;
      open.push_back({span.end, Open(span, insts, open.back().region)});
    }
    Inst& inst = program[insts[i]];
    if (inst.op == OpKind::kLabel || consumed) {
      ir::Forget(inst);
      continue;
    }
    if (inst.op == OpKind::kJump) {
      const auto target = std::lower_bound(by_label.begin(), by_label.end(), std::pair(inst.payload, size_t{0}));
      PLCXX_CHECK(target != by_label.end() && target->first == inst.payload);
      inst.op = OpKind::kExit;
      inst.payload = spans[target->second].block.index;
    }
    program.regions[open.back().region].insts.push_back(insts[i]);
  }
}

void Structurer::Visit(RegionId region) {
  bool jumps = false;
  // By index: Rebuild of a nested region adds regions.
  for (size_t i = 0; i < program.regions[region].insts.size(); ++i) {
    const Inst& inst = program[program.regions[region].insts[i]];
    jumps = jumps || inst.op == OpKind::kJump || inst.op == OpKind::kLabel;
    if (!ir::OwnsRegions(inst)) continue;
    for (const RegionId owned : ir::OwnedRegions(program, inst)) Visit(owned);
  }
  if (jumps) Rebuild(region, FindSpans(program.regions[region].insts));
}

}  // namespace

void Structure(ir::Program& program) {
  Structurer structurer{program};
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::Routine& routine = program.routines[ir::RoutineId(i)];
    for (const RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (region.valid()) structurer.Visit(region);
    }
  }
}

}  // namespace plcxx::passes
