// Decides how each Exit and Repeat gets to where it goes.
//
//   block @1 { exit @1 if %0; ... }; (end of the routine)   ->   if (...) return; ...
//   loop @1 { ...; repeat @1 if %0 }                        ->   for (;;) { ...; if (...) { ...; continue; } break; }
//   block @1 { switch ... { exit @1 } ... }; stmt U4A8      ->   goto to_U4A8; ... to_U4A8:;
//   if %0 { stmt } else { ... }, the stmt a jump            ->   if (...) { return; } ...
//
// C++ has a word of its own for the way out where nothing else follows the block or loop; elsewhere a goto to a label
// after it. Labels have the names of what follows them, so that an edit elsewhere renames none.

#include <algorithm>
#include <unordered_set>

#include "transpiler/emit/legalize/names.h"
#include "transpiler/emit/legalize/steps.h"
#include "transpiler/ir/builder.h"

namespace plcxx::emit::legalize {
namespace {

using ir::InstId;
using ir::RegionId;

/// A place in the program that execution goes on from.
enum class Point : uint64_t {};
constexpr Point kFunctionEnd{~uint64_t{0}};
constexpr uint64_t kNextRound = uint64_t{1} << 32, kNextArm = uint64_t{1} << 33;

/// A word of C++ that goes to a point: break and continue of the instruction `owner`.
struct Way {
  Leave leave;
  InstId owner;
};

/// What happens after the last instruction of a list.
struct End {
  Point point;
  std::vector<Way> ways;  // that go there
};

struct Chooser {
  Emittable& emittable;
  const ir::Program& program;

  std::vector<End> behind;  // of the blocks and loops around, as `around`
  struct Around {
    InstId id;
    RegionId region;    // the list it stands in
    uint32_t at = 0;    // where
    uint32_t stop = 0;  // its end: of the function's part of the list
  };
  std::vector<Around> around;
  struct Breakable {
    InstId id;
    bool is_loop;
  };
  std::vector<Breakable> breakables;
  std::unordered_set<std::string> labels;  // of the function
  RegionId cut_from;                       // the function is a chunk of this list; none: a routine

  void Function(std::initializer_list<RegionId> regions);
  void Region(RegionId region, const End& end);
  void Range(RegionId region, uint32_t begin, uint32_t stop, const End& end);
  void Inst(InstId id, const Around& place, const End& next);
  void Loop(InstId id, const End& next);
  void Switch(InstId id, const End& next);
  void Exit(InstId id, const End& next);
  void Repeat(InstId id, const End& next);
  void LeaveEarly(InstId id, const End& next);
  void ChooseWay(InstId id, const std::vector<Way>& ways, const Around& target);
  bool Binds(const Way& way) const;
  const Around& TargetOf(const ir::Inst& inst) const;
  std::string LabelFor(std::string_view prefix, RegionId region, uint32_t from, uint32_t stop);
};

End With(Way way, const End& next) {
  End end{next.point, {way}};
  end.ways.insert(end.ways.end(), next.ways.begin(), next.ways.end());
  return end;
}

bool Chooser::Binds(const Way& way) const {
  switch (way.leave) {
    case Leave::kReturn:
      return true;
    case Leave::kBreak:
      return !breakables.empty() && breakables.back().id == way.owner;
    case Leave::kContinue:
      for (size_t i = breakables.size(); i-- > 0;) {
        if (breakables[i].is_loop) return breakables[i].id == way.owner;
      }
      return false;
    case Leave::kFallsThrough:
    case Leave::kGoto:
      break;
  }
  return false;
}

/// "to_U4A8": from the subject of the next statement, or "to_end".
std::string Chooser::LabelFor(std::string_view prefix, RegionId region, uint32_t from, uint32_t stop) {
  std::string subject = "end";
  for (uint32_t i = from; i < stop; ++i) {
    const ir::Inst& inst = program[program.regions[region].insts[i]];
    if (inst.op != ir::OpKind::kStatement) continue;
    const std::string& named = program.statements[ir::StatementId(inst.payload)].subject;
    subject = named.empty() ? "next" : named;
    break;
  }
  const std::string name = SafeIdentifier(std::string(prefix) + "_" + subject);
  std::string unique = name;
  for (uint32_t i = 2; !labels.insert(unique).second; ++i) unique = SafeIdentifier(name + "_" + std::to_string(i));
  return unique;
}

const Chooser::Around& Chooser::TargetOf(const ir::Inst& inst) const {
  const auto found = std::find_if(around.rbegin(), around.rend(),
                                  [&inst](const Around& candidate) { return candidate.id.index == inst.payload; });
  PLCXX_CHECK(found != around.rend());
  return *found;
}

void Chooser::ChooseWay(InstId id, const std::vector<Way>& ways, const Around& target) {
  const auto way = std::find_if(ways.begin(), ways.end(), [this](const Way& candidate) { return Binds(candidate); });
  if (way != ways.end()) {
    emittable.leaves[id.index] = way->leave;
    return;
  }
  emittable.leaves[id.index] = Leave::kGoto;
  Landing& landing = emittable.landings[target.id.index];
  if (program[id].op == ir::OpKind::kRepeat) {
    const RegionId body(program[target.id].a);
    const auto size = static_cast<uint32_t>(program.regions[body].insts.size());
    if (landing.again.empty()) landing.again = LabelFor("again", body, 0, size);
  } else if (landing.behind.empty()) {
    landing.behind = LabelFor("to", target.region, target.at + 1, target.stop);
  }
}

void Chooser::Exit(InstId id, const End& next) {
  const Around& target = TargetOf(program[id]);
  const End& end = behind[static_cast<size_t>(&target - around.data())];
  if (next.point == end.point) {
    emittable.leaves[id.index] = Leave::kFallsThrough;
    return;
  }
  const bool loop = program[target.id].op == ir::OpKind::kLoop;
  ChooseWay(id, loop ? With({Leave::kBreak, target.id}, end).ways : end.ways, target);
}

void Chooser::Repeat(InstId id, const End& next) {
  const ir::Inst& inst = program[id];
  const Around& target = TargetOf(inst);
  ChooseWay(id, {{Leave::kContinue, target.id}}, target);
  if (RegionId(inst.b).valid()) Region(RegionId(inst.b), next);
}

/// if c { stmt return } else { ... }, where nothing follows: what the source left by a jump, the text leaves by a word.
/// Not in the debug flavour, where switching off a statement skips the arms of its If together.
void Chooser::LeaveEarly(InstId id, const End& next) {
  const ir::Inst& inst = program[id];
  const bool jumps = static_cast<ir::IfOrigin>(inst.payload) == ir::IfOrigin::kJumps;
  if (!jumps || !RegionId(inst.c).valid() || emittable.options.flavour == Flavour::kDebug) return;
  const auto way = std::ranges::find_if(next.ways, [this](const Way& candidate) { return Binds(candidate); });
  if (way != next.ways.end()) emittable.early_leaves[id.index] = way->leave;
}

void Chooser::Loop(InstId id, const End& next) {
  const ir::Loop& loop = program.loops[ir::LoopId(program[id].payload)];
  breakables.push_back({id, true});
  const End out = With({Leave::kBreak, id}, next);
  const End again{static_cast<Point>(kNextRound + id.index), {{Leave::kContinue, id}}};
  if (loop.condition.valid()) Region(loop.condition, {static_cast<Point>(kNextArm + id.index), {}});
  if (loop.exhausted.valid()) Region(loop.exhausted, out);
  Region(loop.body, loop.kind == ir::LoopBound::kBudget ? out : again);
  breakables.pop_back();
}

void Chooser::Switch(InstId id, const End& next) {
  breakables.push_back({id, false});
  const End out = With({Leave::kBreak, id}, next);
  for (const ir::SwitchCase& arm : program.switches[ir::SwitchId(program[id].payload)].cases) {
    Region(arm.region, arm.falls_through ? End{static_cast<Point>(kNextArm + id.index), {}} : out);
  }
  breakables.pop_back();
}

void Chooser::Inst(InstId id, const Around& place, const End& next) {
  const ir::Inst& inst = program[id];
  if (inst.op == ir::OpKind::kBlock || inst.op == ir::OpKind::kLoop) {
    around.push_back(place);
    behind.push_back(next);
    if (inst.op == ir::OpKind::kLoop) {
      Loop(id, next);
    } else {
      Region(RegionId(inst.a), next);
    }
    behind.pop_back();
    around.pop_back();
  } else if (inst.op == ir::OpKind::kSwitch) {
    Switch(id, next);
  } else if (inst.op == ir::OpKind::kExit) {
    Exit(id, next);
  } else if (inst.op == ir::OpKind::kRepeat) {
    Repeat(id, next);
  } else if (inst.op == ir::OpKind::kIf) {
    LeaveEarly(id, next);
    for (const RegionId arm : {RegionId(inst.b), RegionId(inst.c)}) {
      if (arm.valid()) Region(arm, next);
    }
  }
}

/// The instructions [begin, stop) of a list; `end` is what happens after `stop`.
void Chooser::Range(RegionId region, uint32_t begin, uint32_t stop, const End& end) {
  const std::vector<InstId>& insts = program.regions[region].insts;
  uint32_t last = stop;
  while (last > begin && !IsEffect(emittable, insts[last - 1])) --last;
  const std::vector<uint32_t>& chunks = emittable.region_chunks[region.index];
  size_t chunk = 0;
  for (uint32_t i = begin; i < stop; ++i) {
    // What was cut out of the list is a function of its own.
    while (chunk < chunks.size() && emittable.chunks[chunks[chunk]].end <= i) ++chunk;
    if (region != cut_from && chunk < chunks.size() && emittable.chunks[chunks[chunk]].begin <= i) continue;
    // In front of another effect the point is its own: nothing else leads there.
    const End next = i + 1 == last ? end : End{static_cast<Point>(insts[i].index), {}};
    Inst(insts[i], {insts[i], region, i, stop}, next);
  }
}

void Chooser::Region(RegionId region, const End& end) {
  Range(region, 0, static_cast<uint32_t>(program.regions[region].insts.size()), end);
}

/// The parts of a routine, one after the other.
void Chooser::Function(std::initializer_list<RegionId> regions) {
  labels.clear();
  const auto empty = [this](RegionId region) { return !region.valid() || program.regions[region].insts.empty(); };
  for (const RegionId* region = regions.begin(); region != regions.end(); ++region) {
    if (empty(*region)) continue;
    const bool last = std::all_of(region + 1, regions.end(), empty);
    Region(*region, last ? End{kFunctionEnd, {{Leave::kReturn, {}}}} : End{kFunctionEnd, {}});
  }
}

/// Whether the list declares locals that a goto out of its middle would jump over.
bool HasLocals(const Emittable& emittable, RegionId region) {
  const ir::Program& program = *emittable.program;
  for (const InstId id : program.regions[region].insts) {
    if (emittable.forms[id.index] == Form::kLocal && !emittable.loose_locals.contains(id.index)) return true;
    if (emittable.early_leaves.contains(id.index) && HasLocals(emittable, RegionId(program[id].c))) return true;
    if (program[id].op != ir::OpKind::kBlock) continue;
    const auto landing = emittable.landings.find(id.index);
    const bool braces = landing != emittable.landings.end() && landing->second.braces;
    if (!braces && HasLocals(emittable, RegionId(program[id].a))) return true;
  }
  return false;
}

/// The list's locals, as many as HasLocals looks at.
void Loosen(Emittable& emittable, RegionId region) {
  const ir::Program& program = *emittable.program;
  for (const InstId id : program.regions[region].insts) {
    if (emittable.forms[id.index] == Form::kLocal) emittable.loose_locals.insert(id.index);
    if (emittable.early_leaves.contains(id.index)) Loosen(emittable, RegionId(program[id].c));
    if (program[id].op == ir::OpKind::kBlock) Loosen(emittable, RegionId(program[id].a));
  }
}

constexpr uint32_t kDeepestBraces = 64;  // of regions; Clang refuses brackets that are deeper than 256

void BracesIn(Emittable& emittable, RegionId region, uint32_t depth) {
  const ir::Program& program = *emittable.program;
  for (const InstId id : program.regions[region].insts) {
    for (const RegionId owned : ir::OwnedRegions(program, program[id])) BracesIn(emittable, owned, depth + 1);
    const auto landing = emittable.landings.find(id.index);
    if (program[id].op != ir::OpKind::kBlock || landing == emittable.landings.end()) continue;
    const RegionId inside(program[id].a);
    landing->second.braces = !landing->second.behind.empty() && HasLocals(emittable, inside);
    if (!landing->second.braces || depth < kDeepestBraces) continue;
    landing->second.braces = false;
    Loosen(emittable, inside);
  }
}

}  // namespace

void ChooseLeaves(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  Chooser chooser{.emittable = emittable,
                  .program = program,
                  .behind = {},
                  .around = {},
                  .breakables = {},
                  .labels = {},
                  .cut_from = {}};
  for (const Chunk& chunk : emittable.chunks) {
    chooser.labels.clear();
    chooser.cut_from = chunk.region;
    chooser.Range(chunk.region, chunk.begin, chunk.end, {kFunctionEnd, {{Leave::kReturn, {}}}});
  }
  chooser.cut_from = {};
  for (const ir::Routine& routine : program.routines)
    chooser.Function({routine.prologue, routine.body, routine.epilogue});
}

void PlaceBraces(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  for (const ir::Routine& routine : program.routines) {
    for (const RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (region.valid()) BracesIn(emittable, region, 0);
    }
  }
}

}  // namespace plcxx::emit::legalize
