// The names of what the whole program knows: places, state instances, routines; and of the locals that have a place.

#include <algorithm>
#include <map>
#include <numeric>

#include "transpiler/emit/legalize/names.h"
#include "transpiler/emit/legalize/steps.h"
#include "transpiler/ir/accesses.h"
#include "transpiler/ir/builder.h"

namespace plcxx::emit::legalize {
namespace {

/// By PlaceId: the routines whose functions have it, ascending. Two places of one routine need two names.
std::vector<std::vector<uint32_t>> FunctionsOfPlaces(const ir::Program& program) {
  std::vector<std::vector<uint32_t>> functions(program.places.size());
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::Routine& routine = program.routines[ir::RoutineId(i)];
    const auto note = [&](ir::PlaceId place) {
      if (!place.valid()) return;
      std::vector<uint32_t>& of = functions[place.index];
      if (of.empty() || of.back() != i) of.push_back(i);
    };
    for (const ir::PlaceId place : routine.parameter_places) note(place);
    note(routine.result_place);
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (!region.valid()) continue;
      ir::ForEachInst(program, region, [&](ir::InstId id) {
        ir::ForEachAccess(
            program, program[id], [&](ir::PlaceId place, ir::Access) { note(place); }, [](ir::StateId) {});
      });
    }
  }
  return functions;
}

}  // namespace

void NamePlaces(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  NameTable names;
  for (const ir::Table& table : program.tables) {
    names.Allocate(table.name, "");
    names.Allocate(table.name + "_row", "");
  }
  for (const ir::HostFunction& function : program.host_functions) {
    names.Reserve(function.name);
    for (const ir::Parameter& parameter : function.parameters) names.Reserve(function.name + "_" + parameter.name);
  }
  // The names of subroutines, and of what the host is to call, are the source's; the others are the generated code's.
  const auto is_of_source = [](const ir::Routine& routine) {
    return routine.kind == ir::RoutineKind::kSubroutine || routine.kind == ir::RoutineKind::kInterrupt;
  };
  emittable.routine_names.resize(program.routines.size());
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::Routine& routine = program.routines[ir::RoutineId(i)];
    if (is_of_source(routine)) continue;
    names.Reserve(routine.name);
    emittable.routine_names[i] = routine.name;
  }
  // What the host calls is first, so that no subroutine changes an exported name.
  for (const auto kind : {ir::RoutineKind::kInterrupt, ir::RoutineKind::kSubroutine}) {
    for (uint32_t i = 0; i < program.routines.size(); ++i) {
      const ir::Routine& routine = program.routines[ir::RoutineId(i)];
      if (routine.kind == kind) emittable.routine_names[i] = names.Allocate(routine.name, "routine");
    }
  }
  emittable.namespace_name = NamespaceOf(emittable.options.name);
  names.Reserve(emittable.namespace_name);
  // In the order of the addresses, not of first use: a statement inserted above must not rename what follows.
  std::vector<uint32_t> order(program.places.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&program](uint32_t left, uint32_t right) {
    const ir::Place& a = program.places[ir::PlaceId(left)];
    const ir::Place& b = program.places[ir::PlaceId(right)];
    return std::tuple(a.state.index, a.field, a.space.index, a.offset, a.bit, a.address, a.name) <
           std::tuple(b.state.index, b.field, b.space.index, b.offset, b.bit, b.address, b.name);
  });
  // Locals come before all, for they are not to hide any name. A parameter has the name that the routine says.
  emittable.place_names.resize(program.places.size());
  const auto is_local = [&emittable](uint32_t i) {
    return emittable.layout.places[i].storage == layout::Storage::kLocal;
  };
  const auto is_own = [&program](uint32_t i) {
    const ir::Place& place = program.places[ir::PlaceId(i)];
    return !place.is_field() && program.spaces[place.space].own;
  };
  for (const ir::Routine& routine : program.routines) {
    for (size_t i = 0; i < routine.parameters.size(); ++i) {
      if (is_own(routine.parameter_places[i].index)) continue;
      emittable.place_names[routine.parameter_places[i].index] = routine.parameters[i].name;
      names.Reserve(routine.parameters[i].name);
    }
  }
  for (const uint32_t i : order) {
    if (is_local(i) && !is_own(i) && emittable.place_names[i].empty()) {
      emittable.place_names[i] = names.Allocate(program.places[ir::PlaceId(i)].name, "local");
    }
  }
  // Names that a user did not choose come first: an address keeps its own spelling even beside an odd symbol.
  for (const bool symbols : {false, true}) {
    for (const uint32_t i : order) {
      const ir::Place& place = program.places[ir::PlaceId(i)];
      const bool is_symbol = !place.address.empty() && place.address != place.name;
      if (is_symbol != symbols || emittable.layout.places[i].storage == layout::Storage::kNone || is_local(i)) continue;
      emittable.place_names[i] = names.Allocate(place.name, is_symbol ? place.address : "");
    }
  }
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    const layout::PlaceStorage& stored = emittable.layout.places[i];
    const bool element = stored.storage == layout::Storage::kBit || stored.storage == layout::Storage::kByte ||
                         layout::IsWord(stored.storage);
    if (!element || emittable.place_names[i].empty()) continue;
    std::string& name = emittable.element_names[{stored.storage, stored.index}];
    if (name.empty() || emittable.place_names[i] < name) name = emittable.place_names[i];
  }
  for (const layout::Stretch& stretch : emittable.layout.stretches) {
    std::string& name = emittable.element_names[{layout::Storage::kByte, stretch.index}];
    const std::string address = program.spaces[stretch.space].name + "_" + std::to_string(stretch.begin);
    if (name.empty()) name = names.Allocate(address, "byte");
  }
  // An instance whose own name is the name of its signal ("P6") gives way: the signal is what statements name.
  for (const ir::StateInstance& state : program.states) {
    emittable.state_names.push_back(names.Allocate(state.name, "state"));
  }
  // After all names of the file, none of which such a local may hide.
  const std::vector<std::vector<uint32_t>> functions = FunctionsOfPlaces(program);
  std::vector<FunctionNames> of_routine(program.routines.size());
  std::map<uint32_t, FunctionNames> of_space;
  for (const uint32_t i : order) {
    if (!is_local(i) || !is_own(i)) continue;
    const ir::Place& place = program.places[ir::PlaceId(i)];
    std::vector<FunctionNames*> taken = {&of_space[place.space.index]};
    for (const uint32_t routine : functions[i]) taken.push_back(&of_routine[routine]);
    emittable.place_names[i] = names.AllocateIn(taken, place.name);
  }
}

}  // namespace plcxx::emit::legalize
