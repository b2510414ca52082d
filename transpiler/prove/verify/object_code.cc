#include "transpiler/prove/verify/object_code.h"

#include "transpiler/ir/program.h"
#include "transpiler/prove/verify/units.h"
#include "transpiler/support/module.h"
#include "transpiler/symbolic/execute/cells.h"
#include "transpiler/symbolic/meaning/meaning.h"

namespace plcxx::prove::verify {
namespace {

SignatureParameter Value(std::string name, ir::Type type) {
  return {.name = std::move(name), .width = meaning::WidthOf(type)};
}

uint8_t ResultWidth(ir::Type type) { return type == ir::Type::kNone ? uint8_t{0} : meaning::WidthOf(type); }

Signature OfUnit(const emit::Emittable& emittable, const Unit& unit) {
  const ir::Program& program = *emittable.program;
  Signature signature{.function = emittable.namespace_name + "::" + unit.name, .parameters = {{.name = "m"}}};
  for (const ir::PlaceId id : unit.values)
    signature.parameters.push_back(Value(emittable.place_names[id.index], program.places[id].type));
  for (const ir::PlaceId id : unit.references) signature.parameters.push_back({emittable.place_names[id.index]});
  signature.parameters.push_back({.name = "host"});
  if (unit.result.valid()) signature.result_width = ResultWidth(program.places[unit.result].type);
  return signature;
}

Signature OfHost(const emit::Emittable& emittable, const ir::HostFunction& host) {
  Signature signature{.function = emittable.namespace_name + "::" + host.name, .parameters = {{.name = "host"}}};
  if (host.access != ir::HostAccess::kNone) signature.parameters.push_back({.name = "m"});
  for (const ir::Parameter& parameter : host.parameters)
    signature.parameters.push_back(Value(parameter.name, parameter.type));
  if (!host.out.name.empty()) signature.parameters.push_back({host.out.name});
  if (host.access != ir::HostAccess::kWritesRetentive) signature.result_width = ResultWidth(host.result);
  return signature;
}

}  // namespace

std::vector<Signature> SignaturesOf(const emit::Emittable& emittable) {
  const execute::Cells cells = execute::MakeCells(*emittable.program);
  std::vector<Signature> signatures;
  for (const Unit& unit : MakeUnits(emittable, cells).all) signatures.push_back(OfUnit(emittable, unit));
  for (const ir::HostFunction& host : emittable.program->host_functions) signatures.push_back(OfHost(emittable, host));
  return signatures;
}

LoadedCode LoadObjectCode(const ObjectCodeRequest& request) {
  const support::ModuleFunction function = support::LoadFunction(kVerifyModule, kReadObjects);
  if (function.address == nullptr) return {.code = nullptr, .reason = function.reason};
  auto* const read = reinterpret_cast<ReadObjectsFunction*>(function.address);
  LoadedCode loaded;
  loaded.code.reset(read(request, loaded.reason));
  return loaded;
}

}  // namespace plcxx::prove::verify
