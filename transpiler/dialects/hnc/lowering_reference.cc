// Which functions and variables of the sources are which routines and bytes of the program (ir/reference.h).

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "transpiler/dialects/hnc/lowering_internal.h"
#include "transpiler/dialects/hnc/machine.h"
#include "transpiler/dialects/hnc/product_names.h"

namespace plcxx::hnc {

ir::ReferenceBytes Lowering::BytesOf(ObjectId object) const {
  return {.space = object_space_[object.index], .offset = object_begin_[object.index], .bytes = objects_[object].size};
}

void Lowering::DescribeAreas(const ir::Program& program, ir::Reference& reference) const {
  for (const AreaRow& area : Areas()) {
    const ir::ReferenceBytes at{
        .space = area_spaces_[static_cast<size_t>(area.area)], .offset = 0, .bytes = area.bytes};
    reference.variables.push_back({.name = std::string(area.name), .at = at, .is_table = area.table});
    for (const ViewRow& view : Views()) {
      reference.variables.push_back(
          {.name = std::string(area.name) + std::string(view.suffix), .at = at, .is_table = area.table});
    }
  }
  for (const auto& [name, place] : {std::pair("plc1_time", period1_), std::pair("plc2_time", period2_)}) {
    const ir::Place& period = program.places[place];
    reference.variables.push_back(
        {.name = name, .at = {.space = period.space, .offset = period.offset, .bytes = ir::Bytes(period.type)}});
  }
}

void Lowering::DescribeVariables(ir::Reference& reference) const {
  std::set<std::string> names;
  for (const ir::ReferenceVariable& variable : reference.variables) names.insert(variable.name);
  for (uint32_t i = 0; i < objects_.size(); ++i) {
    const Object& object = objects_[ObjectId(i)];
    if (object.kind != ObjectKind::kVariable || object_space_[i] != data_) continue;
    const Variable& variable = unit_.variables[VariableId(object.index)];
    const bool is_local = variable.storage == Storage::kStaticLocal;
    std::string name = is_local ? object.name : variable.name;
    // The second static variable of one name in a function: the bitcode's name for it cannot be told.
    if (!names.insert(name).second) continue;
    reference.variables.push_back(
        {.name = std::move(name), .at = BytesOf(ObjectId(i)), .is_constant = variable.is_const});
  }
}

std::string Lowering::WhyInCallers(const Function& function) const {
  const auto what = [this](TypeId type) {
    const TypeKind kind = TypeAt(type).kind;
    return kind == TypeKind::kRecord ? "a structure" : kind == TypeKind::kPointer ? "a pointer" : "";
  };
  for (const VariableId parameter : function.parameters) {
    const TypeId type = unit_.variables[parameter].type;
    const std::string kind = what(type);
    if (!kind.empty()) return kind + " as a parameter";
    const bool is_promoted =
        TypeAt(type).bits == 8 || (TypeAt(type).kind == TypeKind::kReal && TypeAt(type).bits == 32);
    if (!function.has_prototype && is_promoted) return "a promoted parameter";
  }
  const std::string kind = what(function.result);
  return kind.empty() ? kind : kind + " as a result";
}

void Lowering::DescribeFunction(FunctionId id, ir::Reference& reference) const {
  const Function& function = unit_.functions[id];
  ir::ReferenceFunction described{
      .name = function.name, .routine = routines_[id.index], .locals = {}, .result = {}, .in_callers = {}};
  const auto type_of = [this](VariableId variable) { return TypeAt(unit_.variables[variable].type).kind; };
  const auto add = [&](VariableId variable, bool is_parameter) {
    const ObjectId object = objects_.OfVariable(variable);
    if (!facts_.IsInMemory(variable) || !object.valid() || type_of(variable) == TypeKind::kPointer) return;
    described.locals.push_back(
        {.name = unit_.variables[variable].name, .at = BytesOf(object), .is_parameter = is_parameter});
  };
  for (const VariableId parameter : function.parameters) add(parameter, true);
  described.in_callers = WhyInCallers(function);
  if (TypeAt(function.result).kind == TypeKind::kRecord) described.result = BytesOf(objects_.OfResult(id));
  for (const VariableId local : function.locals) {
    if (unit_.variables[local].storage == Storage::kAutomatic) add(local, false);
  }
  reference.functions.push_back(std::move(described));
}

/// Calls that are no calls in the program (6.8, 7.3).
void Lowering::DescribeEffects(const ir::Program& program, ir::Reference& reference) const {
  for (const Registration& registration : facts_.registrations()) {
    const char kind = kHandlerKinds[registration.kind];
    const FunctionId handler = registration.function;
    ir::ReferenceEffect effect{.function = "set_mst_func",
                               .arguments = {std::to_string(registration.channel), std::to_string(int{kind}),
                                             handler.valid() ? unit_.functions[handler].name : "0"},
                               .stores_at = {},
                               .host = {}};
    const ir::PlaceId slot = handler_slots_[registration.channel][registration.kind];
    if (slot.valid()) {
      const std::vector<FunctionId>& handlers = handlers_[registration.channel][registration.kind];
      const ir::Place& place = program.places[slot];
      effect.stores_at = {.space = place.space, .offset = place.offset, .bytes = 1};
      if (handler.valid())
        effect.value = static_cast<uint8_t>(std::ranges::find(handlers, handler) - handlers.begin() + 1);
    }
    reference.effects.push_back(std::move(effect));
  }
  if (!critical_flag_.valid()) return;
  const ir::Place& flag = program.places[critical_flag_];
  for (const auto& [name, host, value] :
       {std::tuple(kCliName, "critical_enter", 1), std::tuple(std::string_view("disable"), "critical_enter", 1),
        std::tuple(kStiName, "critical_leave", 0), std::tuple(std::string_view("enable"), "critical_leave", 0)}) {
    const auto found = host_.find(host);
    if (found == host_.end()) continue;
    reference.effects.push_back(
        {.function = std::string(name),
         .arguments = {},
         .stores_at = ir::ReferenceBytes{.space = flag.space, .offset = flag.offset, .bytes = 1},
         .mask = 1,
         .value = static_cast<uint8_t>(value),
         .host = found->second});
  }
}

void Lowering::DescribeCallees(const ir::Program& program, ir::Reference& reference) const {
  for (const auto& [function, routine] : system_routines_) {
    reference.callees.push_back(
        {.name = std::string(SystemFunctions()[function].name), .routine = routine, .host = {}});
  }
  for (const FunctionRow& row : SystemFunctions()) {
    const std::string_view host_name = HostNameOf(row.function);
    const auto host = host_.find(std::string(host_name));
    if (settings_.sysfunc != SysfuncOption::kHost || host_name.empty() || host == host_.end()) continue;
    reference.callees.push_back({.name = std::string(row.name), .routine = {}, .host = host->second});
  }
  std::ranges::sort(reference.callees, {}, &ir::ReferenceCallee::name);
  DescribeEffects(program, reference);
}

ir::Reference Lowering::Describe(const ir::Program& program) const {
  ir::Reference reference;
  reference.fault = fault_;
  reference.undefined_faults = {static_cast<uint64_t>(Fault::kDivision), static_cast<uint64_t>(Fault::kIndex)};
  DescribeAreas(program, reference);
  DescribeVariables(reference);
  for (const FunctionId id : unit_.definitions) {
    if (routines_[id.index].valid()) DescribeFunction(id, reference);
  }
  DescribeCallees(program, reference);
  return reference;
}

ir::Reference DescribeLowered(const Unit& unit, const Settings& settings, const source::SourceManager& sources,
                              diag::Engine& diagnostics) {
  Lowering lowering(Scope::kReached, unit, settings, sources, diagnostics);
  const ir::Program program = lowering.Run();
  if (program.routines.empty()) return {.reason = "the program has errors"};
  return lowering.Describe(program);
}

}  // namespace plcxx::hnc
