#include "transpiler/dialects/hnc/lowering/reference_writer.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "transpiler/dialects/hnc/lowering/critical_sections.h"
#include "transpiler/dialects/hnc/lowering/faults.h"
#include "transpiler/dialects/hnc/lowering/handlers.h"
#include "transpiler/dialects/hnc/lowering/host_calls.h"
#include "transpiler/dialects/hnc/lowering/memory.h"
#include "transpiler/dialects/hnc/lowering/schedule.h"
#include "transpiler/dialects/hnc/lowering/system_functions.h"
#include "transpiler/dialects/hnc/lowering/system_routines.h"
#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/dialects/hnc/machine/product_names.h"

namespace plcxx::hnc {

ir::ReferenceBytes ReferenceWriter::BytesOf(ObjectId object) const {
  return {.space = memory_.SpaceOf(object), .offset = memory_.BeginOf(object), .bytes = objects_[object].size};
}

void ReferenceWriter::DescribeAreas(const ir::Program& program, ir::Reference& reference) const {
  for (const AreaRow& area : Areas()) {
    const ir::ReferenceBytes at{.space = memory_.SpaceOf(area.area), .offset = 0, .bytes = area.bytes};
    reference.variables.push_back({.name = std::string(area.name), .at = at, .is_table = area.table});
    for (const ViewRow& view : Views()) {
      reference.variables.push_back(
          {.name = std::string(area.name) + std::string(view.suffix), .at = at, .is_table = area.table});
    }
  }
  for (const auto& [name, place] :
       {std::pair("plc1_time", schedule_.period1()), std::pair("plc2_time", schedule_.period2())}) {
    const ir::Place& period = program.places[place];
    reference.variables.push_back(
        {.name = name, .at = {.space = period.space, .offset = period.offset, .bytes = ir::Bytes(period.type)}});
  }
}

void ReferenceWriter::DescribeVariables(ir::Reference& reference) const {
  std::set<std::string> names;
  for (const ir::ReferenceVariable& variable : reference.variables) names.insert(variable.name);
  for (uint32_t i = 0; i < objects_.size(); ++i) {
    const Object& object = objects_[ObjectId(i)];
    if (!memory_.IsData(ObjectId(i))) continue;
    const Variable& variable = unit_.variables[VariableId(object.index)];
    const bool is_local = variable.storage == Storage::kStaticLocal;
    std::string name = is_local ? object.name : variable.name;
    // The second static variable of one name in a function: the bitcode's name for it cannot be told.
    if (!names.insert(name).second) continue;
    reference.variables.push_back(
        {.name = std::move(name), .at = BytesOf(ObjectId(i)), .is_constant = variable.is_const});
  }
}

std::string ReferenceWriter::WhyInCallers(const Function& function) const {
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

void ReferenceWriter::DescribeFunction(FunctionId id, ir::Reference& reference) const {
  const Function& function = unit_.functions[id];
  ir::ReferenceFunction described{.name = function.name,
                                  .routine = placement_.routines[id.index],
                                  .locals = {},
                                  .result = {},
                                  .in_callers = {},
                                  .read_otherwise = function.clang_differs};
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
void ReferenceWriter::DescribeEffects(const ir::Program& program, ir::Reference& reference) const {
  for (const Registration& registration : facts_.registrations()) {
    const char kind = kHandlerKinds[registration.kind];
    const FunctionId handler = registration.function;
    ir::ReferenceEffect effect{.function = "set_mst_func",
                               .arguments = {std::to_string(registration.channel), std::to_string(int{kind}),
                                             handler.valid() ? unit_.functions[handler].name : "0"},
                               .stores_at = {},
                               .host = {}};
    const ir::PlaceId slot = handlers_.SlotOf(registration);
    if (slot.valid()) {
      const ir::Place& place = program.places[slot];
      effect.stores_at = {.space = place.space, .offset = place.offset, .bytes = 1};
      effect.value = handlers_.NumberOf(registration);
    }
    reference.effects.push_back(std::move(effect));
  }
  if (!critical_.flag().valid()) return;
  const ir::Place& flag = program.places[critical_.flag()];
  for (const auto& [name, host, value] :
       {std::tuple(kCliName, "critical_enter", 1), std::tuple(std::string_view("disable"), "critical_enter", 1),
        std::tuple(kStiName, "critical_leave", 0), std::tuple(std::string_view("enable"), "critical_leave", 0)}) {
    const std::optional<ir::HostFunctionId> found = host_calls_.Find(host);
    if (!found) continue;
    reference.effects.push_back(
        {.function = std::string(name),
         .arguments = {},
         .stores_at = ir::ReferenceBytes{.space = flag.space, .offset = flag.offset, .bytes = 1},
         .mask = 1,
         .value = static_cast<uint8_t>(value),
         .host = *found});
  }
}

void ReferenceWriter::DescribeCallees(const ir::Program& program, ir::Reference& reference) const {
  for (const auto& [function, routine] : system_routines_.routines()) {
    reference.callees.push_back(
        {.name = std::string(SystemFunctions()[function].name), .routine = routine, .host = {}});
  }
  for (const FunctionRow& row : SystemFunctions()) {
    const SystemSignature* signature = SignatureOf(row.function);
    if (settings_.sysfunc != SysfuncOption::kHost || signature == nullptr) continue;
    const std::optional<ir::HostFunctionId> host = host_calls_.Find(signature->host_name);
    if (!host) continue;
    reference.callees.push_back({.name = std::string(row.name), .routine = {}, .host = *host});
  }
  std::ranges::sort(reference.callees, {}, &ir::ReferenceCallee::name);
  DescribeEffects(program, reference);
}

ir::Reference ReferenceWriter::Describe(const ir::Program& program) const {
  ir::Reference reference;
  reference.fault = faults_.routine();
  reference.undefined_faults = {static_cast<uint64_t>(Fault::kDivision), static_cast<uint64_t>(Fault::kIndex)};
  DescribeAreas(program, reference);
  DescribeVariables(reference);
  for (const FunctionId id : unit_.definitions) {
    if (placement_.routines[id.index].valid()) DescribeFunction(id, reference);
  }
  DescribeCallees(program, reference);
  return reference;
}

}  // namespace plcxx::hnc
