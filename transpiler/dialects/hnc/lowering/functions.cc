#include "transpiler/dialects/hnc/lowering/functions.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "transpiler/dialects/hnc/lowering/cell_places.h"
#include "transpiler/dialects/hnc/lowering/gotos.h"
#include "transpiler/dialects/hnc/lowering/intervals.h"
#include "transpiler/dialects/hnc/lowering/jumps.h"
#include "transpiler/dialects/hnc/lowering/live_path.h"
#include "transpiler/dialects/hnc/lowering/locals.h"
#include "transpiler/dialects/hnc/lowering/memory.h"
#include "transpiler/dialects/hnc/lowering/records.h"
#include "transpiler/dialects/hnc/lowering/returns.h"
#include "transpiler/dialects/hnc/lowering/statement_writer.h"
#include "transpiler/dialects/hnc/lowering/statements.h"
#include "transpiler/dialects/hnc/lowering/switches.h"

namespace plcxx::hnc {

std::string Functions::LinesOf(const std::vector<const Comment*>& comments) const {
  std::vector<source::Range> lines;
  for (const Comment* comment : comments) AddCommentLines(sources_.Text(comment->range), comment->range.begin, lines);
  std::string text;
  for (const source::Range& line : lines) {
    if (!text.empty()) text += '\n';
    text += sources_.Text(line);
  }
  return text;
}

/// The comments above a function and in its head; with the first one of its file those at the head of the file.
void Functions::AddComments(const Function& function, ir::Routine& routine) {
  std::vector<const Comment*> comments = CommentsBefore(unit_, sources_, function.head.begin);
  std::vector<const Comment*> of_file;
  const source::FileId file = sources_.FileAt(function.head.begin);
  if (begun_files_.insert(file.index).second) of_file = CommentsAtHead(unit_, sources_, file);
  if (!comments.empty()) std::erase_if(of_file, [&](const Comment* head) { return head >= comments.front(); });
  const source::Range head = {function.head.begin, unit_.statements[function.body].range.begin};
  std::ranges::copy(CommentsIn(unit_, head), std::back_inserter(comments));
  routine.file_comment = LinesOf(of_file);
  routine.comment = LinesOf(comments);
  if (routine.comment.empty()) routine.comment = function.name + "()";
}

void Functions::AddRoutines() {
  placement_.routines.resize(unit_.functions.size());
  own_locals_.resize(unit_.functions.size());
  for (const FunctionId id : unit_.definitions) {
    if (!IsIncluded(id)) continue;
    const Function& function = unit_.functions[id];
    const bool is_init = id == unit_.init;
    placement_.routines[id.index] =
        builder_.AddRoutine(is_init ? "plc_init" : function.name, ir::RoutineKind::kSubroutine, "");
    locals_.Begin(function.name + "_locals");
    ir::Routine& routine = program_.routines[placement_.routines[id.index]];
    AddComments(function, routine);
    const auto parameter = [&](std::string name, ir::Type type) {
      const ir::PlaceId place = locals_.Add(name, type);
      routine.parameters.push_back({.name = std::move(name), .type = type, .enumerators = {}});
      routine.parameter_places.push_back(place);
      return place;
    };
    for (const VariableId variable_id : function.parameters) {
      const Variable& variable = unit_.variables[variable_id];
      const Type& type = TypeAt(variable.type);
      const std::string name = variable.name.empty() ? "unnamed" : variable.name;
      if (type.kind == TypeKind::kPointer) {
        PointerPlaces places;
        places.offset = parameter(name, ir::Type::kI32);
        if (facts_.TargetsOf(variable_id).objects.size() > 1)
          places.object = parameter(name + "_object", ir::Type::kI16);
        placement_.pointers[variable_id.index] = places;
      } else if (IsArithmetic(type)) {
        const ir::PlaceId place = parameter(name, IrType(variable.type));
        if (facts_.IsInMemory(variable_id)) {
          copied_parameters_[variable_id.index] = place;
        } else {
          placement_.locals[variable_id.index] = place;
        }
      }
    }
    const Type& result = TypeAt(function.result);
    if (IsArithmetic(result) || result.kind == TypeKind::kPointer) {
      const ir::Type type = IrType(function.result);
      routine.result = type;
      routine.result_place = locals_.Add("result", type);
      if (result.kind == TypeKind::kPointer) {
        PointerPlaces places{.offset = routine.result_place, .object = {}};
        if (facts_.ResultTargets(id).objects.size() > 1) {
          places.object = memory_.AddScalar(function.name + "_object", ir::Type::kI16);
        }
        placement_.results[id.index] = places;
      }
    }
    own_locals_[id.index] = locals_.position();
  }
}

/// Locals of the routine, all 0 at its beginning (D30): stores that the body makes superfluous vanish.
void Functions::BeginLocals(const Function& function) {
  const auto zero = [this](ir::PlaceId place, uint64_t value) {
    const ir::Type type = program_.places[place].type;
    builder_.Store(place, builder_.Constant(type, value, value == 0 ? 10 : 16));
  };
  for (const VariableId id : function.parameters) {
    const auto copied = copied_parameters_.find(id.index);
    if (copied == copied_parameters_.end()) continue;
    const ir::Type type = program_.places[copied->second].type;
    const ir::ValueId handed = builder_.Load(copied->second);
    const ir::PlaceId copy = places_.At(objects_.OfVariable(id), 0, type);
    builder_.Store(copy, handed);
  }
  frame_.block_locals = {};
  for (const StatementId block : jumps_.statements()) {
    const bool plain = unit_.statements[block].kind == StatementKind::kCompound && block != function.body;
    if (!plain || jumps_.IsEntered(block)) continue;
    for (const StatementId part : unit_.statements[block].body) {
      for (const VariableId id : unit_.statements[part].variables) frame_.block_locals.insert(id.index);
    }
  }
  for (const VariableId id : function.locals) {
    const Variable& variable = unit_.variables[id];
    if (variable.storage != Storage::kAutomatic) continue;
    const Type& type = TypeAt(variable.type);
    if (type.kind == TypeKind::kPointer) {
      PointerPlaces places;
      places.offset = locals_.Add(variable.name, ir::Type::kI32);
      if (facts_.TargetsOf(id).objects.size() > 1)
        places.object = locals_.Add(variable.name + "_object", ir::Type::kI16);
      placement_.pointers[id.index] = places;
      zero(places.offset, kNullOffset);
      if (places.object.valid()) zero(places.object, 0);
    } else if (!facts_.IsInMemory(id)) {
      placement_.locals[id.index] = locals_.Add(variable.name, IrType(variable.type));
      zero(placement_.locals[id.index], 0);
    } else if (!variable.initialised && objects_.OfVariable(id).valid()) {
      records_.Clear(objects_.OfVariable(id));
    }
    if (facts_.IsInMemory(id)) {  // all that are no scalars are
      frame_.block_locals.erase(id.index);
    } else if (!frame_.block_locals.contains(id.index)) {
      flow_.unassigned.insert(id);
    }
  }
}

void Functions::Lower(FunctionId id) {
  const Function& function = unit_.functions[id];
  ir::Routine& routine = program_.routines[placement_.routines[id.index]];
  locals_.Resume(own_locals_[id.index]);
  frame_ = {.id = id, .function = &function, .result = routine.result_place, .bounds = {}, .block_locals = {}};
  flow_ = {};
  path_.BeginFunction();
  gotos_.BeginFunction();
  switches_.BeginFunction();
  writer_.BeginFunction(function);
  jumps_.Find(function);
  const ir::RegionId prologue = builder_.NewRegion();
  const ir::RegionId region = routine.body;
  builder_.SetRange(function.range);
  builder_.SetRegion(prologue);
  program_.routines[placement_.routines[id.index]].prologue = prologue;
  BeginLocals(function);
  builder_.SetRegion(region);
  statements_.Lower(function.body, Tail::kFunction);
  const bool falls_off = flow_.reachable;
  if (falls_off) returns_.Leave();
  path_.PlaceLabel(LivePath::kEndOfFunction);
  if (falls_off) {
    builder_.SetRegion(prologue);
    returns_.StoreNoResult();
  }
  const bool entry = id == unit_.init || id == unit_.plc1 || id == unit_.plc2;
  const bool gives = TypeAt(function.result).kind != TypeKind::kVoid;
  if (falls_off && gives && !entry) diagnostics_.Report(function.range, diag::HncNoReturnValue, function.name);
  if (falls_off && gives && frame_.bounds) frame_.bounds = Join(*frame_.bounds, {0, 0});
  if (frame_.bounds) intervals_.SetResult(id, *frame_.bounds);
}

std::vector<FunctionId> Functions::CalleesFirst() const {
  std::vector<FunctionId> order;
  std::vector<bool> seen(unit_.functions.size());
  for (const FunctionId root : unit_.definitions) {
    std::vector<std::pair<FunctionId, size_t>> open = {{root, 0}};
    if (seen[root.index]) continue;
    seen[root.index] = true;
    while (!open.empty()) {
      auto& [id, next] = open.back();
      const std::vector<FunctionId>& callees = facts_.CalleesOf(id);
      if (next == callees.size()) {
        if (unit_.functions[id].is_defined && !unit_.functions[id].system && IsIncluded(id)) order.push_back(id);
        open.pop_back();
        continue;
      }
      const FunctionId callee = callees[next++];
      if (seen[callee.index]) continue;
      seen[callee.index] = true;
      open.emplace_back(callee, 0);
    }
  }
  return order;
}

}  // namespace plcxx::hnc
