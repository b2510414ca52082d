// The headers of runtime_support/plcxx_host as files beside generated code: what a host's files include.
#pragma once

#include <vector>

#include "transpiler/compile/runtime_files.h"
#include "transpiler/support/embedded_file.h"

namespace plcxx::compile {

using support::EmbeddedFile;
extern const EmbeddedFile kHostHeaders[];  // made by CMake
extern const unsigned kHostHeadersCount;

/// All of them, by name: "plcxx_host/pins.h".
std::vector<RuntimeFile> HostFiles();

}  // namespace plcxx::compile
