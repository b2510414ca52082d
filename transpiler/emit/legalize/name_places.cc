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

/// Gives names, each step those that are free after the ones before it.
class Namer {
 public:
  explicit Namer(Emittable& emittable) : emittable_(emittable), program_(*emittable.program) {
    emittable_.routine_names.resize(program_.routines.size());
    emittable_.place_names.resize(program_.places.size());
    SortPlaces();
  }

  void NameTables() {
    for (const ir::Table& table : program_.tables) {
      names_.Allocate(table.name, "");
      names_.Allocate(table.name + "_row", "");
    }
  }

  void ReserveHostFunctions() {
    for (const ir::HostFunction& function : program_.host_functions) {
      names_.Reserve(function.name);
      for (const ir::Parameter& parameter : function.parameters) names_.Reserve(function.name + "_" + parameter.name);
    }
  }

  /// Those that the generated code has by itself.
  void ReserveRoutines() {
    for (uint32_t i = 0; i < program_.routines.size(); ++i) {
      const ir::Routine& routine = program_.routines[ir::RoutineId(i)];
      if (routine.kind == ir::RoutineKind::kSubroutine || routine.kind == ir::RoutineKind::kInterrupt) continue;
      names_.Reserve(routine.name);
      emittable_.routine_names[i] = routine.name;
    }
  }

  /// The names of subroutines, and of what the host is to call, are the source's.
  void NameRoutines(ir::RoutineKind kind) {
    for (uint32_t i = 0; i < program_.routines.size(); ++i) {
      const ir::Routine& routine = program_.routines[ir::RoutineId(i)];
      if (routine.kind == kind) emittable_.routine_names[i] = names_.Allocate(routine.name, "routine");
    }
  }

  void NameNamespace() {
    emittable_.namespace_name = NamespaceOf(emittable_.options.name);
    names_.Reserve(emittable_.namespace_name);
  }

  /// A parameter has the name that the routine says.
  void ReserveParameters() {
    for (const ir::Routine& routine : program_.routines) {
      for (size_t i = 0; i < routine.parameters.size(); ++i) {
        if (IsOwn(routine.parameter_places[i].index)) continue;
        emittable_.place_names[routine.parameter_places[i].index] = routine.parameters[i].name;
        names_.Reserve(routine.parameters[i].name);
      }
    }
  }

  void NameSharedLocals() {
    for (const uint32_t i : order_) {
      if (IsLocal(i) && !IsOwn(i) && emittable_.place_names[i].empty()) {
        emittable_.place_names[i] = names_.Allocate(program_.places[ir::PlaceId(i)].name, "local");
      }
    }
  }

  enum class Chosen : uint8_t { kByTheLanguage, kByTheUser };

  /// Those of State: addresses are named by the language, symbols by the user.
  void NameStored(Chosen chosen) {
    for (const uint32_t i : order_) {
      const ir::Place& place = program_.places[ir::PlaceId(i)];
      const bool is_symbol = !place.address.empty() && place.address != place.name;
      if (is_symbol != (chosen == Chosen::kByTheUser)) continue;
      if (emittable_.layout.places[i].storage == layout::Storage::kNone || IsLocal(i)) continue;
      emittable_.place_names[i] = names_.Allocate(place.name, is_symbol ? place.address : "");
    }
  }

  /// An element of State has the first name of what is in it.
  void NameElements() {
    for (uint32_t i = 0; i < program_.places.size(); ++i) {
      const layout::PlaceStorage& stored = emittable_.layout.places[i];
      const bool element = stored.storage == layout::Storage::kBit || stored.storage == layout::Storage::kByte ||
                           layout::IsWord(stored.storage);
      if (!element || emittable_.place_names[i].empty()) continue;
      std::string& name = emittable_.element_names[{stored.storage, stored.index}];
      if (name.empty() || emittable_.place_names[i] < name) name = emittable_.place_names[i];
    }
    for (const layout::Stretch& stretch : emittable_.layout.stretches) {
      std::string& name = emittable_.element_names[{layout::Storage::kByte, stretch.index}];
      const std::string address = program_.spaces[stretch.space].name + "_" + std::to_string(stretch.begin);
      if (name.empty()) name = names_.Allocate(address, "byte");
    }
  }

  void NameStates() {
    for (const ir::StateInstance& state : program_.states) {
      emittable_.state_names.push_back(names_.Allocate(state.name, "state"));
    }
  }

  /// Those of one function each: another function may have the same name.
  void NameOwnLocals() {
    const std::vector<std::vector<uint32_t>> functions = FunctionsOfPlaces(program_);
    std::vector<FunctionNames> of_routine(program_.routines.size());
    std::map<uint32_t, FunctionNames> of_space;
    for (const uint32_t i : order_) {
      if (!IsLocal(i) || !IsOwn(i)) continue;
      const ir::Place& place = program_.places[ir::PlaceId(i)];
      std::vector<FunctionNames*> taken = {&of_space[place.space.index]};
      for (const uint32_t routine : functions[i]) taken.push_back(&of_routine[routine]);
      emittable_.place_names[i] = names_.AllocateIn(taken, place.name);
    }
  }

 private:
  /// In the order of the addresses, not of first use: a statement inserted above must not rename what follows.
  void SortPlaces() {
    order_.resize(program_.places.size());
    std::iota(order_.begin(), order_.end(), 0);
    std::stable_sort(order_.begin(), order_.end(), [this](uint32_t left, uint32_t right) {
      const ir::Place& a = program_.places[ir::PlaceId(left)];
      const ir::Place& b = program_.places[ir::PlaceId(right)];
      return std::tuple(a.state.index, a.field, a.space.index, a.offset, a.bit, a.address, a.name) <
             std::tuple(b.state.index, b.field, b.space.index, b.offset, b.bit, b.address, b.name);
    });
  }

  bool IsLocal(uint32_t i) const { return emittable_.layout.places[i].storage == layout::Storage::kLocal; }
  /// A function's own.
  bool IsOwn(uint32_t i) const {
    const ir::Place& place = program_.places[ir::PlaceId(i)];
    return !place.is_field() && program_.spaces[place.space].own;
  }

  Emittable& emittable_;
  const ir::Program& program_;
  NameTable names_;
  std::vector<uint32_t> order_;  // of the places
};

}  // namespace

void NamePlaces(Emittable& emittable) {
  Namer namer(emittable);
  namer.NameTables();
  namer.ReserveHostFunctions();
  namer.ReserveRoutines();
  namer.NameRoutines(ir::RoutineKind::kInterrupt);  // what the host calls: no subroutine changes an exported name
  namer.NameRoutines(ir::RoutineKind::kSubroutine);
  namer.NameNamespace();
  namer.ReserveParameters();  // before all that is in State, of which they are not to hide any name
  namer.NameSharedLocals();
  namer.NameStored(Namer::Chosen::kByTheLanguage);  // an address keeps its spelling even beside an odd symbol
  namer.NameStored(Namer::Chosen::kByTheUser);
  namer.NameElements();
  namer.NameStates();     // an instance whose name is that of its signal ("P6") gives way: statements name the signal
  namer.NameOwnLocals();  // after all names of the file, none of which such a local may hide
}

}  // namespace plcxx::emit::legalize
