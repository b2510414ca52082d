#include "transpiler/compile/audit_module.h"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

namespace plcxx::compile {
namespace {

struct Loaded {
  ReadObjectFunction read = nullptr;
  std::string reason;
};

#if PLCXX_AUDIT
constexpr const char* kModule = "plcxx_audit.so";

/// Beside the tool: ../lib of the folder in which the running program stands.
Loaded Load() {
  std::error_code error;
  const std::filesystem::path tool = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return {nullptr, "the tool's own place is not known"};
  const std::filesystem::path path = tool.parent_path().parent_path() / "lib" / kModule;
  void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (module == nullptr) return {nullptr, std::string(kModule) + " cannot be loaded from ../lib beside the tool"};
  auto read = reinterpret_cast<ReadObjectFunction>(dlsym(module, kReadObjectSymbol));
  return {read, read == nullptr ? std::string(kModule) + " belongs to another version" : std::string()};
}
#else
Loaded Load() { return {nullptr, "this plcxx was built without LLVM"}; }
#endif

}  // namespace

ReadObjectFunction LoadObjectReader(std::string& reason) {
  static const Loaded loaded = Load();
  reason = loaded.reason;
  return loaded.read;
}

}  // namespace plcxx::compile
