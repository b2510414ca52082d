#include "transpiler/prove/verify/units.h"

#include <algorithm>

#include "transpiler/ir/accesses.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/uses.h"
#include "transpiler/prove/verify/entry_reads.h"
#include "transpiler/symbolic/execute/host_writes.h"

namespace plcxx::prove::verify {
namespace {

class UnitMaker {
 public:
  UnitMaker(const emit::Emittable& emittable, const execute::Cells& cells)
      : emittable_(emittable), program_(*emittable.program), cells_(cells), entry_reads_(program_, cells) {}

  Units Run();

 private:
  void AddRoutines();
  void AddChunks();
  // What a unit calls: chunks are not looked into.
  void FindCallees(Unit& unit);
  void VisitRegion(Unit& unit, ir::RegionId region);
  void VisitInst(Unit& unit, const ir::Inst& inst);
  static void AddCallee(Unit& unit, UnitId callee);
  // What it may do, calls and chunks included.
  const Footprint& OfRoutine(ir::RoutineId id);
  Footprint OfPart(const execute::Stretch& part);
  void Note(Footprint& footprint, const ir::Inst& inst);
  void NoteRegion(Footprint& footprint, ir::RegionId region);
  void NotePlace(Footprint& footprint, ir::PlaceId id, bool writes) const;
  void NoteInstance(Footprint& footprint, ir::StateId state) const;
  void NoteHost(Footprint& footprint, const ir::Call& call) const;
  void NoteCell(Footprint& footprint, execute::CellId cell, bool writes) const;

  const emit::Emittable& emittable_;
  const ir::Program& program_;
  const execute::Cells& cells_;
  EntryReads entry_reads_;
  Units units_;
  std::vector<Footprint> routines_;  // by RoutineId; empty: not looked at yet
};

void UnitMaker::AddRoutines() {
  units_.of_routines.resize(program_.routines.size());
  for (uint32_t i = 0; i < program_.routines.size(); ++i) {
    const ir::RoutineId id(i);
    const ir::Routine& routine = program_.routines[id];
    if (routine.simulation_only) continue;
    units_.of_routines[i] = UnitId(static_cast<uint32_t>(units_.all.size()));
    units_.all.push_back({.name = emittable_.routine_names[i],
                          .part = {.routine = id, .region = {}},
                          .values = emittable_.routine_locals[i].values,
                          .references = emittable_.routine_locals[i].shared,
                          .result = routine.result_place,
                          .callees = {},
                          .footprint = {}});
  }
}

void UnitMaker::AddChunks() {
  for (const emit::Chunk& chunk : emittable_.chunks) {
    const bool printed = !program_.routines[chunk.routine].simulation_only;
    units_.of_chunks.push_back(printed ? UnitId(static_cast<uint32_t>(units_.all.size())) : UnitId());
    if (!printed) continue;
    units_.all.push_back(
        {.name = chunk.name,
         .part = {.routine = chunk.routine, .region = chunk.region, .begin = chunk.begin, .end = chunk.end},
         .values = chunk.locals.values,
         .references = chunk.locals.shared,
         .result = {},
         .callees = {},
         .footprint = {}});
  }
}

void UnitMaker::AddCallee(Unit& unit, UnitId callee) {
  if (callee.valid() && std::ranges::find(unit.callees, callee) == unit.callees.end()) unit.callees.push_back(callee);
}

void UnitMaker::VisitInst(Unit& unit, const ir::Inst& inst) {
  if (inst.op == ir::OpKind::kCall)
    AddCallee(unit, units_.of_routines[program_.calls[ir::CallId(inst.payload)].routine.index]);
  if (!ir::OwnsRegions(inst)) return;
  for (const ir::RegionId owned : ir::OwnedRegions(program_, inst)) VisitRegion(unit, owned);
}

void UnitMaker::VisitRegion(Unit& unit, ir::RegionId region) {
  if (!region.valid()) return;
  const std::vector<ir::InstId>& insts = program_.regions[region].insts;
  for (uint32_t at = 0; at < insts.size();) {
    if (const UnitId chunk = units_.At(emittable_, region, at); chunk.valid()) {
      AddCallee(unit, chunk);
      at = units_[chunk].part.end;
      continue;
    }
    VisitInst(unit, program_[insts[at]]);
    ++at;
  }
}

void UnitMaker::FindCallees(Unit& unit) {
  if (unit.part.region.valid()) {
    for (uint32_t i = unit.part.begin; i < unit.part.end; ++i)
      VisitInst(unit, program_[program_.regions[unit.part.region].insts[i]]);
    return;
  }
  const ir::Routine& routine = program_.routines[unit.part.routine];
  for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) VisitRegion(unit, region);
}

void UnitMaker::NoteCell(Footprint& footprint, execute::CellId cell, bool writes) const {
  footprint.touched[cell.index] = true;
  if (writes) footprint.written[cell.index] = true;
}

void UnitMaker::NotePlace(Footprint& footprint, ir::PlaceId id, bool writes) const {
  if (!id.valid()) return;
  const ir::Place& place = program_.places[id];
  for (const execute::CellId cell : execute::TouchedCells(program_, cells_, place)) NoteCell(footprint, cell, writes);
}

void UnitMaker::NoteInstance(Footprint& footprint, ir::StateId state) const {
  for (const execute::CellId cell : execute::CellsOfInstance(program_, cells_, state)) NoteCell(footprint, cell, true);
}

void UnitMaker::NoteHost(Footprint& footprint, const ir::Call& call) const {
  const ir::HostFunction& host = program_.host_functions[call.host];
  for (const execute::CellId chain : cells_.ChainsOf(call.host, call.exchange)) NoteCell(footprint, chain, true);
  footprint.shows_state = footprint.shows_state || host.access == ir::HostAccess::kReadsState;
  footprint.lends_state = footprint.lends_state || host.access == ir::HostAccess::kWritesState;
  // A retentive copy that is given is judged by the layout that it tells.
  footprint.shows_retentive = footprint.shows_retentive || host.access == ir::HostAccess::kReadsRetentive ||
                              host.access == ir::HostAccess::kWritesRetentive;
  for (uint32_t i = 0; i < program_.spaces.size(); ++i) {
    const ir::SpaceId space(i);
    for (uint32_t offset = 0; offset < program_.spaces[space].bytes; ++offset) {
      const uint8_t written = execute::BitsMayWrite(program_, host, space, offset);
      for (uint8_t bit = 0; bit < 8; ++bit) {
        if ((written >> bit & 1) != 0) NoteCell(footprint, cells_.OfBit(space, offset, bit), true);
      }
    }
  }
}

void UnitMaker::NoteRegion(Footprint& footprint, ir::RegionId region) {
  if (!region.valid()) return;
  ir::ForEachInst(program_, region, [&](ir::InstId id) { Note(footprint, program_[id]); });
}

/// Of the instruction alone; regions that it owns are visited on their own.
void UnitMaker::Note(Footprint& footprint, const ir::Inst& inst) {
  ir::ForEachAccess(
      program_, inst,
      [&](ir::PlaceId place, ir::Access access) { NotePlace(footprint, place, access != ir::Access::kRead); },
      [&](ir::StateId state) { NoteInstance(footprint, state); });
  const ir::Shape shape = ir::Info(inst.op).shape;
  if (shape == ir::Shape::kHostCall) NoteHost(footprint, program_.calls[ir::CallId(inst.payload)]);
  if (shape != ir::Shape::kCall) return;
  const Footprint& callee = OfRoutine(program_.calls[ir::CallId(inst.payload)].routine);
  for (uint32_t i = 0; i < cells_.count; ++i) {
    if (callee.touched[i]) NoteCell(footprint, execute::CellId(i), callee.written[i]);
  }
  footprint.shows_state = footprint.shows_state || callee.shows_state;
  footprint.lends_state = footprint.lends_state || callee.lends_state;
  footprint.shows_retentive = footprint.shows_retentive || callee.shows_retentive;
}

const Footprint& UnitMaker::OfRoutine(ir::RoutineId id) {
  if (routines_[id.index].touched.empty()) routines_[id.index] = OfPart({.routine = id, .region = {}});
  return routines_[id.index];
}

Footprint UnitMaker::OfPart(const execute::Stretch& part) {
  Footprint footprint;
  footprint.touched.resize(cells_.count);
  footprint.written.resize(cells_.count);
  if (!part.region.valid()) {
    const ir::Routine& routine = program_.routines[part.routine];
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) NoteRegion(footprint, region);
    return footprint;
  }
  for (uint32_t i = part.begin; i < part.end; ++i) {
    const ir::Inst& inst = program_[program_.regions[part.region].insts[i]];
    Note(footprint, inst);
    if (!ir::OwnsRegions(inst)) continue;
    for (const ir::RegionId owned : ir::OwnedRegions(program_, inst)) NoteRegion(footprint, owned);
  }
  return footprint;
}

Units UnitMaker::Run() {
  AddRoutines();
  AddChunks();
  routines_.resize(program_.routines.size());
  for (Unit& unit : units_.all) {
    FindCallees(unit);
    unit.footprint = unit.part.region.valid() ? OfPart(unit.part) : OfRoutine(unit.part.routine);
    unit.footprint.read = entry_reads_.Of(unit.part);
  }
  return std::move(units_);
}

}  // namespace

UnitId Units::At(const emit::Emittable& emittable, ir::RegionId region, uint32_t instruction) const {
  for (const uint32_t index : emittable.region_chunks[region.index]) {
    if (emittable.chunks[index].begin == instruction) return of_chunks[index];
  }
  return {};
}

Units MakeUnits(const emit::Emittable& emittable, const execute::Cells& cells) {
  return UnitMaker(emittable, cells).Run();
}

}  // namespace plcxx::prove::verify
