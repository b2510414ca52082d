#include "transpiler/dialects/hnc/module_loading.h"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

namespace plcxx::hnc {
namespace {

constexpr const char* kModule = "plcxx_hnc_parser.so";

struct Loaded {
  ParseFunction parse = nullptr;
  std::string reason;
};

/// Beside the tool: ../lib of the folder in which the running program stands.
Loaded Load() {
#if PLCXX_HNC
  std::error_code error;
  const std::filesystem::path tool = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return {nullptr, "the tool's own place is not known"};
  const std::filesystem::path path = tool.parent_path().parent_path() / "lib" / kModule;
  void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (module == nullptr) return {nullptr, std::string(kModule) + " cannot be loaded from ../lib beside the tool"};
  auto parse = reinterpret_cast<ParseFunction>(dlsym(module, kParseSymbol));
  return {parse, parse == nullptr ? std::string(kModule) + " belongs to another version" : std::string()};
#else
  return {nullptr, "it was built without Clang"};
#endif
}

}  // namespace

ParseFunction LoadParser(std::string& reason) {
  static const Loaded loaded = Load();
  reason = loaded.reason;
  return loaded.parse;
}

}  // namespace plcxx::hnc
