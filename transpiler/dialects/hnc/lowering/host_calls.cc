#include "transpiler/dialects/hnc/lowering/host_calls.h"

#include <utility>

namespace plcxx::hnc {

ir::HostFunctionId HostCalls::Function(std::string name, std::vector<ir::Parameter> parameters, ir::Type result,
                                       std::string comment, ir::HostAccess access) {
  const auto found = made_.find(name);
  if (found != made_.end()) return found->second;
  const bool exchange = access != ir::HostAccess::kNone;
  const ir::HostFunctionId id = program_.host_functions.Add({.name = name,
                                                             .parameters = std::move(parameters),
                                                             .result = result,
                                                             .out = {},
                                                             .access = access,
                                                             .routine_exchange = exchange,
                                                             .comment = std::move(comment)});
  made_.emplace(std::move(name), id);
  return id;
}

std::optional<ir::HostFunctionId> HostCalls::Find(std::string_view name) const {
  const auto found = made_.find(std::string(name));
  return found == made_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace plcxx::hnc
