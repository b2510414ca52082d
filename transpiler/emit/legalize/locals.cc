// Which named locals (places of lifetime kRoutine) a function declares, and which it gets from its caller.
//
//   fast { store s, %0; call PM17 }; subroutine PM17 { load s }   ->   void fast(...) { bool s = false; s = ...;
//                                                                      PM17(m, s, host); }
//                                                                      void PM17(State& m, bool& s, Host& host)
//
// A subroutine gets by reference what it or a callee of it touches, and nothing else; so does a chunk. Parameters stay
// values unless a chunk writes them. A routine's result is a local of its own, and so are the places of a space of its
// own.

#include <algorithm>
#include <map>

#include "transpiler/emit/legalize/steps.h"
#include "transpiler/ir/builder.h"

namespace plcxx::emit::legalize {
namespace {

using ir::PlaceId;

struct Touch {
  bool read = false, written = false;
};

struct Sharing {
  Emittable& emittable;
  const ir::Program& program;
  std::vector<PlaceId> locals;     // all of the program
  std::vector<uint32_t> number;    // by PlaceId: in `locals`
  std::vector<bool> is_parameter;  // by number
  std::vector<bool> known;         // by RoutineId: its locals are computed

  /// By number; of what is touched alone: a program of many subroutines has many locals, each of them few.
  using Touches = std::map<uint32_t, Touch>;

  void Note(Touches& touches, PlaceId place, Touch touch) const;
  void Inst(Touches& touches, const ir::Inst& inst);
  void Region(Touches& touches, ir::RegionId region);
  void Routine(ir::RoutineId id);
  void Chunk(emit::Chunk& chunk);
  Locals Union(const std::vector<uint32_t>& chunks) const;
};

void Sharing::Note(Touches& touches, PlaceId place, Touch touch) const {
  if (!place.valid() || emittable.layout.places[place.index].storage != layout::Storage::kLocal) return;
  Touch& noted = touches[number[place.index]];
  noted.read = noted.read || touch.read;
  noted.written = noted.written || touch.written;
}

void Sharing::Inst(Touches& touches, const ir::Inst& inst) {
  switch (ir::Info(inst.op).shape) {
    case ir::Shape::kLoad:
      Note(touches, PlaceId(inst.payload), {.read = true});
      break;
    case ir::Shape::kStore:
      Note(touches, PlaceId(inst.payload), {.written = true});
      break;
    case ir::Shape::kRepeat: {
      const ir::LoopId loop(program[ir::InstId(inst.payload)].payload);
      Note(touches, program.loops[loop].budget, {.read = true, .written = true});
      break;
    }
    case ir::Shape::kHostCall:
      Note(touches, program.calls[ir::CallId(inst.payload)].out, {.read = true, .written = true});
      break;
    case ir::Shape::kCall: {
      const ir::RoutineId callee = program.calls[ir::CallId(inst.payload)].routine;
      Routine(callee);
      for (const PlaceId place : emittable.routine_locals[callee.index].shared) {
        Note(touches, place, {.read = true, .written = true});
      }
      break;
    }
    case ir::Shape::kPure:
    case ir::Shape::kStep:
    case ir::Shape::kConst:
    case ir::Shape::kText:
    case ir::Shape::kStatement:
    case ir::Shape::kIf:
    case ir::Shape::kSwitch:
    case ir::Shape::kLoop:
    case ir::Shape::kBlock:
    case ir::Shape::kExit:
    case ir::Shape::kJump:
    case ir::Shape::kLabel:
      break;
  }
}

void Sharing::Region(Touches& touches, ir::RegionId region) {
  ir::ForEachInst(program, region, [this, &touches](ir::InstId id) { Inst(touches, program[id]); });
}

void Sharing::Routine(ir::RoutineId id) {
  if (known[id.index]) return;
  known[id.index] = true;  // before its callees: the verifier has refused recursion
  const ir::Routine& routine = program.routines[id];
  Touches touches;
  for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) Region(touches, region);
  Note(touches, routine.result_place, {.read = true});
  Locals found{.declared = {}, .shared = {}, .values = routine.parameter_places};
  for (const auto& [i, touch] : touches) {
    const auto& parameters = routine.parameter_places;
    const bool parameter = std::find(parameters.begin(), parameters.end(), locals[i]) != parameters.end();
    if (parameter) continue;
    const bool own = program.spaces[program.places[locals[i]].space].own;
    if (SharesLocals(routine.kind) && !own && locals[i] != routine.result_place) {
      found.shared.push_back(locals[i]);
    } else {
      found.declared.push_back({locals[i], touch.read});
    }
  }
  emittable.routine_locals[id.index] = std::move(found);
}

void Sharing::Chunk(emit::Chunk& chunk) {
  Touches touches;
  const std::vector<ir::InstId>& insts = program.regions[chunk.region].insts;
  for (uint32_t i = chunk.begin; i < chunk.end; ++i) {
    const ir::Inst& inst = program[insts[i]];
    Inst(touches, inst);
    if (ir::Info(inst.op).effect != ir::Effect::kControl) continue;
    for (const ir::RegionId owned : ir::OwnedRegions(program, inst)) Region(touches, owned);
  }
  for (const auto& [i, touch] : touches) {
    const bool value = is_parameter[i] && !touch.written;
    (value ? chunk.locals.values : chunk.locals.shared).push_back(locals[i]);
  }
}

Locals Sharing::Union(const std::vector<uint32_t>& chunks) const {
  enum class Kind : uint8_t { kValue, kShared };
  std::map<uint32_t, Kind> kinds;  // by number
  for (const uint32_t index : chunks) {
    const Locals& used = emittable.chunks[index].locals;
    for (const PlaceId place : used.values) {
      kinds.try_emplace(number[place.index], Kind::kValue);
    }
    for (const PlaceId place : used.shared) kinds[number[place.index]] = Kind::kShared;
  }
  Locals all;
  for (const auto& [i, kind] : kinds) (kind == Kind::kValue ? all.values : all.shared).push_back(locals[i]);
  return all;
}

}  // namespace

void ShareLocals(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  Sharing sharing{.emittable = emittable,
                  .program = program,
                  .locals = {},
                  .number = std::vector<uint32_t>(program.places.size()),
                  .is_parameter = {},
                  .known = std::vector<bool>(program.routines.size())};
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    if (emittable.layout.places[i].storage != layout::Storage::kLocal) continue;
    sharing.number[i] = static_cast<uint32_t>(sharing.locals.size());
    sharing.locals.emplace_back(i);
  }
  sharing.is_parameter.resize(sharing.locals.size());
  for (const ir::Routine& routine : program.routines) {
    for (const PlaceId place : routine.parameter_places) sharing.is_parameter[sharing.number[place.index]] = true;
  }
  emittable.routine_locals.resize(program.routines.size());
  for (uint32_t i = 0; i < program.routines.size(); ++i) sharing.Routine(ir::RoutineId(i));
  for (Chunk& chunk : emittable.chunks) sharing.Chunk(chunk);
  for (ChunkRun& run : emittable.runs) run.locals = sharing.Union(run.chunks);
}

}  // namespace plcxx::emit::legalize
