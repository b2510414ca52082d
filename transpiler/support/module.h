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

/// A library that was made while the tool runs; open as long as the object lives, also when its file is gone.
class LoadedLibrary {
 public:
  explicit LoadedLibrary(const std::string& path);
  ~LoadedLibrary();
  LoadedLibrary(const LoadedLibrary&) = delete;
  LoadedLibrary& operator=(const LoadedLibrary&) = delete;
  /// Null when there is none; `reason` says why.
  void* Find(const char* symbol);
  const std::string& reason() const { return reason_; }

 private:
  void* handle_ = nullptr;
  std::string reason_;
};

}  // namespace plcxx::support
