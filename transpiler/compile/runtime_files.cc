#include "transpiler/compile/runtime_files.h"

#include <filesystem>
#include <fstream>
#include <system_error>

#include "transpiler/compile/embedded_runtime.h"

namespace plcxx::compile {

std::vector<RuntimeFile> RuntimeFiles() {
  std::vector<RuntimeFile> files;
  for (unsigned i = 0; i < kRuntimeHeadersCount; ++i) {
    const EmbeddedFile& header = kRuntimeHeaders[i];
    files.push_back({std::string("plcxx/") + header.name, {header.text, header.size}});
  }
  return files;
}

bool WriteRuntime(const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::path(directory) / "plcxx", error);
  bool written = !error;
  for (const RuntimeFile& header : RuntimeFiles()) {
    std::ofstream file(std::filesystem::path(directory) / header.name, std::ios::binary);
    file.write(header.text.data(), static_cast<std::streamsize>(header.text.size()));
    written = written && file.good();
  }
  return written;
}

}  // namespace plcxx::compile
