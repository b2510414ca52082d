// The files of runtime/ inside the tool.
#pragma once

#include "transpiler/support/embedded_file.h"

namespace plcxx::fleet {

using support::EmbeddedFile;

extern const EmbeddedFile kFleetRuntime[];
extern const unsigned kFleetRuntimeCount;

}  // namespace plcxx::fleet
