#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_set>

#include "transpiler/emit/cpp_printer.h"
#include "transpiler/emit/emittable.h"
#include "transpiler/emit/names.h"
#include "transpiler/ir/builder.h"

namespace plcxx::emit {
namespace {

void FindUsedHostFunctions(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  emittable.host_used.assign(program.host_functions.size(), false);
  for (const ir::InstId id : PrintedInsts(program, emittable.options.flavour)) {
    const ir::Inst& inst = program[id];
    if (inst.op == ir::OpKind::kHostCall) {
      emittable.host_used[program.calls[ir::CallId(inst.payload)].host.index] = true;
    }
  }
}

void FindUsedFunctions(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  const std::vector<ir::InstId> insts = PrintedInsts(program, emittable.options.flavour);
  std::vector<bool> used(ir::OpCount(), false);
  for (const ir::InstId id : insts) used[static_cast<size_t>(program[id].op)] = true;
  for (uint32_t i = 0; i < used.size(); ++i) {
    const auto op = static_cast<ir::OpKind>(i);
    const ir::OpInfo& info = ir::Info(op);
    if (!used[i] || info.shape != ir::Shape::kPure) continue;
    const size_t bracket = info.spelling.find('(');
    if (bracket != std::string_view::npos && bracket > 0) {
      emittable.functions.emplace_back(info.spelling.substr(0, bracket));
    }
    // Comparisons that may never hold are called by name, see IsForegone.
    if (op == ir::OpKind::kLess8) emittable.functions.emplace_back("Less8");
    if (op == ir::OpKind::kGreater8) emittable.functions.emplace_back("Greater8");
  }
  for (const ir::InstId id : insts) {
    const ir::Inst& inst = program[id];
    if (IsForegone(program, inst)) emittable.functions.emplace_back(ir::Info(inst.op).function);
    const bool number = inst.op == ir::OpKind::kConst && inst.type == ir::Type::kF32;
    if (number && ConstantText(inst.type, ir::ConstantValue(inst)).front() == 'F') {
      emittable.functions.emplace_back("F32OfBits");
    }
    const bool wide = inst.op == ir::OpKind::kConst && inst.type == ir::Type::kF64;
    if (wide && ConstantText(inst.type, ir::ConstantValue(inst)).front() == 'F') {
      emittable.functions.emplace_back("F64OfBits");
    }
  }
  std::sort(emittable.functions.begin(), emittable.functions.end());
  emittable.functions.erase(std::unique(emittable.functions.begin(), emittable.functions.end()),
                            emittable.functions.end());
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
  emittable.namespace_name = SafeIdentifier(emittable.options.name);
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
  const auto is_local = [&emittable](uint32_t i) { return emittable.layout.places[i].storage == Storage::kLocal; };
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
      if (is_symbol != symbols || emittable.layout.places[i].storage == Storage::kNone || is_local(i)) continue;
      emittable.place_names[i] = names.Allocate(place.name, is_symbol ? place.address : "");
    }
  }
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    const PlaceStorage& stored = emittable.layout.places[i];
    const bool element = stored.storage == Storage::kBit || stored.storage == Storage::kByte || IsWord(stored.storage);
    if (!element || emittable.place_names[i].empty()) continue;
    std::string& name = emittable.element_names[{stored.storage, stored.index}];
    if (name.empty() || emittable.place_names[i] < name) name = emittable.place_names[i];
  }
  for (const Stretch& stretch : emittable.layout.stretches) {
    std::string& name = emittable.element_names[{Storage::kByte, stretch.index}];
    const std::string address = program.spaces[stretch.space].name + "_" + std::to_string(stretch.begin);
    if (name.empty()) name = names.Allocate(address, "byte");
  }
  // An instance whose own name is the name of its signal ("P6") gives way: the signal is what statements name.
  for (const ir::StateInstance& state : program.states) {
    emittable.state_names.push_back(names.Allocate(state.name, "state"));
  }
  // Behind all names of the file, none of which such a local may hide. A space is one function's.
  std::map<uint32_t, std::unordered_set<std::string>> functions;
  for (const uint32_t i : order) {
    if (!is_local(i) || !is_own(i)) continue;
    const ir::Place& place = program.places[ir::PlaceId(i)];
    emittable.place_names[i] = names.AllocateIn(functions[place.space.index], place.name);
  }
}

std::vector<ir::InstId> PrintedInsts(const ir::Program& program, Flavour flavour) {
  std::vector<ir::InstId> insts;
  for (const ir::Routine& routine : program.routines) {
    if (routine.simulation_only && flavour != Flavour::kDebug) continue;
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (region.valid()) ir::ForEachInst(program, region, [&insts](ir::InstId id) { insts.push_back(id); });
    }
  }
  return insts;
}

Emittable Legalize(const ir::Program& program, const EmitOptions& options) {
  Emittable emittable;
  emittable.program = &program;
  emittable.options = options;
  emittable.layout = MakeLayout(program);
  FindUsedHostFunctions(emittable);
  FindUsedFunctions(emittable);
  NamePlaces(emittable);
  PlaceTemporaries(emittable);  // before CutChunks: a chunk never cuts between a value and its use
  CutChunks(emittable);
  CutParts(emittable);
  ShareLocals(emittable);   // after CutChunks: chunks get them, too
  ChooseLeaves(emittable);  // after CutChunks: what ends a function decides what `return` leaves
  return emittable;
}

std::string Print(const Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  std::string out = "emittable " + emittable.namespace_name + "\n";
  for (const Member& member : emittable.layout.members) {
    out += "member " + member.name + " : " + member.element + "[" + std::to_string(member.count) + "] at " +
           std::to_string(member.offset) + "\n";
  }
  static constexpr std::string_view kStorage[] = {"none",
                                                  "bit",
                                                  "byte",
                                                  "packed_bit",
                                                  "word16",
                                                  "word32",
                                                  "word64",
                                                  "float32",
                                                  "float64",
                                                  "wide",
                                                  "indexed",
                                                  "retentive_byte",
                                                  "retentive_bit",
                                                  "retentive_wide",
                                                  "retentive_indexed",
                                                  "field",
                                                  "local"};
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    if (emittable.place_names[i].empty()) continue;
    const PlaceStorage& stored = emittable.layout.places[i];
    out += "place " + emittable.place_names[i] + " " + std::string(kStorage[static_cast<size_t>(stored.storage)]) +
           " at " + std::to_string(stored.offset) + (stored.bit != 0 ? "." + std::to_string(stored.bit) : "") + "\n";
  }
  for (const Chunk& chunk : emittable.chunks) {
    out += "chunk " + chunk.name + " " + std::to_string(chunk.statements) + " statements, file " +
           emittable.options.name + emittable.parts[chunk.part].suffix + ".cpp\n";
  }
  for (uint32_t i = 0; i < program.insts.size(); ++i) {
    if (emittable.local_value[i]) out += "local %" + std::to_string(i) + "\n";
  }
  return out;
}

}  // namespace plcxx::emit
