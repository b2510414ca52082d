// What needs large libraries is a module beside the tool, loaded when it is asked for: other commands do not pay for
// it.
#pragma once

#include <string>

namespace plcxx::support {

struct ModuleFunction {
  void* address = nullptr;
  std::string reason;  // why there is none; lower case, no full stop
};

/// The function `symbol` of `module` ("plcxx_audit.so") in ../lib of the folder in which the running program stands.
/// The module stays loaded.
ModuleFunction LoadFunction(const std::string& module, const char* symbol);

}  // namespace plcxx::support
