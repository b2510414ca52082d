#include "transpiler/compile/runtime_files.h"

#include <filesystem>
#include <fstream>
#include <system_error>

#include "transpiler/compile/embedded_runtime.h"

namespace plcxx::compile {

bool WriteRuntime(const std::string& directory) {
  const std::filesystem::path folder = std::filesystem::path(directory) / "plcxx";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  bool written = !error;
  for (unsigned i = 0; i < kRuntimeHeadersCount; ++i) {
    std::ofstream file(folder / kRuntimeHeaders[i].name, std::ios::binary);
    file.write(kRuntimeHeaders[i].text, static_cast<std::streamsize>(kRuntimeHeaders[i].size));
    written = written && file.good();
  }
  return written;
}

}  // namespace plcxx::compile
