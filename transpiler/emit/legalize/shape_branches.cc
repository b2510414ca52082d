// Decides how branches are written: chains of else-if, the ends of a switch's arms, the heads and ends of loops; and,
// in the debug flavour, where the text asks whether a statement is switched on.
//
//   if c { ... } else { stmt s2; if d { ... } }   ->   if (c) { ... } else if (d) { ... }
//   debug: stmt s1 (3); store a, %0               ->   if (m.on(3)) { m[a] = ...; }
//   debug: stmt s1 (3), from a jump: if c { ... } ->   if (m.on(3) && c) { ... }
//
// A function is visited in the order of its text, for in the debug flavour what an instruction asks depends on what
// the text around it has asked already.

#include <algorithm>

#include "transpiler/emit/function_insts.h"
#include "transpiler/emit/legalize/ends.h"
#include "transpiler/emit/legalize/steps.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/uses.h"

namespace plcxx::emit::legalize {
namespace {

using ir::InstId;
using ir::RegionId;
using ir::StatementId;

ir::IfOrigin OriginOf(const ir::Inst& inst) { return static_cast<ir::IfOrigin>(inst.payload); }

struct Shaper {
  Emittable& emittable;
  const ir::Program& program;
  StatementId statement;  // that the text is of
  bool switched = false;  // it is inside of that statement's guard

  bool debug() const { return emittable.options.flavour == Flavour::kDebug; }
  bool IsSwitchable() const;
  void Ask(InstId id, Switch::Joint joint);
  void Pieces(const std::vector<Piece>& pieces);
  void Region(RegionId region);
  void Range(RegionId region, uint32_t begin, uint32_t end);
  void Segment(RegionId region, uint32_t begin, uint32_t end);
  void OpenSegment(RegionId region, uint32_t begin, uint32_t end);
  bool HoldsOthers(InstId id) const;
  bool SpellsEffect(InstId id) const;
  void Inst(InstId id);
  void Line(InstId id);
  void If(InstId id);
  void Condition(InstId id);
  ElseArm ArmOf(InstId id) const;
  void SwitchArms(const ir::Inst& inst);
  ArmEnd EndOf(const ir::SwitchCase& arm) const;
  void Loop(InstId id, const ir::Loop& loop);
  bool IsOneExpression(RegionId region) const;
};

/// What follows is not yet inside of its statement's guard, and has to be.
bool Shaper::IsSwitchable() const {
  if (!debug() || !statement.valid() || switched) return false;
  const ir::Statement& of = program.statements[statement];
  return !of.opens_block && !of.closes_block;
}

void Shaper::Ask(InstId id, Switch::Joint joint) { emittable.switches[id.index] = {joint, statement}; }

/// Whether switching the statement off leaves other statements in its regions on: they were put there by a jump.
bool Shaper::HoldsOthers(InstId id) const {
  const ir::Inst& inst = program[id];
  if (inst.op == ir::OpKind::kBlock) return true;
  if (inst.op == ir::OpKind::kLoop) return program.loops[ir::LoopId(inst.payload)].kind == ir::LoopBound::kBudget;
  return inst.op == ir::OpKind::kIf && OriginOf(inst) != ir::IfOrigin::kSource;
}

/// Whether an effect is in the text of a value.
bool Shaper::SpellsEffect(InstId id) const {
  if (IsEffect(emittable, id)) return true;
  bool spells = false;
  ir::ForEachUse(program, program[id], [&](uint32_t word) {
    spells = spells || (emittable.forms[word] == Form::kInside && SpellsEffect(InstId(word)));
  });
  return spells;
}

void Shaper::Condition(InstId id) {
  if (!debug() || !statement.valid()) return;
  switch (program.statements[statement].opens_block ? ir::IfOrigin::kSource : OriginOf(program[id])) {
    case ir::IfOrigin::kSource:
      Ask(id, Switch::Joint::kAnd);
      return;
    case ir::IfOrigin::kJumps:
      if (IsSwitchable()) Ask(id, Switch::Joint::kOnlyIfOn);
      return;
    case ir::IfOrigin::kStays:
      if (IsSwitchable()) Ask(id, Switch::Joint::kUnlessOff);
      return;
  }
}

/// A chain goes on with an If that is all of the arm, and whose condition needs no line of its own.
ElseArm Shaper::ArmOf(InstId id) const {
  const RegionId otherwise(program[id].c);
  if (!otherwise.valid() || program.regions[otherwise].insts.empty()) return {};
  if (const auto early = emittable.early_leaves.find(id.index); early != emittable.early_leaves.end()) {
    const bool goes_on = EndIsReached(emittable, RegionId(program[id].b));
    return {ElseArm::Kind::kBehind, {}, {}, goes_on ? early->second : Leave::kFallsThrough};
  }
  const ElseArm block{ElseArm::Kind::kBlock, {}, {}};
  const std::vector<InstId>& insts = program.regions[otherwise].insts;
  const InstId last = insts.back();
  if (program[last].op != ir::OpKind::kIf || emittable.forms[last.index] != Form::kLine) return block;
  if (emittable.early_leaves.contains(last.index)) return block;
  if (!emittable.region_chunks[otherwise.index].empty()) return block;
  ElseArm arm{ElseArm::Kind::kIf, last, {}};
  for (size_t i = 0; i + 1 < insts.size(); ++i) {
    const ir::Inst& other = program[insts[i]];
    if (other.op == ir::OpKind::kStatement && i == 0) {
      arm.statement = StatementId(other.payload);
    } else if (IsEffect(emittable, insts[i]) || other.op == ir::OpKind::kStatement ||
               emittable.forms[insts[i].index] == Form::kLocal) {
      return block;
    }
  }
  // Switched off, both arms of a plain If are off, which a chain cannot say; the head of a block is just false.
  const StatementId own = arm.statement.valid() ? arm.statement : statement;
  const bool head = !own.valid() || program.statements[own].opens_block;
  const bool plain = OriginOf(program[last]) == ir::IfOrigin::kSource;
  if (debug() && !head && plain && (arm.statement.valid() || !switched)) return block;
  const ir::Inst& condition = program[ir::ValueId(program[last].a)];
  const bool always =
      condition.op == ir::OpKind::kConst && ir::ConstantValue(condition) != 0 && !RegionId(program[last].c).valid();
  if (always && !debug()) arm.kind = ElseArm::Kind::kAlways;
  return arm;
}

void Shaper::If(InstId id) {
  const StatementId outer = statement;
  const bool outer_switched = switched;
  for (InstId at = id; at.valid();) {
    Condition(at);
    Region(RegionId(program[at].b));
    const ElseArm arm = ArmOf(at);
    emittable.else_arms[at.index] = arm;
    if (arm.kind == ElseArm::Kind::kBlock || arm.kind == ElseArm::Kind::kBehind) Region(RegionId(program[at].c));
    if (arm.statement.valid()) {
      statement = arm.statement;
      switched = false;
    }
    at = arm.chained;
  }
  statement = outer;
  switched = outer_switched;
}

ArmEnd Shaper::EndOf(const ir::SwitchCase& arm) const {
  if (arm.falls_through) return ArmEnd::kFallsThrough;
  const std::vector<InstId>& insts = program.regions[arm.region].insts;
  if (debug() || insts.empty()) return ArmEnd::kBreak;
  const ir::Inst& last = program[insts.back()];
  if (last.op != ir::OpKind::kExit || ir::ValueId(last.a).valid()) return ArmEnd::kBreak;
  return emittable.leaves.at(insts.back().index) == Leave::kFallsThrough ? ArmEnd::kBreak : ArmEnd::kLeaves;
}

void Shaper::SwitchArms(const ir::Inst& inst) {
  const ir::SwitchId id(inst.payload);
  for (const ir::SwitchCase& arm : program.switches[id].cases) {
    emittable.arm_ends[id.index].push_back(EndOf(arm));
    Region(arm.region);
  }
}

/// Whether all of the list is in the text of its last value.
bool Shaper::IsOneExpression(RegionId region) const {
  return std::ranges::all_of(program.regions[region].insts, [this](InstId id) {
    const ir::Shape shape = ir::Info(program[id].op).shape;
    const bool value = shape == ir::Shape::kConst || shape == ir::Shape::kPure || shape == ir::Shape::kLoad;
    return value && emittable.forms[id.index] != Form::kLocal;
  });
}

void Shaper::Loop(InstId id, const ir::Loop& loop) {
  Landing& landing = emittable.landings[id.index];
  if (loop.kind == ir::LoopBound::kBudget) {
    landing.ends_with_break = debug() || EndIsReached(emittable, loop.body);
    Region(loop.body);
    return;
  }
  if (loop.condition.valid()) {
    landing.condition_in_head = IsOneExpression(loop.condition);
    if (debug() && statement.valid()) Ask(id, Switch::Joint::kLoop);
    if (!landing.condition_in_head)
      Range(loop.condition, 0, static_cast<uint32_t>(program.regions[loop.condition].insts.size()));
  }
  if (loop.exhausted.valid()) Region(loop.exhausted);
  Region(loop.body);
}

/// An instruction that has lines of its own.
void Shaper::Line(InstId id) {
  const ir::Inst& inst = program[id];
  if (inst.op == ir::OpKind::kIf) {
    If(id);
  } else if (inst.op == ir::OpKind::kSwitch) {
    SwitchArms(inst);
  } else if (inst.op == ir::OpKind::kLoop) {
    Loop(id, program.loops[ir::LoopId(inst.payload)]);
  } else {
    for (const RegionId owned : ir::OwnedRegions(program, inst)) Region(owned);
  }
}

void Shaper::Inst(InstId id) {
  switch (emittable.forms[id.index]) {
    case Form::kNowhere:
      for (const RegionId owned : ir::OwnedRegions(program, program[id])) Region(owned);
      return;
    case Form::kInside:
      return;
    case Form::kLocal:
      if (IsSwitchable() && SpellsEffect(id)) Ask(id, Switch::Joint::kValue);
      return;
    case Form::kLine:
      Line(id);
      return;
  }
}

/// Of a statement that may be switched off while others in its regions are not: only its own lines are guarded.
void Shaper::OpenSegment(RegionId region, uint32_t begin, uint32_t end) {
  const std::vector<InstId>& insts = program.regions[region].insts;
  std::vector<Guard>& guards = emittable.guards[region.index];
  const auto close = [&](uint32_t at) {
    if (switched) guards.back().end = at;
    switched = false;
  };
  for (uint32_t i = begin; i < end; ++i) {
    const Form form = emittable.forms[insts[i].index];
    if (form == Form::kLocal || (form == Form::kLine && HoldsOthers(insts[i]))) close(i);
    if (form == Form::kLine && !HoldsOthers(insts[i]) && !switched) {
      guards.push_back({i, i, statement});
      switched = true;
    }
    Inst(insts[i]);
  }
  close(end);
}

/// Instructions of one statement.
void Shaper::Segment(RegionId region, uint32_t begin, uint32_t end) {
  const std::vector<InstId>& insts = program.regions[region].insts;
  const bool switchable = IsSwitchable();
  if (switchable &&
      std::any_of(insts.begin() + begin, insts.begin() + end, [this](InstId id) { return HoldsOthers(id); })) {
    OpenSegment(region, begin, end);
    return;
  }
  if (switchable) {
    emittable.guards[region.index].push_back({begin, end, statement});
    switched = true;
  }
  for (uint32_t i = begin; i < end; ++i) Inst(insts[i]);
  if (switchable) switched = false;
}

void Shaper::Range(RegionId region, uint32_t begin, uint32_t end) {
  const StatementId outer = statement;
  const bool outer_switched = switched;
  const std::vector<InstId>& insts = program.regions[region].insts;
  for (uint32_t i = begin; i < end;) {
    if (program[insts[i]].op == ir::OpKind::kStatement) {
      statement = StatementId(program[insts[i]].payload);
      switched = false;
      ++i;
    }
    uint32_t stop = i;
    while (stop < end && program[insts[stop]].op != ir::OpKind::kStatement) ++stop;
    Segment(region, i, stop);
    i = stop;
  }
  statement = outer;
  switched = outer_switched;
}

void Shaper::Pieces(const std::vector<Piece>& pieces) {
  for (const Piece& piece : pieces)
    if (piece.chunk == Piece::kInPlace) Range(piece.region, piece.begin, piece.end);
}

void Shaper::Region(RegionId region) { Pieces(PiecesOf(emittable, region)); }

}  // namespace

void ShapeBranches(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  emittable.arm_ends.resize(program.switches.size());
  emittable.guards.resize(program.regions.size());
  Shaper shaper{.emittable = emittable, .program = program, .statement = {}};
  for (const Chunk& chunk : emittable.chunks) shaper.Pieces({PieceOf(chunk)});
  for (uint32_t i = 0; i < program.routines.size(); ++i) shaper.Pieces(PiecesOf(emittable, ir::RoutineId(i)));
  for (std::vector<Guard>& guards : emittable.guards) {
    std::ranges::stable_sort(guards, {}, &Guard::begin);
  }
}

}  // namespace plcxx::emit::legalize
