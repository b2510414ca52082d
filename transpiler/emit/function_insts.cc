#include "transpiler/emit/function_insts.h"

#include <algorithm>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/uses.h"

namespace plcxx::emit {

std::vector<Piece> PiecesOf(const Emittable& emittable, ir::RegionId region) {
  std::vector<Piece> pieces;
  uint32_t at = 0;
  const auto in_place = [&](uint32_t end) {
    if (at < end) pieces.push_back({region, at, end});
  };
  for (const uint32_t index : emittable.region_chunks[region.index]) {
    const Chunk& chunk = emittable.chunks[index];
    in_place(chunk.begin);
    pieces.push_back({region, chunk.begin, chunk.end, index});
    at = chunk.end;
  }
  in_place(static_cast<uint32_t>(emittable.program->regions[region].insts.size()));
  return pieces;
}

std::vector<Piece> PiecesOf(const Emittable& emittable, ir::RoutineId routine) {
  const ir::Routine& of = emittable.program->routines[routine];
  std::vector<Piece> pieces;
  for (const ir::RegionId region : {of.prologue, of.body, of.epilogue}) {
    if (!region.valid()) continue;
    const std::vector<Piece> more = PiecesOf(emittable, region);
    pieces.insert(pieces.end(), more.begin(), more.end());
  }
  return pieces;
}

Piece PieceOf(const Chunk& chunk) { return {chunk.region, chunk.begin, chunk.end}; }

ChunkCall CallOf(const Emittable& emittable, uint32_t chunk, uint32_t part) {
  const Chunk& called = emittable.chunks[chunk];
  if (called.part == part) return {called.name, &called.locals};
  const auto run =
      std::ranges::find_if(emittable.runs, [chunk](const ChunkRun& other) { return other.chunks.front() == chunk; });
  return run == emittable.runs.end() ? ChunkCall{} : ChunkCall{run->name, &run->locals};
}

void VisitFunction(const Emittable& emittable, const std::vector<Piece>& pieces, const FunctionVisitor& visitor) {
  const ir::Program& program = *emittable.program;
  for (const Piece& piece : pieces) {
    if (piece.chunk != Piece::kInPlace) {
      visitor.chunk(piece.chunk);
      continue;
    }
    for (uint32_t i = piece.begin; i < piece.end; ++i) {
      const ir::InstId id = program.regions[piece.region].insts[i];
      visitor.inst(id);
      if (!ir::OwnsRegions(program[id])) continue;
      for (const ir::RegionId owned : ir::OwnedRegions(program, program[id]))
        VisitFunction(emittable, PiecesOf(emittable, owned), visitor);
    }
  }
}

}  // namespace plcxx::emit
