#include "transpiler/prove/verify/entry_reads.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "transpiler/ir/accesses.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/uses.h"

namespace plcxx::prove::verify {

void EntryReads::Written::Add(execute::CellId cell) {
  if (is_written[cell.index]) return;
  is_written[cell.index] = true;
  cells.push_back(cell);
}

std::vector<execute::CellId> EntryReads::Written::TakeBack(size_t count) {
  std::vector<execute::CellId> taken(cells.begin() + static_cast<std::ptrdiff_t>(count), cells.end());
  for (const execute::CellId cell : taken) is_written[cell.index] = false;
  cells.resize(count);
  return taken;
}

void EntryReads::Read(Walked& walked, execute::CellId cell) const {
  if (!walked.written.is_written[cell.index]) walked.read[cell.index] = true;
}

void EntryReads::ReadAll(Walked& walked, const std::vector<execute::CellId>& cells) const {
  for (const execute::CellId cell : cells) Read(walked, cell);
}

/// What an instruction owns is executed once, not at all or again and again, and may be left from anywhere inside: what
/// it writes counts inside. Of a choice of two ways, what both write counts after it as well.
void EntryReads::Branches(Walked& walked, const ir::Inst& inst) {
  const size_t before = walked.written.cells.size();
  std::vector<std::vector<execute::CellId>> ways;
  for (const ir::RegionId region : ir::OwnedRegions(program_, inst)) {
    Region(walked, region);
    ways.push_back(walked.written.TakeBack(before));
  }
  if (ir::Info(inst.op).shape != ir::Shape::kIf || ways.size() != 2) return;
  for (std::vector<execute::CellId>& way : ways) std::ranges::sort(way);
  std::vector<execute::CellId> both;
  std::ranges::set_intersection(ways[0], ways[1], std::back_inserter(both));
  for (const execute::CellId cell : both) walked.written.Add(cell);
}

void EntryReads::Inst(Walked& walked, const ir::Inst& inst) {
  const ir::Shape shape = ir::Info(inst.op).shape;
  ir::ForEachAccess(
      program_, inst,
      [&](ir::PlaceId id, ir::Access access) {
        const ir::Place& place = program_.places[id];
        const std::vector<execute::CellId> touched = execute::TouchedCells(program_, cells_, place);
        if (access != ir::Access::kWrite) ReadAll(walked, touched);
        // A host function that gives no second result writes none.
        if (access != ir::Access::kWrite || shape != ir::Shape::kStore || !execute::IsInside(program_, place)) return;
        for (const execute::CellId cell : touched) walked.written.Add(cell);
      },
      [&](ir::StateId state) { ReadAll(walked, execute::CellsOfInstance(program_, cells_, state)); });
  if (shape == ir::Shape::kHostCall) {
    const ir::Call& call = program_.calls[ir::CallId(inst.payload)];
    for (const execute::CellId chain : cells_.ChainsOf(call.host, call.exchange)) Read(walked, chain);
  }
  if (shape == ir::Shape::kCall) {
    const Summary& callee = OfRoutine(program_.calls[ir::CallId(inst.payload)].routine);
    for (uint32_t i = 0; i < cells_.count; ++i) {
      if (callee.read[i]) Read(walked, execute::CellId(i));
    }
    for (const execute::CellId cell : callee.written) walked.written.Add(cell);
  }
  if (ir::OwnsRegions(inst)) Branches(walked, inst);
}

void EntryReads::Region(Walked& walked, ir::RegionId region) {
  if (!region.valid()) return;
  for (const ir::InstId id : program_.regions[region].insts) Inst(walked, program_[id]);
}

EntryReads::Summary EntryReads::Walk(const execute::Stretch& part) {
  Walked walked;
  walked.read.resize(cells_.count);
  walked.written.is_written.resize(cells_.count);
  if (part.region.valid()) {
    for (uint32_t i = part.begin; i < part.end; ++i) Inst(walked, program_[program_.regions[part.region].insts[i]]);
  } else {
    const ir::Routine& routine = program_.routines[part.routine];
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) Region(walked, region);
  }
  return {.read = std::move(walked.read), .written = std::move(walked.written.cells)};
}

const EntryReads::Summary& EntryReads::OfRoutine(ir::RoutineId id) {
  if (!routines_[id.index]) routines_[id.index] = Walk({.routine = id, .region = {}});
  return *routines_[id.index];
}

}  // namespace plcxx::prove::verify
