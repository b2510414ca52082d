// Which instructions the text of a generated function holds: its lists without what was cut out of them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "transpiler/emit/emittable.h"

namespace plcxx::emit {

/// Instructions [begin, end) of a list that are text in one function; or, of a list, the call of what was cut out.
struct Piece {
  static constexpr uint32_t kInPlace = 0xFFFFFFFF;
  ir::RegionId region;
  uint32_t begin = 0, end = 0;
  uint32_t chunk = kInPlace;  // else an index into Emittable::chunks
};

/// A list as its own function has it.
std::vector<Piece> PiecesOf(const Emittable& emittable, ir::RegionId region);
/// The same of a whole function: all parts of a routine.
std::vector<Piece> PiecesOf(const Emittable& emittable, ir::RoutineId routine);
Piece PieceOf(const Chunk& chunk);

/// The line that stands where the chunk was cut out, in the file `part`.
struct ChunkCall {
  std::string name;  // of the chunk, or of the run that begins with it; empty: the call of a run covers it
  const Locals* locals = nullptr;
};
ChunkCall CallOf(const Emittable& emittable, uint32_t chunk, uint32_t part);

/// What the text of a function consists of, in the order of the lists.
struct FunctionVisitor {
  std::function<void(ir::InstId)> inst;
  std::function<void(uint32_t)> chunk;  // a call of one
};
void VisitFunction(const Emittable& emittable, const std::vector<Piece>& pieces, const FunctionVisitor& visitor);

}  // namespace plcxx::emit
