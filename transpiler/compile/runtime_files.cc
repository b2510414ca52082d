#include "transpiler/compile/runtime_files.h"

#include <filesystem>
#include <fstream>
#include <system_error>

#include "transpiler/compile/embedded_runtime.h"

namespace plcxx::compile {

namespace {

std::vector<RuntimeFile> FilesOf(const std::string& folder, const EmbeddedFile* headers, unsigned count) {
  std::vector<RuntimeFile> files;
  for (unsigned i = 0; i < count; ++i) files.push_back({folder + headers[i].name, {headers[i].text, headers[i].size}});
  return files;
}

}  // namespace

std::vector<RuntimeFile> RuntimeFiles() { return FilesOf("plcxx/", kRuntimeHeaders, kRuntimeHeadersCount); }

std::vector<RuntimeFile> HostFiles() { return FilesOf("plcxx_host/", kHostHeaders, kHostHeadersCount); }

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
