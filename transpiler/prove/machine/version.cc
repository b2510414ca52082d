#include "transpiler/prove/machine/version.h"

#include "transpiler/ir/accesses.h"
#include "transpiler/ir/op.h"
#include "transpiler/ir/zones.h"
#include "transpiler/prove/machine/sets.h"
#include "transpiler/symbolic/execute/host_writes.h"

namespace plcxx::prove::machine {

Version MakeVersion(const ir::Program& program) {
  return {
      .program = &program, .cells = execute::MakeCells(program, execute::ExchangeCalls::kApart), .shared_loops = {}};
}

ir::Direction DirectionOf(const Version& version, execute::CellId id) {
  const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
  if (cell.kind == execute::CellKind::kCalls) return ir::Direction::kOutput;
  if (cell.kind == execute::CellKind::kField) return ir::Direction::kInternal;
  return ir::DirectionOf(version.program->spaces[cell.space], cell.offset, cell.bit);
}

execute::ControlWrite WhatControlWrites(const Version& version, execute::CellId id) {
  const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
  if (cell.kind != execute::CellKind::kBit) return execute::ControlWrite::kNothing;
  return execute::WhatControlWrites(version.program->spaces[cell.space], cell.offset, cell.bit);
}

bool IsState(const Version& version, execute::CellId id) {
  const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
  return cell.kind != execute::CellKind::kBit || version.program->spaces[cell.space].lifetime != ir::Lifetime::kRoutine;
}

bool IsRetentive(const Version& version, execute::CellId id) {
  const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
  return cell.kind == execute::CellKind::kBit &&
         version.program->spaces[cell.space].lifetime == ir::Lifetime::kRetentive;
}

Uses UsesOf(const Version& version) {
  const ir::Program& program = *version.program;
  Uses uses{.reads = std::vector<bool>(version.cells.count),
            .writes = std::vector<bool>(version.cells.count),
            .sets = std::vector<bool>(version.cells.count)};
  const auto on_instance = [&](ir::StateId state) {
    for (const execute::CellId cell : execute::CellsOfInstance(program, version.cells, state)) {
      uses.reads[cell.index] = uses.writes[cell.index] = uses.sets[cell.index] = true;
    }
  };
  for (uint32_t r = 0; r < program.regions.size(); ++r) {
    for (const ir::InstId id : program.regions[ir::RegionId(r)].insts) {
      const ir::Inst& inst = program[id];
      const auto on_place = [&](ir::PlaceId place, ir::Access access) {
        for (const execute::CellId cell : execute::TouchedCells(program, version.cells, program.places[place])) {
          if (access != ir::Access::kWrite) uses.reads[cell.index] = true;
          if (access != ir::Access::kRead) uses.writes[cell.index] = true;
        }
      };
      ir::ForEachAccess(program, inst, on_place, on_instance);
      if (ir::Info(inst.op).shape == ir::Shape::kHostCall) {
        const ir::Call& call = program.calls[ir::CallId(inst.payload)];
        for (const execute::CellId chain : version.cells.ChainsOf(call.host, call.exchange))
          uses.writes[chain.index] = uses.sets[chain.index] = true;
      }
    }
  }
  const std::vector<bool> set = SetCells(version);
  for (uint32_t i = 0; i < version.cells.count; ++i) uses.sets[i] = uses.sets[i] || set[i];
  return uses;
}

}  // namespace plcxx::prove::machine
