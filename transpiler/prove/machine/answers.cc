#include "transpiler/prove/machine/answers.h"

#include <algorithm>
#include <optional>
#include <set>

#include "transpiler/ir/accesses.h"
#include "transpiler/ir/builder.h"

namespace plcxx::prove::machine {
namespace {

bool IsHostCall(const ir::Inst& inst) { return ir::Info(inst.op).shape == ir::Shape::kHostCall; }

/// All instructions of the parts that run by themselves after power-on, and of what they call.
template <typename Visit>
void ForEachInPeriods(const ir::Program& program, Visit&& visit) {
  std::vector<bool> seen(program.routines.size());
  std::vector<ir::RoutineId> open;
  const auto add = [&](ir::RoutineId id) {
    if (!id.valid() || seen[id.index]) return;
    seen[id.index] = true;
    open.push_back(id);
  };
  for (const ir::RoutineId id : {program.schedule.period, program.schedule.fast_only, program.schedule.elapse}) add(id);
  while (!open.empty()) {
    const ir::Routine& routine = program.routines[open.back()];
    open.pop_back();
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      ir::ForEachInst(program, region, [&](ir::InstId id) {
        const ir::Inst& inst = program[id];
        if (ir::Info(inst.op).shape == ir::Shape::kCall) add(program.calls[ir::CallId(inst.payload)].routine);
        visit(id, inst);
      });
    }
  }
}

/// Whether all of the place is an input of the machine.
bool IsInput(const Version& version, const ir::Place& place) {
  if (place.is_field() || place.indexed || !execute::IsInside(*version.program, place)) return false;
  return std::ranges::all_of(execute::CellsOf(*version.program, version.cells, place),
                             [&](execute::CellId cell) { return DirectionOf(version, cell) == ir::Direction::kInput; });
}

/// The value that an instruction stores to an input of the machine, if it does.
std::optional<ir::InstId> StoredToInput(const Version& version, const ir::Inst& inst) {
  if (ir::Info(inst.op).shape != ir::Shape::kStore) return std::nullopt;
  if (!IsInput(version, version.program->places[ir::PlaceId(inst.payload)])) return std::nullopt;
  return ir::InstId(inst.a);
}

}  // namespace

std::map<ir::InstId, ir::PlaceId> FetchedInputs(const Version& version) {
  const ir::Program& program = *version.program;
  std::set<ir::InstId> asked;
  std::map<ir::InstId, ir::PlaceId> fetched;
  std::map<ir::PlaceId, uint32_t> times;
  std::set<ir::InstId> stored_twice;
  ForEachInPeriods(program, [&](ir::InstId id, const ir::Inst& inst) {
    if (IsHostCall(inst)) {
      const ir::Call& call = program.calls[ir::CallId(inst.payload)];
      if (call.exchange && program.host_functions[call.host].result != ir::Type::kNone && !call.out.valid())
        asked.insert(id);
      return;
    }
    const std::optional<ir::InstId> value = StoredToInput(version, inst);
    if (!value || !IsHostCall(program[*value])) return;
    const ir::PlaceId place(inst.payload);
    if (!fetched.try_emplace(*value, place).second) stored_twice.insert(*value);
    ++times[place];
  });
  // What is asked for twice in a period may have changed in between.
  std::erase_if(fetched, [&](const auto& one) {
    return !asked.contains(one.first) || stored_twice.contains(one.first) || times[one.second] != 1;
  });
  return fetched;
}

std::vector<bool> HandshakeCells(const Version& version) {
  const ir::Program& program = *version.program;
  const std::map<ir::InstId, ir::PlaceId> fetched = FetchedInputs(version);
  std::vector<bool> cells(version.cells.count);
  ForEachInPeriods(program, [&](ir::InstId, const ir::Inst& inst) {
    const bool fetches = ir::Info(inst.op).shape == ir::Shape::kStore && fetched.contains(ir::InstId(inst.a));
    if (fetches) return;
    ir::ForEachAccess(
        program, inst,
        [&](ir::PlaceId id, ir::Access access) {
          const ir::Place& place = program.places[id];
          if (access != ir::Access::kWrite || place.is_field()) return;
          if (!place.indexed && !execute::IsInside(program, place)) return;
          for (const execute::CellId cell : execute::TouchedCells(program, version.cells, place)) {
            if (WhatControlWrites(version, cell) != execute::ControlWrite::kNothing) cells[cell.index] = true;
          }
        },
        [](ir::StateId) {});
  });
  return cells;
}

bool AnswersMatter(const Version& version) {
  const ir::Program& program = *version.program;
  if (program.text_inbox.valid()) return true;
  const std::map<ir::InstId, ir::PlaceId> fetched = FetchedInputs(version);
  bool matters = false;
  uint32_t exchanges = 0;
  ForEachInPeriods(program, [&](ir::InstId id, const ir::Inst& inst) {
    if (!IsHostCall(inst)) return;
    const ir::HostFunctionId host = program.calls[ir::CallId(inst.payload)].host;
    const ir::HostFunction& function = program.host_functions[host];
    if (host == program.schedule.now || host == program.schedule.retentive_load) return;
    const bool answers = function.result != ir::Type::kNone || !function.out.name.empty();
    matters = matters || (answers && !fetched.contains(id));
    const bool writes =
        function.access == ir::HostAccess::kWritesState || function.access == ir::HostAccess::kWritesRetentive;
    matters = matters || (writes && !function.routine_exchange);
    if (writes && function.routine_exchange) ++exchanges;
  });
  // The first exchange of a period brings the inputs, which are new anyway; another one may take handshakes back.
  const std::vector<bool> handshakes = HandshakeCells(version);
  for (uint32_t i = 0; i < handshakes.size() && !matters; ++i) {
    const bool is_cleared = WhatControlWrites(version, execute::CellId(i)) == execute::ControlWrite::kClears;
    matters = handshakes[i] && (exchanges > 1 || is_cleared);
  }
  return matters;
}

}  // namespace plcxx::prove::machine
