#include "transpiler/support/module.h"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

namespace plcxx::support {

ModuleFunction LoadFunction(const std::string& module, const char* symbol) {
  std::error_code error;
  const std::filesystem::path tool = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return {nullptr, "the tool's own place is not known"};
  const std::filesystem::path path = tool.parent_path().parent_path() / "lib" / module;
  void* const handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    // The loader's own words: the file is missing, or a library that it needs.
    const char* const cause = dlerror();
    return {nullptr, module + " cannot be loaded: " + (cause != nullptr ? cause : "no cause was given")};
  }
  void* const address = dlsym(handle, symbol);
  return {address, address == nullptr ? module + " belongs to another version" : std::string()};
}

LoadedLibrary::LoadedLibrary(const std::string& path) : handle_(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (handle_ != nullptr) return;
  const char* const cause = dlerror();
  reason_ = cause != nullptr ? cause : "no cause was given";
}

LoadedLibrary::~LoadedLibrary() {
  if (handle_ != nullptr) dlclose(handle_);
}

void* LoadedLibrary::Find(const char* symbol) {
  if (handle_ == nullptr) return nullptr;
  void* const address = dlsym(handle_, symbol);
  if (address == nullptr) reason_ = std::string("it has no ") + symbol;
  return address;
}

}  // namespace plcxx::support
