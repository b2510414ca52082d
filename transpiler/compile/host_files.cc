#include "transpiler/compile/host_files.h"

namespace plcxx::compile {

std::vector<RuntimeFile> HostFiles() {
  std::vector<RuntimeFile> files;
  for (unsigned i = 0; i < kHostHeadersCount; ++i) {
    const EmbeddedFile& header = kHostHeaders[i];
    files.push_back({std::string("plcxx_host/") + header.name, {header.text, header.size}});
  }
  return files;
}

}  // namespace plcxx::compile
