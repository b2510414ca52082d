// Puts the values of a function's own variables where a reader expects them: in the declaration, in the return.
//
//   bool left = false; left = false;      ->   bool left = false;
//   result = i; return result;            ->   return i;
//   if (c) { result = 1; } return result; ->   if (c) { return 1; } return result;
//
// Only what belongs to no statement of the source moves into a declaration. The debug flavour, where a statement may be
// switched off, keeps its assignments.

#include <algorithm>
#include <ranges>

#include "transpiler/emit/function_insts.h"
#include "transpiler/emit/legalize/ends.h"
#include "transpiler/emit/legalize/steps.h"
#include "transpiler/ir/builder.h"

namespace plcxx::emit::legalize {
namespace {

using ir::InstId;
using ir::RegionId;

struct ValuePlacer {
  Emittable& emittable;
  const ir::Program& program;
  ir::RoutineId routine;
  Locals& locals;
  ir::PlaceId result;

  void FirstValues();
  void Returns();
  bool HasText(InstId id) const;
  bool GivesResult(InstId id) const;
  bool Returns(InstId exit) const;
  void ReturnsIn(const std::vector<Piece>& pieces);
  void ReturnsAtEnd(const std::vector<Piece>& pieces);
  bool ReturnsEarly(InstId id) const;
  bool IsAskedFor() const;
};

/// Also the mark of a statement has: its comments.
bool ValuePlacer::HasText(InstId id) const {
  const Form form = emittable.forms[id.index];
  return form == Form::kLine || form == Form::kLocal;
}

/// A store of the result that is an assignment on a line of its own.
bool ValuePlacer::GivesResult(InstId id) const {
  const ir::Inst& inst = program[id];
  return inst.op == ir::OpKind::kStore && inst.payload == result.index && emittable.forms[id.index] == Form::kLine &&
         emittable.wordings[id.index] == Wording::kTable;
}

/// Whether it leaves the function whatever happens.
bool ValuePlacer::Returns(InstId exit) const {
  const ir::Inst& inst = program[exit];
  return inst.op == ir::OpKind::kExit && !ir::ValueId(inst.a).valid() &&
         emittable.leaves.at(exit.index) == Leave::kReturn;
}

/// Assignments of the control's own, before anything else happens.
void ValuePlacer::FirstValues() {
  for (const Piece& piece : PiecesOf(emittable, routine)) {
    if (piece.chunk != Piece::kInPlace) return;
    for (uint32_t i = piece.begin; i < piece.end; ++i) {
      const InstId id = program.regions[piece.region].insts[i];
      const ir::Inst& inst = program[id];
      if (!HasText(id)) continue;
      if (inst.op != ir::OpKind::kStore || program[ir::ValueId(inst.a)].op != ir::OpKind::kConst) return;
      const auto declared = std::ranges::find_if(locals.declared, [&inst](const Locals::Declared& local) {
        return local.place.index == inst.payload && !local.first.valid();
      });
      if (declared == locals.declared.end()) return;
      declared->first = id;
      emittable.forms[id.index] = Form::kInside;
    }
  }
}

/// result = i; return result;
void ValuePlacer::ReturnsIn(const std::vector<Piece>& pieces) {
  for (const Piece& piece : pieces) {
    if (piece.chunk != Piece::kInPlace) continue;
    InstId store;
    for (uint32_t i = piece.begin; i < piece.end; ++i) {
      const InstId id = program.regions[piece.region].insts[i];
      for (const RegionId owned : ir::OwnedRegions(program, program[id])) ReturnsIn(PiecesOf(emittable, owned));
      const auto early = emittable.early_leaves.find(id.index);
      if (early != emittable.early_leaves.end() && early->second == Leave::kReturn)
        ReturnsAtEnd(PiecesOf(emittable, RegionId(program[id].b)));
      if (store.valid() && HasText(id) && Returns(id)) {
        emittable.returns[store.index] = id;
        emittable.forms[id.index] = Form::kInside;
        store = {};
      }
      if (HasText(id)) store = GivesResult(id) ? id : InstId();  // none behind a statement: its comments are between
    }
  }
}

/// What is assigned last of all, in each arm that nothing follows.
void ValuePlacer::ReturnsAtEnd(const std::vector<Piece>& pieces) {
  if (pieces.empty() || pieces.back().chunk != Piece::kInPlace) return;
  const Piece& piece = pieces.back();
  for (uint32_t i = piece.end; i-- > piece.begin;) {
    const InstId id = program.regions[piece.region].insts[i];
    const ir::Inst& inst = program[id];
    if (!HasText(id)) continue;
    if (GivesResult(id)) emittable.returns.try_emplace(id.index);
    if (inst.op == ir::OpKind::kBlock) ReturnsAtEnd(PiecesOf(emittable, RegionId(inst.a)));
    if (inst.op == ir::OpKind::kIf) {
      ReturnsAtEnd(PiecesOf(emittable, RegionId(inst.b)));
      if (RegionId(inst.c).valid()) ReturnsAtEnd(PiecesOf(emittable, RegionId(inst.c)));
    }
    return;
  }
}

/// Whether a line `return result;` ends its first arm.
bool ValuePlacer::ReturnsEarly(InstId id) const {
  const auto early = emittable.early_leaves.find(id.index);
  return early != emittable.early_leaves.end() && early->second == Leave::kReturn &&
         EndIsReached(emittable, RegionId(program[id].b));
}

/// Whether any text names the variable of the result.
bool ValuePlacer::IsAskedFor() const {
  if (emittable.returns_at_end[routine.index]) return true;
  bool asked = false;
  VisitFunction(emittable, PiecesOf(emittable, routine),
                {.inst =
                     [&](InstId id) {
                       const ir::Inst& inst = program[id];
                       const Form form = emittable.forms[id.index];
                       const bool store = inst.op == ir::OpKind::kStore && !emittable.changes_nothing[id.index] &&
                                          !emittable.returns.contains(id.index);
                       const bool load = inst.op == ir::OpKind::kLoad && form != Form::kNowhere;
                       asked = asked || ((store || load) && inst.payload == result.index);
                       asked = asked || (inst.op == ir::OpKind::kExit && form == Form::kLine &&
                                         emittable.leaves.at(id.index) == Leave::kReturn);
                       asked = asked || ReturnsEarly(id);
                       if (inst.op == ir::OpKind::kHostCall)
                         asked = asked || program.calls[ir::CallId(inst.payload)].out == result;
                     },
                 .chunk =
                     [&](uint32_t chunk) {
                       const std::vector<ir::PlaceId>& shared = emittable.chunks[chunk].locals.shared;
                       asked = asked || std::ranges::find(shared, result) != shared.end();
                     }});
  return asked;
}

void ValuePlacer::Returns() {
  const std::vector<Piece> pieces = PiecesOf(emittable, routine);
  ReturnsIn(pieces);
  ReturnsAtEnd(pieces);
  emittable.returns_at_end[routine.index] = EndIsReached(emittable, pieces);
  if (IsAskedFor()) return;
  for (Locals::Declared& local : locals.declared) local.read = local.read && local.place != result;
  std::erase_if(locals.declared,
                [this](const Locals::Declared& local) { return local.place == result && !local.first.valid(); });
}

}  // namespace

void PlaceValues(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  emittable.returns_at_end.assign(program.routines.size(), false);
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::RoutineId id(i);
    ValuePlacer placer{emittable, program, id, emittable.routine_locals[i], program.routines[id].result_place};
    placer.FirstValues();
    if (!placer.result.valid()) continue;
    emittable.returns_at_end[i] = true;
    if (emittable.options.flavour == Flavour::kRelease) placer.Returns();
  }
}

}  // namespace plcxx::emit::legalize
