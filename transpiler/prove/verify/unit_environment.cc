#include "transpiler/prove/verify/unit_environment.h"

namespace plcxx::prove::verify {

terms::TermId UnitEnvironment::CallControl(CodeMemory& memory, const HostRequest& request, std::string& refusal) {
  std::string_view name = request.function;
  name.remove_prefix(std::min(program_.emittable.namespace_name.size() + 2, name.size()));
  const auto host = std::ranges::find(program_.shape.hosts, name, &std::pair<std::string, ir::HostFunctionId>::first);
  if (host != program_.shape.hosts.end()) {
    const std::string function = program_.CppName(program_.ir.host_functions[host->second].name);
    std::vector<HostArgument> arguments = {{.kind = HostArgument::Kind::kHost, .value = {}, .name = {}}};
    const ir::HostFunction& called = program_.ir.host_functions[host->second];
    if (called.access != ir::HostAccess::kNone)
      arguments.push_back(
          {.kind = HostArgument::Kind::kMemory, .value = {}, .slot = 0, .bytes = program_.image.size(), .name = {}});
    arguments.insert(arguments.end(), request.arguments.begin(), request.arguments.end());
    return HostEnvironment::CallHost(
        memory, {.function = function, .arguments = arguments, .result_width = request.result_width}, refusal);
  }
  std::vector<terms::TermId> values;
  for (const HostArgument& argument : request.arguments) {
    if (argument.kind == HostArgument::Kind::kValue) values.push_back(argument.value);
  }
  const bool numbers = values.size() == request.arguments.size() && program_.shape.library;
  const terms::TermId result = numbers ? program_.shape.library(terms_, name, values) : terms::TermId();
  if (!result.valid()) refusal = "a call of " + std::string(name);
  return result;
}

}  // namespace plcxx::prove::verify
