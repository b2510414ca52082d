#include "transpiler/dialects/hnc/lowering.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/checks.h"
#include "transpiler/dialects/hnc/lowering_internal.h"

namespace plcxx::hnc {

Lowering::Lowering(Scope scope, const Unit& unit, const Settings& settings, const source::SourceManager& sources,
                   diag::Engine& diagnostics)
    : scope_(scope), unit_(unit), settings_(settings), sources_(sources), diagnostics_(diagnostics) {
  int_ = IntegerType(16, true);
  unsigned_ = IntegerType(16, false);
  long_ = IntegerType(32, true);
  unsigned_long_ = IntegerType(32, false);
  for (uint32_t i = 0; i < types_.size(); ++i) {
    if (types_[TypeId(i)].kind == TypeKind::kReal && types_[TypeId(i)].bits == 64) double_ = TypeId(i);
  }
  if (!double_.valid()) {
    double_ = types_.Add({.kind = TypeKind::kReal, .bits = 64, .size = 8, .text = "double"});
  }
}

/// The last line of the comment above a function, in one line.
std::string Lowering::CommentAbove(const Function& function) const {
  const std::vector<const Comment*> above = CommentsBefore(unit_, sources_, function.head.begin);
  if (above.empty()) return function.name + "()";
  std::string text;
  for (const char c : above.back()->text) text += c == '\n' || c == '\r' ? ' ' : c;
  return text.empty() ? function.name + "()" : text;
}

/// Routines with their parameters and results, so that bodies may call them in any order.
void Lowering::AddRoutines() {
  routines_.resize(unit_.functions.size());
  function_spaces_.resize(unit_.functions.size());
  function_bytes_.resize(unit_.functions.size());
  for (const FunctionId id : unit_.definitions) {
    if (!IsIncluded(id)) continue;
    const Function& function = unit_.functions[id];
    const bool is_init = id == unit_.init;
    routines_[id.index] =
        builder_.AddRoutine(is_init ? "plc_init" : function.name, ir::RoutineKind::kSubroutine, CommentAbove(function));
    locals_ = program_.spaces.Add(
        {.name = function.name + "_locals", .title = "", .bytes = 0, .lifetime = ir::Lifetime::kRoutine, .own = true});
    local_bytes_ = 0;
    ir::Routine& routine = program_.routines[routines_[id.index]];
    const auto parameter = [&](std::string name, ir::Type type) {
      const ir::PlaceId place = AddLocal(name, type);
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
        pointer_places_[variable_id.index] = places;
      } else if (IsArithmetic(type)) {
        const ir::PlaceId place = parameter(name, IrType(variable.type));
        if (facts_.IsInMemory(variable_id)) {
          copied_parameters_[variable_id.index] = place;
        } else {
          local_places_[variable_id.index] = place;
        }
      }
    }
    const Type& result = TypeAt(function.result);
    if (IsArithmetic(result) || result.kind == TypeKind::kPointer) {
      const ir::Type type = IrType(function.result);
      routine.result = type;
      routine.result_place = AddLocal("result", type);
      if (result.kind == TypeKind::kPointer) {
        PointerPlaces places{.offset = routine.result_place, .object = {}};
        if (facts_.ResultTargets(id).objects.size() > 1) {
          places.object = AddScalar(function.name + "_object", ir::Type::kI16);
        }
        result_pointers_[id.index] = places;
      }
    }
    function_spaces_[id.index] = locals_;
    function_bytes_[id.index] = local_bytes_;
  }
}

/// Locals of the routine, all 0 at its beginning (D30): stores that the body makes superfluous vanish.
void Lowering::BeginLocals(const Function& function) {
  const auto zero = [this](ir::PlaceId place, uint64_t value) {
    const ir::Type type = program_.places[place].type;
    builder_.Store(place, builder_.Constant(type, value, value == 0 ? 10 : 16));
  };
  for (const VariableId id : function.parameters) {
    const auto copied = copied_parameters_.find(id.index);
    if (copied == copied_parameters_.end()) continue;
    const ir::Type type = program_.places[copied->second].type;
    builder_.Store(PlaceAt(objects_.OfVariable(id), 0, type), builder_.Load(copied->second));
  }
  block_locals_ = {};
  for (const StatementId block : statements_) {
    const bool plain = unit_.statements[block].kind == StatementKind::kCompound && block != function.body;
    if (!plain || IsEntered(block)) continue;
    for (const StatementId part : unit_.statements[block].body) {
      for (const VariableId id : unit_.statements[part].variables) block_locals_.insert(id.index);
    }
  }
  for (const VariableId id : function.locals) {
    const Variable& variable = unit_.variables[id];
    if (variable.storage != Storage::kAutomatic) continue;
    const Type& type = TypeAt(variable.type);
    if (type.kind == TypeKind::kPointer) {
      PointerPlaces places;
      places.offset = AddLocal(variable.name, ir::Type::kI32);
      if (facts_.TargetsOf(id).objects.size() > 1) places.object = AddLocal(variable.name + "_object", ir::Type::kI16);
      pointer_places_[id.index] = places;
      zero(places.offset, kNullOffset);
      if (places.object.valid()) zero(places.object, 0);
    } else if (!facts_.IsInMemory(id)) {
      local_places_[id.index] = AddLocal(variable.name, IrType(variable.type));
      zero(local_places_[id.index], 0);
    } else if (!variable.initialised && objects_.OfVariable(id).valid()) {
      ClearObject(objects_.OfVariable(id));
    }
    if (facts_.IsInMemory(id)) {  // all that are no scalars are
      block_locals_.erase(id.index);
    } else if (!block_locals_.contains(id.index)) {
      flow_.unassigned.insert(id);
    }
  }
}

void Lowering::LowerFunction(FunctionId id) {
  const Function& function = unit_.functions[id];
  function_id_ = id;
  function_ = &function;
  ir::Routine& routine = program_.routines[routines_[id.index]];
  locals_ = function_spaces_[id.index];
  local_bytes_ = function_bytes_[id.index];
  result_ = routine.result_place;
  flow_ = {};
  next_label_ = 1;
  end_label_ = 0;
  targets_.clear();
  around_.clear();
  elided_break_ = {};
  end_of_switch_.clear();
  result_bounds_.reset();
  placed_labels_.clear();
  annotated_labels_.clear();
  rounds_around_ = 1;
  const Statement& body = unit_.statements[function.body];
  next_comment_ = static_cast<size_t>(
      std::ranges::lower_bound(unit_.comments, body.range.begin, {}, [](const Comment& c) { return c.range.begin; }) -
      unit_.comments.begin());
  FindLabels(function);
  const ir::RegionId prologue = builder_.NewRegion();
  const ir::RegionId region = routine.body;
  builder_.SetRange(function.range);
  builder_.SetRegion(prologue);
  program_.routines[routines_[id.index]].prologue = prologue;
  BeginLocals(function);
  builder_.SetRegion(region);
  Lower(function.body, true);
  const bool falls_off = flow_.reachable;
  if (falls_off) LeaveFunction();
  PlaceLabel(end_label_);
  if (falls_off) {
    builder_.SetRegion(prologue);
    StoreNoResult();
  }
  const bool entry = id == unit_.init || id == unit_.plc1 || id == unit_.plc2;
  const bool gives = TypeAt(function.result).kind != TypeKind::kVoid;
  if (falls_off && gives && !entry) diagnostics_.Report(function.range, diag::HncNoReturnValue, function.name);
  if (falls_off && gives && result_bounds_) result_bounds_ = Join(*result_bounds_, {0, 0});
  if (result_bounds_) bounds_of_results_[id.index] = *result_bounds_;
}

/// Callees before their callers, so that bounds of results are known.
std::vector<FunctionId> Lowering::CalleesFirst() const {
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

ir::Program Lowering::Run() {
  program_.dialect = "hnc";
  const bool has_entries = unit_.init.valid() && unit_.plc1.valid() && unit_.plc2.valid();
  AddSpaces();
  AddVariables();
  CollectCellNames();
  AddScheduleScalars();
  AddFaultRoutine();
  facts_stated_.Begin(settings_.facts);
  AddRoutines();
  for (const FunctionId id : CalleesFirst()) LowerFunction(id);
  if (!has_entries || scope_ == Scope::kAll || diagnostics_.HasErrors()) return {};
  AddScheduleRoutines();
  AddSymbols();
  Document();
  program_.spaces[system_].bytes = system_bytes_;
  program_.spaces[pointers_].bytes = pointer_bytes_;
  program_.spaces[arguments_].bytes = argument_bytes_;
  return std::move(program_);
}

ir::Program Lower(const Unit& unit, const Settings& settings, const source::SourceManager& sources,
                  diag::Engine& diagnostics) {
  const Objects objects(unit);
  const Facts facts(unit, objects);
  Check(unit, objects, facts, sources, diagnostics);
  const bool unreached = std::ranges::any_of(unit.definitions, [&](FunctionId id) { return facts.PartsOf(id) == 0; });
  // What is reported of a function twice is kept once.
  if (unreached) Lowering(Scope::kAll, unit, settings, sources, diagnostics).Run();
  return Lowering(Scope::kReached, unit, settings, sources, diagnostics).Run();
}

}  // namespace plcxx::hnc
