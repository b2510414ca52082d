#include "transpiler/measure/slices.h"

#include <algorithm>
#include <set>
#include <string>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/slices.h"
#include "transpiler/ir/uses.h"

namespace plcxx::measure {
namespace {

/// The regions that are reached from some instructions on, through calls, too.
class Reached {
 public:
  explicit Reached(const ir::Program& program) : program_(program), regions_(program.regions.size()) {}

  void Add(ir::RegionId region) {
    if (!region.valid() || regions_[region.index]) return;
    regions_[region.index] = true;
    for (const ir::InstId id : program_.regions[region].insts) Add(program_[id]);
  }
  void Add(const ir::Inst& inst) {
    if (inst.op == ir::OpKind::kCall) {
      const ir::Routine& callee = program_.routines[program_.calls[ir::CallId(inst.payload)].routine];
      for (const ir::RegionId region : {callee.prologue, callee.body, callee.epilogue}) Add(region);
    }
    if (!ir::OwnsRegions(inst)) return;
    for (const ir::RegionId owned : ir::OwnedRegions(program_, inst)) Add(owned);
  }
  std::vector<bool> Take() { return std::move(regions_); }

 private:
  const ir::Program& program_;
  std::vector<bool> regions_;
};

/// What the routine executes whatever slice it is asked for.
std::vector<bool> RegionsOfAll(const ir::Program& program, const ir::Routine& routine,
                               const std::vector<ir::SlicePiece>& pieces) {
  Reached reached(program);
  for (const ir::RegionId region : {routine.prologue, routine.epilogue}) reached.Add(region);
  for (const ir::InstId id : program.regions[routine.body].insts) {
    const std::vector<ir::RegionId> owned =
        ir::OwnsRegions(program[id]) ? ir::OwnedRegions(program, program[id]) : std::vector<ir::RegionId>();
    const bool chooses = std::ranges::find(owned, pieces.front().region) != owned.end();
    if (!chooses) {
      reached.Add(program[id]);
      continue;
    }
    for (const ir::RegionId arm : owned) {
      if (std::ranges::find(pieces, arm, &ir::SlicePiece::region) == pieces.end()) reached.Add(arm);
    }
  }
  return reached.Take();
}

/// The functions of generated code whose statements are in such regions, as the source calls them.
std::set<std::string> FunctionsIn(const emit::Emittable& emittable, const std::vector<bool>& regions) {
  const ir::Program& program = *emittable.program;
  std::set<std::string> names;
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::Routine& routine = program.routines[ir::RoutineId(i)];
    if (routine.body.valid() && regions[routine.body.index]) names.insert(emittable.routine_names[i]);
  }
  for (const emit::Chunk& chunk : emittable.chunks) {
    if (regions[chunk.region.index]) names.insert(chunk.name);
  }
  for (const emit::ChunkRun& run : emittable.runs) {
    if (regions[emittable.chunks[run.chunks.front()].region.index]) names.insert(run.name);
  }
  return names;
}

}  // namespace

std::vector<bool> RegionsFrom(const ir::Program& program, ir::RegionId region) {
  Reached reached(program);
  reached.Add(region);
  return reached.Take();
}

std::vector<bool> RegionsOf(const ir::Program& program, ir::RoutineId id) {
  const ir::Routine& routine = program.routines[id];
  Reached reached(program);
  for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) reached.Add(region);
  return reached.Take();
}

std::vector<bool> RegionsOfSlice(const ir::Program& program, ir::RoutineId id, ir::RegionId piece) {
  std::vector<bool> regions = RegionsOfAll(program, program.routines[id], ir::SlicePieces(program, id));
  regions[program.routines[id].body.index] = true;  // the choice itself
  const std::vector<bool> own = RegionsFrom(program, piece);
  for (size_t i = 0; i < regions.size(); ++i) regions[i] = regions[i] || own[i];
  return regions;
}

std::vector<SliceCode> SlicesOf(const compile::ProgramCode& code, const emit::Emittable& emittable, ir::RoutineId id) {
  const ir::Program& program = *emittable.program;
  const std::vector<ir::SlicePiece> pieces = ir::SlicePieces(program, id);
  std::vector<SliceCode> slices;
  if (pieces.empty()) return slices;
  const std::set<std::string> always = FunctionsIn(emittable, RegionsOfAll(program, program.routines[id], pieces));
  std::vector<std::set<std::string>> own;
  std::set<std::string> all;
  for (const ir::SlicePiece& piece : pieces) {
    own.push_back(FunctionsIn(emittable, RegionsFrom(program, piece.region)));
    all.insert(own.back().begin(), own.back().end());
  }
  std::vector<std::string> names;  // by function of the objects, without namespace; empty: not of a slice
  const std::string prefix = emittable.namespace_name + "::";
  for (uint32_t i = 0; i < code.function_count(); ++i) {
    const std::string name = code.Name(i);
    names.push_back(name.starts_with(prefix) ? name.substr(prefix.size()) : "");
  }
  for (size_t i = 0; i < pieces.size(); ++i) {
    SliceCode slice{pieces[i].slice, pieces[i].region, std::vector<bool>(names.size())};
    for (size_t k = 0; k < names.size(); ++k) {
      slice.impossible[k] = all.contains(names[k]) && !own[i].contains(names[k]) && !always.contains(names[k]);
    }
    slices.push_back(std::move(slice));
  }
  return slices;
}

}  // namespace plcxx::measure
