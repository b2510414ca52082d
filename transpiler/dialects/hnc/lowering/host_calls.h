// Functions of the host that the program calls, each once.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class HostCalls : Context {
 public:
  explicit HostCalls(const Context& context) : Context(context) {}

  ir::HostFunctionId Function(std::string name, std::vector<ir::Parameter> parameters, ir::Type result,
                              std::string comment, ir::HostAccess access = ir::HostAccess::kNone);
  /// None: nothing calls it.
  std::optional<ir::HostFunctionId> Find(std::string_view name) const;

 private:
  std::unordered_map<std::string, ir::HostFunctionId> made_;
};

}  // namespace plcxx::hnc
