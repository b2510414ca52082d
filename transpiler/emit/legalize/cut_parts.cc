// Spreads long programs over several files: chunks of the partitions, and subroutines with all that was cut out of
// them.
//
//   chunks of slow, subroutines   ->   program.cpp: slow calls run_slow_U4A8, ...; program_slow_U4A8.cpp: a run of
//   chunks
//
// The partitions themselves stay in the first file, with the state's values at power-on.

#include <algorithm>
#include <utility>
#include <vector>

#include "transpiler/emit/function_insts.h"
#include "transpiler/emit/legalize/content_borders.h"
#include "transpiler/emit/legalize/steps.h"
#include "transpiler/ir/builder.h"

namespace plcxx::emit::legalize {
namespace {

constexpr BorderLimits kPerPart = {.least = 750, .most = 3000};  // statements of a file
constexpr uint32_t kOneFile = 3000;                              // up to so many statements the program is one file
constexpr uint32_t kPartSeed = 1;  // not the chunks' own order: their borders are the least in that

/// What goes into a file as a whole.
struct Unit {
  static constexpr uint32_t kNoChunk = 0xFFFFFFFF;
  uint32_t chunk = kNoChunk;  // index into the chunks; else the whole routine
  ir::RoutineId routine;
  uint32_t statements = 0;
  uint32_t hash = 0;
};

uint32_t HashOf(const std::string& name) {
  uint32_t hash = 0;
  for (const char c : name) hash = hash * 31 + static_cast<unsigned char>(c);
  return hash;
}

uint32_t StatementsOf(const ir::Program& program, const ir::Routine& routine) {
  uint32_t count = 0;
  for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
    if (!region.valid()) continue;
    ir::ForEachInst(program, region, [&](ir::InstId id) { count += program[id].op == ir::OpKind::kStatement ? 1 : 0; });
  }
  return count;
}

/// In the order of the program.
std::vector<Unit> UnitsOf(const Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  std::vector<Unit> units;
  size_t next = 0;  // chunk
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::RoutineId id(i);
    const bool whole = program.routines[id].kind == ir::RoutineKind::kSubroutine;
    if (whole) {
      units.push_back({.routine = id,
                       .statements = std::max(1u, StatementsOf(program, program.routines[id])),
                       .hash = HashOf(emittable.routine_names[i])});
    }
    for (; next < emittable.chunks.size() && emittable.chunks[next].routine == id; ++next) {
      const Chunk& chunk = emittable.chunks[next];
      if (whole || chunk.parent != Chunk::kNoParent) continue;
      units.push_back({static_cast<uint32_t>(next), id, chunk.statements, chunk.last_id});
    }
  }
  for (Unit& unit : units) unit.hash = SpreadHash(unit.hash, kPartSeed);
  return units;
}

uint32_t Total(const std::vector<Unit>& units) {
  uint32_t total = 0;
  for (const Unit& unit : units) total += unit.statements;
  return total;
}

void Put(Emittable& emittable, const Unit& unit, uint32_t part) {
  if (unit.chunk != Unit::kNoChunk) {
    emittable.chunks[unit.chunk].part = part;
    return;
  }
  emittable.routine_parts[unit.routine.index] = part;
}

void MakeParts(Emittable& emittable) {
  const std::vector<Unit> units = UnitsOf(emittable);
  if (Total(units) <= kOneFile) return;
  std::vector<BorderCandidate> candidates;
  for (const Unit& unit : units) candidates.push_back({unit.statements, unit.hash, true});
  const std::vector<size_t> borders = ContentBorders(candidates, kPerPart);
  size_t border = 0;
  for (size_t i = 0; i < units.size(); ++i) {
    const bool first = i == 0 || (border < borders.size() && i == borders[border] + 1);
    if (first) {
      if (i > 0) ++border;
      const Unit& unit = units[i];
      emittable.parts.push_back({"_" + (unit.chunk != Unit::kNoChunk ? emittable.chunks[unit.chunk].name
                                                                     : emittable.routine_names[unit.routine.index])});
    }
    Put(emittable, units[i], static_cast<uint32_t>(emittable.parts.size() - 1));
  }
}

/// The borders are after the units with the least hashes, some distance from each other: which ones these are depends
/// on their own contents, so that an edit moves at most the border that it touches.
void MakeFixedParts(Emittable& emittable) {
  const std::vector<Unit> units = UnitsOf(emittable);
  struct Candidate {
    uint32_t hash, behind;  // so many statements stand before it
    size_t unit;            // the first one of the next file
  };
  std::vector<Candidate> candidates;
  uint32_t behind = 0;
  for (size_t i = 0; i < units.size(); ++i) {
    if (i > 0) candidates.push_back({units[i - 1].hash, behind, i});
    behind += units[i].statements;
  }
  const uint32_t total = behind;
  std::ranges::sort(candidates, {}, [](const Candidate& c) { return std::pair(c.hash, c.unit); });
  const uint32_t distance = total / (3 * emittable.options.parts);
  std::vector<Candidate> borders;
  for (const Candidate& candidate : candidates) {
    if (borders.size() + 1 == emittable.options.parts) break;
    const auto near = [&](uint32_t at) {
      return (candidate.behind < at ? at - candidate.behind : candidate.behind - at) < distance;
    };
    if (near(0) || near(total)) continue;
    if (std::ranges::none_of(borders, [&](const Candidate& border) { return near(border.behind); }))
      borders.push_back(candidate);
  }
  std::ranges::sort(borders, {}, &Candidate::unit);
  // The first units are functions of the partitions' own file.
  uint32_t part = 0;
  for (size_t i = 0; i < units.size(); ++i) {
    if (part < borders.size() && i == borders[part].unit) ++part;
    Put(emittable, units[i], part);
  }
  for (uint32_t number = 2; number <= emittable.options.parts; ++number)
    emittable.parts.push_back({"_" + std::to_string(number)});
}

/// Neighbours of one file are called by one function, and a chunk stands in the file of what it was cut out of.
void CallInRuns(Emittable& emittable) {
  std::vector<Chunk>& chunks = emittable.chunks;
  const Chunk* previous = nullptr;
  for (uint32_t index = 0; index < chunks.size(); ++index) {
    Chunk& chunk = chunks[index];
    if (chunk.parent != Chunk::kNoParent) continue;
    if (emittable.program->routines[chunk.routine].kind == ir::RoutineKind::kSubroutine) {
      chunk.part = emittable.routine_parts[chunk.routine.index];
      continue;
    }
    const bool follows = previous != nullptr && previous->region == chunk.region && previous->end == chunk.begin;
    if (chunk.part != 0) {
      if (!follows || chunk.part != previous->part) emittable.runs.push_back({"run_" + chunk.name, chunk.part, {}, {}});
      emittable.runs.back().chunks.push_back(index);
    }
    previous = &chunk;
  }
  for (uint32_t index = static_cast<uint32_t>(chunks.size()); index-- > 0;) {
    if (chunks[index].parent != Chunk::kNoParent) chunks[index].part = chunks[chunks[index].parent].part;
  }
}

}  // namespace

void CutParts(Emittable& emittable) {
  emittable.parts.push_back({});
  emittable.routine_parts.assign(emittable.program->routines.size(), 0);
  if (emittable.options.parts == 0) MakeParts(emittable);
  if (emittable.options.parts > 1) MakeFixedParts(emittable);
  CallInRuns(emittable);
}

void FindCalledSubroutines(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  for (Part& part : emittable.parts) part.called.assign(program.routines.size(), false);
  const auto note = [&](uint32_t part, ir::RoutineId routine, const std::vector<Piece>& pieces) {
    const bool is_printed = IsPrinted(program.routines[routine], emittable.options);
    if (!is_printed) return;
    VisitFunction(emittable, pieces,
                  {.inst =
                       [&](ir::InstId id) {
                         const ir::Inst& inst = program[id];
                         if (inst.op != ir::OpKind::kCall) return;
                         const ir::RoutineId callee = program.calls[ir::CallId(inst.payload)].routine;
                         if (SharesLocals(program.routines[callee].kind))
                           emittable.parts[part].called[callee.index] = true;
                       },
                   .chunk = [](uint32_t) {}});
  };
  for (const Chunk& chunk : emittable.chunks) note(chunk.part, chunk.routine, {PieceOf(chunk)});
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::RoutineId id(i);
    note(emittable.routine_parts[i], id, PiecesOf(emittable, id));
  }
}

}  // namespace plcxx::emit::legalize
