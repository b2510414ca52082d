// The parameters of each function, and which of them its text uses: the others have no name in its head, for compilers
// report a parameter that nothing reads.

#include <algorithm>
#include <unordered_set>

#include "transpiler/emit/function_insts.h"
#include "transpiler/emit/legalize/steps.h"
#include "transpiler/ir/builder.h"

namespace plcxx::emit::legalize {
namespace {

using ir::PlaceId;

/// What the text of a function names.
struct UsedNames {
  const Emittable& emittable;
  const ir::Program& program;
  bool state = false, host = false;
  std::unordered_set<uint32_t> places = {};  // locals
  bool in_statement = false;

  void Place(PlaceId place);
  void Inst(ir::InstId id);
  void Switchable(const ir::Inst& inst);
  void HostCall(const ir::Call& call);
  void Call(const Locals& passed);
  void Mark(Locals& locals) const;
};

void UsedNames::Place(PlaceId place) {
  if (!place.valid()) return;
  if (emittable.layout.places[place.index].storage == layout::Storage::kLocal) {
    places.insert(place.index);
  } else {
    state = true;
  }
}

void UsedNames::HostCall(const ir::Call& call) {
  host = true;
  state = state || program.host_functions[call.host].access != ir::HostAccess::kNone;
  Place(call.out);
}

/// A call of one of the generated functions.
void UsedNames::Call(const Locals& passed) {
  state = host = true;
  for (const PlaceId place : passed.values) places.insert(place.index);
  for (const PlaceId place : passed.shared) places.insert(place.index);
}

/// The debug flavour asks the state whether a statement is switched on.
void UsedNames::Switchable(const ir::Inst& inst) {
  if (emittable.options.flavour != Flavour::kDebug) return;
  if (inst.op == ir::OpKind::kStatement) {
    in_statement = true;
    const ir::Statement& statement = program.statements[ir::StatementId(inst.payload)];
    state = state || (!statement.opens_block && !statement.closes_block);
  }
  const bool conditional = inst.op == ir::OpKind::kIf || inst.op == ir::OpKind::kLoop;
  state = state || (conditional && in_statement);
}

void UsedNames::Inst(ir::InstId id) {
  const ir::Inst& inst = program[id];
  Switchable(inst);
  if (emittable.forms[id.index] == Form::kNowhere) return;
  switch (ir::Info(inst.op).shape) {
    case ir::Shape::kLoad:
    case ir::Shape::kStore:
      Place(PlaceId(inst.payload));
      return;
    case ir::Shape::kStep:
    case ir::Shape::kText:
      state = true;
      return;
    case ir::Shape::kRepeat:
      Place(program.loops[ir::LoopId(program[ir::InstId(inst.payload)].payload)].budget);
      return;
    case ir::Shape::kHostCall:
      HostCall(program.calls[ir::CallId(inst.payload)]);
      return;
    case ir::Shape::kCall: {
      const ir::RoutineId callee = program.calls[ir::CallId(inst.payload)].routine;
      state = host = true;
      for (const PlaceId place : emittable.routine_locals[callee.index].shared) places.insert(place.index);
      return;
    }
    case ir::Shape::kPure:
    case ir::Shape::kConst:
    case ir::Shape::kStatement:
    case ir::Shape::kIf:
    case ir::Shape::kSwitch:
    case ir::Shape::kLoop:
    case ir::Shape::kBlock:
    case ir::Shape::kExit:
    case ir::Shape::kJump:
    case ir::Shape::kLabel:
      return;
  }
}

/// The parameters in the order of the head: the state, values, references, the host.
void UsedNames::Mark(Locals& locals) const {
  const auto add = [&](PlaceId place, std::string_view reference) {
    locals.parameters.push_back({std::string(ir::CppName(program.places[place].type)).append(reference),
                                 emittable.place_names[place.index], places.contains(place.index)});
  };
  locals.parameters = {{"State&", "m", state}};
  for (const PlaceId place : locals.values) add(place, "");
  for (const PlaceId place : locals.shared) add(place, "&");
  locals.parameters.push_back({"Host&", "host", host});
}

UsedNames NamesOf(const Emittable& emittable, const std::vector<Piece>& pieces) {
  UsedNames names{.emittable = emittable, .program = *emittable.program};
  VisitFunction(emittable, pieces,
                {.inst = [&](ir::InstId id) { names.Inst(id); },
                 .chunk = [&](uint32_t chunk) { names.Call(emittable.chunks[chunk].locals); }});
  return names;
}

}  // namespace

void FindUsedParameters(Emittable& emittable) {
  const ir::Program& program = *emittable.program;
  for (Chunk& chunk : emittable.chunks) NamesOf(emittable, {PieceOf(chunk)}).Mark(chunk.locals);
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    UsedNames names = NamesOf(emittable, PiecesOf(emittable, ir::RoutineId(i)));
    const bool debug = emittable.options.flavour == Flavour::kDebug;
    const bool init = program.routines[ir::RoutineId(i)].kind == ir::RoutineKind::kInit;
    names.state = names.state || (init && (debug || !emittable.layout.members.empty()));
    names.Mark(emittable.routine_locals[i]);
  }
  for (ChunkRun& run : emittable.runs) {
    UsedNames names{.emittable = emittable, .program = program};
    names.Call(run.locals);
    names.Mark(run.locals);
  }
}

}  // namespace plcxx::emit::legalize
