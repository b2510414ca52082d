#include "transpiler/emit/legalize/ends.h"

namespace plcxx::emit::legalize {
namespace {

using ir::InstId;
using ir::RegionId;

bool HasText(const Emittable& emittable, InstId id) {
  const Form form = emittable.forms[id.index];
  return form == Form::kLine || form == Form::kLocal;
}

/// Whether control gets after an instruction that is the last one with text.
bool IsPassed(const Emittable& emittable, InstId id) {
  const ir::Inst& inst = (*emittable.program)[id];
  const bool always = !ir::ValueId(inst.a).valid();
  if (inst.op == ir::OpKind::kStore) return !emittable.returns.contains(id.index);
  if (inst.op == ir::OpKind::kExit) return !always || emittable.leaves.at(id.index) == Leave::kFallsThrough;
  if (inst.op == ir::OpKind::kRepeat)
    return !always || !RegionId(inst.b).valid() || EndIsReached(emittable, RegionId(inst.b));
  if (inst.op == ir::OpKind::kIf) {
    return !RegionId(inst.c).valid() || EndIsReached(emittable, RegionId(inst.c)) ||
           (!emittable.early_leaves.contains(id.index) && EndIsReached(emittable, RegionId(inst.b)));
  }
  if (inst.op != ir::OpKind::kBlock) return true;
  const auto landing = emittable.landings.find(id.index);
  const bool is_landed_at = landing != emittable.landings.end() && !landing->second.behind.empty();
  return is_landed_at || EndIsReached(emittable, RegionId(inst.a));
}

}  // namespace

bool EndIsReached(const Emittable& emittable, const std::vector<Piece>& pieces) {
  if (pieces.empty() || pieces.back().chunk != Piece::kInPlace) return true;
  const Piece& piece = pieces.back();
  const std::vector<InstId>& insts = emittable.program->regions[piece.region].insts;
  for (uint32_t i = piece.end; i-- > piece.begin;) {
    if ((*emittable.program)[insts[i]].op != ir::OpKind::kStatement && HasText(emittable, insts[i]))
      return IsPassed(emittable, insts[i]);
  }
  return true;
}

bool EndIsReached(const Emittable& emittable, RegionId region) {
  return EndIsReached(emittable, PiecesOf(emittable, region));
}

}  // namespace plcxx::emit::legalize
