// Names what a function calls its own: consts for values, counters of loops.
//
// A const has a number of three digits that its statement's own text says, so that an edit renames no other one's;
// where that is taken, the next one. What is no statement of the source counts from 1. Nothing else of the function may
// have the name: NameTable keeps names of this form out of the program's.

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "transpiler/emit/function_insts.h"
#include "transpiler/emit/legalize/steps.h"
#include "transpiler/ir/builder.h"
#include "transpiler/support/check.h"

namespace plcxx::emit::legalize {
namespace {

struct LocalNamer {
  Emittable& emittable;
  const ir::Program& program;
  std::unordered_map<uint32_t, uint32_t> taken;  // numbers of the function, each with a later one that may be free
  std::unordered_set<std::string> names;         // of the function
  int loop_depth = 0;

  void Function(const Locals& locals, const std::vector<Piece>& pieces);
  void Pieces(const std::vector<Piece>& pieces, ir::StatementId outer);
  void Inst(ir::InstId id, ir::StatementId statement);
  void Loop(ir::InstId id, const ir::Loop& loop, ir::StatementId statement);
  void Region(ir::RegionId region, ir::StatementId statement);
  std::string NextName(ir::StatementId statement);
};

std::string LocalNamer::NextName(ir::StatementId statement) {
  constexpr uint32_t kFirst = 100;
  constexpr uint32_t kNumbers = 900;
  const uint32_t wanted = statement.valid() ? kFirst + program.statements[statement].id % kNumbers : 1;
  uint32_t number = wanted;
  for (auto found = taken.find(number); found != taken.end(); found = taken.find(number)) number = found->second;
  taken[number] = number + 1;
  // Who comes the same way later goes on after this one at once.
  for (uint32_t passed = wanted; passed != number;) passed = std::exchange(taken[passed], number + 1);
  return "t" + std::to_string(number);
}

void LocalNamer::Region(ir::RegionId region, ir::StatementId statement) {
  if (region.valid()) Pieces(PiecesOf(emittable, region), statement);
}

void LocalNamer::Loop(ir::InstId id, const ir::Loop& loop, ir::StatementId statement) {
  const bool counts = loop.kind != ir::LoopBound::kBudget;
  if (loop.kind == ir::LoopBound::kGuard) {
    emittable.landings[id.index].counter = "round" + (loop_depth == 0 ? "" : std::to_string(loop_depth + 1));
  }
  loop_depth += counts ? 1 : 0;
  Region(loop.condition, statement);
  Region(loop.exhausted, statement);
  Region(loop.body, statement);
  loop_depth -= counts ? 1 : 0;
}

void LocalNamer::Inst(ir::InstId id, ir::StatementId statement) {
  const ir::Inst& inst = program[id];
  if (emittable.forms[id.index] == Form::kLocal) {
    std::string& name = emittable.value_names[id.index];
    name = NextName(statement);
    PLCXX_CHECK(names.insert(name).second);
  }
  if (inst.op == ir::OpKind::kLoop) {
    Loop(id, program.loops[ir::LoopId(inst.payload)], statement);
    return;
  }
  for (const ir::RegionId owned : ir::OwnedRegions(program, inst)) Region(owned, statement);
}

void LocalNamer::Pieces(const std::vector<Piece>& pieces, ir::StatementId outer) {
  for (const Piece& piece : pieces) {
    if (piece.chunk != Piece::kInPlace) continue;
    ir::StatementId statement = outer;
    for (uint32_t i = piece.begin; i < piece.end; ++i) {
      const ir::InstId id = program.regions[piece.region].insts[i];
      if (program[id].op == ir::OpKind::kStatement) statement = ir::StatementId(program[id].payload);
      Inst(id, statement);
    }
  }
}

void LocalNamer::Function(const Locals& locals, const std::vector<Piece>& pieces) {
  taken.clear();
  names.clear();
  for (const Parameter& parameter : locals.parameters) PLCXX_CHECK(names.insert(parameter.name).second);
  for (const Locals::Declared& local : locals.declared)
    PLCXX_CHECK(names.insert(emittable.place_names[local.place.index]).second);
  Pieces(pieces, {});
}

}  // namespace

void NameLocals(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  emittable.value_names.resize(program.insts.size());
  LocalNamer namer{.emittable = emittable, .program = program, .taken = {}, .names = {}};
  for (const Chunk& chunk : emittable.chunks) namer.Function(chunk.locals, {PieceOf(chunk)});
  for (uint32_t i = 0; i < program.routines.size(); ++i)
    namer.Function(emittable.routine_locals[i], PiecesOf(emittable, ir::RoutineId(i)));
}

}  // namespace plcxx::emit::legalize
