// Decides where the text says each instruction: on lines of its own, inside another line, as a named const, nowhere.
//
//   %1 = call S; exit @1 if %1   ->   if (S(m, host)) return;       one line spells both
//   %1 = call S; %2 = load a;    ->   const bool t1 = S(m, host);   what the local reads is read after the call
//   exit @1 if %1; store b, %2 ...    const bool t2 = m[a]; ...
//   %1 = call S; exit @1 if %1   ->   S(m, host);                   where @1 ends here and the exit leads nowhere else
//
//   store a, (load a); if %1 { }   ->   nothing: what would change nothing has no text but its statements' comments
//
// An effect happens where its text is. So it is spelled inside another line only when that line is the next one after
// it; and when no line asks for its value, it is a line itself. The lists are read backwards: who asks is known first.

#include <algorithm>
#include <ranges>

#include "transpiler/emit/legalize/steps.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/uses.h"

namespace plcxx::emit::legalize {
namespace {

using ir::Inst;
using ir::InstId;

bool ChangesNothing(const Emittable& emittable, InstId id);

struct EffectPlacer {
  Emittable& emittable;
  const ir::Program& program;
  std::vector<InstId> asks;  // by InstId: the line that the value is spelled in; none: nothing asks for it
  InstId next;               // the next line of the text

  void Region(ir::RegionId region);
  void Place(InstId id);
  void Value(InstId id);
  void Result(InstId id);
  void Line(InstId id, Form form);
  void Ask(InstId user, InstId line);
  void Loop(InstId id);
  void Step(ir::RegionId region, InstId loop);
};

/// What `user` is computed from is spelled in `line`.
void EffectPlacer::Ask(InstId user, InstId line) {
  ir::ForEachUse(program, program[user], [&](uint32_t word) { asks[word] = line; });
}

void EffectPlacer::Line(InstId id, Form form) {
  emittable.forms[id.index] = form;
  Ask(id, id);
  next = id;
}

/// A value without effect.
void EffectPlacer::Value(InstId id) {
  Form& form = emittable.forms[id.index];
  if (!asks[id.index].valid()) {
    form = Form::kNowhere;
  } else if (form == Form::kLocal) {
    Line(id, form);
  } else {
    form = Form::kInside;
    Ask(id, asks[id.index]);
  }
}

/// What may have an effect and a value.
void EffectPlacer::Result(InstId id) {
  Form& form = emittable.forms[id.index];
  if (!asks[id.index].valid()) {
    Line(id, Form::kLine);
  } else if (form == Form::kLocal || asks[id.index] != next) {
    Line(id, Form::kLocal);
  } else {
    form = Form::kInside;
    Ask(id, asks[id.index]);
  }
}

/// All of it is in the head of the loop: a value that is used twice is spelled twice there.
void EffectPlacer::Step(ir::RegionId region, InstId loop) {
  if (!region.valid()) return;
  for (const InstId id : program.regions[region].insts) {
    const bool store = ir::Info(program[id].op).shape == ir::Shape::kStore;
    emittable.forms[id.index] = store ? Form::kLine : Form::kInside;
    Ask(id, loop);
  }
}

void EffectPlacer::Loop(InstId id) {
  const ir::Loop& loop = program.loops[ir::LoopId(program[id].payload)];
  Region(loop.body);
  Region(loop.exhausted);
  if (loop.condition.valid()) {
    // The loop itself asks for the last value, in its head or on the line after the others.
    asks[program.regions[loop.condition].insts.back().index] = id;
    next = id;
    Region(loop.condition);
  }
  Line(id, Form::kLine);
  Step(loop.step, id);
}

void EffectPlacer::Place(InstId id) {
  const Inst& inst = program[id];
  switch (ir::Info(inst.op).shape) {
    case ir::Shape::kConst:
      emittable.forms[id.index] = Form::kInside;
      return;
    case ir::Shape::kStatement:
      emittable.forms[id.index] = Form::kLine;
      return;
    case ir::Shape::kPure:
    case ir::Shape::kLoad:
      Value(id);
      return;
    case ir::Shape::kStep:
    case ir::Shape::kCall:
    case ir::Shape::kHostCall:
      Result(id);
      return;
    case ir::Shape::kLoop:
      Loop(id);
      return;
    case ir::Shape::kBlock:  // has no line that does anything
      emittable.forms[id.index] = Form::kLine;
      Region(ir::RegionId(inst.a));
      return;
    case ir::Shape::kStore:
    case ir::Shape::kText:
    case ir::Shape::kIf:
    case ir::Shape::kSwitch:
    case ir::Shape::kExit:
    case ir::Shape::kRepeat:
      for (const ir::RegionId owned : std::views::reverse(ir::OwnedRegions(program, inst))) Region(owned);
      if (ChangesNothing(emittable, id)) {
        emittable.forms[id.index] = Form::kNowhere;
        emittable.changes_nothing[id.index] = true;
      } else {
        Line(id, Form::kLine);
      }
      return;
    case ir::Shape::kJump:
    case ir::Shape::kLabel:
      return;  // structured programs have none
  }
}

void EffectPlacer::Region(ir::RegionId region) {
  if (!region.valid()) return;
  for (const InstId id : std::views::reverse(program.regions[region].insts)) Place(id);
}

/// `m[X] = m[X];`
bool StoresWhatIsThere(const Emittable& emittable, const Inst& store) {
  const ir::Program& program = *emittable.program;
  const Inst& value = program[ir::ValueId(store.a)];
  const ir::PlaceId place(store.payload);
  // A local's store stays: with it, the local might lose its only use.
  return value.op == ir::OpKind::kLoad && value.payload == store.payload && !program.places[place].indexed &&
         emittable.forms[store.a] != Form::kLocal &&
         emittable.layout.places[place.index].storage != layout::Storage::kLocal;
}

bool HoldsNothing(const Emittable& emittable, ir::RegionId region) {
  if (!region.valid()) return true;
  return std::ranges::all_of(emittable.program->regions[region].insts, [&](InstId id) {
    return emittable.forms[id.index] != Form::kLocal && (!IsEffect(emittable, id) || ChangesNothing(emittable, id));
  });
}

/// Whether it is an instruction with an effect (IsEffect) whose text would do nothing: it has none.
bool ChangesNothing(const Emittable& emittable, ir::InstId id) {
  const Inst& inst = (*emittable.program)[id];
  // An exit to what follows anyway.
  if (inst.op == ir::OpKind::kExit) return emittable.leaves.at(id.index) == Leave::kFallsThrough;
  if (inst.op == ir::OpKind::kStore) return StoresWhatIsThere(emittable, inst);
  return inst.op == ir::OpKind::kIf && HoldsNothing(emittable, ir::RegionId(inst.b)) &&
         HoldsNothing(emittable, ir::RegionId(inst.c));
}

}  // namespace

void PlaceEffects(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  emittable.changes_nothing.assign(program.insts.size(), false);
  EffectPlacer placer{
      .emittable = emittable, .program = program, .asks = std::vector<InstId>(program.insts.size()), .next = {}};
  for (const ir::Routine& routine : program.routines) {
    for (const ir::RegionId region : {routine.epilogue, routine.body, routine.prologue}) placer.Region(region);
  }
}

}  // namespace plcxx::emit::legalize
